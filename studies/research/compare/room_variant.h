/* room_variant.h - a room or scene as another program may have taken it: switches, in words.
 *
 *     bounces=N              reflections between surfaces on a path, at most; the ground
 *                            glows by itself
 *     ab=N                   N-1 of them, the ground's among them, as Radiance counts where
 *                            the ground is a surface; ab=0: no light that is not from a
 *                            concentrated source
 *     glass=normal           lets light of all angles through as at normal incidence
 *     glass=transmissivity   the transmittance given as Radiance's transmissivity
 *     glass=none             openings without glass
 *     panes=1                one pane of those that there are
 *     frame=none  dirt=none  no frames; clean glass
 *     plane=Z                points lie at that height (m)
 *     sky=WORD               as a room file's, or gensky: overcast, and faded into the
 *                            ground at the horizon
 *     ground=R  ground=open  reflectance of the ground; it is lit by the whole sky
 *     outside=none           nothing stands outside
 *     colour=WORD            of a scene in colours: grey, materials had the luminance of
 *                            theirs; mean, green: values had red, green and blue alike,
 *                            green alone for luminance
 *     factor=F               all values times F
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
    bool ground_counts; /* among them */
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

/* Adds the comma-separated switches of `words` to those already set; the name of a
 * preset is replaced by its words. PP_BAD_INPUT with a sentence for an unknown
 * switch. */
enum pp_status pp_room_variant_add(struct pp_room_variant *variant, const char *words,
                                   struct pp_error *err);

/* Names for settings that are common. */
struct pp_room_variant_preset {
    const char *name, *words;
    const char *what; /* source of the settings */
};
const struct pp_room_variant_preset *pp_room_variant_preset_at(
    int index); /* NULL after the last */

/* Options for the simulation of a variant, and its progress callback. */
struct pp_variant_tracing {
    double error; /* target standard error over value, above 0 */
    uint64_t seed;
    int threads; /* 0: one for each processor */
    /* Returns whether to continue; done: 0 to 1. NULL: not called. */
    bool (*look)(void *data, double done);
    void *data;
};

#endif
