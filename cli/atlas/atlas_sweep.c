/* atlas_sweep.c - joins the rooms to the file they go to. */
#include "cli/atlas/atlas_sweep.h"

#include <stdlib.h>

#include "cli/atlas/atlas_file.h"
#include "cli/interrupt.h"
#include "cli/message.h"
#include "cli/output.h"
#include "studies/atlas/atlas_renewal.h"
#include "studies/atlas/atlas_room.h"
#include "studies/atlas/atlas_run.h"

/* What rows are worked out of. */
struct source {
    const struct pp_atlas_making *making;
    const struct pp_atlas_table *table; /* that the truth is kept of; NULL: traced */
    struct pp_atlas_design design;
    struct pp_atlas_columns columns;
};

static enum pp_status open_source(struct source *source,
                                  const struct pp_atlas_making *making,
                                  const struct pp_atlas_table *table,
                                  struct pp_error *err)
{
    source->making = making;
    source->table = table;
    pp_atlas_design_init(&source->design, making->sky);
    return pp_atlas_room_columns(&source->columns, &source->design, err);
}

static enum pp_status rows_of(const void *of, int room, char **rows, size_t *length,
                              struct pp_error *err)
{
    const struct source *source = of;
    if (source->table)
        return pp_atlas_renewal_rows(rows, length, &source->columns, &source->design,
                                     source->table, room, err);
    return pp_atlas_room_rows(rows, length, &source->columns, &source->design, room,
                              &source->making->trace, err);
}

/* ---- on ---- */

static enum pp_status take(void *to, const char *rows, size_t length,
                           struct pp_error *err)
{
    struct pp_atlas_file *file = to;
    enum pp_status status = pp_atlas_file_add(file, rows, length, err);
    file->rooms += status == PP_OK;
    return status;
}

static enum pp_status go_on(struct pp_atlas_file *file, const struct source *source,
                            int rooms, const struct pp_room_options *options,
                            struct pp_error *err)
{
    char *head = pp_atlas_head_text(source->making, &source->columns);
    if (!head)
        return pp_fail_memory(err);
    enum pp_status status = pp_atlas_file_open(file, options->output, head, err);
    free(head);
    if (status != PP_OK)
        return status;
    int next;
    pp_interrupt_watch();
    status = pp_atlas_run(&(struct pp_atlas_run){.first = file->rooms,
                                                 .end = rooms,
                                                 .threads = options->study.threads,
                                                 .watch = options->study.watch,
                                                 .rows_of = rows_of,
                                                 .of = source,
                                                 .take = take,
                                                 .to = file},
                          &next, err);
    return pp_atlas_file_close(file, status, err);
}

enum pp_exit pp_atlas_sweep_on(const struct pp_atlas_making *making, int rooms,
                               const struct pp_room_options *options)
{
    struct pp_error err = {0};
    struct pp_atlas_file file = {0};
    struct source source;
    enum pp_status status = open_source(&source, making, NULL, &err);
    if (status == PP_OK) {
        status = go_on(&file, &source, rooms, options, &err);
        pp_atlas_columns_clear(&source.columns);
    }
    if (status != PP_OK)
        return pp_message_error(&err);
    if (file.rooms >= rooms)
        return PP_EXIT_DONE;
    pp_message(
        "interrupted: %s has %d rooms of %d; the same command goes on from there",
        file.path, file.rooms, rooms);
    return PP_EXIT_INTERRUPTED;
}

/* ---- anew ---- */

static enum pp_status put(void *to, const char *rows, size_t length,
                          struct pp_error *err)
{
    return pp_output_put(to, (const unsigned char *)rows, length, err);
}

/* Prints head and rooms. *next: the room after the last. */
static enum pp_status print_anew(FILE *out, const struct source *source, int rooms,
                                 const struct pp_room_options *options, int *next,
                                 struct pp_error *err)
{
    char *head = pp_atlas_head_text(source->making, &source->columns);
    if (!head)
        return pp_fail_memory(err);
    fputs(head, out);
    free(head);
    pp_interrupt_watch();
    return pp_atlas_run(&(struct pp_atlas_run){.end = rooms,
                                               .threads = options->study.threads,
                                               .watch = options->study.watch,
                                               .rows_of = rows_of,
                                               .of = source,
                                               .take = put,
                                               .to = out},
                        next, err);
}

static enum pp_status renew(const struct pp_atlas_making *making,
                            const struct pp_atlas_table *table,
                            const struct pp_room_options *options, struct pp_error *err)
{
    struct source source;
    struct pp_output output;
    int rooms = 0, next = 0;
    enum pp_status status = pp_atlas_renewal_rooms(&rooms, table, err);
    if (status == PP_OK)
        status = open_source(&source, making, table, err);
    if (status != PP_OK)
        return status;
    status = pp_output_open(&output, options->output, err);
    if (status == PP_OK) {
        status = print_anew(output.stream, &source, rooms, options, &next, err);
        if (status == PP_OK && next < rooms)
            status = pp_fail(err, PP_INTERRUPTED, "interrupted: nothing is written");
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
    enum pp_status status = pp_atlas_head_read(&making, path, &err);
    if (status == PP_OK) {
        status = pp_atlas_table_read(&table, path, &err);
        if (status == PP_OK)
            status = renew(&making, &table, options, &err);
        pp_atlas_table_clear(&table);
    }
    return status == PP_OK ? PP_EXIT_DONE : pp_message_error(&err);
}
