/* size_block.c - see size_block.h. */
#include "cli/size/size_block.h"

#include <math.h>

#include "api/draw_envelope.h"
#include "cli/job.h"
#include "cli/message.h"
#include "cli/output.h"
#include "cli/rooms.h"
#include "cli/terminal.h"
#include "model/base/text.h"
#include "reports/block_height_report.h"
#include "reports/plot_envelope_report.h"

enum { NAMES_MOST = 64 };

struct block_run {
    const struct pp_size_options *options;
    const char *file;
    struct pp_block_height_task height_task;
    struct pp_block_height height;
    struct pp_plot_envelope_task envelope_task;
    struct pp_plot_envelope envelope;
};

/* PP_BAD_INPUT where the file has not one block so called. */
static enum pp_status check_name(const char *file, const struct pp_building *building,
                                 const char *name, struct pp_error *err)
{
    const char *names[NAMES_MOST];
    int count = pp_building_block_names(building, names, NAMES_MOST);
    if (isfinite(pp_building_block_height(building, name)))
        return PP_OK;
    return count == 0 ? pp_fail(err, PP_BAD_INPUT,
                                "%s: no block in it has a name; expected one named "
                                "\"%.60s\"",
                                file, name)
                      : pp_text_unknown(err, name, names, count, NULL,
                                        "%s: there is not one block named \"%.60s\"",
                                        file, name);
}

static enum pp_status draw_to(struct block_run *run, FILE *out, struct pp_error *err)
{
    struct pp_sheet sheet = {.landscape = true,
                             .title = run->envelope_task.block,
                             .description = "the largest envelope on the plot"};
    struct pp_canvas *canvas;
    enum pp_status status = pp_canvas_format_of(&sheet.format, run->options->draw, err);
    if (status == PP_OK)
        status = pp_canvas_create(&canvas, &sheet, err);
    if (status != PP_OK)
        return status;
    status =
        pp_draw_envelope(canvas, &run->envelope, &run->envelope_task, run->file, err);
    if (status == PP_OK)
        status = pp_canvas_write(canvas, pp_output_put, out, err);
    pp_canvas_destroy(canvas);
    return status;
}

static enum pp_status draw_envelope_chart(struct block_run *run, struct pp_error *err)
{
    struct pp_output output;
    enum pp_status status = pp_output_open(&output, run->options->draw, err);
    if (status == PP_OK)
        status = draw_to(run, output.stream, err);
    return pp_output_close(&output, status, err);
}

static enum pp_status compute_block_height(void *data, struct pp_error *err)
{
    struct block_run *run = data;
    struct pp_error fault = {0};
    enum pp_status status =
        check_name(run->file, run->height_task.building, run->height_task.block, err);
    if (status != PP_OK)
        return status;
    status = run->options->envelope
                 ? pp_plot_envelope_find(&run->envelope, &run->envelope_task, &fault)
                 : pp_block_height_find(&run->height, &run->height_task, &fault);
    if (status != PP_OK)
        return pp_fail(err, status, "%s: %s", run->file, fault.message);
    return run->options->draw ? draw_envelope_chart(run, err) : PP_OK;
}

static enum pp_status print_height(const struct block_run *run, int width, FILE *out,
                                   struct pp_error *err)
{
    return run->options->format == PP_FORMAT_JSON
               ? pp_block_height_report_json(&run->height, &run->height_task, out, err)
               : pp_block_height_report(&run->height, &run->height_task, width, out,
                                        err);
}

static enum pp_status print_envelope(const struct block_run *run, int width, FILE *out,
                                     struct pp_error *err)
{
    switch (run->options->format) {
    case PP_FORMAT_JSON:
        return pp_plot_envelope_report_json(&run->envelope, &run->envelope_task, out,
                                            err);
    case PP_FORMAT_CSV:
        return pp_plot_envelope_report_csv(&run->envelope, &run->envelope_task, out,
                                           err);
    default:
        return pp_plot_envelope_report(&run->envelope, &run->envelope_task, width, out,
                                       err);
    }
}

static enum pp_status print_block_height(const void *data, FILE *out,
                                         struct pp_error *err)
{
    const struct block_run *run = data;
    int width = pp_terminal_width(run->options->room.output);
    return run->options->envelope ? print_envelope(run, width, out, err)
                                  : print_height(run, width, out, err);
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
                            .height_task = {.building = rooms.buildings[0],
                                            .block = pp_size_options_block(options),
                                            .rule = options->rule,
                                            .most_m = options->highest_m},
                            .envelope_task = {.building = rooms.buildings[0],
                                              .block = pp_size_options_block(options),
                                              .rule = options->rule,
                                              .most_m = options->highest_m}};
    exit_status = pp_job_run(&(struct pp_job){
        options->room.output, compute_block_height, print_block_height, NULL, &run});
    pp_block_height_clear(&run.height);
    pp_plot_envelope_clear(&run.envelope);
    pp_rooms_clear(&rooms);
    return exit_status;
}
