/* gains.h - the changes to a room that would raise its daylight factors most.
 *
 * Each change is made to a copy of the room, and the daylight factors of the copy are
 * computed by the same method as those of the room. pp_gains_simulate simulates the
 * room and the most promising changes with the same seed, and ranks these changes
 * again. The average is over the working plane. The darkest point is that of EN 17037's
 * largest grid (pp_plane_grid_largest), which some rooms do not have. The method is
 * exact+bre, or exact+split-flux in rooms that exact+bre does not cover.
 */
#ifndef PP_STUDIES_SIZING_GAINS_H
#define PP_STUDIES_SIZING_GAINS_H

#include <stdbool.h>

#include "model/base/error.h"
#include "model/light/outside_light.h"
#include "model/room/building.h"
#include "model/room/world.h"
#include "studies/study_options.h"

/* Daylight factors, fractions; NAN: no value. */
struct pp_gain_values {
    double average, darkest;
};

struct pp_gain {
    char change[128]; /* "a ceiling of reflectance 0.85 instead of 0.6" */
    const char
        *lacks;     /* fault that the change corrects: "a dark ceiling"; static; NULL:
                     * it corrects no fault of the room */
    bool of_design; /* the designer can make the change; false for obstructions */
    struct pp_gain_values values; /* values of the changed room */
    int kind;                     /* index in the list of kinds (gain_changes.h) */
};

enum { PP_GAINS_MOST = 16 };

struct pp_gains {
    const char *method; /* "exact+bre", or "traced"; static; NULL: no method covers the
                         * room */
    struct pp_gain_values now;
    struct pp_gain list[PP_GAINS_MOST]; /* largest average first; all larger than the
                                         * room's */
    int count;
};

/* Evaluates and ranks the changes that apply to the room. `world` must be made from
 * `room`. */
enum pp_status pp_gains_find(struct pp_gains *gains, const struct pp_room *room,
                             const struct pp_world *world,
                             const struct pp_outside_light *light,
                             struct pp_error *err);

/* Replaces the hand values by simulated ones, for the room and for the
 * PP_GAINS_SIMULATED changes with the largest averages by hand; other changes are
 * dropped. Standard errors of the averages are 2 % or less, unless options->samples or
 * options->seconds end the simulation sooner. Does nothing if no method covers the
 * room. */
enum { PP_GAINS_SIMULATED = 6 };
enum pp_status pp_gains_simulate(struct pp_gains *gains, const struct pp_room *room,
                                 const struct pp_world *world,
                                 const struct pp_outside_light *light,
                                 const struct pp_study_options *options,
                                 struct pp_error *err);

/* Scales the averages so that the room has this one, which is more accurate, and the
 * gains keep their ratios: rooms with the same seed have most of their noise in common.
 * Does nothing if an average is not known. */
void pp_gains_relate(struct pp_gains *gains, double average);

/* The room's three largest faults as a sentence ("Main causes: low window heads and a
 * dark ceiling."), in `text` of `size` bytes; empty if no change raises the average. */
void pp_gains_sentence(const struct pp_gains *gains, char *text, size_t size);

#endif
