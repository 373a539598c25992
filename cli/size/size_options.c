/* size_options.c - reads the options of the command size. */
#include "cli/size/size_options.h"

#include <math.h>
#include <string.h>

#include "charts/sheet/canvas.h"
#include "methods/evaluate.h"
#include "methods/selection.h"
#include "model/base/text.h"
#include "studies/sizing/criterion_margin.h"

static enum pp_status read_change(const char *text, void *place, struct pp_error *err)
{
    for (int i = 0; pp_size_room_change_words[i]; i++)
        if (strcmp(text, pp_size_room_change_words[i]) == 0) {
            *(enum pp_size_change *)place = (enum pp_size_change)i;
            return PP_OK;
        }
    return pp_fail(err, PP_BAD_INPUT, "width, height, head, sill or number");
}

static enum pp_status read_height(const char *text, void *place, struct pp_error *err)
{
    double height_m;
    if (!pp_text_parse_number(text, &height_m) || !(height_m >= 1.0 && height_m <= 1e3))
        return pp_fail(err, PP_BAD_INPUT, "a height from 1 to 1000 m, such as 25");
    *(double *)place = height_m;
    return PP_OK;
}

static enum pp_status read_of(const char *text, void *place, struct pp_error *err)
{
    for (int i = 0; pp_retained_sky_words[i]; i++)
        if (strcmp(text, pp_retained_sky_words[i]) == 0) {
            *(enum pp_retained_sky_of *)place = (enum pp_retained_sky_of)i;
            return PP_OK;
        }
    return pp_fail(err, PP_BAD_INPUT, "vsc or lit-area");
}

#define PLACE(member) offsetof(struct pp_size_options, member)

const struct pp_option pp_size_task_options[] = {
    {"target", 't', "DF%", "Target daylight factor, such as 2% or 2.",
     pp_options_read_per_cent, PLACE(request.target)},
    {"for", 0, "CRITERION",
     "Use a criterion of assess as the target, with all its requirements. Add a colon "
     "and the start of a requirement to select it: en17037:minimum.",
     pp_options_read_text, PLACE(request.criterion)},
    {"by", 'b', "METHOD",
     "Method for the calculation: a method, a pair of methods, or \"traced\" for "
     "the simulation (default exact+bre, or exact+split-flux if bre does not apply).",
     pp_options_read_text, PLACE(request.by)},
    {"change", 'c', "WHAT",
     "Quantity to vary: width (default), height, head, sill, or number (of windows).",
     read_change, PLACE(request.change)},
    {"wall", 0, "NAME", "Change the windows in this wall only.", pp_options_read_text,
     PLACE(request.wall)},
    {"window", 0, "LINE", "Change only the window on this line of the room file.",
     pp_options_read_count, PLACE(request.line)},
    {0},
};

const struct pp_option pp_size_block_options[] = {
    {"obstruction", 0, "NAME",
     "Instead of a window, find the maximum height of this block at which every "
     "vertical window, or every room, keeps its share of the sky.",
     pp_options_read_text, PLACE(obstruction)},
    {"envelope", 0, "NAME",
     "Instead of a window, find the largest envelope on the plot of this block with "
     "which every vertical window keeps its share of the sky.",
     pp_options_read_text, PLACE(envelope)},
    {"draw", 0, "FILE",
     "Draw the envelope to FILE.pdf, FILE.svg or FILE.png: a plan with its heights. A "
     "PDF adds the Waldram diagram of the critical window.",
     pp_options_read_output, PLACE(draw)},
    {"of", 0, "WHAT",
     "Quantity to keep: vsc, the vertical sky component of each vertical window "
     "(default), or lit-area, the part of each room's working plane with a view of the "
     "sky.",
     read_of, PLACE(rule.of)},
    {"keep", 0, "SHARE%", "Share of the quantity to keep (default 80%).",
     pp_options_read_per_cent, PLACE(rule.keep)},
    {"enough", 0, "VSC%",
     "Vertical sky component that is always sufficient, such as 27%.",
     pp_options_read_per_cent, PLACE(rule.enough)},
    {"window-name", 0, "NAME", "Consider only the window with this name.",
     pp_options_read_text, PLACE(rule.window)},
    {"highest", 0, "M", "Maximum height in metres (default 300).", read_height,
     PLACE(highest_m)},
    {0},
};

const struct pp_option pp_size_write_option[] = {
    {"write", 'w', "FILE",
     "Write the room file with the new window sizes to FILE; everything else is "
     "unchanged.",
     pp_options_read_output, PLACE(write)},
    {0},
};

static enum pp_status check_method(const char *by, struct pp_error *err)
{
    if (strpbrk(by, ", ") || strcmp(by, "all") == 0 || strcmp(by, "default") == 0)
        return pp_fail(err, PP_BAD_INPUT,
                       "--by is \"%.200s\"; expected one method or pair, such as "
                       "exact+bre, or traced",
                       by);
    struct pp_error fault = {0};
    enum pp_status status = pp_selection_check(by, &fault);
    return status == PP_OK ? status : pp_fail(err, status, "--by: %s", fault.message);
}

/* Checks the options for --obstruction or --envelope. PP_BAD_INPUT if they are combined
 * with options for windows. */
static enum pp_status settle_block(struct pp_size_options *options,
                                   struct pp_error *err)
{
    const struct pp_size_request *request = &options->request;
    const struct pp_room_options *room = &options->room;
    struct pp_retained_sky_rule *rule = &options->rule;
    const char *other = request->target > 0.0          ? "target"
                        : request->criterion           ? "for"
                        : request->by                  ? "by"
                        : request->wall                ? "wall"
                        : request->line > 0            ? "window"
                        : options->write               ? "write"
                        : room->study.points.count > 0 ? "points"
                        : room->study.simulate         ? "simulate"
                        : room->state != PP_STATE_BOTH ? "state"
                                                       : NULL;
    const char *own = options->envelope ? "envelope" : "obstruction";
    if (options->envelope && options->obstruction)
        other = "obstruction";
    if (other)
        return pp_fail(err, PP_BAD_INPUT,
                       "--%s and --%s cannot be combined; expected only one of them",
                       other, own);
    if (options->envelope && rule->of == PP_RETAINED_SKY_LIT_AREA)
        return pp_fail(err, PP_BAD_INPUT,
                       "--envelope keeps the sky of windows; expected --of vsc");
    if (options->obstruction && options->draw)
        return pp_fail(err, PP_BAD_INPUT, "--draw is for --envelope only");
    enum pp_chart_format format;
    if (options->draw && pp_canvas_format_of(&format, options->draw, err) != PP_OK)
        return PP_BAD_INPUT;
    if (options->obstruction && options->format == PP_FORMAT_CSV)
        return pp_fail(err, PP_BAD_INPUT,
                       "CSV is for --envelope only; expected text or json");
    if (rule->of == PP_RETAINED_SKY_LIT_AREA
        && (rule->window || rule->enough > 0.0 || rule->french_m > 0.0))
        return pp_fail(err, PP_BAD_INPUT,
                       "--%s is for windows, but a lit area belongs to a room; "
                       "expected --of vsc or%s",
                       rule->window         ? "window-name"
                       : rule->enough > 0.0 ? "enough"
                                            : "vsc-point-french",
                       rule->window ? " --room NAME" : " --keep alone");
    if (rule->keep == 0.0)
        rule->keep = PP_SIZE_OPTIONS_KEEP;
    if (rule->keep >= 1.0)
        return pp_fail(err, PP_BAD_INPUT,
                       "--keep is 100%% or more; expected less, such as 80%%");
    if (rule->enough == 0.0)
        rule->enough = INFINITY;
    if (options->highest_m == 0.0)
        options->highest_m = PP_SIZE_OPTIONS_HIGHEST_M;
    rule->room = room->room;
    return PP_OK;
}

const char *pp_size_options_block(const struct pp_size_options *options)
{
    return options->envelope ? options->envelope : options->obstruction;
}

/* Name of the first option given that requires --obstruction or --envelope; NULL:
 * none. */
static const char *stray_rule(const struct pp_size_options *options)
{
    const struct pp_retained_sky_rule *rule = &options->rule;
    return options->highest_m > 0.0               ? "highest"
           : options->draw                        ? "draw"
           : rule->window                         ? "window-name"
           : rule->keep > 0.0                     ? "keep"
           : rule->enough > 0.0                   ? "enough"
           : rule->french_m > 0.0                 ? "vsc-point-french"
           : rule->of == PP_RETAINED_SKY_LIT_AREA ? "of"
                                                  : NULL;
}

/* Checks the options for a criterion, which determines target and points. */
static enum pp_status settle_criterion(struct pp_size_options *options,
                                       struct pp_error *err)
{
    struct pp_size_request *request = &options->request;
    const char *by = request->by;
    const char *other = request->target > 0.0                  ? "target"
                        : by && strcmp(by, "traced") != 0      ? "by"
                        : options->room.study.points.count > 0 ? "points"
                                                               : NULL;
    if (other)
        return pp_fail(err, PP_BAD_INPUT,
                       "--%s and --for cannot be combined; expected only one of them%s",
                       other, strcmp(other, "by") == 0 ? ", or --by traced" : "");
    struct pp_error fault = {0};
    enum pp_status status = pp_criterion_margin_check(request->criterion, &fault);
    request->target = 1.0;
    return status == PP_OK ? status : pp_fail(err, status, "--for: %s", fault.message);
}

enum pp_status pp_size_options_settle(struct pp_size_options *options,
                                      struct pp_error *err)
{
    if (pp_size_options_block(options)) {
        enum pp_status status = pp_sweep_choose(&options->room.sweep, 0, err);
        return status == PP_OK ? settle_block(options, err) : status;
    }
    const char *stray = stray_rule(options);
    if (stray)
        return pp_fail(
            err, PP_BAD_INPUT,
            "--%s needs --obstruction or --envelope; expected one of these as well",
            stray);
    if (!options->request.criterion
        && (options->request.grid.largest || options->request.grid.spacing_m > 0.0))
        return pp_fail(err, PP_BAD_INPUT,
                       "--spacing applies only with a criterion; expected --for as "
                       "well");
    if (options->request.criterion) {
        enum pp_status status = settle_criterion(options, err);
        if (status != PP_OK)
            return status;
    }
    if (!(options->request.target > 0.0))
        return pp_fail(err, PP_BAD_INPUT,
                       "no target is given; expected --target with a daylight factor, "
                       "such as --target 2%%, or --for with a criterion");
    options->request.traced =
        options->request.by && strcmp(options->request.by, "traced") == 0;
    options->request.study = &options->room.study;
    if (options->request.traced && options->room.by_hand)
        return pp_fail(err, PP_BAD_INPUT,
                       "--by traced needs the simulation, but --by-hand leaves it out; "
                       "expected only one of them");
    enum pp_status status = pp_room_options_settle_by_hand(&options->room, err);
    if (status == PP_OK)
        status = pp_room_options_settle(&options->room, err);
    if (status == PP_OK && options->request.by && !options->request.traced)
        status = check_method(options->request.by, err);
    return status;
}
