/* corrections.h - the published corrections of the daylight factor: frames and
 * curtains that have a name, dirt and decorations by place and work
 * (tables/frames.csv, curtains.csv, maintenance.csv, decorations.csv). */
#ifndef PP_MODEL_ROOM_CORRECTIONS_H
#define PP_MODEL_ROOM_CORRECTIONS_H

#include "model/room/world.h"

struct pp_named_factor {
    const char *name;
    double factor;      /* share of the light that it leaves, 0 to 1 */
    const char *source; /* as the head of the table explains it */
    const char *description;
};

struct pp_named_factors {
    const struct pp_named_factor *list;
    int count;
};

extern const struct pp_named_factors pp_frames, pp_curtains;

/* The factor of that name, or NULL. */
const struct pp_named_factor *pp_corrections_find(
    const struct pp_named_factors *factors, const char *name);

/* M, the share of the light that dirt leaves on glass of that slope (rad, 0
 * horizontal); NAN where that edition has no figures for such a place or work. */
double pp_corrections_maintenance(enum pp_dirt edition,
                                  enum pp_surroundings surroundings, enum pp_work work,
                                  double slope_rad);

/* Keys in docs/SOURCES.md, by enum pp_dirt. */
extern const char *const pp_corrections_editions[];

/* D, the share of the internally reflected component that the deterioration of
 * decorations leaves. */
double pp_corrections_decorations(enum pp_surroundings surroundings, enum pp_work work);

#endif
