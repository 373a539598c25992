/* room_variant.h - switches by which our simulation imitates changes that another
 * program may have made to the room or scene.
 *
 *     bounces=N              at most N reflections between surfaces on a path. The
 *                            ground does not count: it emits its light
 *     ab=N                   as in Radiance with the ground as a surface: at most
 *                            N-1 reflections, including the ground's. ab=0: only direct
 *                            light of concentrated sources
 *     glass=normal           the transmittance at normal incidence for all angles
 *     glass=transmissivity   the transmittance is used as Radiance's transmissivity
 *     glass=none             openings without glass
 *     panes=1                only one of several panes
 *     frame=none  dirt=none  no frames; clean glass
 *     plane=Z                points at the height Z (m)
 *     sky=WORD               a sky of the room file format, or gensky: overcast,
 *                            blended into the ground at the horizon
 *     ground=R  ground=open  reflectance of the ground; ground lit by the whole sky
 *     outside=none           no obstructions outside
 *     colour=WORD            in a coloured scene: grey, materials are replaced by grey
 *                            ones of equal luminance; mean, the result is the mean of
 *                            red, green and blue; green, the green channel alone
 *     factor=F               all values multiplied by F
 */
#ifndef PP_STUDIES_RESEARCH_COMPARE_ROOM_VARIANT_H
#define PP_STUDIES_RESEARCH_COMPARE_ROOM_VARIANT_H

#include <stdbool.h>
#include <stdint.h>

#include "model/base/error.h"

enum pp_room_variant_glass {
    PP_ROOM_VARIANT_GLASS_IS,
    PP_ROOM_VARIANT_GLASS_NORMAL,
    PP_ROOM_VARIANT_GLASS_TRANSMISSIVITY,
    PP_ROOM_VARIANT_GLASS_NONE
};

enum pp_room_variant_colour {
    PP_ROOM_VARIANT_COLOUR_IS,
    PP_ROOM_VARIANT_COLOUR_GREY,
    PP_ROOM_VARIANT_COLOUR_MEAN,
    PP_ROOM_VARIANT_COLOUR_GREEN
};

struct pp_room_variant {
    int bounces;        /* -1: unlimited */
    bool ground_counts; /* reflections by the ground count as bounces */
    bool dark;          /* ab=0 */
    enum pp_room_variant_glass glass;
    enum pp_room_variant_colour colour;
    bool one_pane, no_frame, no_dirt, open_ground, nothing_outside;
    double plane_m, ground; /* NAN: unchanged */
    char sky[16];           /* empty: unchanged */
    double factor;
};

/* The unchanged room. */
struct pp_room_variant pp_room_variant_nothing(void);

/* Adds the comma-separated switches in `words` to those already set. A word may be a
 * preset, which stands for its switches. PP_BAD_INPUT, with a message, for an unknown
 * switch. */
enum pp_status pp_room_variant_add(struct pp_room_variant *variant, const char *words,
                                   struct pp_error *err);

/* A named set of common settings. */
struct pp_room_variant_preset {
    const char *name, *words;
    const char *what; /* source of the settings */
};
const struct pp_room_variant_preset *pp_room_variant_preset_at(
    int index); /* NULL after the last */

/* Options for the simulation of a variant, and its progress callback. */
struct pp_variant_tracing {
    double error; /* target relative standard error, above 0 */
    uint64_t seed;
    int threads; /* 0: one for each processor */
    /* Returns true to continue. done: 0 to 1. NULL: not called. */
    bool (*look)(void *data, double done);
    void *data;
};

#endif
