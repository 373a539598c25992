/* radiance_options.h - which estimators the light transport uses, and when paths
 * end. */
#ifndef PP_SIMULATE_TRANSPORT_RADIANCE_OPTIONS_H
#define PP_SIMULATE_TRANSPORT_RADIANCE_OPTIONS_H

#include <stdbool.h>

struct pp_radiance_options {
    bool sources;       /* next-event estimation of concentrated emitters */
    bool windows;       /* next-event estimation of openings */
    bool stored;        /* the radiance of surfaces outside is read from a window store
                   * (window_store.h) instead of being traced along each path */
    double source_size; /* the angular size (size over distance) to which a source or
                         * window is stratified at a path's first scattering surface; 0:
                         * one direction a source */
    int source_most;    /* directions to one source or window, at most; for n paths a
                         * pixel about 64/n is enough */
    int bounces;        /* diffuse reflections of a path, at most; -1: no limit but
                         * Russian roulette, which has no bias */
    double least;       /* Russian roulette begins where the throughput falls below
                         * this; after gloss, mirror and clear glass below a tenth of
                         * it; greater than 0 */
};

/* All estimators on, no limit of bounces, unbiased but for `stored`: size 0.2, at most
 * 64 directions, roulette below 0.3. */
struct pp_radiance_options pp_radiance_options_defaults(void);

#endif
