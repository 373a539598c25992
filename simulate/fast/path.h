/* path.h - the daylight factor at a point, by random paths.
 *
 * The daylight factor is the sum of three expectations, each sampled separately. Let B
 * be the true exitance of the room's surfaces,
 *
 *     B = M + rho (E + K B)                                                        (1)
 *
 * where M is the emission of the surfaces, E the irradiance from the openings, and K
 * the operator that gives the irradiance from the exitance of other surfaces. Let G be
 * a coarse radiosity solution (control_variate.h), used as control variate:
 *
 *     direct      light that enters through an opening and reaches the point without
 *                 reflection, by next-event estimation
 *     gather      the mean of G over the cosine lobe of the point; in a convex room
 *                 by cells (gather_cells.h), and the remainder by rays
 *     correction  the mean of B - G over that lobe, with
 *
 *                     B - G = (M - G) + rho (E + K G) + rho K (B - G)              (2)
 *
 *                 followed along a path: at each surface met, several directions
 *                 sample the first two terms of (2), K G also by cells; one of
 *                 these directions continues
 *
 * The sum is unbiased for any G; with a good G the correction has little variance. This
 * variance comes from the noise of the samples at each surface, which grows with the
 * light at that surface. The direction that continues is therefore drawn in proportion
 * to G at the surface that it meets, as in the importance resampling of [TCE05].
 * Russian roulette ends paths according to their expected contribution, which is
 * estimated from G.
 *
 * Without G, the correction is plain path tracing. If receivers share light
 * (shared_density.h), most of the correction comes from shared points. A path then
 * continues only with the remainder.
 *
 * In an empty convex room, directions to the openings are directions to the mouths of
 * their niches. A direction that ends on a side of a niche adds the side's G to the
 * direct light. Rays from the room that reach a side add nothing. Sides are small and
 * bright, so few rays would meet them. When sides were sampled by rays only, rooms with
 * reveals took up to ten times longer.
 *
 * Paths are those of the light transport (transport/light_path.h), in the scene of a
 * world with diffuse finishes only. Indoors, next-event estimation samples the light
 * from the openings at every surface. A ray of the cosine lobe that reaches an opening
 * therefore adds nothing for light that enters through the opening; glass and frame
 * reflect the ray.
 *
 * Light of other openings that glass reflects to the point itself is sampled with the
 * direct light, by the images of the openings, and excluded from the correction's own
 * rays. When this light was sampled by rays only, few rays met it: in rooms with
 * windows in several walls, one point in a hundred had three to fifteen times the
 * target error.
 *
 * All light is over Eh.
 */
#ifndef PP_SIMULATE_FAST_PATH_H
#define PP_SIMULATE_FAST_PATH_H

#include "simulate/scene/images/glass_images.h"
#include "simulate/fast/control_variate.h"
#include "simulate/fast/gather_cells.h"
#include "simulate/fast/shared_density.h"
#include "simulate/transport/irradiance.h"
#include "simulate/transport/radiance_state.h"

/* Light by component, from the first surface seen by the point: PP_SC, PP_ERC, PP_IRC
 * of model/results/reading.h. */
struct pp_light {
    double part[3];
};

/* State of a thread that follows paths. */
struct pp_path_state {
    struct pp_radiance_state light;
    const struct pp_control_variate
        *variate; /* the control variate; not owned; NULL: none */
    const struct pp_niche_light *niches; /* from the control variate; not owned; NULL:
                                          * niches are not sampled */
    const struct pp_shared_density *shared; /* not owned; NULL: nothing is shared */
    const struct pp_gather_cells *cells;    /* not owned; NULL: rays gather all */
    const double *net;         /* cell points of this randomisation; not owned */
    bool glass;                /* openings are sampled by their images in glass */
    struct pp_glass_view view; /* images seen from the last point */
};

/* State for paths in this scene and light. The caller still sets the sequence. */
struct pp_path_state pp_path_state(const struct pp_light_scene *scene,
                                   const struct pp_environment *environment,
                                   const struct pp_control_variate *variate);

/* Start of paths: a point, or anywhere on the working plane. */
struct pp_start {
    bool anywhere;
    struct pp_vec3 position; /* in the scene's coordinates */
    struct pp_vec3 normal;
};

/* The irradiance from the openings at a point indoors, from this many directions with
 * the random numbers of a vertex. Components: directly from the sky, from outside, and
 * (`rest`) from sides of niches (according to G) and from the room itself through other
 * openings. */
struct pp_irradiance pp_path_by_openings(struct pp_path_state *state,
                                         struct pp_vec3 point, struct pp_vec3 normal,
                                         int vertex, uint32_t directions);

/* True if next-event estimation at `from` already counts the light of this hit. */
bool pp_path_counted_by_nee(const struct pp_path_state *state, struct pp_vec3 from,
                            const struct pp_light_hit *met);

/* Add the samples of the paths from state->light.index up to, but not including, `end`;
 * afterwards the index is `end`. Gathered light and its correction are internally
 * reflected light, 0 without a room. */
void pp_path_direct(struct pp_path_state *state, const struct pp_start *start,
                    uint32_t end, struct pp_light *light);
void pp_path_gather(struct pp_path_state *state, const struct pp_start *start,
                    uint32_t end, double *sum);
void pp_path_correction(struct pp_path_state *state, const struct pp_start *start,
                        uint32_t end, double *sum);

/* Light gathered by cells in a randomisation, in addition to the paths. 0 if there are
 * no cells or if paths start anywhere on the plane. */
double pp_path_gather_cells(const struct pp_path_state *state,
                            const struct pp_start *start);

/* Estimate from one of the shared points. If state->shared is not NULL, the mean of
 * these estimates is a part of the correction. */
double pp_path_shared(const struct pp_path_state *state, const struct pp_start *start,
                      const struct pp_shared_light *shared);

/* One sample of B - G at a surface: by a path or, given independent shared points, by
 * one step of (2) and the light of the shared points. */
double pp_path_residual(struct pp_path_state *state, const struct pp_light_hit *met,
                        const struct pp_shared_light *others, int count);

#endif
