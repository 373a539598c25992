/* assess - what a room's daylight has to reach, and whether it does. */
#include <stdlib.h>
#include <string.h>

#include "cli/assess/assessment.h"
#include "cli/availability/availability_options.h"
#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/print/format.h"
#include "cli/study_report.h"
#include "cli/interrupt.h"
#include "cli/message.h"
#include "cli/output.h"
#include "cli/print/print.h"
#include "studies/criteria/factors.h"
#include "studies/criteria/pair_rooms.h"
#include "studies/criteria/capitals.h"
#include "studies/criteria/en17037_grid.h"
#include "model/base/text.h"

#define PLACE(member) offsetof(struct pp_assess_options, member)

static const struct pp_option choice_options[] = {
    {"criteria", 'c', "LIST", "Only these criteria, by name and with commas between.",
     pp_options_read_text, PLACE(criteria)},
    {"before", 'b', "FILE",
     "The room as it was before something was built outside: sky and area lost.",
     pp_options_read_input, PLACE(before)},
    {"place", 0, "NAME",
     "A capital of EN 17037's table, whose median illuminance is taken; by default the "
     "one nearest to the room's site.",
     pp_options_read_text, PLACE(place)},
    {"median-diffuse", 0, "LUX",
     "The place's median diffuse illuminance itself, for EN 17037.",
     pp_options_read_lux, PLACE(median_lux)},
    {"weather", 'w', "FILE.epw", "The same by a weather file in EnergyPlus format.",
     pp_options_read_input, PLACE(weather)},
    {"room", 0, "NAME", "Only the room of that name.", pp_options_read_text,
     PLACE(room.room)},
    {0},
};

static const char about[] =
    "Holds each room against the criteria of daylight design: its figures, what is "
    "wanted of them, and the verdict; with --simulate they rest on traced light paths, "
    "and each verdict has its probability. FILE is a room file; - is standard input.";

static void help_on_criteria(FILE *out)
{
    fputs("\nCriteria:\n", out);
    const struct pp_criterion *criterion;
    for (int i = 0; (criterion = pp_criteria_at(i)) != NULL; i++)
        pp_options_help_word(criterion->name, criterion->summary, out);
}

/* ---- which criteria ---- */

enum { CRITERIA_MOST = 64 };

/* Marks the criteria of a list with commas; NULL is all of them. */
static enum pp_status choose(bool chosen[CRITERIA_MOST], const char *list,
                             struct pp_error *err)
{
    const char *names[CRITERIA_MOST];
    int count = 0;
    for (; pp_criteria_at(count); count++) {
        names[count] = pp_criteria_at(count)->name;
        chosen[count] = !list;
    }
    while (list) {
        char word[64], known[512];
        snprintf(word, sizeof word, "%.*s", (int)strcspn(list, ","), list);
        int i = 0;
        while (i < count && strcmp(names[i], word) != 0)
            i++;
        if (i == count) {
            const char *guess = pp_text_nearest(word, names, count);
            return guess
                       ? pp_fail(err, PP_BAD_INPUT,
                                 "there is no criterion \"%s\"; did you mean %s?", word,
                                 guess)
                       : pp_fail(err, PP_BAD_INPUT,
                                 "there is no criterion \"%s\"; expected %s", word,
                                 pp_text_list_names(known, sizeof known, names, count));
        }
        chosen[i] = true;
        list = strchr(list, ',');
        list = list ? list + 1 : NULL;
    }
    return PP_OK;
}

/* ---- one room ---- */

/* The room of the file before that goes with this one: the only one, or that of the
 * same name. */
static enum pp_status find_before(struct pp_assessment *assessment,
                                  const struct pp_rooms *before, int room_count,
                                  struct pp_error *err)
{
    const struct pp_loaded_room *room = assessment->room, *found = NULL;
    for (int i = 0; i < before->count && !found; i++) {
        const char *name = before->list[i].world->name, *wanted = room->world->name;
        bool only = before->count == 1 && room_count == 1;
        if (only || (name && wanted && strcmp(name, wanted) == 0))
            found = &before->list[i];
    }
    const char *file = before->list[0].file;
    if (!found)
        return pp_fail(err, PP_BAD_INPUT,
                       "%s: it has no room named \"%.100s\" to compare with", file,
                       room->world->name ? room->world->name : "");
    assessment->before = found;
    struct pp_error why;
    enum pp_status status =
        pp_pair_rooms(&assessment->pairs, room->world, found->world, &why);
    return status == PP_BAD_INPUT ? pp_fail(err, status, "%s: %s", file, why.message)
           : status != PP_OK      ? pp_fail(err, status, "%s", why.message)
                                  : PP_OK;
}

static void find_median(struct pp_median *median, const struct pp_world *world,
                        const struct pp_assess_options *options)
{
    if (options->median_lux > 0.0) {
        median->lux = options->median_lux;
        snprintf(median->how, sizeof median->how, "%s",
                 options->weather ? "of the weather file" : "as given");
    } else if (options->place) {
        const struct pp_capital *capital = pp_capitals_find(options->place);
        median->lux = capital->median_lux;
        snprintf(median->how, sizeof median->how, "%s, as chosen", capital->name);
    } else {
        *median = pp_capitals_median(world->latitude_rad, world->longitude_rad);
    }
}

/* The daylight factors that criteria rest on; those of simulation come later. */
static enum pp_status gather(struct pp_assessment *assessment,
                             const struct pp_assess_options *options,
                             struct pp_error *err)
{
    const struct pp_world *world = assessment->room->world;
    find_median(&assessment->median, world, options);
    assessment->report = (struct pp_report){.world = world, .finished = true};
    if (!assessment->has_factors)
        return PP_OK;
    enum pp_status status = pp_en17037_grid(
        &assessment->grid, &assessment->report.receiver_count, world, err);
    assessment->report.receivers = assessment->grid;
    return status == PP_OK ? pp_factors_by_hand(&assessment->report, err) : status;
}

static enum pp_status judge(struct pp_assessment *assessment,
                            const bool chosen[CRITERIA_MOST], struct pp_error *err)
{
    const struct pp_inquiry inquiry = {
        .world = assessment->room->world,
        .before = assessment->before ? assessment->before->world : NULL,
        .pairs = assessment->pairs,
        .factors = assessment->has_factors ? &assessment->report : NULL,
        .median = assessment->median,
    };
    assessment->answers = calloc(CRITERIA_MOST, sizeof *assessment->answers);
    if (!assessment->answers)
        return pp_fail_memory(err);
    enum pp_status status = PP_OK;
    const struct pp_criterion *criterion;
    for (int i = 0; status == PP_OK && (criterion = pp_criteria_at(i)) != NULL; i++) {
        if (!chosen[i] || (criterion->needs_before && !inquiry.before))
            continue;
        struct pp_answer *answer = &assessment->answers[assessment->answer_count++];
        answer->criterion = criterion;
        status = criterion->evaluate(&inquiry, &answer->findings, err);
    }
    return status;
}

static void clear(struct pp_assessment *assessment)
{
    for (int i = 0; i < assessment->answer_count; i++)
        pp_finding_list_clear(&assessment->answers[i].findings);
    free(assessment->answers);
    pp_report_clear(&assessment->report);
    free(assessment->grid);
    free(assessment->pairs);
}

/* ---- all rooms ---- */

static bool any_of_factors(const bool chosen[CRITERIA_MOST])
{
    const struct pp_criterion *criterion;
    for (int i = 0; (criterion = pp_criteria_at(i)) != NULL; i++)
        if (chosen[i] && criterion->of_factors)
            return true;
    return false;
}

static enum pp_status assess(struct pp_assessments *all, const struct pp_rooms *rooms,
                             const struct pp_rooms *before, struct pp_error *err)
{
    const struct pp_assess_options *options = all->options;
    bool chosen[CRITERIA_MOST];
    enum pp_status status = choose(chosen, options->criteria, err);
    for (int i = 0; i < rooms->count && status == PP_OK; i++) {
        struct pp_assessment *one = &all->list[all->count++];
        one->room = &rooms->list[i];
        one->has_factors = any_of_factors(chosen);
        if (before->count > 0)
            status = find_before(one, before, rooms->count, err);
        if (status == PP_OK)
            status = gather(one, options, err);
    }
    if (status == PP_OK && options->room.simulate)
        pp_interrupt_watch();
    for (int i = 0; i < all->count && status == PP_OK; i++) {
        struct pp_assessment *one = &all->list[i];
        if (options->room.simulate && one->has_factors)
            status = pp_study_report_traced(&one->report, &options->room,
                                            &one->by_clock, err);
        if (status == PP_OK)
            status = judge(one, chosen, err);
        one->has_gains = !options->criteria;
        if (status == PP_OK && one->has_gains)
            status = pp_gains_find(&one->gains, one->room->room, one->room->world, err);
    }
    return status;
}

static enum pp_exit assess_and_print(struct pp_assessments *all,
                                     const struct pp_rooms *rooms,
                                     const struct pp_rooms *before,
                                     enum pp_format format)
{
    const char *path = all->options->room.output;
    struct pp_error err = {0};
    struct pp_output output;
    enum pp_status status = pp_output_open(&output, path, &err);
    if (status == PP_OK)
        status = assess(all, rooms, before, &err);
    if (status == PP_OK && format == PP_FORMAT_JSON)
        status = pp_assess_json(all, output.stream, &err);
    else if (status == PP_OK)
        status = pp_assess_text(all, pp_print_width(path), pp_format_utf8_terminal(),
                                output.stream, &err);
    status = pp_output_close(&output, status, &err);
    if (status != PP_OK)
        return pp_message_error(&err);
    for (int i = 0; i < all->count; i++)
        if (!all->list[i].report.finished)
            return pp_message_unfinished();
    return PP_EXIT_DONE;
}

static enum pp_exit run(const struct pp_assess_options *options, enum pp_format format,
                        char **files, int file_count)
{
    struct pp_rooms rooms = {0}, before = {0};
    enum pp_exit exit_status =
        pp_rooms_load(&rooms, "assess", files, file_count, &options->room);
    if (exit_status != PP_EXIT_DONE)
        return exit_status;
    if (options->before) {
        struct pp_room_options all_rooms = options->room;
        all_rooms.room = NULL;
        char *file[] = {(char *)options->before};
        exit_status = pp_rooms_load(&before, "assess", file, 1, &all_rooms);
    }
    struct pp_assessments all = {.several = rooms.several,
                                 .more_than_one_file = rooms.more_than_one_file,
                                 .options = options,
                                 .list =
                                     calloc((size_t)rooms.count + 1, sizeof *all.list)};
    if (exit_status == PP_EXIT_DONE && all.list) {
        exit_status = assess_and_print(&all, &rooms, &before, format);
    } else if (!all.list) {
        struct pp_error err;
        pp_fail_memory(&err);
        exit_status = pp_message_error(&err);
    }
    for (int i = 0; i < all.count; i++)
        clear(&all.list[i]);
    free(all.list);
    pp_rooms_clear(&before);
    pp_rooms_clear(&rooms);
    return exit_status;
}

/* ---- the command line ---- */

static enum pp_status check_place(const struct pp_assess_options *options,
                                  struct pp_error *err)
{
    const char *names[64];
    char known[512];
    int count = 0;
    if (options->weather && (options->place || options->median_lux > 0.0))
        return pp_fail(err, PP_BAD_INPUT,
                       "--weather says what %s says too; expected one of them",
                       options->place ? "--place" : "--median-diffuse");
    if (!options->place || pp_capitals_find(options->place))
        return options->place && options->median_lux > 0.0
                   ? pp_fail(err, PP_BAD_INPUT,
                             "--place and --median-diffuse are two ways to say the "
                             "same; expected one of them")
                   : PP_OK;
    for (; count < 64 && count < pp_capitals_count(); count++)
        names[count] = pp_capitals_at(count)->name;
    const char *guess = pp_text_nearest(options->place, names, count);
    return guess
               ? pp_fail(err, PP_BAD_INPUT,
                         "--place: \"%.100s\" is not in the standard's table; did you "
                         "mean %s?",
                         options->place, guess)
               : pp_fail(err, PP_BAD_INPUT,
                         "--place: \"%.100s\" is not in the standard's table; "
                         "expected %s",
                         options->place,
                         pp_text_list_names(known, sizeof known, names, count));
}

static enum pp_status check(struct pp_assess_options *options, char **files,
                            int file_count, struct pp_error *err)
{
    bool chosen[CRITERIA_MOST];
    if (file_count == 0)
        return pp_fail(err, PP_BAD_INPUT,
                       "expected a room file, or - for standard input");
    for (int i = 0; i < file_count && options->before; i++)
        if (strcmp(options->before, "-") == 0 && strcmp(files[i], "-") == 0)
            return pp_fail(err, PP_BAD_INPUT,
                           "standard input can't be the room and the room before");
    enum pp_status status = pp_room_options_settle(&options->room, err);
    if (status == PP_OK)
        status = check_place(options, err);
    if (status == PP_OK)
        status = choose(chosen, options->criteria, err);
    const struct pp_criterion *criterion;
    for (int i = 0; status == PP_OK && (criterion = pp_criteria_at(i)) != NULL; i++)
        if (options->criteria && chosen[i] && criterion->needs_before
            && !options->before)
            status = pp_fail(err, PP_BAD_INPUT,
                             "%s compares with the room as it was; it needs --before "
                             "FILE",
                             criterion->name);
    return status;
}

enum pp_exit cmd_assess(int argc, char **argv)
{
    struct pp_assess_options options = {.room = pp_room_options_none};
    enum pp_format format = PP_FORMAT_TEXT;
    const struct pp_option_group groups[] = {
        {"What is judged", choice_options, &options},
        {"What is judged", pp_room_external_option, &options.room},
        {"Simulation", pp_room_simulation_options, &options.room},
        {"Output", pp_text_or_json_option, &format},
        {"Output", pp_room_output_options, &options.room},
        {0},
    };
    const struct pp_command_line line = {"assess", "FILE...", about, groups,
                                         help_on_criteria};

    struct pp_error err = {0};
    int file_count;
    bool wants_help;
    enum pp_exit exit_status;
    enum pp_status status =
        pp_options_read(&line, argc, argv, &file_count, &wants_help, &err);
    if (status == PP_OK && !wants_help)
        status = check(&options, argv, file_count, &err);

    if (pp_command_line_starts(&line, argv, file_count, status, wants_help, &err,
                               &exit_status)) {
        if (options.weather)
            exit_status =
                pp_availability_options_median(options.weather, &options.median_lux);
        if (exit_status == PP_EXIT_DONE)
            exit_status = run(&options, format, argv, file_count);
    }
    pp_room_options_clear(&options.room);
    return exit_status;
}
