/* study.c - implementation of pepperpot.h: studies, their points, and their columns. */
#include "api/study.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "methods/evaluate.h"
#include "model/room/building.h"
#include "model/room/position.h"
#include "model/room/room.h"
#include "model/room/room_light.h"
#include "simulate/scene/light_scene_of_world.h"
#include "studies/criteria/grid/plane_grid.h"

void pp_study_begin_report(struct pp_study *study)
{
    study->report = (struct pp_report){.world = study->room.world,
                                       .light = study->room.light,
                                       .options = &study->options.method_options,
                                       .receivers = study->room.receivers,
                                       .receiver_count = study->room.receiver_count,
                                       .finished = true};
}

static void forget_results(struct pp_study *study)
{
    pp_simulation_destroy(study->simulation);
    study->simulation = NULL;
    study->options.simulate = false;
    pp_report_clear(&study->report);
    if (study->has_assessment)
        pp_assessment_clear(&study->assessment);
    study->has_assessment = false;
}

/* Copies and resolves a room of the building; `sky`, if not NULL, replaces the room's
 * sky. */
static enum pp_status resolve_study_room(struct pp_study *study,
                                         struct pp_building *building, int index,
                                         const char *sky, struct pp_mistakes *mistakes,
                                         struct pp_error *err)
{
    struct pp_world *world = NULL;
    struct pp_outside_light light;
    study->file = strdup(mistakes->file);
    enum pp_status status = study->file ? PP_OK : pp_fail_memory(err);
    if (status == PP_OK)
        status =
            pp_room_copy(&study->description, pp_building_room(building, index), err);
    if (status == PP_OK && sky)
        status = pp_room_set_sky(study->description, sky, err);
    if (status == PP_OK)
        status = pp_world_create(&world, study->description, mistakes, err);
    if (status == PP_OK)
        status = pp_room_light(&light, study->description, err);
    if (status == PP_OK)
        pp_study_room_init(&study->room, study->file, building, index,
                           study->description, world, &light);
    else
        pp_world_destroy(world);
    return status;
}

enum pp_status pp_study_create(struct pp_study **study, struct pp_building *building,
                               int index, const char *sky, struct pp_mistakes *mistakes,
                               struct pp_error *err)
{
    *study = NULL;
    if (!building || index < 0 || index >= pp_building_room_count(building))
        return pp_fail(err, PP_BAD_INPUT, "there is no room %d", index);
    struct pp_study *made = calloc(1, sizeof *made);
    if (!made)
        return pp_fail_memory(err);
    enum pp_status status =
        resolve_study_room(made, building, index, sky, mistakes, err);
    if (status != PP_OK) {
        pp_study_destroy(made);
        return status;
    }
    made->options = PP_STUDY_OPTIONS_NONE;
    made->options.method_options.variants = &made->variants;
    pp_study_begin_report(made);
    *study = made;
    return PP_OK;
}

void pp_study_destroy(struct pp_study *study)
{
    if (!study)
        return;
    forget_results(study);
    pp_light_scene_destroy(study->scene);
    pp_study_room_clear(&study->room);
    pp_room_destroy(study->description);
    pp_variant_clear(&study->variants);
    free(study->file);
    free(study);
}

const char *pp_study_name(const struct pp_study *study)
{
    return study->room.world->name;
}

enum pp_status pp_study_set_sky(struct pp_study *study, const char *sky,
                                struct pp_error *err)
{
    struct pp_study_room *room = &study->room;
    struct pp_room *changed = NULL;
    enum pp_status status =
        pp_room_copy(&changed, pp_building_room(room->building, room->index), err);
    if (status == PP_OK && sky)
        status = pp_room_set_sky(changed, sky, err);
    if (status == PP_OK)
        status = pp_room_light(&room->light, changed, err);
    if (status == PP_OK) {
        pp_room_take_sky(study->description, changed);
        forget_results(study);
        pp_study_begin_report(study);
    }
    pp_room_destroy(changed);
    return status;
}

/* Replaces the study's points by the given points, which the study then owns. */
static void take_over_points(struct pp_study *study, struct pp_receiver *points,
                             int count, struct pp_grid_choice grid)
{
    forget_results(study);
    pp_study_room_set_points(&study->room, points, count);
    study->grid = grid;
    pp_study_begin_report(study);
}

enum pp_status pp_study_set_points(struct pp_study *study, const double (*points)[3],
                                   int count, struct pp_error *err)
{
    const struct pp_world *world = study->room.world;
    if (count < 1)
        return pp_fail(err, PP_BAD_INPUT, "there are %d points; expected one or more",
                       count);
    struct pp_receiver *receivers = calloc((size_t)count, sizeof *receivers);
    if (!receivers)
        return pp_fail_memory(err);
    for (int i = 0; i < count; i++) {
        struct pp_vec3 at = pp_vec(points[i][0], points[i][1], points[i][2]);
        if (pp_position_place_receiver(&receivers[i], world, at, err) != PP_OK) {
            free(receivers);
            return PP_BAD_INPUT;
        }
    }
    take_over_points(study, receivers, count, (struct pp_grid_choice){0});
    return PP_OK;
}

enum pp_status pp_study_set_grid(struct pp_study *study, struct pp_error *err)
{
    struct pp_plane_grid grid;
    enum pp_status status =
        pp_plane_grid_make(&grid, study->room.world, study->description, NULL, 0, err);
    if (status != PP_OK) {
        pp_plane_grid_clear(&grid);
        return status;
    }
    take_over_points(study, grid.receivers, grid.count,
                     (struct pp_grid_choice){.spacing_m = grid.spacing_m,
                                             .margin_m = grid.margin_m});
    free(grid.cells);
    return PP_OK;
}

int pp_study_point_count(const struct pp_study *study)
{
    return study->room.receiver_count;
}

void pp_study_point(const struct pp_study *study, int index, double xyz[3])
{
    struct pp_vec3 at = study->room.receivers[index].position;
    xyz[0] = at.x;
    xyz[1] = at.y;
    xyz[2] = at.z;
}

enum pp_status pp_study_methods(struct pp_study *study, const char *methods,
                                bool explain, struct pp_error *err)
{
    if (explain && study->room.receiver_count != 1)
        return pp_fail(err, PP_BAD_INPUT,
                       "explanations are available for one point only; the "
                       "room has %d",
                       study->room.receiver_count);
    study->report.explain = study->options.explain = explain;
    return pp_methods_evaluate(&study->report, methods, err);
}

void pp_study_stop_when(struct pp_study *study, bool (*came)(void *data), void *data)
{
    study->options.method_options.stop = (struct pp_stop){came, data};
}

enum pp_status pp_study_formula(struct pp_study *study, const char *formula,
                                struct pp_error *err)
{
    return pp_variant_add(&study->variants, formula, err);
}

struct pp_simulation_request pp_simulation_request_default(void)
{
    return (struct pp_simulation_request){.error = 0.01, .seed = 1};
}

enum pp_status pp_study_simulate(struct pp_study *study,
                                 const struct pp_simulation_request *request,
                                 struct pp_error *err)
{
    const struct pp_simulation_request usual = pp_simulation_request_default();
    const struct pp_simulation_request *wanted = request ? request : &usual;
    const char *name = wanted->engine ? wanted->engine : "path";
    const struct pp_engine *engine = pp_engine_find(name);
    if (!engine)
        return pp_fail(err, PP_BAD_INPUT, "there is no engine \"%.100s\"", name);
    if (!(wanted->error >= 0.0 && wanted->error <= 1.0) || wanted->samples < 0
        || wanted->threads < 0)
        return pp_fail(err, PP_BAD_INPUT,
                       "the error is %g, with %ld samples and %d threads; expected an "
                       "error from 0 to 1, and no negative numbers",
                       wanted->error, wanted->samples, wanted->threads);
    double error =
        wanted->error == 0.0 && wanted->samples == 0 ? usual.error : wanted->error;
    const struct pp_engine_options options = {.error = error,
                                              .samples = wanted->samples,
                                              .seed = wanted->seed,
                                              .threads = wanted->threads,
                                              .cache = pp_irradiance_cache_defaults()};
    struct pp_simulation *simulation;
    enum pp_status status = PP_OK;
    if (!study->scene)
        status = pp_light_scene_of_world_grey(&study->scene, study->room.world, err);
    if (status == PP_OK)
        status = pp_simulation_create_in(&simulation, engine, study->scene,
                                         &study->report, &options, err);
    if (status != PP_OK)
        return status;
    pp_simulation_destroy(study->simulation);
    study->simulation = simulation;
    study->options.simulate = true;
    study->options.error = error;
    study->options.samples = wanted->samples;
    study->options.seed = wanted->seed;
    study->options.threads = wanted->threads;
    study->report.finished = false;
    return PP_OK;
}

enum pp_status pp_study_advance(struct pp_study *study, double seconds,
                                struct pp_error *err)
{
    if (!study->simulation)
        return pp_fail(err, PP_BAD_INPUT, "no simulation was requested");
    enum pp_status status = pp_simulation_advance(study->simulation, seconds, err);
    if (status == PP_OK)
        status = pp_simulation_add_columns(study->simulation, &study->report, err);
    study->report.finished = status == PP_OK && pp_simulation_done(study->simulation);
    return status;
}

bool pp_study_done(const struct pp_study *study)
{
    return !study->simulation || pp_simulation_done(study->simulation);
}

double pp_study_progress(const struct pp_study *study)
{
    return study->simulation ? pp_simulation_progress(study->simulation) : 1.0;
}

double pp_study_error(const struct pp_study *study)
{
    return study->simulation ? pp_simulation_error(study->simulation) : NAN;
}

int pp_study_column_count(const struct pp_study *study)
{
    return study->report.column_count;
}

const char *pp_study_column_name(const struct pp_study *study, int column)
{
    return study->report.columns[column].name;
}

enum pp_component pp_study_column_component(const struct pp_study *study, int column)
{
    return study->report.columns[column].component;
}

int pp_study_find(const struct pp_study *study, enum pp_component component,
                  const char *name)
{
    const struct pp_column *column = pp_report_find(&study->report, component, name);
    return column ? (int)(column - study->report.columns) : -1;
}

struct pp_reading pp_study_reading(const struct pp_study *study, int column, int point)
{
    if (column < 0 || column >= study->report.column_count)
        return pp_reading_none("there is no such column");
    const struct pp_column *found = &study->report.columns[column];
    if (point < 0)
        return found->average;
    if (point >= study->report.receiver_count)
        return pp_reading_none("there is no such point");
    return found->points
               ? found->points[point]
               : pp_reading_none("the value is for the whole room, not for a point");
}
