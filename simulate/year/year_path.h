/* year_path.h - light paths of a room as events, without amounts of light. Events are
 * the places where the paths end and where the sun may light them. One set of paths
 * therefore serves every hour of a year.
 *
 * The paths are those of simulate/path_tracer/path_trace.h, with the same next-event
 * estimation of openings. A path reports its events to a sink, each with a weight w:
 *
 *     sky          E += w L(u)             L luminance of the sky in direction u
 *     skyline      E += w M/pi             M exitance of a skyline without a distance
 *     horizontal   E += w Eh               Eh horizontal illuminance: open ground, and
 *                                          surfaces with an exitance of their own
 *     lit          E += w Es(y)            Es illuminance of the sun on one side of a
 *                                          surface, at y
 *     pane_sun     E += w f Es(y)          f: BTDF of a scattering pane, from the
 *                                          sun to a class of leaving light
 *                                          (pane_scatter.h); y is on its outside
 *     pane         E += w M/pi             M exitance of a pane that would emit
 *                                          uniformly, instead of transmitting light
 *
 * E is the irradiance of the receiver. A sink may also end a path at an inside surface
 * if the sink knows the irradiance of that surface.
 *
 * Specular reflections of sunlight by panes, mirrors or glosses are not counted.
 */
#ifndef PP_SIMULATE_YEAR_YEAR_PATH_H
#define PP_SIMULATE_YEAR_YEAR_PATH_H

#include "simulate/path_tracer/path_trace.h"

/* An event. opening: the last opening through which the path has left the room; -1:
 * none. */
struct pp_year_event {
    double weight;
    int opening;
    bool straight; /* sky, horizontal: reached directly, or through clear glass only */
    struct pp_vec3 u;               /* sky: direction */
    int far;                        /* skyline: index */
    struct pp_lit_point at;         /* lit, pane_sun: one side of a surface */
    int leaving;                    /* pane_sun: class of the leaving light */
    const struct pp_light_hit *hit; /* lit and known: hit on the surface */
};

struct pp_year_sink {
    void *data;
    void (*sky)(void *data, const struct pp_year_event *event);
    void (*skyline)(void *data, const struct pp_year_event *event);
    void (*horizontal)(void *data, const struct pp_year_event *event);
    void (*lit)(void *data, const struct pp_year_event *event);
    void (*pane)(void *data, const struct pp_year_event *event); /* NULL: not needed */
    void (*pane_sun)(void *data, const struct pp_year_event *event); /* NULL: not
                                                                      * needed */
    bool pane_sun_apart; /* pp_year_path_openings does not report the sunlight of the
                          * pane at which it aims; pp_year_path_pane_sun does */
    /* Returns true if the irradiance of this inside surface is known. The path then
     * ends, and w times the irradiance is added to E. NULL: never known. */
    bool (*known)(void *data, const struct pp_year_event *event);
};

/* Sample the irradiance E of one side of a surface. pp_year_path_openings uses one path
 * through the openings, by next-event estimation; the other function uses one path in a
 * direction of the cosine lobe. Each samples its own part of E; outdoors the lobe
 * samples all of E. */
void pp_year_path_openings(struct pp_path_walk *walk, const struct pp_year_sink *sink,
                           const struct pp_lit_point *at);
void pp_year_path_lobe(struct pp_path_walk *walk, const struct pp_year_sink *sink,
                       const struct pp_lit_point *at);

/* Samples the sunlight that scattering panes send directly to a point indoors, in the
 * same way as pp_year_path_openings, but without a path outside. */
void pp_year_path_pane_sun(struct pp_path_walk *walk, const struct pp_year_sink *sink,
                           const struct pp_lit_point *at);

#endif
