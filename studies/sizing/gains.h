/* gains.h - what holds a room's daylight back, and what each change to it would bring.
 *
 * Each change is made to a copy of the room, which is resolved and worked out again by
 * the same method: nothing is estimated. The average is over the working plane, the
 * darkest point is that of the grid of EN 17037 (studies/criteria/en17037_grid.h), of which a
 * room may have none. The method is exact+bre, or exact+split-flux where that does not
 * cover the room.
 */
#ifndef PP_STUDIES_SIZING_GAINS_H
#define PP_STUDIES_SIZING_GAINS_H

#include <stdbool.h>

#include "model/base/error.h"
#include "model/room/building.h"
#include "model/room/world.h"

/* Daylight factors, fractions; NAN where there is none. */
struct pp_gain_values {
    double average, darkest;
};

struct pp_gain {
    char change[128];  /* "a ceiling of reflectance 0.85 instead of 0.6" */
    const char *lacks; /* what this lack is called: "a dark ceiling"; static; NULL: it
                        * is none, but a chance */
    bool of_design;    /* false: what stands outside, which nobody can take away */
    struct pp_gain_values values; /* of the room so changed */
};

enum { PP_GAINS_MOST = 16 };

struct pp_gains {
    const char *method; /* static; NULL: no method covers the room */
    struct pp_gain_values now;
    struct pp_gain list[PP_GAINS_MOST]; /* largest average first; none that is smaller
                                         * than now */
    int count;
};

/* Ranks the changes that make sense for the room. world is that of room. */
enum pp_status pp_gains_find(struct pp_gains *gains, const struct pp_room *room,
                             const struct pp_world *world, struct pp_error *err);

/* What holds it back most, as a sentence; empty where no change brings anything. */
void pp_gains_sentence(const struct pp_gains *gains, char *text, size_t room);

#endif
