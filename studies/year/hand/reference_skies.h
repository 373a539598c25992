/* reference_skies.h - factors of a room's points under skies and suns from which the hand
 * methods for the year compose an hour.
 *
 * A factor is the illuminance of a point for a horizontal illuminance of 1 lx from the
 * open sky, or for 1 lx from the sun on a plane normal to its rays. All factors come
 * from one simulation by daylight coefficients with the paths of the simulated year, so
 * that the hand methods and the simulated year have the same noise.
 */
#ifndef PP_STUDIES_YEAR_HAND_REFERENCE_SKIES_H
#define PP_STUDIES_YEAR_HAND_REFERENCE_SKIES_H

#include "studies/year/hand/standard_sky.h"
#include "studies/year/annual.h"

struct pp_reference_skies {
    struct pp_perez_sky *list; /* axes: x east, y north, z up; owned */
    int count;
    int space;
    float *factors; /* [receiver][sky]; owned; NULL: not simulated */
    bool failed;    /* true: out of memory */
};

/* Adds a sky without its sun, scaled to 1 lx, or a sun without a sky; returns its
 * index. Equal skies have one index. A black sky and a sun below the horizon have the
 * index -1, whose factor is 0. */
int pp_reference_skies_add(struct pp_reference_skies *skies,
                           const struct pp_perez_sky *sky);
int pp_reference_skies_add_standard(struct pp_reference_skies *skies,
                                    enum pp_standard_sky kind, struct pp_vec3 sun);
int pp_reference_skies_add_sun(struct pp_reference_skies *skies, struct pp_vec3 sun);

/* Simulates the factors of all points. The options are those of the simulated year.
 * *finished is false if the watch of the options stopped the simulation. */
enum pp_status pp_reference_skies_simulate(struct pp_reference_skies *skies,
                                           const struct pp_world *world,
                                           const struct pp_outside_light *light,
                                           const struct pp_receiver *receivers,
                                           int receiver_count,
                                           const struct pp_annual_options *options,
                                           bool *finished, struct pp_error *err);

double pp_reference_skies_factor(const struct pp_reference_skies *skies, int receiver,
                                 int sky);

void pp_reference_skies_clear(struct pp_reference_skies *skies);

#endif
