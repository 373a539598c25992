/* hand_year.c - see hand_year.h. */
#include "studies/year/hand/hand_year.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/thread_pool.h"
#include "model/results/sheets/point_areas.h"
#include "model/room/build/device_states.h"
#include "studies/study_report.h"
#include "studies/year/hand/hand_figures.h"
#include "studies/year/hand/hand_range.h"

/* One method of a run. */
struct hand_entry {
    const struct pp_year_method *method;
    void *tools;
    struct pp_formulary *formulary;
};

struct hand_run {
    struct pp_hand_year_sheet *sheet;
    const struct pp_study_room *room;
    const struct pp_annual_options *annual;
    const struct pp_hand_year_options *options;
    struct pp_year_clock clock;
    struct pp_hand_case of;
    struct hand_entry entries[PP_YEAR_METHODS_MOST];
};

static enum pp_status prepare_methods(struct hand_run *run, struct pp_error *err)
{
    const struct pp_year_methods_choice *choice = &run->options->methods;
    struct pp_hand_year_sheet *sheet = run->sheet;
    enum pp_status status = PP_OK;
    sheet->receiver_count = run->room->receiver_count;
    sheet->columns = calloc((size_t)choice->count + 1, sizeof *sheet->columns);
    if (!sheet->columns)
        return pp_fail_memory(err);
    for (int i = 0; i < choice->count && status == PP_OK; i++) {
        const struct pp_year_method *method = choice->list[i];
        struct hand_entry *entry = &run->entries[i];
        struct pp_hand_column *column = &sheet->columns[sheet->column_count++];
        entry->method = method;
        *column = (struct pp_hand_column){
            .name = method->name,
            .summary = method->summary,
            .source = method->source,
            .assumptions = method->assumptions,
            .why = method->refuses ? method->refuses(&run->of) : NULL,
            .points = calloc((size_t)sheet->receiver_count + 1, sizeof *column->points),
            .ranges = calloc((size_t)sheet->receiver_count + 1, sizeof *column->ranges),
            .mean = pp_hand_figures_none()};
        if (!column->points || !column->ranges)
            return pp_fail_memory(err);
        if (!column->why && method->prepare)
            status = method->prepare(&entry->tools, &run->of, err);
        if (status == PP_OK)
            status =
                pp_formulary_create(&entry->formulary, method->formulae, NULL, err);
    }
    return status;
}

/* Sets the daylight factors by the user's selection of hand methods. */
static enum pp_status df_by_hand(struct hand_run *run, struct pp_error *err)
{
    struct pp_study_room overcast = *run->room;
    overcast.light.sky = pp_sky_overcast();
    struct pp_study_options study = PP_STUDY_OPTIONS_NONE;
    study.methods = run->options->df;
    study.threads = run->annual->threads;
    struct pp_report report = {.world = NULL};
    const struct pp_column *found = NULL;
    int count = 0;
    enum pp_status status = pp_study_report_methods(&report, &overcast, &study, err);
    for (int i = 0; i < report.column_count && status == PP_OK; i++) {
        const struct pp_column *column = &report.columns[i];
        if (column->component == PP_DF && column->points) {
            found = column;
            count++;
        }
    }
    if (status == PP_OK && count != 1)
        status = pp_fail(err, PP_BAD_INPUT,
                         "--df %s gives %d daylight factors for each point; expected "
                         "one, such as exact+bre",
                         run->options->df, count);
    if (status == PP_OK) {
        for (int x = 0; x < run->room->receiver_count && status == PP_OK; x++) {
            run->of.df[x] = found->points[x].value;
            if (isnan(run->of.df[x]))
                status = pp_fail(
                    err, PP_BAD_INPUT,
                    "--df %s gives no daylight factor: %s; expected another "
                    "method",
                    run->options->df,
                    found->points[x].why ? found->points[x].why : "no reason known");
        }
        snprintf(run->sheet->words, sizeof run->sheet->words,
                 "daylight factors by %s under the CIE overcast sky", found->name);
    }
    pp_report_clear(&report);
    return status;
}

static enum pp_status find_df(struct hand_run *run, struct pp_error *err)
{
    int count = run->room->receiver_count;
    run->of.df = calloc((size_t)count + 1, sizeof *run->of.df);
    run->sheet->df = calloc((size_t)count + 1, sizeof *run->sheet->df);
    if (!run->of.df || !run->sheet->df)
        return pp_fail_memory(err);
    for (int x = 0; x < count; x++)
        run->of.df[x] = pp_reference_skies_factor(&run->of.skies, x, run->of.overcast);
    snprintf(
        run->sheet->words, sizeof run->sheet->words,
        "daylight factors simulated under the CIE overcast sky%s with the paths of "
        "the year",
        run->options->overcast == PP_STANDARD_ISO_1 ? " (ISO 15469 type 1)" : "");
    enum pp_status status = run->options->df ? df_by_hand(run, err) : PP_OK;
    size_t used = strlen(run->sheet->words);
    if (run->of.skies.count > 1)
        snprintf(run->sheet->words + used, sizeof run->sheet->words - used,
                 "; factors under %d other skies and suns simulated with the same "
                 "paths",
                 run->of.skies.count - 1);
    for (int x = 0; x < count && status == PP_OK; x++)
        run->sheet->df[x] = run->of.df[x];
    return status;
}

static bool has_range(double target_lx)
{
    return target_lx >= 200.0 && target_lx <= 750.0;
}

/* Reason why there are no likely ranges, as the end of a sentence; NULL: there are. */
static const char *why_no_ranges(const struct hand_run *run)
{
    const struct pp_working_hours *hours = &run->annual->hours;
    bool in_range = false;
    for (int i = 0; i < run->annual->illuminance_count; i++)
        in_range |= has_range(run->annual->illuminances_lx[i]);
    return run->options->df ? "they are known for simulated daylight factors only"
           : run->options->overcast != PP_STANDARD_OVERCAST
               ? "they are known for the CIE overcast sky of Moon and Spencer only"
           : !in_range ? "they are known for targets of 200 to 750 lx only"
           : run->annual->summer.from.month > 0
               ? "they are known for standard time only"
           : hours->from_h != 8.0 || hours->to_h != 18.0 || hours->days != PP_ALL_DAYS
               ? "they are known for 8 to 18 h on all days only"
           : !run->room->world->is_empty
               ? "they are known for rooms without objects only"
           : pp_hand_case_facade(&run->of) < 0 ? "they are known for windows only"
                                               : NULL;
}

static void say_ranges(struct hand_run *run)
{
    const char *why = why_no_ranges(run);
    snprintf(run->sheet->ranges, sizeof run->sheet->ranges, "%s%s",
             why ? "no likely ranges: "
                 : "likely ranges of the simulated daylight autonomy, for targets of "
                   "200 to 750 lx: " PP_HAND_RANGE_COVERAGE,
             why ? why : "");
}

/* Finds the ranges of one point by one method. */
static void set_ranges(const struct hand_run *run, struct pp_hand_column *column, int x)
{
    int facade = why_no_ranges(run) ? -1 : pp_hand_case_facade(&run->of);
    for (int i = 0; i < run->annual->illuminance_count; i++) {
        double lx = run->annual->illuminances_lx[i];
        bool known = has_range(lx);
        struct pp_hand_interval range = pp_hand_range_of(
            column->name, known ? facade : -1, column->points[x].autonomy[i]);
        column->ranges[x].low[i] = range.low;
        column->ranges[x].high[i] = range.high;
    }
}

static bool evaluate_point(void *data, int worker, int x)
{
    struct hand_run *run = data;
    (void)worker;
    for (int i = 0; i < run->sheet->column_count; i++) {
        const struct hand_entry *entry = &run->entries[i];
        struct pp_hand_column *column = &run->sheet->columns[i];
        bool explains = run->options->explain && x == 0;
        if (column->why)
            column->points[x] = pp_hand_figures_none();
        else
            pp_hand_figures_of(
                &column->points[x], &run->of, entry->method, entry->tools,
                entry->formulary, x, run->annual->illuminances_lx,
                run->annual->illuminance_count, explains ? &column->year : NULL);
        set_ranges(run, column, x);
    }
    return true;
}

static enum pp_status evaluate_points(struct hand_run *run, struct pp_error *err)
{
    struct pp_thread_pool *pool;
    const struct pp_receiver *receivers = run->room->receivers;
    int count = run->room->receiver_count;
    double area_m2 = pp_point_areas_sum(receivers, count);
    enum pp_status status = pp_thread_pool_create(&pool, run->annual->threads, err);
    if (status != PP_OK)
        return status;
    say_ranges(run);
    pp_thread_pool_run(pool, 0, count, evaluate_point, run);
    pp_thread_pool_destroy(pool);
    for (int i = 0; i < run->sheet->column_count; i++) {
        struct pp_hand_column *column = &run->sheet->columns[i];
        double *mean = (double *)&column->mean;
        for (int k = 0; k < PP_HAND_FIGURES; k++) {
            mean[k] = 0.0;
            for (int x = 0; x < count; x++)
                mean[k] += pp_point_areas_share(receivers, count, area_m2, x)
                           * ((const double *)&column->points[x])[k];
        }
        if (column->year.failed)
            return pp_fail_memory(err);
    }
    return PP_OK;
}

/* Records the calculation of the hour that contains the chosen time. */
static enum pp_status explain_hour(struct hand_run *run, struct pp_error *err)
{
    const struct pp_hand_year_options *options = run->options;
    struct pp_perez_sky unused;
    char date[32];
    enum pp_status status = pp_weather_year_moment(&unused, run->of.year, options->date,
                                                   options->clock_h, err);
    if (status != PP_OK)
        return status;
    for (int i = 0; i < run->of.hour_count; i++) {
        const struct pp_hand_hour *hour = &run->of.hours[i];
        if (!pp_month_day_same(hour->date, options->date)
            || options->clock_h < hour->start_h
            || options->clock_h >= hour->start_h + hour->length_h)
            continue;
        snprintf(run->sheet->when, sizeof run->sheet->when,
                 "%s, %g to %g h standard time",
                 pp_month_day_words(date, sizeof date, hour->date), hour->start_h,
                 hour->start_h + hour->length_h);
        for (int k = 0; k < run->sheet->column_count; k++) {
            struct pp_hand_column *column = &run->sheet->columns[k];
            const struct hand_entry *entry = &run->entries[k];
            if (!column->why)
                pp_hand_figures_hour(&run->of, entry->method, entry->tools,
                                     entry->formulary, 0, hour, &column->hour);
            if (column->hour.failed)
                return pp_fail_memory(err);
        }
    }
    return PP_OK;
}

static enum pp_status run_methods(struct hand_run *run,
                                  const struct pp_weather_year *year,
                                  struct pp_error *err)
{
    const struct pp_study_room *room = run->room;
    enum pp_status status = pp_hand_case_init(&run->of, room->world, year, &run->clock,
                                              run->options->overcast, err);
    if (status == PP_OK)
        status = prepare_methods(run, err);
    if (status == PP_OK)
        status = pp_reference_skies_simulate(&run->of.skies, room->world, &room->light,
                                             room->receivers, room->receiver_count,
                                             run->annual, &run->sheet->finished, err);
    if (status != PP_OK || !run->sheet->finished)
        return status;
    status = find_df(run, err);
    if (status == PP_OK)
        status = evaluate_points(run, err);
    if (status == PP_OK && run->options->explain && run->options->date.month > 0)
        status = explain_hour(run, err);
    return status;
}

/* Calculates the methods for the room with its blinds open, as the simulated figures
 * beside them are. */
static enum pp_status run_open(struct hand_run *run, const struct pp_weather_year *year,
                               struct pp_error *err)
{
    struct pp_study_room open = *run->room;
    struct pp_world *opened = NULL;
    enum pp_status status = PP_OK;
    if (run->annual->blinds != PP_BLINDS_AS_DRAWN
        && pp_device_states_exist(open.world)) {
        status = pp_device_states_open(&opened, open.world, err);
        open.world = opened;
        run->room = &open;
    }
    if (status == PP_OK)
        status = run_methods(run, year, err);
    pp_device_states_destroy(opened);
    return status;
}

enum pp_status pp_hand_year_of_room(struct pp_hand_year_sheet *sheet,
                                    const struct pp_study_room *room,
                                    const struct pp_weather_year *year,
                                    const struct pp_annual_options *annual,
                                    const struct pp_hand_year_options *options,
                                    struct pp_error *err)
{
    *sheet = (struct pp_hand_year_sheet){.columns = NULL};
    struct hand_run run = {
        .sheet = sheet, .room = room, .annual = annual, .options = options};
    enum pp_status status =
        pp_year_clock_init(&run.clock, year, &annual->hours, &annual->summer, err);
    if (status != PP_OK)
        return status;
    status = run_open(&run, year, err);
    for (int i = 0; i < PP_YEAR_METHODS_MOST; i++) {
        free(run.entries[i].tools);
        pp_formulary_destroy(run.entries[i].formulary);
    }
    pp_hand_case_clear(&run.of);
    pp_year_clock_clear(&run.clock);
    return status;
}
