/* gains.h - finds the changes to a room that would increase its daylight factors most.
 *
 * Each change is made to a copy of the room. The daylight factors of room and copy are
 * computed by the same method. pp_gains_simulate simulates the room and the most
 * promising changes with the same seed, and ranks these changes again. The average is
 * over the working plane. The darkest point is the darkest one of the largest grid of
 * EN 17037 (pp_plane_grid_largest), which some rooms do not have. The method is
 * exact+bre, or exact+split-flux for rooms to which exact+bre does not apply.
 */
#ifndef PP_STUDIES_SIZING_GAINS_H
#define PP_STUDIES_SIZING_GAINS_H

#include <stdbool.h>

#include "model/base/error.h"
#include "model/light/outside_light.h"
#include "model/room/building.h"
#include "model/room/world.h"
#include "studies/study_options.h"

/* Daylight factors as fractions; NAN: no value. */
struct pp_gain_values {
    double average, darkest;
};

struct pp_gain {
    char change[128]; /* such as "a ceiling of reflectance 0.85 instead of 0.6" */
    const char
        *lacks;     /* fault that the change corrects, such as "a dark ceiling"; static;
                     * NULL: the room does not have such a fault */
    bool of_design; /* true if the designer can make the change; false for
                     * obstructions */
    struct pp_gain_values values; /* values of the changed room */
    int kind;                     /* index in pp_gain_kinds (gain_changes.h) */
};

enum { PP_GAINS_MOST = 16 };

struct pp_gains {
    const char *method; /* "exact+bre", "exact+split-flux" or "traced"; static; NULL: no
                         * method applies to the room */
    struct pp_gain_values now;
    struct pp_gain list[PP_GAINS_MOST]; /* in descending order of averages, all greater
                                         * than that of the room */
    int count;
};

/* Evaluates and ranks the changes that apply to the room. `world` must be made from
 * `room`. The watch shows progress; it cannot stop the work. */
enum pp_status pp_gains_find(struct pp_gains *gains, const struct pp_room *room,
                             const struct pp_world *world,
                             const struct pp_outside_light *light,
                             const struct pp_watch *watch, struct pp_error *err);

/* Replaces the values by hand by simulated values, for the room and for the
 * PP_GAINS_SIMULATED changes with the greatest averages by hand. Other changes are
 * removed from the list. The target error is options->error, but at least 2 %;
 * options->samples, if given, replaces it. options->seconds is the time for all
 * simulations together. Does nothing if no method applies to the room. */
enum { PP_GAINS_SIMULATED = 6 };
enum pp_status pp_gains_simulate(struct pp_gains *gains, const struct pp_room *room,
                                 const struct pp_world *world,
                                 const struct pp_outside_light *light,
                                 const struct pp_study_options *options,
                                 struct pp_error *err);

/* Scales all averages so that the room has the given average, which is more accurate.
 * The ratios between the averages are kept, because simulations with the same seed have
 * most of their noise in common. Does nothing if an average is not known. */
void pp_gains_relate(struct pp_gains *gains, double average);

/* Writes a sentence on the three greatest faults of the room ("Main causes: low window
 * heads and a dark ceiling."). text: buffer of `size` bytes; empty if no change
 * increases the average. */
void pp_gains_sentence(const struct pp_gains *gains, char *text, size_t size);

#endif
