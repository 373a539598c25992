/* glare_study.c - see glare_study.h. */
#include "studies/glare/glare_study.h"

#include <math.h>
#include <stdlib.h>

#include "model/base/thread_pool.h"
#include "model/room/build/device_states.h"
#include "simulate/scene/light_scene_of_world.h"
#include "studies/glare/dgp.h"
#include "studies/glare/glare_view.h"

/* Number of cells across the field of view. A moment has cells of about 1.1 degrees,
 * since its results are printed by opening; a year has cells of about 2.2 degrees. In
 * the views of the tests, cells of half the size change DGP by at most 0.001 and
 * 0.003. */
enum { SIDE_MOMENT = 128, SIDE_YEAR = 64, SURFACE_SAMPLES = 64 };

const struct pp_glare_options pp_glare_options_default = {
    .threshold_cd_m2 = 2000.0,
    .annual = {.hours = {8.0, 18.0, PP_ALL_DAYS},
               .illuminance_count = 1,
               .illuminances_lx = {300.0},
               .patches = 577,
               .seed = 1}};

struct glare_work {
    struct pp_glare_sheet *sheet;
    const struct pp_study_room *room;
    const struct pp_moment *moment;
    const struct pp_weather_year *year;
    const struct pp_glare_options *options;
    struct pp_light_scene *scene;
    struct pp_thread_pool *pool;
    struct pp_receiver *eyes;
    struct pp_perez_sky *skies; /* in the axes of the room */
    int sky_count;

    struct pp_glare_view view;      /* the view being processed */
    struct pp_annual_sheet surface; /* illuminances at the surfaces of that view */
    struct hour_result {
        double sum;
        bool sun;
        bool enough; /* false: memory is exhausted */
    } * results;     /* one for each sky */
};

/* ---- field of view and illuminances ---- */

static enum pp_status light_points(struct glare_work *work,
                                   struct pp_annual_sheet *sheet,
                                   const struct pp_receiver *points, int count,
                                   const struct pp_annual_options *options,
                                   struct pp_error *err)
{
    const struct pp_study_room *room = work->room;
    if (work->moment)
        return pp_moment_of_room(sheet, room->world, &room->light, points, count,
                                 work->moment, options, err);
    return pp_annual_of_room(sheet, room->world, &room->light, points, count, false,
                             work->year, options, err);
}

/* Greatest relative standard error of the illuminances at the eyes. */
static double worst_of(const struct pp_annual_sheet *sheet)
{
    double worst = 0.0;
    for (int v = 0; v < sheet->receiver_count; v++) {
        struct pp_annual_value lx = sheet->points[v].year_lxh;
        if (lx.value > 0.0)
            worst = fmax(worst, lx.std_error / lx.value);
    }
    return worst;
}

/* Simulates the illuminances at the eyes. A moment is simulated by paths under the true
 * sky and sun. For a single hour this is faster than sky patches and sun cells, and its
 * only error is noise. The number of paths, unless given, begins with 1024 and is
 * doubled until the target error or 16,384 paths are reached. */
static enum pp_status light_eyes(struct glare_work *work, struct pp_error *err)
{
    enum { PATHS = 1024, PATHS_MOST = 16384 };
    struct pp_annual_options options = work->options->annual;
    struct pp_annual_sheet *sheet = &work->sheet->annual;
    int count = work->sheet->view_count;
    if (!work->moment)
        return light_points(work, sheet, work->eyes, count, &options, err);
    bool by_error = options.samples == 0;
    double target = options.error > 0.0 ? options.error : 0.005;
    options.exact_sky = true;
    if (by_error)
        options.samples = PATHS;
    for (;;) {
        enum pp_status status =
            light_points(work, sheet, work->eyes, count, &options, err);
        if (status != PP_OK || !by_error || options.samples >= PATHS_MOST
            || !sheet->finished || worst_of(sheet) <= target)
            return status;
        options.samples *= 2;
        pp_annual_sheet_clear(sheet);
    }
}

/* Finds the field of view, and simulates the illuminances at the points on its
 * surfaces. */
static enum pp_status begin_view(struct glare_work *work, int index,
                                 struct pp_error *err)
{
    struct pp_annual_options options = work->options->annual;
    enum pp_status status = pp_glare_view_init(
        &work->view, work->scene, work->room->world, &work->room->light,
        &work->eyes[index], work->year ? SIDE_YEAR : SIDE_MOMENT, err);
    options.samples = SURFACE_SAMPLES;
    options.error = 0.0;
    options.strict = false; /* the weather was checked for the eyes */
    options.watch = (struct pp_watch){.begin = NULL};
    if (status == PP_OK && work->view.surface_count > 0)
        status = light_points(work, &work->surface, work->view.surfaces,
                              work->view.surface_count, &options, err);
    return status;
}

static void end_view(struct glare_work *work)
{
    pp_glare_view_clear(&work->view);
    pp_annual_sheet_clear(&work->surface);
    work->view = (struct pp_glare_view){.surface_count = 0};
}

/* Illuminances of the view's surfaces in one hour, without direct sun. */
static void rest_of_hour(const struct glare_work *work, int sky, float *rest)
{
    const struct pp_annual_sheet *sheet = &work->surface;
    for (int k = 0; k < work->view.surface_count; k++) {
        size_t at = (size_t)k * (size_t)work->sky_count + (size_t)sky;
        rest[k] = sheet->lx[at] - sheet->sun_lx[at];
    }
}

static float eye_lx(const struct glare_work *work, int view, int sky)
{
    return work->sheet->annual.lx[(size_t)view * (size_t)work->sky_count + (size_t)sky];
}

/* ---- a moment ---- */

static enum pp_status judge_moment(struct glare_work *work, int view,
                                   struct pp_error *err)
{
    struct pp_glare_moment *moment = &work->sheet->moments[view];
    int openings = work->room->world->opening_count;
    float rest[PP_GLARE_SURFACES_MOST];
    moment->part_count = openings + 1;
    moment->parts = calloc((size_t)openings + 1, sizeof *moment->parts);
    double *space = malloc(((size_t)work->view.work_count + 1) * sizeof *space);
    if (!moment->parts || !space) {
        free(space);
        return pp_fail_memory(err);
    }
    rest_of_hour(work, 0, rest);
    moment->sum = pp_glare_view_sources(&work->view, &work->skies[0], rest,
                                        work->options->threshold_cd_m2, moment->parts,
                                        openings, &moment->sun, space);
    free(space);
    moment->eye_lx = work->sheet->annual.points[view].year_lxh;
    double lx = moment->eye_lx.value, se = moment->eye_lx.std_error;
    moment->dgp.value = pp_dgp(lx, moment->sum);
    moment->dgp.std_error =
        fabs(pp_dgp(lx + se, moment->sum) - pp_dgp(fmax(lx - se, 0.0), moment->sum))
        / 2.0;
    return PP_OK;
}

/* ---- a year ---- */

static bool sum_hour(void *data, int worker, int sky)
{
    (void)worker;
    struct glare_work *work = data;
    int openings = work->room->world->opening_count;
    struct pp_glare_part *parts = malloc(((size_t)openings + 1) * sizeof *parts);
    double *space = malloc(((size_t)work->view.work_count + 1) * sizeof *space);
    struct pp_glare_sun sun;
    float rest[PP_GLARE_SURFACES_MOST];
    if (!parts || !space) {
        free(parts);
        free(space);
        return false;
    }
    rest_of_hour(work, sky, rest);
    work->results[sky] =
        (struct hour_result){pp_glare_view_sources(&work->view, &work->skies[sky], rest,
                                                   work->options->threshold_cd_m2,
                                                   parts, openings, &sun, space),
                             false, true};
    work->results[sky].sun = sun.visible;
    free(parts);
    free(space);
    return true;
}

/* A value of DGP, and the occupied time with that value. */
struct dgp_time {
    double dgp, hours;
};

static int falling(const void *a, const void *b)
{
    const struct dgp_time *x = a, *y = b;
    return (x->dgp < y->dgp) - (x->dgp > y->dgp);
}

/* DGP that is exceeded in `hours` of the occupied time. Sorts the list. */
static double dgp_exceeded(struct dgp_time *times, int count, double hours)
{
    double sum = 0.0;
    qsort(times, (size_t)count, sizeof *times, falling);
    for (int i = 0; i < count; i++) {
        sum += times[i].hours;
        if (sum > hours)
            return times[i].dgp;
    }
    return 0.0;
}

/* Occupied hours with DGP above each limit, if all illuminances at the eye are
 * multiplied by `factor`. */
static void hours_above(const struct glare_work *work, int view, double factor,
                        double hours[PP_GLARE_LIMITS])
{
    const struct pp_annual_sheet *annual = &work->sheet->annual;
    for (int i = 0; i < PP_GLARE_LIMITS; i++)
        hours[i] = 0.0;
    for (int h = 0; h < annual->hour_count; h++) {
        int sky = annual->hours[h].sky;
        if (sky < 0 || !(annual->hours[h].occupied_h > 0.0))
            continue;
        double dgp = pp_dgp(factor * eye_lx(work, view, sky), work->results[sky].sum);
        for (int i = 0; i < PP_GLARE_LIMITS; i++)
            if (dgp > pp_glare_sheet_limits[i])
                hours[i] += annual->hours[h].occupied_h;
    }
}

static enum pp_status judge_year(struct glare_work *work, int view,
                                 struct pp_error *err)
{
    const struct pp_annual_sheet *annual = &work->sheet->annual;
    struct pp_glare_year *year = &work->sheet->years[view];
    struct dgp_time *times = calloc((size_t)annual->hour_count + 1, sizeof *times);
    year->dgp = calloc((size_t)work->sky_count + 1, sizeof *year->dgp);
    year->most_hour = -1;
    for (int t = 0; t < work->sky_count; t++)
        work->results[t].enough = false;
    pp_thread_pool_run(work->pool, 0, work->sky_count, sum_hour, work);
    bool enough = times && year->dgp;
    for (int t = 0; t < work->sky_count && enough; t++) {
        enough = work->results[t].enough;
        year->dgp[t] = (float)pp_dgp(eye_lx(work, view, t), work->results[t].sum);
    }
    if (!enough) {
        free(times);
        return pp_fail_memory(err);
    }
    int count = 0;
    for (int h = 0; h < annual->hour_count; h++) {
        const struct pp_annual_hour *hour = &annual->hours[h];
        if (hour->sky < 0 || !(hour->occupied_h > 0.0))
            continue;
        times[count++] = (struct dgp_time){year->dgp[hour->sky], hour->occupied_h};
        if (work->results[hour->sky].sun)
            year->sun_h += hour->occupied_h;
        if (year->dgp[hour->sky] > year->most) {
            year->most = year->dgp[hour->sky];
            year->most_hour = h;
        }
    }
    year->exceeded_in_5 =
        dgp_exceeded(times, count, PP_GLARE_SHARE * annual->occupied_h);
    free(times);
    struct pp_annual_value light = annual->points[view].year_lxh;
    double step = light.value > 0.0 ? light.std_error / light.value : 0.0;
    double middle[PP_GLARE_LIMITS], low[PP_GLARE_LIMITS], high[PP_GLARE_LIMITS];
    hours_above(work, view, 1.0, middle);
    hours_above(work, view, 1.0 - step, low);
    hours_above(work, view, 1.0 + step, high);
    for (int i = 0; i < PP_GLARE_LIMITS; i++)
        year->above_h[i] =
            (struct pp_annual_value){middle[i], fabs(high[i] - low[i]) / 2.0};
    return PP_OK;
}

/* ---- moment and year ---- */

static enum pp_status prepare_glare(struct glare_work *work, struct pp_error *err)
{
    const struct pp_world *world = work->room->world;
    size_t views = (size_t)work->sheet->view_count;
    work->sky_count = work->moment ? 1 : work->year->sky_count;
    work->eyes = calloc(views, sizeof *work->eyes);
    work->skies = calloc((size_t)work->sky_count + 1, sizeof *work->skies);
    work->results = calloc((size_t)work->sky_count + 1, sizeof *work->results);
    if (work->moment)
        work->sheet->moments = calloc(views, sizeof *work->sheet->moments);
    else
        work->sheet->years = calloc(views, sizeof *work->sheet->years);
    if (!work->eyes || !work->skies || !work->results
        || !(work->sheet->moments || work->sheet->years))
        return pp_fail_memory(err);
    for (int t = 0; t < work->sky_count; t++)
        work->skies[t] = pp_weather_year_turned(work->moment ? &work->moment->sky
                                                             : &work->year->skies[t],
                                                world->north_rad);
    enum pp_status status =
        pp_thread_pool_create(&work->pool, work->options->annual.threads, err);
    if (status == PP_OK)
        status = pp_light_scene_of_world_matt(&work->scene, world, err);
    for (size_t v = 0; v < views; v++) {
        const struct pp_world_view *view = &work->sheet->views[v];
        work->eyes[v] = (struct pp_receiver){
            .position = view->eye, .normal = view->direction, .line = view->line};
    }
    return status;
}

static void clear_glare(struct glare_work *work)
{
    end_view(work);
    pp_light_scene_destroy(work->scene);
    pp_thread_pool_destroy(work->pool);
    free(work->eyes);
    free(work->skies);
    free(work->results);
}

int pp_glare_study_turning(const struct pp_world *world)
{
    for (int i = 0; i < world->opening_count; i++)
        if (pp_device_states_follows(&world->openings[i]))
            return i;
    return -1;
}

enum pp_status pp_glare_study_run(struct pp_glare_sheet *sheet,
                                  const struct pp_study_room *room,
                                  const struct pp_world_view *views, int view_count,
                                  const struct pp_moment *moment,
                                  const struct pp_weather_year *year,
                                  const struct pp_glare_options *options,
                                  struct pp_error *err)
{
    *sheet =
        (struct pp_glare_sheet){.world = room->world,
                                .views = views,
                                .view_count = view_count,
                                .threshold_cd_m2 = options->threshold_cd_m2,
                                .is_year = !moment,
                                .has_devices = pp_device_states_exist(room->world)};
    struct glare_work work = {.sheet = sheet,
                              .room = room,
                              .moment = moment,
                              .year = moment ? NULL : year,
                              .options = options};
    int turning = pp_glare_study_turning(room->world);
    if (!moment && turning >= 0)
        return pp_fail(err, PP_BAD_INPUT,
                       "the slats of %s %s follow the sun, and their glare over a year "
                       "is not calculated; expected slats with an angle, or --when",
                       pp_world_kind(room->world, room->world->openings[turning].line),
                       room->world->openings[turning].label);
    enum pp_status status = prepare_glare(&work, err);
    if (status == PP_OK)
        status = light_eyes(&work, err);
    const struct pp_watch *watch = &options->annual.watch;
    for (int v = 0; v < view_count && status == PP_OK && sheet->annual.finished; v++) {
        if (watch->look && !watch->look(watch->data, 0.0, NAN)) {
            sheet->annual.finished = false;
            break;
        }
        status = begin_view(&work, v, err);
        if (status == PP_OK)
            status = moment ? judge_moment(&work, v, err) : judge_year(&work, v, err);
        end_view(&work);
    }
    clear_glare(&work);
    sheet->annual.receivers = NULL; /* the receivers were the eyes, which are freed */
    return status;
}
