/* cmd_assess.c - the command assess: compares a room's daylight with criteria. */
#include <stddef.h>

#include "cli/assess/assess_run.h"
#include "cli/assess/assess_sweep.h"
#include "cli/assess/assess_words.h"
#include "cli/assess/schedule_file.h"
#include "cli/command.h"
#include "cli/format_option.h"
#include "cli/job.h"
#include "cli/sweep/sweep_options.h"
#include "cli/terminal.h"
#include "reports/assess/assess_csv.h"
#include "reports/assess/assess_json.h"
#include "reports/assess/assess_table.h"
#include "reports/assess/assess_table_json.h"
#include "reports/assess/assess_text.h"
#include "reports/assess/rules_list.h"

#define PLACE(member) offsetof(struct pp_assess_words, member)

static const char about[] =
    "Assesses each room against daylight criteria. Shows each figure, its target and "
    "the verdict. Daylight factors are simulated, and each verdict has a probability; "
    "--by-hand uses hand methods instead. FILE is a room file; - is standard input.";

static enum pp_status print_assess(const void *data, FILE *out, struct pp_error *err)
{
    const struct pp_assess_run *run = data;
    if (run->words->schedule) {
        enum pp_status status =
            pp_schedule_file_write(run->words->schedule, &run->all, err);
        if (status != PP_OK)
            return status;
    }
    if (run->words->format == PP_FORMAT_CSV)
        return run->words->table ? pp_assess_csv_of_site(&run->all, out, err)
                                 : pp_assess_csv(&run->all, out, err);
    if (run->words->table && run->words->format == PP_FORMAT_JSON)
        return pp_assess_table_json(&run->all, out, err);
    if (run->words->table)
        return pp_assess_table(&run->all, pp_terminal_width(run->words->room.output),
                               out, err);
    return run->words->format == PP_FORMAT_JSON
               ? pp_assess_json(&run->all, out, err)
               : pp_assess_text(&run->all, pp_terminal_width(run->words->room.output),
                                pp_terminal_utf8(), out, err);
}

static enum pp_status print_rules(const void *data, FILE *out, struct pp_error *err)
{
    const struct pp_assess_words *words = data;
    if (words->format == PP_FORMAT_JSON)
        return pp_rules_list_json(out, err);
    if (words->format == PP_FORMAT_CSV)
        pp_rules_list_csv(out);
    else
        pp_rules_list_text(pp_terminal_width(words->room.output), out);
    return PP_OK;
}

/* Does nothing: the table of rules needs no computation. */
static enum pp_status list_nothing_else(void *data, struct pp_error *err)
{
    (void)data, (void)err;
    return PP_OK;
}

static enum pp_exit run_assess(void *words, char **files, int file_count)
{
    struct pp_assess_words *options = words;
    if (options->list_rules)
        return pp_job_run(&(struct pp_job){options->room.output, list_nothing_else,
                                           print_rules, NULL, options});
    if (options->room.sweep.axis_count > 0)
        return pp_assess_sweep_run(words, files, file_count, print_assess);
    return pp_assess_run(words, "assess", files, file_count, print_assess);
}

static const struct pp_option_group groups[] = {
    {"Criteria", pp_assess_words_choice, 0},
    {"Criteria", pp_room_french_option, PLACE(french_m)},
    {"Criteria", pp_room_spacing_option, PLACE(grid)},
    {"Criteria", pp_room_external_option, PLACE(room)},
    {"Criteria", pp_sweep_options, PLACE(room.sweep)},
    PP_ROOM_BY_HAND_GROUPS(PLACE(room)),
    {"Simulation", pp_room_plain_option, PLACE(room)},
    {"Output", pp_assess_words_table, 0},
    {"Output", pp_format_option, PLACE(format)},
    {"Output", pp_room_output_options, PLACE(room)},
    {0},
};

const struct pp_command pp_command_assess = {
    .name = "assess",
    .summary = "assess rooms against daylight criteria, with verdicts",
    .operands = "FILE...",
    .about = about,
    .groups = groups,
    .size = sizeof(struct pp_assess_words),
    .more_help = pp_assess_words_help,
    .init = pp_assess_words_init,
    .check = pp_assess_words_check,
    .run = run_assess,
    .clear = pp_assess_words_clear,
    .uses_ranks = true,
    .ranks_place = PLACE(room.ranks),
};
