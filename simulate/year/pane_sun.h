/* pane_sun.h - sunlight that scattering panes send into a room, in every hour of a
 * year.
 *
 * The panes of a group are of the same kind. Es is the mean illuminance of the sun on
 * their outside, C the coefficient of a receiver for a class of leaving light
 * (year_batch.h), and E the illuminance of the receiver:
 *
 *     E = Es sum over classes of C btdf(sun, class)
 */
#ifndef PP_SIMULATE_YEAR_PANE_SUN_H
#define PP_SIMULATE_YEAR_PANE_SUN_H

#include "simulate/year/light_columns.h"
#include "simulate/year/year_batch.h"

struct pp_pane_sun {
    int class_count, hours;
    const struct pp_opening **panes; /* [group]: one scattering pane of the group; NULL:
                                      * none */
    float *btdf;                     /* [group][hour][class], 1/sr; 0 for groups without
                                      * such a pane */
};

/* Greatest number of classes of any pane of the scene's world; 0: no pane scatters. */
int pp_pane_sun_classes(const struct pp_light_scene *scene);

/* Calculates the BTDF for the sun of every hour. The caller must clear *panes, even
 * after a failure. */
enum pp_status pp_pane_sun_init(struct pp_pane_sun *panes,
                                const struct pp_year_task *task,
                                const struct pp_light_columns *light,
                                struct pp_error *err);
void pp_pane_sun_clear(struct pp_pane_sun *panes);

/* Mean illuminance of the sun on the outside of a group's panes, in a randomisation. */
double pp_pane_sun_lx(const struct pp_year_task *task,
                      const struct pp_year_batch *batch, int group,
                      const struct pp_perez_sky *sky);

/* Sum over classes for a receiver with these coefficients: its illuminance (lx) divided
 * by the illuminance of the sun (lx) on the outside of the panes. */
float pp_pane_sun_share(const struct pp_pane_sun *panes, const float *coefficients,
                        int group, int hour);

#endif
