/* render_parts.h - the data of a render. Inside simulate/render/ only. */
#ifndef PP_SIMULATE_RENDER_RENDER_PARTS_H
#define PP_SIMULATE_RENDER_RENDER_PARTS_H

#include "simulate/estimate/planner.h"
#include "simulate/render/render.h"

enum { PP_RENDER_TILE = 16 }; /* width of a tile, pixels */

struct pp_render {
    const struct pp_light_scene *scene;
    const struct pp_environment *environment; /* NULL: scene from a description */
    struct pp_render_options options;         /* samples: a power of two */
    struct pp_planner *planner;
    struct pp_render_tile tile;        /* the current tile */
    enum pp_space eye_space;           /* space of all rays except those of a
                                        * parallel view */
    struct pp_picture picture, errors; /* errors: empty if not requested */
    int *tags;
    int tiles_across, tile_count;
    unsigned char *tile_done; /* 1: the tile is done */
    int done_count;
    struct pp_render_work resumed; /* work done before the checkpoint */
};

#endif
