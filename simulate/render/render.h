/* render.h - a picture of a scene: light along the rays of a camera, pixel by pixel.
 *
 * The caller holds the loop: create, then advance until done, looking at the picture
 * whenever it likes, then destroy. The picture grows tile by tile; a pixel hangs on the
 * scene, the options and its own place alone, so that it is the same, to the bit,
 * whatever the number of threads, the length of the slices and where it was resumed.
 *
 * A pixel is the mean over places in and about it, by its filter, stratified; each
 * place has one path of radiance.h. Light of a world is over Eh, as there.
 */
#ifndef PP_SIMULATE_RENDER_RENDER_H
#define PP_SIMULATE_RENDER_RENDER_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

#include "model/pictures/camera.h"
#include "model/pictures/picture.h"
#include "simulate/cache/irradiance_cache.h"
#include "simulate/transport/radiance.h"

/* How places are weighed about a pixel's middle. */
enum pp_pixel_filter {
    PP_FILTER_BOX,   /* all of the pixel alike */
    PP_FILTER_GAUSS, /* a standard deviation of half a pixel, to 1.5 pixels */
};

enum { PP_RENDER_SAMPLES_MOST = 1 << 16 };

struct pp_render_options {
    struct pp_camera camera;
    int width, height; /* pixels */
    bool irradiance;   /* of the surfaces that are seen, instead of their radiance; of a
                        * world with its allowance for decorations, as the tracer's */
    bool indoors;      /* of a parallel view: only from where it cuts the room */
    enum pp_pixel_filter filter;
    int samples; /* a pixel; the next power of two is taken */
    struct pp_radiance_options light;
    const struct pp_window_store *store; /* not owned; NULL: none */
    const struct pp_ambient *ambient;    /* not owned; NULL: none */
    uint64_t ambient_hash; /* a number that hangs on what the ambient store holds */
    uint64_t seed;
    int threads; /* 0: as many as the machine has processors */
};

struct pp_render;

/* ---- before it: overture.c ----
 *
 * Lets a cache grow until it has what the middles of all pixels ask for, so that the
 * picture reads between records and not beyond them; then it may be the ambient store.
 * A large picture is shown to it in parts, first each pixel of a coarser one, over and
 * over until nothing is missing: memory is that of one part. */
struct pp_overture;

/* cache and scene must live as long as it. part_pixels: about how many a part has; 0: a
 * million, which take some 170 MB. */
enum pp_status pp_overture_create(struct pp_overture **overture,
                                  struct pp_irradiance_cache *cache,
                                  const struct pp_light_scene *scene,
                                  const struct pp_render_options *options,
                                  int part_pixels, struct pp_error *err);
void pp_overture_destroy(struct pp_overture *overture); /* NULL is allowed */

/* Works for about `seconds`; the records don't hang on how often. */
enum pp_status pp_overture_advance(struct pp_overture *overture, double seconds,
                                   struct pp_error *err);
bool pp_overture_done(const struct pp_overture *overture);
double pp_overture_progress(const struct pp_overture *overture); /* 0 to 1 */

/* ---- the picture ---- */

/* A number that hangs on all records of a cache, for ambient_hash. */
uint64_t pp_render_cache_hash(const struct pp_irradiance_cache *cache);

/* scene, store and ambient must live as long as it. */
enum pp_status pp_render_create(struct pp_render **render,
                                const struct pp_light_scene *scene,
                                const struct pp_render_options *options,
                                struct pp_error *err);
void pp_render_destroy(struct pp_render *render); /* NULL is allowed */

/* Works for about `seconds` (by the clock; at least one tile a thread). */
void pp_render_advance(struct pp_render *render, double seconds);
bool pp_render_done(const struct pp_render *render);

/* Share of the tiles that are done. */
double pp_render_progress(const struct pp_render *render);

/* The picture so far, owned by the render; what is not done is black. A pixel where
 * there is nothing to show is NAN: outside a fisheye's circle, outside a room that is
 * cut, and, of irradiances, where most of it shows glass or sky. Of a pixel on the
 * circle's edge the part outside is black. */
const struct pp_picture *pp_render_picture(const struct pp_render *render);

/* The picture to keep, once it is done: *picture is the caller's to clear, and the
 * render's own is empty. */
void pp_render_take_picture(struct pp_render *render, struct pp_picture *picture);

/* Row by row, the tag (light_scene.h) of what each pixel's middle shows, glass
 * included; -1: nothing. */
const int *pp_render_tags(const struct pp_render *render);

struct pp_render_work {
    long long rays, leaks; /* leaks: rays that were lost through cracks */
};
struct pp_render_work pp_render_work(const struct pp_render *render);

/* Where in the picture, in pixels, the records of a cache are seen that were made for
 * what is seen: not through glass. *xy is the caller's to free. */
enum pp_status pp_render_cache_positions(const struct pp_render *render,
                                         const struct pp_irradiance_cache *cache,
                                         double (**xy)[2], int *count,
                                         struct pp_error *err);

/* ---- checkpoints: checkpoint.c ---- */

/* Writes what is done, to be taken up again, and the cache that it is read from (NULL:
 * none). What the stream makes of it is PP_SYSTEM. */
enum pp_status pp_checkpoint_save(const struct pp_render *render,
                                  const struct pp_irradiance_cache *cache, FILE *out,
                                  struct pp_error *err);

/* The cache in what pp_checkpoint_save wrote, for pp_cache_file_unpack: a part of
 * bytes; NULL and 0 where there is none. PP_BAD_INPUT as by pp_checkpoint_resume, but of
 * another scene or options. */
enum pp_status pp_checkpoint_cache(const unsigned char *bytes, size_t length,
                                   const char **cache, size_t *cache_length,
                                   struct pp_error *err);

/* Takes up what pp_checkpoint_save wrote of the same scene and options, whole or not at
 * all; PP_BAD_INPUT where it is of others, of another version, cut off or damaged. */
enum pp_status pp_checkpoint_resume(struct pp_render *render,
                                    const unsigned char *bytes, size_t length,
                                    struct pp_error *err);

#endif
