/* gain_changes.h - the changes to a room that gains.h tries, one function each. Inside
 * studies/sizing/ only.
 */
#ifndef PP_STUDIES_SIZING_GAIN_CHANGES_H
#define PP_STUDIES_SIZING_GAIN_CHANGES_H

#include "studies/sizing/gains.h"
#include "model/room/room.h"

/* Makes the changed room, which is the caller's, and says what was changed in
 * gain->change; *changed NULL where the change makes no sense of this room. */
typedef enum pp_status pp_gain_change(struct pp_room **changed, struct pp_gain *gain,
                                      const struct pp_room *room,
                                      const struct pp_world *world,
                                      struct pp_error *err);

struct pp_gain_kind {
    pp_gain_change *make;
    const char *lacks;
    bool of_design;
};

/* The kinds, in an order that decides between equal gains; make is NULL at the end. */
extern const struct pp_gain_kind pp_gain_kinds[];

#endif
