/* cmd_atlas.c - the command atlas: how far every method is from the truth, over thousands
 * of designed rooms. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/atlas/atlas_file.h"
#include "cli/command.h"
#include "cli/interrupt.h"
#include "cli/message.h"
#include "cli/output.h"
#include "cli/room_options.h"
#include "cli/watch.h"
#include "model/base/text.h"
#include "studies/atlas/atlas_run.h"

static const char about[] =
    "Traces the rooms of a designed sweep, and the worlds that hand methods have in "
    "mind, "
    "and writes what each method says beside what is true, a row a point, as CSV. "
    "Rooms "
    "that FILE has already are not traced again: a run that was stopped goes on where "
    "it "
    "was, and more rooms can be added to those there are. The same rooms give the same "
    "bytes, however many runs and threads they took.";

struct atlas_options {
    struct pp_room_options room; /* error, seed, threads, output, quiet */
    long rooms;                  /* 0: not given */
    const char *number;          /* of the room whose file is wanted; NULL: none */
    enum pp_atlas_sky sky;
};

/* ---- a room's file ---- */

static enum pp_exit print_room(const struct atlas_options *options,
                               const struct pp_atlas_design *design)
{
    char xml[PP_ATLAS_XML];
    struct pp_output output;
    struct pp_error err = {0};
    pp_atlas_design_room(design, (uint32_t)strtoul(options->number, NULL, 10), xml);
    enum pp_status status = pp_output_open(&output, options->room.output, &err);
    if (status == PP_OK)
        fputs(xml, output.stream);
    status = pp_output_close(&output, status, &err);
    return status == PP_OK ? PP_EXIT_DONE : pp_message_error(&err);
}

/* ---- the sweep ---- */

/* What a file of this sweep begins with; the caller's to free, NULL when memory is out. */
static char *head_of(const struct atlas_options *options,
                     const struct pp_atlas_columns *columns)
{
    char *head = NULL;
    size_t length;
    FILE *out = open_memstream(&head, &length);
    if (!out)
        return NULL;
    fprintf(out,
            "# pepperpot-atlas-1: daylight factors, per cent of the open sky's "
            "horizontal illuminance\n"
            "# sky %s, error %g %%, seed %llu\n",
            options->sky == PP_ATLAS_ISO ? "iso" : "overcast",
            100.0 * options->room.study.error,
            (unsigned long long)options->room.study.seed);
    pp_atlas_columns_print_names(columns, out);
    return fclose(out) == 0 ? head : NULL;
}

static enum pp_status take(void *data, const char *rows, size_t length,
                           struct pp_error *err)
{
    struct pp_atlas_file *file = data;
    enum pp_status status = pp_atlas_file_add(file, rows, length, err);
    file->rooms += status == PP_OK;
    return status;
}

/* Goes on from what the file has. */
static enum pp_status run_on(const struct atlas_options *options,
                             const struct pp_atlas_design *design,
                             const struct pp_atlas_columns *columns,
                             struct pp_atlas_file *file, struct pp_error *err)
{
    const struct pp_study_options *study = &options->room.study;
    struct pp_atlas_run run = {
        .design = design,
        .columns = columns,
        .trace = {.error = study->error, .seed = study->seed},
        .first = file->rooms,
        .end = (int)options->rooms,
        .threads = study->threads,
        .watch = study->watch,
        .take = take,
        .data = file,
    };
    int next;
    pp_interrupt_watch();
    return pp_atlas_run(&run, &next, err);
}

static enum pp_exit sweep(const struct atlas_options *options,
                          const struct pp_atlas_design *design)
{
    struct pp_error err = {0};
    struct pp_atlas_columns columns;
    enum pp_status status = pp_atlas_room_columns(&columns, design, &err);
    if (status != PP_OK)
        return pp_message_error(&err);
    struct pp_atlas_file file = {0};
    char *head = head_of(options, &columns);
    status = head ? pp_atlas_file_open(&file, options->room.output, head, &err)
                  : pp_fail_memory(&err);
    if (status == PP_OK) {
        status = run_on(options, design, &columns, &file, &err);
        status = pp_atlas_file_close(&file, status, &err);
    }
    free(head);
    pp_atlas_columns_clear(&columns);
    if (status != PP_OK)
        return pp_message_error(&err);
    if (file.rooms >= options->rooms)
        return PP_EXIT_DONE;
    pp_message(
        "interrupted: %s has %d rooms of %ld; the same command goes on from there",
        file.path, file.rooms, options->rooms);
    return PP_EXIT_INTERRUPTED;
}

/* ---- the command line ---- */

static enum pp_status read_sky(const char *text, void *place, struct pp_error *err)
{
    if (strcmp(text, "overcast") != 0 && strcmp(text, "iso") != 0)
        return pp_fail(err, PP_BAD_INPUT, "overcast or iso");
    *(enum pp_atlas_sky *)place =
        strcmp(text, "iso") == 0 ? PP_ATLAS_ISO : PP_ATLAS_OVERCAST;
    return PP_OK;
}

static enum pp_status read_number(const char *text, void *place, struct pp_error *err)
{
    double number;
    if (!pp_text_parse_number(text, &number) || number < 0.0 || number >= PP_ATLAS_MOST
        || number != floor(number))
        return pp_fail(err, PP_BAD_INPUT, "the number of a room, 0 to %d",
                       PP_ATLAS_MOST - 1);
    *(const char **)place = text;
    return PP_OK;
}

#define PLACE(member) offsetof(struct atlas_options, member)

static const struct pp_option sweep_options[] = {
    {"rooms", 'n', "N", "Have the first N rooms of the sweep in FILE.",
     pp_options_read_count, PLACE(rooms)},
    {"room", 0, "NUMBER", "Print the room file of that room, counted from 0, instead.",
     read_number, PLACE(number)},
    {"sky", 0, "SKY",
     "overcast (default), or iso: for each room one of the skies of ISO 15469.",
     read_sky, PLACE(sky)},
    {0},
};

static const struct pp_option stop_option[] = {
    {"error", 0, "E%",
     "Trace until the standard error of the daylight factor is down to that share of "
     "it, "
     "or to 0.002 % daylight factor, at every point (default 1%).",
     pp_options_read_per_cent, PLACE(room.study.error)},
    {0},
};

static const struct pp_option_group groups[] = {
    {"Rooms", sweep_options, 0},
    {"Simulation", stop_option, 0},
    {"Simulation", pp_room_seed_options, PLACE(room)},
    {"Output", pp_room_output_options, PLACE(room)},
    {0},
};

static void init(void *values)
{
    *(struct atlas_options *)values =
        (struct atlas_options){.room = pp_room_options_none};
}

static enum pp_status check(void *values, char **operands, int count,
                            struct pp_error *err)
{
    struct atlas_options *options = values;
    const char *output = options->room.output;
    if (count > 0)
        return pp_fail(err, PP_BAD_INPUT,
                       "the atlas has its own rooms; expected no file, but %s",
                       "-o FILE and --rooms N");
    if ((options->rooms > 0) == (options->number != NULL))
        return pp_fail(err, PP_BAD_INPUT,
                       "expected --rooms N and -o FILE, or --room NUMBER");
    if (options->rooms > PP_ATLAS_MOST)
        return pp_fail(err, PP_BAD_INPUT, "--rooms: expected at most %d",
                       PP_ATLAS_MOST);
    if (options->rooms > 0 && (!output || strcmp(output, "-") == 0))
        return pp_fail(err, PP_BAD_INPUT,
                       "the atlas grows in a file; expected -o FILE");
    if (!(options->room.study.error > 0.0))
        options->room.study.error = 0.01;
    return PP_OK;
}

static enum pp_exit run(void *values, char **operands, int count)
{
    struct atlas_options *options = values;
    struct pp_terminal_watch watch;
    struct pp_atlas_design design;
    (void)operands;
    options->room.study.watch = pp_watch_of_terminal(&watch, options->room.quiet);
    pp_atlas_design_init(&design, options->sky);
    return options->number ? print_room(options, &design) : sweep(options, &design);
}

static void clear(void *values)
{
    struct atlas_options *options = values;
    pp_room_options_clear(&options->room);
}

const struct pp_command pp_command_atlas = {
    .name = "atlas",
    .summary = "every method's error over thousands of rooms",
    .operands = "",
    .about = about,
    .groups = groups,
    .size = sizeof(struct atlas_options),
    .init = init,
    .check = check,
    .run = run,
    .clear = clear,
};
