/* sky_table.h - the light of any polygon from a sky of ISO 15469 through one pane on
 * one plane, from a table: in a few microseconds instead of up to a millisecond.
 *
 * For one sky, pane and normal the integrand depends on direction alone,
 *
 *     f(u) = L(u) T(w.u) (n.u)
 *
 * where w is the outward normal of the pane, and L is continued smoothly below the
 * horizon. All directions through the pane lie about w, so that w is the axis of
 * arc_sum.h, and the potential B is tabulated over the half space before the pane. f
 * has a cusp at the sun. Its circumsolar part, times the tangent plane at the sun of
 * the other factors of f,
 *
 *     c exp(d chi) [ G(s) + (u - s).grad G(s) ],   G = Lz phi(Z) T(w.u) (n.u)
 *
 * with chi the angle from the sun s, is not in the table; it is summed separately, with
 * the sun as axis (axial_table.h). The remainder has bounded second derivatives.
 *
 * The table has equal steps in t, w.u = (1 - t^2)^2, and in the tangent of the angle
 * round w, between -1 and 1, in two charts (t is negative on the other side of w).
 * Steps of w.u shrink towards grazing incidence, where the transmittance of glass falls
 * off. f is summed along t with two Gauss points per step, and B is interpolated by
 * cubic B-splines.
 *
 * In a test of 24,000 random windows of any slope and glazing, with planes that face up
 * and all sky types, the worst error was 7e-7 of the open sky and the rms error 5e-8.
 * On planes tilted towards a low sun under types 14 and 15 the error is up to 1e-5.
 */
#ifndef PP_METHODS_FAST_SKY_TABLE_H
#define PP_METHODS_FAST_SKY_TABLE_H

#include "methods/exact/half_space_clip.h"
#include "model/base/error.h"
#include "model/geometry/projection.h"
#include "model/light/glass.h"
#include "model/light/sky.h"

struct pp_sky_table;

/* phi(Z) of sky.h for z = cos Z, continued as 1 below the horizon, where all its
 * derivatives are 0. */
double pp_sky_table_gradation(const struct pp_sky *sky, double z);

/* sky: a sky of ISO 15469. glass: perpendicular to view->toward. view: the axes of the
 * pane; eye and distance are not used. normal: that of the receiving plane, in the
 * room's axes. On success the caller destroys *table. Several threads may read one
 * table. */
enum pp_status pp_sky_table_create(struct pp_sky_table **table,
                                   const struct pp_sky *sky,
                                   const struct pp_glass *glass,
                                   const struct pp_projection *view,
                                   struct pp_vec3 normal, struct pp_error *err);
void pp_sky_table_destroy(struct pp_sky_table *table); /* NULL is allowed */

/* True if the table was made for a plane with that normal. */
bool pp_sky_table_is_for(const struct pp_sky_table *table, struct pp_vec3 normal);

/* Illuminance, over Eh, from the part of a ring within the half-spaces, both in the
 * view's axes (arc_sum.h). One of the half-spaces must be that above the horizon,
 * another that in front of the plane. */
double pp_sky_table_sum(const struct pp_sky_table *table,
                        const struct pp_vec3 *vertices, int count,
                        const struct pp_vec3 *half_spaces, int half_space_count);

#endif
