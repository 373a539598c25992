/* render_parts.h - a render from within: for cmd_render.c and checkpoint.c. */
#ifndef PP_SIMULATE_RENDER_RENDER_PARTS_H
#define PP_SIMULATE_RENDER_RENDER_PARTS_H

#include "simulate/render/render.h"

enum { PP_RENDER_TILE = 16 }; /* pixels along its side */

struct pp_render {
    const struct pp_light_scene *scene;
    struct pp_render_options options; /* samples: a power of two; threads: 1 or more */
    struct pp_sobol sobol;
    enum pp_space eye_space; /* of all rays but those of a parallel view */
    struct pp_picture picture;
    int *tags;
    int tiles_across, tile_count;
    unsigned char *tile_done; /* 1: it is */
    int done_count;
    struct pp_render_work work;
};

/* The pixels of a tile: x0 <= x < x1, y0 <= y < y1. */
struct pp_render_tile {
    int x0, y0, x1, y1;
};
struct pp_render_tile pp_render_tile(const struct pp_render *render, int tile);

/* The camera's ray at a place in the picture, in pixels; false where it has none. */
bool pp_render_camera_ray(const struct pp_render *render, const double place[2],
                          struct pp_light_ray *ray);

/* What the deterioration of the room's decorations leaves of what is reflected inside:
 * of irradiances; radiances are those of surfaces as their finishes say, and have 1. */
double pp_render_decorations(const struct pp_render *render);

/* A number that hangs on all that the pixels hang on. */
uint64_t pp_checkpoint_hash(const struct pp_render *render);

#endif
