/* atlas_sweep.c - computes the rooms of an atlas and appends them to the file. */
#include "cli/atlas/atlas_sweep.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/atlas/atlas_file.h"
#include "cli/interrupt.h"
#include "cli/message.h"
#include "cli/output.h"
#include "model/base/work_queue.h"
#include "studies/research/atlas/atlas_renewal.h"
#include "studies/research/atlas/atlas_room.h"

/* ---- head of an atlas: version line, settings of rooms and simulation, column names
 * ---- */

static const char atlas_form[] =
    "# pepperpot-atlas-1: daylight factors, per cent of the open "
    "sky's horizontal illuminance\n";

/* Makes the text of the head, which the caller frees; NULL: out of memory. */
static char *atlas_head_text(const struct pp_atlas_making *making,
                             const struct pp_atlas_columns *columns)
{
    char *head = NULL;
    size_t length;
    FILE *out = open_memstream(&head, &length);
    if (!out)
        return NULL;
    fprintf(out, "%s# sky %s, error %g %%, seed %llu\n", atlas_form,
            making->sky == PP_ATLAS_ISO ? "iso" : "overcast",
            100.0 * making->trace.error, (unsigned long long)making->trace.seed);
    pp_atlas_columns_print_names(columns, out);
    if (fclose(out) == 0)
        return head;
    free(head);
    return NULL;
}

/* Reads the settings from the second line of the head. Returns false if they are
 * invalid. */
static bool read_making(struct pp_atlas_making *making, const char *line)
{
    char sky[16];
    unsigned long long seed;
    if (sscanf(line, "# sky %15[a-z], error %lf %%, seed %llu", sky,
               &making->trace.error, &seed)
        != 3)
        return false;
    making->trace.error *= 0.01;
    making->trace.seed = seed;
    making->sky = strcmp(sky, "iso") == 0 ? PP_ATLAS_ISO : PP_ATLAS_OVERCAST;
    return strcmp(sky, "iso") == 0 || strcmp(sky, "overcast") == 0;
}

/* Reads the settings of an atlas from the head of its file. PP_BAD_INPUT if the head is
 * invalid; the message gives the reason. */
static enum pp_status read_atlas_head(struct pp_atlas_making *making, const char *path,
                                      struct pp_error *err)
{
    char first[sizeof atlas_form + 1], second[128];
    FILE *in = fopen(path, "r");
    if (!in)
        return pp_fail(err, errno == ENOENT ? PP_BAD_INPUT : PP_SYSTEM,
                       "%s cannot be read: %s", path, strerror(errno));
    bool is_one = fgets(first, sizeof first, in) && strcmp(first, atlas_form) == 0
                  && fgets(second, sizeof second, in) && read_making(making, second);
    fclose(in);
    return is_one ? PP_OK
                  : pp_fail(err, PP_BAD_INPUT,
                            "%s:1: this is not an atlas; expected a file written by "
                            "pepperpot atlas -o",
                            path);
}

/* ---- rows ---- */

/* Data from which rows are made. */
struct row_source {
    const struct pp_atlas_making *making;
    const struct pp_atlas_table *table; /* existing atlas whose simulated values are
                                         * kept; NULL: simulate */
    struct pp_atlas_design design;
    struct pp_atlas_columns columns;
};

/* A range of rooms, and where their rows are written. */
struct sweep {
    const struct row_source *source;
    const struct pp_watch *watch;
    struct pp_atlas_file *file; /* NULL: write to `out` */
    FILE *out;
};

static enum pp_status open_source(struct row_source *source,
                                  const struct pp_atlas_making *making,
                                  const struct pp_atlas_table *table,
                                  struct pp_error *err)
{
    source->making = making;
    source->table = table;
    pp_atlas_design_init(&source->design, making->sky);
    return pp_atlas_room_columns(&source->columns, &source->design, err);
}

/* Makes the rows of a room, as a result for the work queue. */
static enum pp_status rows_of(void *data, int worker, int room, char **rows,
                              size_t *length, struct pp_error *err)
{
    const struct row_source *source = ((struct sweep *)data)->source;
    (void)worker;
    if (source->table)
        return pp_atlas_renewal_rows(rows, length, &source->columns, &source->design,
                                     source->table, room, err);
    return pp_atlas_room_rows(rows, length, &source->columns, &source->design, room,
                              &source->making->trace, err);
}

static enum pp_status write_sweep_rows(void *data, int room, const char *rows,
                                       size_t length, struct pp_error *err)
{
    struct sweep *sweep = data;
    (void)room;
    if (!sweep->file)
        return pp_output_put(sweep->out, (const unsigned char *)rows, length, err);
    enum pp_status status = pp_atlas_file_add(sweep->file, rows, length, err);
    sweep->file->rooms += status == PP_OK;
    return status;
}

static bool sweep_goes_on(void *data, double done)
{
    const struct pp_watch *watch = ((struct sweep *)data)->watch;
    return !watch->look || watch->look(watch->data, done, NAN);
}

/* Computes the rooms [first, end). *next is set to the index after the last room that
 * was collected. */
static enum pp_status run_queue(struct sweep *sweep, int first, int end,
                                const struct pp_room_options *options, int *next,
                                struct pp_error *err)
{
    sweep->watch = &options->study.watch;
    const struct pp_work_queue queue = {.first = first,
                                        .end = end,
                                        .threads = options->study.threads,
                                        .work = rows_of,
                                        .collect = write_sweep_rows,
                                        .goes_on = sweep_goes_on,
                                        .data = sweep,
                                        .ranks = options->ranks};
    pp_interrupt_watch();
    if (sweep->watch->begin)
        sweep->watch->begin(sweep->watch->data, "atlas");
    enum pp_status status = pp_work_queue_run(&queue, next, err);
    if (sweep->watch->end)
        sweep->watch->end(sweep->watch->data);
    return status;
}

/* Computes rooms for rank 0, which is the only rank that reads and writes files.
 * Returns PP_INTERRUPTED on success. */
static enum pp_status follow_sweep(const struct row_source *source,
                                   const struct pp_room_options *options,
                                   struct pp_error *err)
{
    int next;
    return run_queue(&(struct sweep){.source = source}, 0, 0, options, &next, err);
}

static bool is_rank_0(const struct pp_room_options *options)
{
    return !options->ranks || options->ranks->rank == 0;
}

/* ---- extending an atlas ---- */

static enum pp_status continue_sweep(struct pp_atlas_file *file,
                                     const struct row_source *source, int rooms,
                                     const struct pp_room_options *options,
                                     struct pp_error *err)
{
    char *head = atlas_head_text(source->making, &source->columns);
    if (!head)
        return pp_fail_memory(err);
    enum pp_status status = pp_atlas_file_open(file, options->output, head, err);
    free(head);
    if (status != PP_OK)
        return status;
    int next;
    status = run_queue(&(struct sweep){.source = source, .file = file}, file->rooms,
                       rooms, options, &next, err);
    return pp_atlas_file_close(file, status, err);
}

enum pp_exit pp_atlas_sweep_on(const struct pp_atlas_making *making, int rooms,
                               const struct pp_room_options *options)
{
    struct pp_error err = {0};
    struct pp_atlas_file file = {0};
    struct row_source source;
    enum pp_status status = open_source(&source, making, NULL, &err);
    if (status == PP_OK) {
        status = is_rank_0(options)
                     ? continue_sweep(&file, &source, rooms, options, &err)
                     : follow_sweep(&source, options, &err);
        pp_atlas_columns_clear(&source.columns);
    }
    if (status != PP_OK)
        return pp_message_error(&err);
    if (file.rooms >= rooms)
        return PP_EXIT_DONE;
    pp_message(
        "interrupted: %s has %d of %d rooms; the same command continues from there",
        file.path, file.rooms, rooms);
    return PP_EXIT_INTERRUPTED;
}

/* ---- renewing an atlas ---- */

/* Writes the head and the first `rooms` rooms. *next is set to the index after the last
 * room that was written. */
static enum pp_status print_anew(FILE *out, const struct row_source *source, int rooms,
                                 const struct pp_room_options *options, int *next,
                                 struct pp_error *err)
{
    char *head = atlas_head_text(source->making, &source->columns);
    if (!head)
        return pp_fail_memory(err);
    fputs(head, out);
    free(head);
    return run_queue(&(struct sweep){.source = source, .out = out}, 0, rooms, options,
                     next, err);
}

static enum pp_status renew(const struct pp_atlas_making *making,
                            const struct pp_atlas_table *table,
                            const struct pp_room_options *options, struct pp_error *err)
{
    struct row_source source;
    struct pp_output output;
    int rooms = 0, next = 0;
    enum pp_status status = pp_atlas_renewal_rooms(&rooms, table, err);
    if (status == PP_OK)
        status = open_source(&source, making, table, err);
    if (status != PP_OK)
        return status;
    if (is_rank_0(options))
        status = pp_output_open(&output, options->output, err);
    else
        status = follow_sweep(&source, options, err);
    if (status == PP_OK) {
        status = print_anew(output.stream, &source, rooms, options, &next, err);
        if (status == PP_OK && next < rooms)
            status = pp_fail(err, PP_INTERRUPTED, "interrupted: nothing was written");
        status = pp_output_close(&output, status, err);
    }
    pp_atlas_columns_clear(&source.columns);
    return status;
}

enum pp_exit pp_atlas_sweep_anew(const char *path,
                                 const struct pp_room_options *options)
{
    struct pp_error err = {0};
    struct pp_atlas_making making;
    struct pp_atlas_table table;
    enum pp_status status = read_atlas_head(&making, path, &err);
    if (status == PP_OK) {
        status = pp_atlas_table_read(&table, path, &err);
        if (status == PP_OK)
            status = renew(&making, &table, options, &err);
        pp_atlas_table_clear(&table);
    }
    return status == PP_OK ? PP_EXIT_DONE : pp_message_error(&err);
}
