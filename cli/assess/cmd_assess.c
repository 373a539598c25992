/* cmd_assess.c - the command assess: what a room's daylight has to reach, and
 * whether it does. */
#include <stdlib.h>
#include <string.h>

#include "cli/terminal.h"
#include "cli/availability/availability_options.h"
#include "cli/command.h"
#include "cli/ranks/deal_rooms.h"
#include "cli/format_option.h"
#include "studies/study_report.h"
#include "cli/interrupt.h"
#include "cli/message.h"
#include "cli/job.h"
#include "cli/rooms.h"
#include "cli/watch.h"
#include "reports/assess/assess_csv.h"
#include "reports/assess/assess_json.h"
#include "reports/assess/assess_table.h"
#include "reports/assess/assess_table_json.h"
#include "reports/assess/assess_text.h"
#include "studies/criteria/capitals.h"
#include "studies/criteria/larger_house.h"
#include "studies/criteria/profile.h"
#include "model/base/text.h"

struct assess_options {
    struct pp_room_options room;
    const char *criteria;     /* as typed; NULL: all */
    const char *profile_name; /* as typed; NULL: none asked for */
    const struct pp_profile *profile;
    bool table;          /* one table of all rooms in place of a sheet a room */
    const char *before;  /* the file with the room as it was; NULL: none */
    const char *place;   /* a capital of the standard's table; NULL: the room's site */
    double median_lux;   /* instead; 0: not given */
    const char *weather; /* or the weather file that it is taken from; NULL: none */
    struct pp_sunshine sunshine; /* of that file */
    enum pp_format format;
};

#define PLACE(member) offsetof(struct assess_options, member)

static const struct pp_option table_option[] = {
    {"table", 0, NULL,
     "One table of all windows and rooms, existing and proposed, in place of a sheet a "
     "room.",
     NULL, PLACE(table)},
    {0},
};

static const struct pp_option choice_options[] = {
    {"criteria", 'c', "LIST", "Only these criteria, by name and with commas between.",
     pp_options_read_text, PLACE(criteria)},
    {"for", 0, "PROFILE",
     "Only what a report of that kind has to judge, of rooms of that use.",
     pp_options_read_text, PLACE(profile_name)},
    {"before", 'b', "FILE",
     "The room as it was before something was built outside: sky and area lost.",
     pp_options_read_input, PLACE(before)},
    {"place", 0, "NAME",
     "A capital of EN 17037's table, whose median illuminance is taken; by default "
     "that "
     "of the site's country, or else the one nearest to the site.",
     pp_options_read_text, PLACE(place)},
    {"median-diffuse", 0, "LUX",
     "The place's median diffuse illuminance itself, for EN 17037.",
     pp_options_read_lux, PLACE(median_lux)},
    {"weather", 'w', "FILE.epw",
     "The same by a weather file in EnergyPlus format, and how likely the sun is to "
     "shine.",
     pp_options_read_input, PLACE(weather)},
    {"room", 0, "NAME", "Only the room of that name.", pp_options_read_text,
     PLACE(room.room)},
    {"state", 0, "STATE",
     "Judge the site as it is, existing, or as it will be, proposed. Without the "
     "option, "
     "where the file has both: as proposed, with what is lost.",
     pp_room_options_read_state, PLACE(room.state)},
    {0},
};

static const char about[] =
    "Holds each room against the criteria of daylight design: its figures, what is "
    "wanted of them, and the verdict. Daylight factors are traced, and each verdict on "
    "them has its probability; with --by-hand they are those of hand methods. FILE is "
    "a room file; - is standard input.";

static void help_on_criteria(FILE *out)
{
    fputs("\nCriteria:\n", out);
    const struct pp_criterion *criterion;
    for (int i = 0; (criterion = pp_criteria_at(i)) != NULL; i++)
        pp_options_help_word(criterion->name, criterion->summary, out);
    fputs("\nProfiles, of --for:\n", out);
    const struct pp_profile *profile;
    for (int i = 0; (profile = pp_profile_at(i)) != NULL; i++)
        pp_options_help_word(profile->name, profile->summary, out);
    fputs("\nAlso:", out);
    for (int i = 0; (criterion = pp_criteria_at(i)) != NULL; i++)
        if (criterion->alias)
            fprintf(out, " %s (%s)", criterion->alias, criterion->name);
    fputc('\n', out);
}

struct assess_run {
    const struct assess_options *options;
    const struct pp_rooms *rooms, *before;
    struct pp_assessments all;
};

static struct pp_room_figures figures(void *data, int room)
{
    struct pp_assessment *one = &((struct assess_run *)data)->all.list[room];
    return (struct pp_room_figures){&one->report, &one->by_clock};
}

/* Some of the time is for the larger houses. */
static enum pp_status simulate_room(const void *data, int room,
                                    struct pp_report *report, bool *by_clock,
                                    struct pp_error *err)
{
    const struct assess_run *run = data;
    struct pp_study_options own = run->options->room.study;
    own.seconds *= 1.0 - PP_LARGER_HOUSE_SHARE;
    return run->all.list[room].has_factors
               ? pp_study_report_traced(report, &own, by_clock, err)
               : PP_OK;
}

static enum pp_status compute(void *data, struct pp_error *err)
{
    struct assess_run *run = data;
    struct pp_assessments *all = &run->all;
    const struct pp_rooms *rooms = run->rooms, *before = run->before;
    const struct pp_study_options *study = &run->options->room.study;
    const struct pp_assess_options wanted = {
        .study = study,
        .criteria = run->options->criteria,
        .profile = run->options->profile,
        .before_is_state = !run->options->before,
        .place = run->options->place,
        .median_lux = run->options->median_lux,
        .of_weather = run->options->weather != NULL,
        .sunshine = run->options->sunshine.known ? &run->options->sunshine : NULL};
    enum pp_status status = PP_OK;
    all->list = calloc((size_t)rooms->count + 1, sizeof *all->list);
    if (!all->list)
        return pp_fail_memory(err);
    for (int i = 0; i < rooms->count && status == PP_OK; i++)
        status =
            pp_assessment_begin(&all->list[all->count++], &rooms->list[i], rooms->count,
                                before->list, before->count, &wanted, err);
    if (status == PP_OK && study->simulate)
        pp_interrupt_watch();
    if (status == PP_OK)
        status =
            pp_deal_rooms(&(struct pp_room_dealing){study->simulate ? all->count : 0,
                                                    run->options->room.ranks, figures,
                                                    simulate_room, run},
                          err);
    for (int i = 0; i < all->count && status == PP_OK; i++) {
        struct pp_assessment *one = &all->list[i];
        status = pp_assessment_judge(one, &wanted, err);
        if (status == PP_OK)
            status = pp_larger_house_doubt(one, &wanted, err);
    }
    return status;
}

static enum pp_status print(const void *data, FILE *out, struct pp_error *err)
{
    const struct assess_run *run = data;
    if (run->options->format == PP_FORMAT_CSV)
        return pp_assess_csv(&run->all, out, err);
    if (run->options->table && run->options->format == PP_FORMAT_JSON)
        return pp_assess_table_json(&run->all, out, err);
    if (run->options->table)
        return pp_assess_table(&run->all, pp_terminal_width(run->options->room.output),
                               out, err);
    return run->options->format == PP_FORMAT_JSON
               ? pp_assess_json(&run->all, out, err)
               : pp_assess_text(&run->all, pp_terminal_width(run->options->room.output),
                                pp_terminal_utf8(), out, err);
}

static bool is_finished(const void *data)
{
    const struct assess_run *run = data;
    for (int i = 0; i < run->all.count; i++)
        if (!run->all.list[i].report.finished)
            return false;
    return true;
}

static enum pp_exit run_on(struct assess_options *options, const struct pp_rooms *rooms,
                           const struct pp_rooms *before)
{
    struct pp_terminal_watch watch;
    options->room.study.watch = pp_watch_of_terminal(&watch, options->room.quiet);
    struct assess_run run = {.options = options,
                             .rooms = rooms,
                             .before = before,
                             .all = {.several = rooms->several,
                                     .more_than_one_file = rooms->more_than_one_file,
                                     .options = &options->room.study}};
    enum pp_exit exit_status = pp_job_run(
        &(struct pp_job){options->room.output, compute, print, is_finished, &run});
    for (int i = 0; i < run.all.count; i++)
        pp_assessment_clear(&run.all.list[i]);
    free(run.all.list);
    return exit_status;
}

static enum pp_status refuse_without_before(const struct pp_criterion *criterion,
                                            struct pp_error *err)
{
    return pp_fail(err, PP_BAD_INPUT,
                   "%s compares with the room as it was; it needs --before FILE, or a "
                   "file that says what is existing and what is proposed",
                   criterion->name);
}

/* A criterion that was asked for by name must have a room before to compare with. */
static enum pp_exit check_before(const struct assess_options *options)
{
    bool chosen[PP_CRITERIA_MOST];
    struct pp_error err;
    const struct pp_criterion *criterion;
    if (!options->criteria
        || pp_assessment_choose(chosen, options->criteria, &err) != PP_OK)
        return PP_EXIT_DONE;
    for (int i = 0; (criterion = pp_criteria_at(i)) != NULL; i++)
        if (chosen[i] && criterion->needs_before) {
            refuse_without_before(criterion, &err);
            return pp_message_usage("assess", &err);
        }
    return PP_EXIT_DONE;
}

static enum pp_exit run(void *values, char **files, int file_count)
{
    struct assess_options *options = values;
    struct pp_rooms rooms = {0}, before = {0};
    enum pp_exit exit_status = PP_EXIT_DONE;
    if (options->weather)
        exit_status = pp_availability_options_median(
            options->weather, &options->median_lux, &options->sunshine);
    if (exit_status == PP_EXIT_DONE)
        exit_status =
            pp_rooms_load(&rooms, "assess", files, file_count, &options->room);
    if (exit_status != PP_EXIT_DONE)
        return exit_status;
    if (options->before) {
        struct pp_room_options all_rooms = options->room;
        all_rooms.room = NULL;
        char *file[] = {(char *)options->before};
        exit_status = pp_rooms_load(&before, "assess", file, 1, &all_rooms);
    } else if (options->room.state == PP_STATE_BOTH) {
        exit_status = pp_rooms_load_existing(&before, "assess", &rooms, &options->room);
    }
    if (exit_status == PP_EXIT_DONE && before.count == 0)
        exit_status = check_before(options);
    if (exit_status == PP_EXIT_DONE)
        exit_status = run_on(options, &rooms, &before);
    pp_rooms_clear(&before);
    pp_rooms_clear(&rooms);
    return exit_status;
}

/* ---- the command line ---- */

static enum pp_status check_place(const struct assess_options *options,
                                  struct pp_error *err)
{
    const char *names[64];
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
    return pp_text_unknown(err, options->place, names, count, NULL,
                           "--place: \"%.100s\" is not in the standard's table",
                           options->place);
}

static enum pp_status check(void *values, char **files, int file_count,
                            struct pp_error *err)
{
    struct assess_options *options = values;
    bool chosen[PP_CRITERIA_MOST];
    if (file_count == 0)
        return pp_fail(err, PP_BAD_INPUT,
                       "expected a room file, or - for standard input");
    for (int i = 0; i < file_count && options->before; i++)
        if (strcmp(options->before, "-") == 0 && strcmp(files[i], "-") == 0)
            return pp_fail(err, PP_BAD_INPUT,
                           "standard input can't be the room and the room before");
    enum pp_status status = pp_room_options_settle_by_hand(&options->room, err);
    if (status == PP_OK)
        status = pp_room_options_settle(&options->room, err);
    if (status == PP_OK)
        status = check_place(options, err);
    if (status == PP_OK)
        status = pp_assessment_choose(chosen, options->criteria, err);
    if (status == PP_OK && options->profile_name) {
        options->profile = pp_profile_find(options->profile_name, err);
        status = options->profile ? PP_OK : PP_BAD_INPUT;
    }
    if (status == PP_OK && options->criteria && options->profile)
        status = pp_fail(err, PP_BAD_INPUT,
                         "--criteria and --for both say what is judged; expected one "
                         "of them");
    if (status == PP_OK && options->before && options->room.state != PP_STATE_BOTH)
        status = pp_fail(err, PP_BAD_INPUT,
                         "--before and --state both say what is set beside each other; "
                         "expected one of them");
    return status;
}

static void init(void *values)
{
    *(struct assess_options *)values =
        (struct assess_options){.room = pp_room_options_none};
}

static void clear(void *values)
{
    struct assess_options *options = values;
    pp_room_options_clear(&options->room);
}

static const struct pp_option_group groups[] = {
    {"What is judged", choice_options, 0},
    {"What is judged", pp_room_external_option, PLACE(room)},
    PP_ROOM_BY_HAND_GROUPS(PLACE(room)),
    {"Output", table_option, 0},
    {"Output", pp_format_option, PLACE(format)},
    {"Output", pp_room_output_options, PLACE(room)},
    {0},
};

const struct pp_command pp_command_assess = {
    .name = "assess",
    .summary = "what a room's daylight has to reach, and whether it does",
    .operands = "FILE...",
    .about = about,
    .groups = groups,
    .size = sizeof(struct assess_options),
    .more_help = help_on_criteria,
    .init = init,
    .check = check,
    .run = run,
    .clear = clear,
    .deals = true,
    .ranks_place = PLACE(room.ranks),
};
