/* pane_scatter.h - a pane that scatters light by direction: measured glazing, or a
 * device such as a blind, as simulations use it.
 *
 * A pane is a struct of functions, so that a new kind of pane needs no change in any
 * tracer: fill in a struct, and let an opening of the world (model/room/world.h) refer
 * to it. Directions are unit vectors in which the light travels, in the axes of the
 * pane: z is its normal into the room, y is up, x = y cross z. The sign of z tells
 * which way the light travels; it is the same for arriving (`in`) and leaving (`out`)
 * light. The light divides into
 *
 *     straight(in)     share that leaves in the same direction; a ray in simulations,
 *                      so that the sun and its shadows stay sharp
 *     scattered(in)    share that leaves in other directions
 *     btdf(in, out)    of scattered light, 1/sr: scattered = integral of btdf |out.z|
 *
 * Paths run from the eye to the light. For them `out` is known and `in` is sampled:
 *
 *     arriving(out)    integral of btdf |in.z| over all `in`: radiance along `out` if
 *                      the radiance from all directions is 1. It may exceed 1.
 *     sample           draws `in` for that `out`, with the density given by `density`;
 *                      returns btdf |in.z| / (density arriving), which is 1 if the
 *                      density is exact
 *
 * A passive pane is reciprocal, btdf(in, out) = btdf(-out, -in), so that the direction
 * of leaving light can be sampled by the same function.
 *
 * For annual simulations, the directions of light that leaves into the room are divided
 * into classes. Light of one class is assumed to have one radiance, given by
 * class_btdf.
 *
 * Reflected light is diffuse.
 */
#ifndef PP_MODEL_LIGHT_PANE_SCATTER_H
#define PP_MODEL_LIGHT_PANE_SCATTER_H

#include <stdbool.h>
#include <stdint.h>

#include "model/geometry/vec.h"

struct pp_angle_basis; /* model/light/bsdf/angle_basis.h */

struct pp_pane_scatter {
    const struct pp_pane_scatter
        *for_sun;     /* the pane as it is for light of the sun, in a
                                            * year of suns: slats that follow it; not
                                            * owned; NULL: the same */
    const void *data; /* first argument of all functions; not owned */
    uint64_t id;      /* hash of the data: panes with equal ids are the same */
    double reflect_outside, reflect_room; /* reflectances of the two sides */
    bool splits;                          /* `straight` can be other than 0 */
    const struct pp_angle_basis *basis;   /* patches in which btdf and straight do not
                                           * vary, for files; not owned; NULL: none */

    double (*straight)(const void *data, struct pp_vec3 in);
    double (*scattered)(const void *data, struct pp_vec3 in);
    double (*btdf)(const void *data, struct pp_vec3 in, struct pp_vec3 out);

    double (*arriving)(const void *data, struct pp_vec3 out);
    double (*sample)(const void *data, struct pp_vec3 out, double u, double v,
                     struct pp_vec3 *in); /* u, v: in (0, 1) */
    double (*density)(const void *data, struct pp_vec3 in, struct pp_vec3 out);

    int class_count; /* classes of light that leaves into the room; out.z > 0 */
    int (*class_of)(const void *data, struct pp_vec3 out);
    double (*class_btdf)(const void *data, struct pp_vec3 in, int class_index);
};

#endif
