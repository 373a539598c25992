/* size_block.c - see size_block.h. */
#include "cli/size/size_block.h"

#include <math.h>

#include "cli/job.h"
#include "cli/message.h"
#include "cli/rooms.h"
#include "cli/terminal.h"
#include "model/base/text.h"
#include "reports/block_height_report.h"

struct block_run {
    const struct pp_size_options *options;
    struct pp_block_height_task task;
    struct pp_block_height found;
    const char *file;
};

enum { NAMES_MOST = 64 };

/* Nobody builds higher beside a house. */
static const double highest_m = 300.0;

static enum pp_status compute(void *data, struct pp_error *err)
{
    struct block_run *run = data;
    struct pp_error fault = {0};
    const char *name = run->task.block, *names[NAMES_MOST];
    int count = pp_building_block_names(run->task.building, names, NAMES_MOST);
    if (!isfinite(pp_building_block_height(run->task.building, name)))
        return count == 0
                   ? pp_fail(err, PP_BAD_INPUT,
                             "%s: no block in it has a name; expected one named "
                             "\"%.60s\"",
                             run->file, name)
                   : pp_text_unknown(err, name, names, count, NULL,
                                     "%s: there is not one block named \"%.60s\"",
                                     run->file, name);
    enum pp_status status = pp_block_height_find(&run->found, &run->task, &fault);
    return status == PP_OK ? status
                           : pp_fail(err, status, "%s: %s", run->file, fault.message);
}

static enum pp_status print(const void *data, FILE *out, struct pp_error *err)
{
    const struct block_run *run = data;
    return run->options->format == PP_FORMAT_JSON
               ? pp_block_height_report_json(&run->found, &run->task, out, err)
               : pp_block_height_report(&run->found, &run->task,
                                        pp_terminal_width(run->options->room.output),
                                        out, err);
}

enum pp_exit pp_size_block(const struct pp_size_options *options, const char *file)
{
    struct pp_rooms rooms;
    char *files[] = {(char *)file};
    enum pp_exit exit_status = pp_rooms_load(&rooms, "size", files, 1, &options->room);
    if (exit_status != PP_EXIT_DONE)
        return exit_status;
    struct block_run run = {.options = options,
                            .file = file,
                            .task = {.building = rooms.buildings[0],
                                     .block = options->obstruction,
                                     .rule = options->rule,
                                     .most_m = highest_m}};
    exit_status =
        pp_job_run(&(struct pp_job){options->room.output, compute, print, NULL, &run});
    pp_block_height_clear(&run.found);
    pp_rooms_clear(&rooms);
    return exit_status;
}
