/* render.h - a picture of a scene: light along the rays of a camera, pixel by pixel.
 *
 * The caller runs the loop: create, advance until done, with the picture available at
 * any time, then destroy. The picture grows tile by tile. A pixel depends only on the
 * scene, the options and its position. It is bit-identical for any number of threads,
 * duration of the calls and point of resumption.
 *
 * A pixel is the mean over stratified positions in and around it, weighted by the
 * filter; each position has one path of radiance.h. Light of a world is over Eh, as in
 * radiance.h.
 */
#ifndef PP_SIMULATE_RENDER_RENDER_H
#define PP_SIMULATE_RENDER_RENDER_H

#include <stdbool.h>
#include <stdint.h>

#include "model/pictures/camera.h"
#include "model/pictures/picture.h"
#include "simulate/cache/irradiance_cache.h"
#include "simulate/transport/radiance.h"

/* The reconstruction filter: the weight of positions relative to a pixel's middle. */
enum pp_pixel_filter {
    PP_FILTER_BOX,   /* uniform over the pixel */
    PP_FILTER_GAUSS, /* a standard deviation of half a pixel, to 1.5 pixels */
};

enum { PP_RENDER_SAMPLES_MOST = 1 << 16, PP_RENDER_RANDOMISATIONS_LEAST = 4 };

struct pp_render_options {
    struct pp_camera camera;
    int width, height; /* pixels */
    bool irradiance;   /* irradiance of the visible surfaces instead of their
                        * radiance; for a world with its allowance for decorations,
                        * as in the tracer */
    bool indoors;      /* for a parallel view: begins at the cut through the room */
    enum pp_pixel_filter filter;
    int samples;        /* per pixel, rounded up to a power of two */
    int randomisations; /* number of randomisations among which samples are divided, to
                         * give each pixel a standard error: a power of two, at least 4;
                         * 0: one, with least noise and no standard error */
    bool plain;         /* by plain path tracing (simulate/path_tracer/): `light`, store
                         * and ambient are not used */
    struct pp_radiance_options light;
    const struct pp_opening_store *store; /* not owned; NULL: none */
    const struct pp_ambient *ambient;     /* not owned; NULL: none */
    uint64_t ambient_hash;                /* hash of the contents of the ambient
                                           * store */
    uint64_t seed;
    int threads; /* 0: one for each processor */
};

struct pp_render;

/* scene, environment (of a world; NULL: of a description), store and ambient must
 * outlive the render. */
enum pp_status pp_render_create(struct pp_render **render,
                                const struct pp_light_scene *scene,
                                const struct pp_environment *environment,
                                const struct pp_render_options *options,
                                struct pp_error *err);
void pp_render_destroy(struct pp_render *render); /* NULL is allowed */

/* Calculates for about `seconds` (by the clock; at least one tile). */
enum pp_status pp_render_advance(struct pp_render *render, double seconds,
                                 struct pp_error *err);
bool pp_render_done(const struct pp_render *render);

/* Fraction of the tiles that are done, 0 to 1. */
double pp_render_progress(const struct pp_render *render);

/* The picture so far, owned by the render; unfinished parts are black. A pixel without
 * a value is NAN: outside the circle of a fisheye view, outside a room that is shown
 * cut, and, in pictures of irradiance, where most of the pixel shows glass or sky. For
 * a pixel on the edge of the circle, light from outside the circle counts as black. */
const struct pp_picture *pp_render_picture(const struct pp_render *render);

/* Standard errors of the picture's pixels, by channel; NULL if there are none. Errors
 * of a cache are not included. */
const struct pp_picture *pp_render_errors(const struct pp_render *render);

/* Moves the finished picture and its errors (empty if not requested) to the caller, who
 * must clear them. Afterwards the render has an empty picture. */
void pp_render_take_picture(struct pp_render *render, struct pp_picture *picture,
                            struct pp_picture *errors);

/* Tag (light_scene.h) of the object at each pixel's middle, glass included, row by row;
 * -1: nothing. */
const int *pp_render_tags(const struct pp_render *render);

struct pp_render_work {
    long long rays, leaks; /* leaks: rays lost in gaps between two surfaces */
};
struct pp_render_work pp_render_work(const struct pp_render *render);

/* ---- for the other files of simulate/render/ ---- */

/* The pixels of a tile: x0 <= x < x1, y0 <= y < y1. */
struct pp_render_tile {
    int x0, y0, x1, y1;
};
struct pp_render_tile pp_render_tile(const struct pp_render *render, int tile);

/* The camera's ray through a position in the picture (pixels); false if the camera has
 * no ray there. */
bool pp_render_camera_ray(const struct pp_render *render, const double place[2],
                          struct pp_light_ray *ray);

/* Allowance for the deterioration of the room's decorations: a factor for the
 * internally reflected light of irradiances. 1 for radiances, which always apply to
 * surfaces with their stated finishes. */
double pp_render_decorations(const struct pp_render *render);

#endif
