/* assess_run.c - see assess_run.h. */
#include "cli/assess/assess_run.h"

#include <math.h>
#include <stdlib.h>

#include "cli/availability/availability_options.h"
#include "cli/interrupt.h"
#include "cli/job.h"
#include "cli/message.h"
#include "cli/ranks/room_queue.h"
#include "cli/watch.h"
#include "model/base/read_file.h"
#include "studies/criteria/facade_sensitivity.h"
#include "studies/criteria/grid/plane_trace.h"

static struct pp_room_figures assessed_room_figures(void *data, int room)
{
    struct pp_assessment *one = &((struct pp_assess_run *)data)->all.list[room];
    return (struct pp_room_figures){&one->report, &one->by_clock};
}

/* Simulates a room. Part of the time limit is reserved for simulating the room with a
 * larger facade (facade_sensitivity.h). */
static enum pp_status simulate_room(const void *data, int room,
                                    struct pp_report *report, bool *by_clock,
                                    struct pp_error *err)
{
    const struct pp_assess_run *run = data;
    struct pp_study_options own = run->words->room.study;
    own.seconds *= 1.0 - PP_FACADE_SENSITIVITY_SHARE;
    return run->all.list[room].has_factors ? pp_plane_trace(
               report, &own, run->all.list[room].has_average, by_clock, err)
                                           : PP_OK;
}

enum pp_status pp_assess_run_compute(void *data, struct pp_error *err)
{
    struct pp_assess_run *run = data;
    struct pp_assessments *all = &run->all;
    const struct pp_rooms *rooms = run->rooms;
    const struct pp_rooms_before then = {run->before->list, run->before->count,
                                         !run->words->before};
    const struct pp_rooms_before mirrored = {run->mirrored->list, run->mirrored->count,
                                             true};
    const struct pp_rooms_before cumulative = {run->cumulative->list,
                                               run->cumulative->count, true};
    const struct pp_study_options *study = &run->words->room.study;
    const struct pp_assess_options wanted = {
        .study = study,
        .criteria = run->words->criteria,
        .profile = run->words->profile,
        .rules = run->words->has_rules ? &run->words->rules : NULL,
        .withdrawn = run->words->withdrawn,
        .place = run->words->place,
        .median_lux = run->words->median_lux,
        .french_m = run->words->french_m,
        .grid = run->words->grid,
        .least_altitude_rad = run->words->least_altitude_rad,
        .shortest_h = run->words->shortest_h,
        .trace_again = study->simulate,
        .of_averages = run->words->of_averages,
        .verdicts_only =
            run->words->gains_rooms > 0 && rooms->count > run->words->gains_rooms,
        .mirrored = &mirrored,
        .cumulative = &cumulative,
        .with_year = run->words->with_year,
        .year = run->words->year.count > 0 ? &run->words->year : NULL,
        .sunshine = run->words->sunshine.known ? &run->words->sunshine : NULL,
        .of_weather = run->words->weather != NULL};
    enum pp_status status = PP_OK;
    all->list = calloc((size_t)rooms->count + 1, sizeof *all->list);
    if (!all->list)
        return pp_fail_memory(err);
    for (int i = 0; i < rooms->count && status == PP_OK; i++)
        status = pp_assessment_begin(&all->list[all->count++], &rooms->list[i],
                                     rooms->count, &then, &wanted, err);
    if (status == PP_OK && study->simulate)
        pp_interrupt_watch();
    if (status == PP_OK)
        status = pp_room_queue_run(
            &(struct pp_room_queue){study->simulate ? all->count : 0,
                                    run->words->room.ranks, assessed_room_figures,
                                    simulate_room, run},
            err);
    for (int i = 0; i < all->count && status == PP_OK; i++) {
        struct pp_assessment *one = &all->list[i];
        status = pp_assessment_judge(one, &wanted, err);
        if (status == PP_OK)
            status = pp_facade_sensitivity_check(one, &wanted, err);
    }
    return status;
}

bool pp_assess_run_is_finished(const void *data)
{
    const struct pp_assess_run *run = data;
    for (int i = 0; i < run->all.count; i++)
        if (!run->all.list[i].report.finished)
            return false;
    return true;
}

struct pp_assess_run pp_assess_run_of(const struct pp_assess_words *words,
                                      const struct pp_assess_rooms *rooms)
{
    return (struct pp_assess_run){
        .words = words,
        .rooms = &rooms->rooms,
        .before = &rooms->before,
        .mirrored = &rooms->mirrored,
        .cumulative = &rooms->cumulative,
        .all = {.several = rooms->rooms.several,
                .more_than_one_file = rooms->rooms.more_than_one_file,
                .options = &words->room.study}};
}

void pp_assess_run_clear(struct pp_assess_run *run)
{
    for (int i = 0; i < run->all.count; i++)
        pp_assessment_clear(&run->all.list[i]);
    free(run->all.list);
}

static enum pp_status refuse_alone(const struct pp_criterion *criterion,
                                   struct pp_error *err)
{
    if (criterion->needs_mirror_image)
        return pp_fail(err, PP_BAD_INPUT,
                       "%s compares the site with the building's mirror image; "
                       "expected --mirror-image X1,Y1,X2,Y2, the boundary line",
                       criterion->name);
    return pp_fail(err, PP_BAD_INPUT,
                   "%s compares the room before and after the development; expected "
                   "--before FILE, or a file with existing and proposed states",
                   criterion->name);
}

/* Checks that the former state and the mirror image are given if a selected criterion
 * needs them. */
static enum pp_exit check_compared(const struct pp_assess_words *words,
                                   const char *command, bool has_before)
{
    bool chosen[PP_CRITERIA_MOST];
    struct pp_error err;
    const struct pp_criterion *criterion;
    if (!words->criteria
        || pp_assessment_choose(chosen, words->criteria, &err) != PP_OK)
        return PP_EXIT_DONE;
    for (int i = 0; (criterion = pp_criteria_at(i)) != NULL; i++)
        if (chosen[i]
            && ((criterion->needs_before && !has_before)
                || (criterion->needs_mirror_image && !words->mirror_image.given))) {
            refuse_alone(criterion, &err);
            return pp_message_usage(command, &err);
        }
    return PP_EXIT_DONE;
}

enum pp_exit pp_assess_run_load(struct pp_assess_rooms *all,
                                struct pp_assess_words *words, const char *command,
                                char **files, int file_count)
{
    enum pp_exit exit_status =
        pp_rooms_load(&all->rooms, command, files, file_count, &words->room);
    if (exit_status != PP_EXIT_DONE)
        return exit_status;
    if (words->before) {
        struct pp_room_options all_rooms = words->room;
        all_rooms.room = NULL;
        all_rooms.sweep.now.lenient = true;
        char *file[] = {(char *)words->before};
        exit_status = pp_rooms_load(&all->before, command, file, 1, &all_rooms);
    } else if (words->room.state == PP_STATE_BOTH) {
        exit_status = pp_rooms_load_state(&all->before, command, &all->rooms,
                                          &words->room, PP_STATE_EXISTING);
        if (exit_status == PP_EXIT_DONE)
            exit_status = pp_rooms_load_state(&all->cumulative, command, &all->rooms,
                                              &words->room, PP_STATE_CUMULATIVE);
    }
    if (exit_status == PP_EXIT_DONE)
        exit_status = check_compared(words, command, all->before.count > 0);
    if (exit_status == PP_EXIT_DONE && words->mirror_image.given)
        exit_status = pp_rooms_load_mirrored(&all->mirrored, command, &all->rooms,
                                             &words->room, &words->mirror_image.line);
    return exit_status;
}

void pp_assess_run_unload(struct pp_assess_rooms *all)
{
    pp_rooms_clear(&all->mirrored);
    pp_rooms_clear(&all->cumulative);
    pp_rooms_clear(&all->before);
    pp_rooms_clear(&all->rooms);
}

enum pp_exit pp_assess_run_weather(struct pp_assess_words *words)
{
    struct pp_error err = {0};
    if (!words->weather)
        return PP_EXIT_DONE;
    words->light.weather = words->weather;
    enum pp_exit result =
        pp_availability_options_load(&words->light, words->room.study.strict);
    if (result == PP_EXIT_DONE)
        result = pp_availability_options_median(&words->light, &words->median_lux,
                                                &words->sunshine);
    if (result != PP_EXIT_DONE || !pp_assess_words_use_year(words))
        return result;
    const struct pp_weather_options weather = {.sun_shift_h = NAN};
    enum pp_status status =
        pp_weather_year_of_epw(&words->year, words->light.epw, &weather,
                               pp_read_file_title(words->weather), &err);
    return status == PP_OK ? PP_EXIT_DONE : pp_message_error(&err);
}

enum pp_exit pp_assess_run(struct pp_assess_words *words, const char *command,
                           char **files, int file_count,
                           enum pp_status (*print)(const void *data, FILE *out,
                                                   struct pp_error *err))
{
    struct pp_terminal_watch watch;
    struct pp_assess_rooms rooms = {0};
    enum pp_exit exit_status = pp_assess_run_weather(words);
    if (exit_status == PP_EXIT_DONE)
        exit_status = pp_assess_run_load(&rooms, words, command, files, file_count);
    words->room.study.watch = pp_watch_of_terminal(&watch, words->room.quiet);
    struct pp_assess_run run = pp_assess_run_of(words, &rooms);
    if (exit_status == PP_EXIT_DONE)
        exit_status =
            pp_job_run(&(struct pp_job){words->room.output, pp_assess_run_compute,
                                        print, pp_assess_run_is_finished, &run});
    pp_assess_run_clear(&run);
    pp_assess_run_unload(&rooms);
    return exit_status;
}
