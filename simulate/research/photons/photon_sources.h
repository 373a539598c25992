/* photon_sources.h - sources of photons: the openings of a room, for the light of sky
 * and ground, and the self-luminous surfaces in the room.
 *
 * A source is drawn in proportion to its estimated light, and a point on the source
 * uniformly. At an opening, a direction is drawn in proportion to the luminance
 * outside times the pane's transmittance times the projected area. It is drawn from a
 * table over the unit square, which the concentric map [SC97] maps to the cosine lobe.
 * The estimates are made from the middle of each opening. They affect the variance
 * alone, since the light is divided by the known density of the direction.
 *
 * A photon that starts at x with density p(x) contributes to a receiver at distance d
 *
 *     L cos cos'/d^2 / p(x)                                              (1)
 *
 * which is unbounded as d approaches 0. Therefore cos cos'/d^2 is clamped to a limit,
 * for sources and for surfaces that photons hit. Rays from the receiver sample the part
 * cut off (photon_gather.h); their weights are bounded where (1) is not.
 */
#ifndef PP_SIMULATE_RESEARCH_PHOTONS_PHOTON_SOURCES_H
#define PP_SIMULATE_RESEARCH_PHOTONS_PHOTON_SOURCES_H

#include "simulate/research/photons/photon_state.h"

enum { PP_PHOTON_CELLS = 16 }; /* cells along either side of the table */

struct pp_photon_source {
    int pane; /* index of the opening's pane in the scene; -1: a lamp */
    int part; /* the part; whether light leaves from its back */
    bool back;
    const struct pp_vec3 (*triangles)[3]; /* not owned */
    int triangle_count;
    double area_m2;
    struct pp_rgb radiance; /* radiance of a lamp */
    double power;           /* estimated flux */
    double chance;          /* probability with which the source is drawn */
    double limit;           /* limit of cos cos'/d^2 (1/m2) for this probability */
    bool clear;             /* clear glass: photons continue in the direction drawn */
    double rows[PP_PHOTON_CELLS]; /* table of an opening: means of its rows of cells */
    double cells[PP_PHOTON_CELLS][PP_PHOTON_CELLS]; /* values with a mean of 1 */
};

struct pp_photon_sources {
    struct pp_photon_source *list; /* openings first, in the order of the scene's
                                    * panes */
    int count, pane_count;
    double power, pane_power;       /* power of all sources, and of all openings */
    double limit;                   /* limit of cos cos'/d^2 at a surface hit by a
                                     * photon */
    bool all_seen;                  /* any two places in the room see each other */
    struct pp_vec3 (*triangles)[3]; /* triangles of lamps */
};

/* environment: of the same scene, of a world. Scene and environment must outlive
 * *sources. */
enum pp_status pp_photon_sources_create(struct pp_photon_sources **sources,
                                        const struct pp_light_scene *scene,
                                        const struct pp_environment *environment,
                                        struct pp_error *err);
void pp_photon_sources_destroy(struct pp_photon_sources *sources); /* NULL is allowed */

/* The source selected by u in (0, 1) among the first `count`, in proportion to their
 * probabilities; -1: there is none. */
int pp_photon_sources_choose(const struct pp_photon_sources *sources, int count,
                             double u);

/* A point of the source, uniform by area for two numbers in (0, 1). */
struct pp_vec3 pp_photon_sources_point(const struct pp_light_scene *scene,
                                       const struct pp_photon_source *source, double u,
                                       double v);

/* Direction about n, drawn from the source's table by two numbers in (0, 1). *density:
 * relative to that of the cosine lobe, cos/pi. */
struct pp_vec3 pp_photon_sources_direction(const struct pp_light_scene *scene,
                                           const struct pp_photon_source *source,
                                           struct pp_vec3 n, double u, double v,
                                           double *density);

/* The limit of cos cos'/d^2 (1/m2) at an opening drawn with this probability. */
double pp_photon_sources_limit(double area_m2, double chance);

/* Writes the probability of each opening for a receiver into chances[], in proportion
 * to its possible contribution. False if none can contribute. */
bool pp_photon_sources_for(double *chances, const struct pp_photon_sources *sources,
                           const struct pp_light_scene *scene, struct pp_vec3 point,
                           struct pp_vec3 normal);

#endif
