/* corrections.h - published correction factors of the daylight factor: named frames and
 * curtains, dirt and decorations by place and work (tables/frames.csv, curtains.csv,
 * maintenance.csv, decorations.csv). */
#ifndef PP_MODEL_ROOM_CORRECTIONS_H
#define PP_MODEL_ROOM_CORRECTIONS_H

#include "model/room/world.h"

struct pp_named_factor {
    const char *name;
    double factor;      /* transmitted share of the light, 0 to 1 */
    const char *source; /* as explained at the head of the table */
    const char *description;
};

struct pp_named_factors {
    const struct pp_named_factor *list;
    int count;
};

extern const struct pp_named_factors pp_frames, pp_curtains;

/* Finds a factor by name; NULL if there is none. */
const struct pp_named_factor *pp_corrections_find(
    const struct pp_named_factors *factors, const char *name);

/* Maintenance factor M, 0 to 1: light transmitted through dirty glass of that slope
 * (rad, 0 horizontal) divided by light through clean glass. NAN if the edition has no
 * value for the surroundings and the type of work. */
double pp_corrections_maintenance(enum pp_dirt edition,
                                  enum pp_surroundings surroundings, enum pp_work work,
                                  double slope_rad);

/* Sources of the editions: keys in docs/SOURCES.md, by enum pp_dirt. */
extern const char *const pp_corrections_editions[];

/* Factor D, 0 to 1, by which the deterioration of decorations reduces the internally
 * reflected component. */
double pp_corrections_decorations(enum pp_surroundings surroundings, enum pp_work work);

#endif
