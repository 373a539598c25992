/* render_choice.c - reads the options of the command render and checks that they are
 * consistent. */
#include "cli/render/render_choice.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "model/base/text.h"
#include "model/pictures/raster.h"

/* Size of a text that lists the formats (bytes). */
enum { EXTENSIONS_SIZE = 128 };

struct pp_render_choice pp_render_choice_default(void)
{
    return (struct pp_render_choice){.cache = pp_cache_choice_default()};
}

void pp_render_choice_clear(struct pp_render_choice *choice)
{
    pp_cache_choice_clear(&choice->cache);
}

enum pp_status pp_render_choice_format(struct pp_picture_format *format,
                                       const struct pp_render_choice *choice,
                                       const char *path, struct pp_error *err)
{
    char extensions[EXTENSIONS_SIZE];
    path = path ? path : "-";
    if (choice->format ? pp_picture_format_named(format, choice->format)
                       : pp_picture_format_of(format, path))
        return PP_OK;
    return pp_fail(err, PP_BAD_INPUT,
                   "the file type of \"%.200s\" is not clear from its name; expected a "
                   "name that ends in %s, or --format",
                   path,
                   pp_picture_format_list(extensions, sizeof extensions, ".", false));
}

bool pp_render_choice_on_sheet(const struct pp_render_choice *choice,
                               const struct pp_picture_format *format)
{
    if (format->numbers)
        return false;
    return format->shown != PP_CHART_PNG || choice->false_colour || choice->grid
           || choice->records;
}

/* First option given that applies only to rendering a room; NULL: none. */
static const char *making_said(const struct pp_render_choice *choice,
                               const struct pp_room_options *options)
{
    const struct {
        const char *name;
        bool said;
    } list[] = {
        {"--view", choice->view != PP_CHOOSE_PERSPECTIVE},
        {"--from", choice->from.count > 0},
        {"--towards", choice->towards.count > 0},
        {"--direction", choice->direction.count > 0},
        {"--up", choice->up.count > 0},
        {"--angle", choice->angle_deg > 0.0},
        {"--across", choice->across_m > 0.0},
        {"--size", choice->size.width > 0},
        {"--samples", choice->samples > 0},
        {"--engine", choice->paths},
        {"--plain", options->study.method_options.plain},
        {"--windows", choice->windows != PP_WINDOWS_STORED},
        {"--filter", choice->filter != PP_FILTER_BOX},
        {"--checkpoint", choice->checkpoint != NULL},
        {"--errors", choice->errors != NULL},
        {"--external", options->study.external_lux > 0.0},
        {"--sky", options->study.sky != NULL},
        {"--room", options->room != NULL},
        {"--seed", options->study.seed != pp_room_options_none.study.seed},
    };
    for (size_t i = 0; i < sizeof list / sizeof *list; i++)
        if (list[i].said)
            return list[i].name;
    return NULL;
}

/* Checks the options of the sheet. All of them require a picture that is drawn on a
 * sheet; --dpi requires a PNG. */
static enum pp_status check_sheet(const struct pp_render_choice *choice,
                                  const struct pp_picture_format *format,
                                  struct pp_error *err)
{
    const char *of_sheet = choice->paper.said                  ? "--paper"
                           : choice->orientation != PP_AS_FITS ? "--orientation"
                           : choice->dpi > 0.0                 ? "--dpi"
                                                               : NULL;
    if (of_sheet && !pp_render_choice_on_sheet(choice, format))
        return pp_fail(err, PP_BAD_INPUT,
                       "%s is for sheets; expected -o FILE.pdf or FILE.svg, or "
                       "--false-colour, --grid or --records",
                       of_sheet);
    if (choice->dpi > 0.0 && format->shown != PP_CHART_PNG)
        return pp_fail(
            err, PP_BAD_INPUT,
            "--dpi is for a PNG sheet; PDF and SVG files have no resolution");
    return PP_OK;
}

/* Checks the size of the picture. The limit is lower for a displayed picture than for a
 * picture stored as numbers. */
static enum pp_status check_size(const struct pp_render_choice *choice, bool shown,
                                 struct pp_error *err)
{
    const struct pp_picture_size *size = &choice->size;
    if (!shown
        || (size->width <= PP_RASTER_SIDE_MOST && size->height <= PP_RASTER_SIDE_MOST))
        return PP_OK;
    char extensions[EXTENSIONS_SIZE];
    return pp_fail(err, PP_BAD_INPUT,
                   "a picture of %d x %d pixels can be stored, as %s, but not "
                   "displayed; expected at most %d each way",
                   size->width, size->height,
                   pp_picture_format_list(extensions, sizeof extensions, ".", true),
                   PP_RASTER_SIDE_MOST);
}

static enum pp_status check_view(const struct pp_render_choice *choice,
                                 struct pp_error *err)
{
    bool parallel = choice->view == PP_CHOOSE_PARALLEL || choice->view == PP_CHOOSE_PLAN
                    || choice->view == PP_CHOOSE_SECTION;
    if (choice->towards.count && choice->direction.count)
        return pp_fail(err, PP_BAD_INPUT,
                       "--towards and --direction both determine the view; expected "
                       "only one of them");
    if (parallel && choice->angle_deg > 0.0)
        return pp_fail(
            err, PP_BAD_INPUT,
            "a parallel view has no angle; expected --across M instead of --angle");
    if (choice->view == PP_CHOOSE_PERSPECTIVE && choice->angle_deg >= 180.0)
        return pp_fail(err, PP_BAD_INPUT,
                       "--angle is %g; expected more than 0 and less than 180 degrees "
                       "for a perspective view",
                       choice->angle_deg);
    if (!parallel && choice->across_m > 0.0)
        return pp_fail(err, PP_BAD_INPUT,
                       "--across is for parallel views; expected --angle DEG");
    if (choice->view == PP_CHOOSE_PARALLEL && !choice->from.count)
        return pp_fail(
            err, PP_BAD_INPUT,
            "a parallel view needs an eye and a direction; expected --from X,Y,Z with "
            "--direction or --towards, or the view plan or section");
    return PP_OK;
}

/* Checks the options for standard errors, which require a numeric format and several
 * paths per pixel. */
static enum pp_status check_errors(const struct pp_render_choice *choice,
                                   struct pp_error *err)
{
    struct pp_picture_format format;
    char extensions[EXTENSIONS_SIZE];
    if (!choice->errors)
        return PP_OK;
    if (!pp_picture_format_of(&format, choice->errors) || !format.numbers)
        return pp_fail(
            err, PP_BAD_INPUT,
            "--errors is \"%.200s\", but standard errors are stored as "
            "numbers; expected a file that ends in %s",
            choice->errors,
            pp_picture_format_list(extensions, sizeof extensions, ".", true));
    if (choice->samples < PP_RENDER_RANDOMISATIONS_LEAST)
        return pp_fail(err, PP_BAD_INPUT,
                       "--errors compares the paths of a pixel, but there are only %d; "
                       "expected --samples of %d or more",
                       choice->samples, PP_RENDER_RANDOMISATIONS_LEAST);
    return PP_OK;
}

enum pp_status pp_render_choice_check(struct pp_render_choice *choice,
                                      const struct pp_room_options *options,
                                      int file_count, struct pp_error *err)
{
    char extensions[EXTENSIONS_SIZE];
    if (choice->from_picture && file_count > 0)
        return pp_fail(err, PP_BAD_INPUT,
                       "--from-picture displays a picture instead of a room; expected "
                       "only one of them");
    const char *making = making_said(choice, options);
    if (choice->from_picture && making)
        return pp_fail(err, PP_BAD_INPUT,
                       "%s is for rendering; it cannot be combined with --from-picture",
                       making);
    if (!choice->from_picture && file_count != 1)
        return pp_fail(err, PP_BAD_INPUT,
                       "expected one room file, or - for standard input");
    if (!options->output && !choice->format)
        return pp_fail(
            err, PP_BAD_INPUT, "expected -o %s",
            pp_picture_format_list(extensions, sizeof extensions, "FILE.", false));
    struct pp_picture_format format;
    enum pp_status status =
        pp_render_choice_format(&format, choice, options->output, err);
    if (status != PP_OK)
        return status;
    bool shown = !format.numbers;
    if ((choice->false_colour || choice->grid || choice->records) && !shown)
        return pp_fail(
            err, PP_BAD_INPUT,
            "%s displayed, not stored; expected -o FILE.png, FILE.pdf or FILE.svg",
            choice->false_colour ? "false colour is"
            : choice->grid       ? "a grid is"
                                 : "records are");
    const char *of_cache =
        choice->records ? "--records" : pp_cache_choice_used(&choice->cache);
    bool plain = options->study.method_options.plain;
    if (of_cache && (choice->paths || plain || choice->from_picture))
        return pp_fail(err, PP_BAD_INPUT,
                       "%s is for rendering a room with --engine cache", of_cache);
    const char *of_transport =
        choice->windows != PP_WINDOWS_STORED ? "--windows"
        : choice->cache.options.bounces != pp_irradiance_cache_defaults().bounces
            ? "--bounces"
            : NULL;
    if (plain && of_transport)
        return pp_fail(err, PP_BAD_INPUT,
                       "%s cannot be combined with --plain, which follows every path "
                       "and samples every window; expected only one of them",
                       of_transport);
    if (choice->exposure.said && !shown)
        return pp_fail(err, PP_BAD_INPUT,
                       "stored light has no exposure; expected -o FILE.png, FILE.pdf "
                       "or FILE.svg with --exposure");
    const char *of_scale = choice->range.count    ? "--range"
                           : choice->linear       ? "--linear"
                           : choice->levels.count ? "--levels"
                           : choice->no_contours  ? "--no-contours"
                                                  : NULL;
    if (of_scale && !choice->false_colour)
        return pp_fail(err, PP_BAD_INPUT, "%s is for the scale of --false-colour",
                       of_scale);
    if (choice->grid
        && (choice->from_picture || choice->view < PP_CHOOSE_HEMISPHERICAL))
        return pp_fail(err, PP_BAD_INPUT,
                       "--grid is for a fisheye view of a room; expected --view "
                       "hemispherical or angular");
    if (choice->exposure.said && choice->false_colour)
        return pp_fail(err, PP_BAD_INPUT,
                       "false colour has no exposure; expected --range LOW,HIGH");
    if (choice->exposure.way == PP_TONE_HUMAN && choice->exposure.said
        && choice->quantity.is != PP_LUMINANCE)
        return pp_fail(err, PP_BAD_INPUT,
                       "--exposure human is for luminance; expected no --quantity %s",
                       pp_quantity_words(choice->quantity.is).name);
    if (options->study.external_lux > 0.0 && choice->quantity.is == PP_DAYLIGHT_FACTOR)
        return pp_fail(err, PP_BAD_INPUT,
                       "a daylight factor does not depend on --external; expected "
                       "another --quantity, or no --external");
    if (choice->samples == 0)
        choice->samples = 16;
    status = check_view(choice, err);
    if (status == PP_OK)
        status = check_sheet(choice, &format, err);
    if (status == PP_OK)
        status = check_size(choice, shown, err);
    if (status == PP_OK)
        status = check_errors(choice, err);
    return status == PP_OK ? pp_cache_choice_settle(&choice->cache, err) : status;
}
