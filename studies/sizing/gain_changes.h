/* gain_changes.h - the changes to a room that gains.h ranks. There is one function for
 * each kind of change. For use inside studies/sizing/ only.
 */
#ifndef PP_STUDIES_SIZING_GAIN_CHANGES_H
#define PP_STUDIES_SIZING_GAIN_CHANGES_H

#include "studies/sizing/gains.h"
#include "model/room/room.h"

/* Makes a changed copy of the room, owned by the caller, and describes the change in
 * gain->change. *changed remains NULL if the change does not apply to the room. */
typedef enum pp_status pp_gain_change(struct pp_room **changed, struct pp_gain *gain,
                                      const struct pp_room *room,
                                      const struct pp_world *world,
                                      struct pp_error *err);

/* A kind of change. lacks, of_design: as in struct pp_gain. */
struct pp_gain_kind {
    pp_gain_change *make;
    const char *lacks;
    bool of_design;
};

/* All kinds of change. If gains are equal, the kind that is first in this list ranks
 * first. The last entry has make = NULL. */
extern const struct pp_gain_kind pp_gain_kinds[];

#endif
