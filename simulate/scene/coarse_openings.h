/* coarse_openings.h - the openings of a coarse model as targets, for directions of
 * diffuse surfaces in that model.
 *
 * Paths that leave a nested room run among the surfaces of the coarse model, which the
 * sky lights only through the other openings of that model. At a diffuse surface there,
 * one direction is drawn from the mixture of the cosine lobe and of directions to the
 * openings. Its density is
 *
 *     q sum of P_i p_i(u) + (1 - q) cos(theta) / pi
 *
 * where P_i is the probability of opening i, and p_i the density of sample_polygon.h.
 * This is the balance heuristic for one sample [VG95]: no light is counted twice, and
 * no further rays are needed. Openings that are hidden cause noise, but no bias.
 */
#ifndef PP_SIMULATE_SCENE_COARSE_OPENINGS_H
#define PP_SIMULATE_SCENE_COARSE_OPENINGS_H

#include <stdbool.h>

#include "model/base/error.h"
#include "model/geometry/bounds.h"
#include "model/geometry/frame.h"
#include "model/room/world.h"
#include "simulate/sampling/sample_polygon.h"

/* Rectangular openings between the coarse model and the sky, glazed or not. There are
 * none if the room is not nested, if the coarse model is in its place, or if it has
 * more than 8 such openings. */
struct pp_coarse_openings {
    struct pp_target *list; /* owned */
    int count;
    struct pp_bounds3 inside; /* bounds of the interior of the coarse model */
};

/* Points are measured from `centre`. The caller frees coarse->list, even after an
 * error. */
enum pp_status pp_coarse_openings_find(struct pp_coarse_openings *coarse,
                                       const struct pp_world *world,
                                       struct pp_vec3 centre, struct pp_error *err);

/* Draws a direction from the mixture at a point of a diffuse surface, by three numbers
 * in (0, 1). frame->z: normal of the surface. throughput: of the path, including the
 * reflectance of the surface; it determines q. *weight: density of the cosine lobe
 * divided by that of the mixture. False, without a direction, if the point is not in
 * the coarse model or no opening is in sight. */
bool pp_coarse_openings_draw(const struct pp_coarse_openings *coarse,
                             const struct pp_brightness *brightness,
                             struct pp_vec3 from, const struct pp_frame *frame,
                             double throughput, const double u[3], struct pp_vec3 *to,
                             double *weight);

#endif
