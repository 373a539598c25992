/* slat_cell.h - light that the slats of a blind scatter, by the direction in which it
 * leaves.
 *
 * A slat is cut into straight strips; each side of a strip is uniformly bright. With
 * P_i the light that strip i reflects and F_ij the share of this light that falls on j,
 *
 *     P_j = rho_j (E_j + sum_i F_ij P_i)                                            (1)
 *
 * E_j is the light that falls on strip j from outside the blind. F_ij is integrated
 * exactly over the angle in the section, and by quadrature over strip i. Only the two
 * neighbours of a slat are visible from that slat. As slats are endless and Lambertian,
 * the shares in the section equal those in space. Notation as in slats.h; all light is
 * relative to the light that falls on the window's plane.
 */
#ifndef PP_MODEL_LIGHT_SLATS_SLAT_CELL_H
#define PP_MODEL_LIGHT_SLATS_SLAT_CELL_H

#include <stdbool.h>

#include "model/light/slats/slats.h"
#include "pepperpot.h"

/* Number of bins for leaving light: 5 degrees each of the profile angle of travel, from
 * -180 degrees. Light in the middle half of the bins travels into the room. */
enum { PP_SLAT_BINS = 72 };

struct pp_slat_light {
    double straight;
    double leaving[PP_SLAT_BINS]; /* scattered light, by bin */
};

struct pp_slat_cell;

/* Makes the cell; PP_BAD_INPUT if neighbouring slats touch. On success *cell belongs to
 * the caller. */
enum pp_status pp_slat_cell_create(struct pp_slat_cell **cell,
                                   const struct pp_slats *slats, struct pp_error *err);
/* True if neighbouring slats do not touch. */
bool pp_slat_cell_fits(const struct pp_slats *slats);
void pp_slat_cell_destroy(struct pp_slat_cell *cell); /* NULL is allowed */

/* Light of one profile angle, -pi to pi; light beyond pi/2 (either sign) comes from the
 * room. */
void pp_slat_cell_light(const struct pp_slat_cell *cell, double profile_rad,
                        struct pp_slat_light *light);

/* Light of equal luminance from all directions with a profile angle from `low` to
 * `high`, both on the same side of the window. From -pi/2 to pi/2: the whole outside; 0
 * to pi/2: its upper half, the sky; -pi/2 to 0: the ground. */
void pp_slat_cell_diffuse(const struct pp_slat_cell *cell, double low_rad,
                          double high_rad, struct pp_slat_light *light);

/* Sum of the scattered light that leaves in the bins `first` to `end` - 1. */
double pp_slat_cell_sum(const struct pp_slat_light *light, int first, int end);

/* Scattered light that leaves into the room downwards and upwards, and back outside
 * upwards and downwards. */
struct pp_slat_parts {
    double straight, room_down, room_up, back_up, back_down;
};
struct pp_slat_parts pp_slat_cell_parts(const struct pp_slat_light *light);

#endif
