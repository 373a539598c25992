/* make_picture.c - renders in time slices, writes checkpoints, and stops when
 * interrupted. */
#include "cli/render/make_picture.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <unistd.h>

#include "cli/interrupt.h"
#include "cli/output.h"
#include "cli/progress.h"
#include "cli/render/render_view.h"
#include "model/light/photographs/sky_picture.h"
#include "model/base/clock.h"
#include "model/base/read_file.h"
#include "simulate/cache/cache_file.h"
#include "simulate/render/cache_warm_up.h"
#include "simulate/render/checkpoint.h"
#include "simulate/render/render_cache.h"
#include "simulate/scene/light_scene_of_world.h"
#include "simulate/transport/opening_store.h"

/* Duration of a time slice, and time between checkpoints (s). */
static const double slice_s = 0.1, checkpoint_s = 30.0;

/* Maximum number of directions from a pixel to one window, over all paths of the pixel.
 * Each path has at least one, so that a pixel with more paths has more directions. */
enum { DIRECTIONS = 16 };

/* Number of independent groups of a pixel's paths, used to estimate the standard error
 * of the pixel. */
enum { RANDOMISATIONS = 32 };

/* Maximum size of a checkpoint: 4 GiB. */
#define CHECKPOINT_MOST ((size_t)1 << 32)

/* Adds records to the cache until it contains those needed by all pixels of the
 * picture. */
static enum pp_status grow_picture_cache(struct pp_cache_warm_up *warm_up, bool quiet,
                                         struct pp_error *err)
{
    struct pp_progress progress;
    enum pp_status status = PP_OK;
    pp_progress_begin(&progress, "irradiance cache", quiet);
    while (status == PP_OK && !pp_cache_warm_up_done(warm_up)) {
        status = pp_cache_warm_up_advance(warm_up, slice_s, err);
        pp_progress_show(&progress, pp_cache_warm_up_progress(warm_up), NAN);
        /* An incomplete cache is not saved, because a run that continues from it would
         * give different results. */
        if (status == PP_OK && pp_interrupt_came() && !pp_cache_warm_up_done(warm_up))
            status = pp_fail(err, PP_INTERRUPTED,
                             "interrupted during the calculation of the irradiance "
                             "cache; there is no picture, and nothing was saved");
    }
    pp_progress_end(&progress);
    return status;
}

/* Reads the whole file. The caller frees *bytes, which is NULL if the file does not
 * exist. */
static enum pp_status read_checkpoint(const char *path, char **bytes, size_t *length,
                                      struct pp_error *err)
{
    *bytes = NULL;
    if (access(path, F_OK) != 0 && errno == ENOENT)
        return PP_OK;
    return pp_read_file(bytes, length, path, CHECKPOINT_MOST, err);
}

/* Adds the records of the checkpoint to the cache, if the file exists. */
static enum pp_status take_records(struct pp_irradiance_cache *cache, const char *path,
                                   struct pp_error *err)
{
    char *bytes;
    const char *records;
    size_t length, count;
    enum pp_status status = read_checkpoint(path, &bytes, &length, err);
    if (status != PP_OK || !bytes)
        return status;
    struct pp_error own = {0};
    status = pp_checkpoint_cache((const unsigned char *)bytes, length, &records, &count,
                                 &own);
    if (status != PP_OK)
        pp_fail(err, status, "%s: %s", path, own.message);
    else if (records
             && pp_cache_file_unpack(cache, records, count, path, &own) != PP_OK)
        status = pp_fail(
            err, PP_BAD_INPUT,
            "%s: the checkpoint belongs to another picture: its room or options differ",
            path);
    free(bytes);
    return status;
}

/* Fills the irradiance cache used for the picture. */
static enum pp_status fill_cache(struct pp_made_picture *made,
                                 struct pp_render_options *render,
                                 const struct pp_render_choice *choice,
                                 const struct pp_room_options *options,
                                 struct pp_error *err)
{
    struct pp_cache_warm_up *warm_up = NULL;
    enum pp_status status = pp_cache_choice_open(
        &made->cache, &choice->cache, made->scene, made->environment, made->store,
        &render->light, options->study.seed, options->study.threads, err);
    if (status == PP_OK && choice->checkpoint
        && pp_irradiance_cache_count(made->cache) == 0)
        status = take_records(made->cache, choice->checkpoint, err);
    if (status == PP_OK)
        status =
            pp_cache_warm_up_create(&warm_up, made->cache, made->scene, render, 0, err);
    if (status == PP_OK)
        status = grow_picture_cache(warm_up, options->quiet, err);
    pp_cache_warm_up_destroy(warm_up);
    if (status == PP_OK)
        status = pp_cache_choice_save(&choice->cache, made->cache, err);
    if (status != PP_OK)
        return status;
    render->ambient = pp_irradiance_cache_ambient(made->cache);
    render->ambient_hash = pp_render_cache_hash(made->cache);
    return PP_OK;
}

/* Number of randomisations: at most RANDOMISATIONS and at most the number of paths; 0
 * if no standard errors are requested. */
static int randomisations(const struct pp_render_choice *choice)
{
    if (!choice->errors)
        return 0;
    return choice->samples < RANDOMISATIONS ? choice->samples : RANDOMISATIONS;
}

static enum pp_status create_render(struct pp_made_picture *made,
                                    const struct pp_world *world,
                                    const struct pp_outside_light *light,
                                    const struct pp_render_choice *choice,
                                    const struct pp_room_options *options,
                                    struct pp_error *err)
{
    struct pp_render_options render = {
        .irradiance = choice->quantity.is != PP_LUMINANCE,
        .indoors = choice->view == PP_CHOOSE_PLAN || choice->view == PP_CHOOSE_SECTION,
        .filter = choice->filter,
        .samples = choice->samples,
        .randomisations = randomisations(choice),
        .plain = options->study.method_options.plain,
        .light = pp_radiance_state_defaults(),
        .seed = options->study.seed,
        .threads = options->study.threads,
    };
    render.light.windows = choice->windows != PP_WINDOWS_CHANCE;
    render.light.stored = choice->windows == PP_WINDOWS_STORED;
    if (choice->paths)
        render.light.bounces = choice->cache.options.bounces;
    enum pp_status status =
        pp_light_scene_of_world_sunlit(&made->scene, world, &light->sun, err);
    if (status == PP_OK)
        status = pp_light_scene_under(&made->environment, made->scene, light, err);
    struct pp_picture_size size;
    if (status == PP_OK)
        status = pp_render_view(&render.camera, &size, choice, made->scene, world, err);
    if (status == PP_OK && render.light.stored && !render.plain)
        status =
            pp_opening_store_create(&made->store, made->scene, made->environment,
                                    options->study.seed, options->study.threads, err);
    if (status != PP_OK)
        return status;
    render.width = size.width;
    render.height = size.height;
    render.store = made->store;
    made->shown.camera = render.camera;
    if (!choice->paths && !render.plain)
        status = fill_cache(made, &render, choice, options, err);
    if (status != PP_OK)
        return status;
    render.light.source_most =
        choice->samples < DIRECTIONS ? DIRECTIONS / choice->samples : 1;
    return pp_render_create(&made->render, made->scene, made->environment, &render,
                            err);
}

/* ---- checkpoints ---- */

/* Continues from the checkpoint file, if it exists. */
static enum pp_status resume(struct pp_made_picture *made, const char *path,
                             struct pp_error *err)
{
    char *bytes;
    size_t length;
    enum pp_status status = read_checkpoint(path, &bytes, &length, err);
    if (status != PP_OK || !bytes)
        return status;
    struct pp_error own = {0};
    status =
        pp_checkpoint_resume(made->render, (const unsigned char *)bytes, length, &own);
    free(bytes);
    return status == PP_OK ? PP_OK : pp_fail(err, status, "%s: %s", path, own.message);
}

static enum pp_status save(const struct pp_made_picture *made, const char *path,
                           struct pp_error *err)
{
    struct pp_output output;
    enum pp_status status = pp_output_open(&output, path, err);
    if (status == PP_OK)
        status = pp_checkpoint_save(made->render, made->cache, output.stream, err);
    return pp_output_close(&output, status, err);
}

/* Handles an interrupt. Saves the finished part if a checkpoint file is named. Returns
 * PP_INTERRUPTED, or another error if saving fails. */
static enum pp_status interrupted(const struct pp_made_picture *made, const char *path,
                                  struct pp_error *err)
{
    if (!path)
        return pp_fail(err, PP_INTERRUPTED,
                       "interrupted; there is no picture (use --checkpoint FILE to "
                       "save the work)");
    enum pp_status status = save(made, path, err);
    if (status != PP_OK)
        return status;
    return pp_fail(err, PP_INTERRUPTED,
                   "interrupted; %s contains %.0f %% of the work, and the same command "
                   "continues from there",
                   path, floor(100.0 * pp_render_progress(made->render)));
}

/* ---- the work ---- */

static enum pp_status render_picture(struct pp_made_picture *made,
                                     const struct pp_world *world,
                                     const char *checkpoint, bool quiet,
                                     struct pp_error *err)
{
    struct pp_progress progress;
    enum pp_status status = checkpoint ? resume(made, checkpoint, err) : PP_OK;
    double saved_s = pp_clock_s(), before = pp_render_progress(made->render);
    bool all_there = pp_render_done(made->render);
    pp_progress_begin(&progress, world->name ? world->name : "picture", quiet);
    pp_progress_resume(&progress, before);
    while (status == PP_OK && !pp_render_done(made->render)) {
        status = pp_render_advance(made->render, slice_s, err);
        pp_progress_show(&progress, pp_render_progress(made->render), NAN);
        if (pp_interrupt_came() && !pp_render_done(made->render)) {
            pp_progress_end(&progress);
            return interrupted(made, checkpoint, err);
        }
        if (checkpoint && pp_clock_s() - saved_s > checkpoint_s) {
            status = save(made, checkpoint, err);
            saved_s = pp_clock_s();
        }
    }
    pp_progress_end(&progress);
    if (status == PP_OK && checkpoint && !all_there)
        status = save(made, checkpoint, err);
    return status;
}

static void scale_picture(struct pp_picture *picture, double scale)
{
    size_t count = 3 * (size_t)picture->width * (size_t)picture->height;
    for (size_t i = 0; i < count; i++)
        picture->rgb[i] = (float)(scale * picture->rgb[i]);
}

/* Horizontal illuminance outside (lx): the value given by the user, or that of the
 * photographed sky, or 10,000 lx. */
static double external_of(const struct pp_room_options *options,
                          const struct pp_sky *sky)
{
    if (options->study.external_lux > 0.0)
        return options->study.external_lux;
    return sky->kind == PP_SKY_PICTURE ? sky->picture->horizontal_lx : 1e4;
}

/* Converts the picture and its errors from fractions of the external illuminance to the
 * units of their quantity. */
static enum pp_status take_picture(struct pp_made_picture *made,
                                   const struct pp_world *world,
                                   const struct pp_outside_light *light,
                                   const struct pp_render_choice *choice,
                                   const struct pp_room_options *options,
                                   struct pp_error *err)
{
    struct pp_shown_picture *shown = &made->shown;
    enum pp_status status = PP_OK;
    pp_render_take_picture(made->render, &shown->picture, &made->errors);
    shown->quantity = choice->quantity.is;
    shown->world = world;
    shown->light = light;
    shown->tags = pp_render_tags(made->render);
    shown->external_lux = external_of(options, &light->sky);
    pp_camera_options(&shown->camera, shown->view, sizeof shown->view);
    pp_render_view_words(shown->words, sizeof shown->words, &shown->camera, world);
    if (choice->records) {
        status = pp_render_cache_positions(made->render, made->cache, &made->marks,
                                           &shown->mark_count, err);
        shown->marks = made->marks;
    }
    double scale = shown->quantity == PP_DAYLIGHT_FACTOR
                       ? 1.0
                       : shown->external_lux / PP_LUMENS_PER_WATT;
    scale_picture(&shown->picture, scale);
    scale_picture(&made->errors, scale);
    return status;
}

enum pp_status pp_make_picture(struct pp_made_picture *made,
                               const struct pp_world *world,
                               const struct pp_outside_light *light,
                               const struct pp_render_choice *choice,
                               const struct pp_room_options *options,
                               struct pp_error *err)
{
    *made = (struct pp_made_picture){0};
    pp_interrupt_watch();
    enum pp_status status = create_render(made, world, light, choice, options, err);
    if (status == PP_OK)
        status = render_picture(made, world, choice->checkpoint, options->quiet, err);
    if (status == PP_OK)
        status = take_picture(made, world, light, choice, options, err);
    return status;
}

void pp_make_picture_clear(struct pp_made_picture *made)
{
    pp_picture_clear(&made->shown.picture);
    pp_picture_clear(&made->errors);
    pp_render_destroy(made->render);
    pp_irradiance_cache_destroy(made->cache);
    free(made->marks);
    pp_opening_store_destroy(made->store);
    pp_environment_destroy(made->environment);
    pp_light_scene_destroy(made->scene);
    *made = (struct pp_made_picture){0};
}
