#include "cli/make_picture.h"

#include <math.h>
#include <string.h>

#include "cli/interrupt.h"
#include "cli/progress.h"
#include "cli/render_view.h"

/* A slice of the work, and the time between two checkpoints. */
static const double slice_s = 0.1;

/* Directions from one place of a pixel to one window. */
enum { DIRECTIONS_MOST = 4 };

static enum pp_status create(struct pp_made_picture *made, const struct pp_world *world,
                             const struct pp_render_choice *choice,
                             const struct pp_room_options *options,
                             struct pp_error *err)
{
    struct pp_render_options render = {
        .irradiance = choice->quantity.is != PP_LUMINANCE,
        .filter = choice->filter,
        .samples = choice->samples,
        .light = pp_radiance_defaults(),
        .seed = options->seed,
        .threads = options->threads,
    };
    render.light.bounces = choice->bounces;
    render.light.source_most = DIRECTIONS_MOST;
    enum pp_status status = pp_light_scene_of_world(&made->scene, world, err);
    struct pp_picture_size size;
    if (status == PP_OK)
        status = pp_render_view(&render.camera, &size, choice, made->scene, world, err);
    if (status == PP_OK)
        status = pp_window_store_create(&made->store, made->scene, options->seed,
                                        options->threads, err);
    if (status != PP_OK)
        return status;
    render.width = size.width;
    render.height = size.height;
    render.store = made->store;
    made->shown.camera = render.camera;
    return pp_render_create(&made->render, made->scene, &render, err);
}

static enum pp_status work(struct pp_made_picture *made, const struct pp_world *world,
                           const struct pp_room_options *options, struct pp_error *err)
{
    enum pp_status status = PP_OK;
    struct pp_progress progress;
    pp_progress_begin(&progress, world->name ? world->name : "picture", options->quiet);
    while (!pp_render_done(made->render) && status == PP_OK) {
        pp_render_advance(made->render, slice_s);
        pp_progress_show(&progress, pp_render_progress(made->render), NAN);
        if (pp_interrupt_came())
            status = pp_fail(err, PP_INTERRUPTED, "interrupted; there is no picture");
    }
    pp_progress_end(&progress);
    return status;
}

/* The picture, out of shares of Eh into its own units. */
static enum pp_status take_picture(struct pp_made_picture *made,
                                   const struct pp_world *world,
                                   const struct pp_render_choice *choice,
                                   const struct pp_room_options *options,
                                   struct pp_error *err)
{
    struct pp_shown *shown = &made->shown;
    const struct pp_picture *from = pp_render_picture(made->render);
    enum pp_status status =
        pp_picture_create(&shown->picture, from->width, from->height, err);
    if (status != PP_OK)
        return status;
    shown->quantity = choice->quantity.is;
    shown->world = world;
    shown->tags = pp_render_tags(made->render);
    shown->external_lux = options->external_lux;
    pp_camera_options(&shown->camera, shown->view, sizeof shown->view);
    pp_render_view_words(shown->words, sizeof shown->words, &shown->camera, world);
    double scale = shown->quantity == PP_DAYLIGHT_FACTOR
                       ? 1.0
                       : options->external_lux / PP_LUMENS_PER_WATT;
    size_t count = 3 * (size_t)from->width * (size_t)from->height;
    for (size_t i = 0; i < count; i++)
        shown->picture.rgb[i] = (float)(scale * from->rgb[i]);
    return PP_OK;
}

enum pp_status pp_make_picture(struct pp_made_picture *made,
                               const struct pp_world *world,
                               const struct pp_render_choice *choice,
                               const struct pp_room_options *options,
                               struct pp_error *err)
{
    *made = (struct pp_made_picture){0};
    pp_interrupt_watch();
    enum pp_status status = create(made, world, choice, options, err);
    if (status == PP_OK)
        status = work(made, world, options, err);
    if (status == PP_OK)
        status = take_picture(made, world, choice, options, err);
    return status;
}

void pp_made_picture_clear(struct pp_made_picture *made)
{
    pp_picture_clear(&made->shown.picture);
    pp_render_destroy(made->render);
    pp_window_store_destroy(made->store);
    pp_light_scene_destroy(made->scene);
    *made = (struct pp_made_picture){0};
}
