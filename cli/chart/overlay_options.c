/* overlay_options.c - reads the options of overlays. */
#include "cli/chart/overlay_options.h"

#include <string.h>

#include "api/chart_kind.h"
#include "model/base/text.h"

static enum pp_status read_lens(const char *text, void *place, struct pp_error *err)
{
    static const char *const names[PP_LENS_COUNT] = {
        [PP_LENS_EQUIDISTANT] = "equidistant",
        [PP_LENS_EQUISOLID] = "equisolid",
        [PP_LENS_STEREOGRAPHIC] = "stereographic",
        [PP_LENS_ORTHOGRAPHIC] = "orthographic",
    };
    struct pp_overlay_options *overlay = place;
    for (int i = 0; i < PP_LENS_COUNT; i++)
        if (strcmp(text, names[i]) == 0) {
            overlay->lens = (enum pp_lens)i;
            overlay->typed = "--lens";
            return PP_OK;
        }
    return pp_fail(err, PP_BAD_INPUT,
                   "equidistant, equisolid, stereographic or orthographic");
}

static enum pp_status read_diameter(const char *text, void *place, struct pp_error *err)
{
    struct pp_overlay_options *overlay = place;
    double mm;
    if (!pp_text_parse_number(text, &mm) || !(mm >= 20.0 && mm <= 400.0))
        return pp_fail(err, PP_BAD_INPUT, "a number of millimetres from 20 to 400");
    overlay->diameter_mm = mm;
    overlay->typed = "--diameter";
    return PP_OK;
}

static enum pp_status read_show(const char *text, void *place, struct pp_error *err)
{
    struct pp_overlay_options *overlay = place;
    overlay->said = true;
    overlay->typed = "--show";
    for (const char *at = text;; at++) {
        size_t length = strcspn(at, ",");
        bool *shown = length == 4 && strncmp(at, "dots", 4) == 0    ? &overlay->dots
                      : length == 5 && strncmp(at, "cells", 5) == 0 ? &overlay->cells
                      : length == 3 && strncmp(at, "sun", 3) == 0   ? &overlay->sun
                                                                    : NULL;
        if (!shown)
            return pp_fail(err, PP_BAD_INPUT,
                           "dots, cells, sun, or several with commas between");
        *shown = true;
        at += length;
        if (!*at)
            return PP_OK;
    }
}

const struct pp_option pp_overlay_options[] = {
    {"lens", 0, "NAME",
     "equidistant (default), equisolid, stereographic or orthographic.", read_lens, 0},
    {"diameter", 0, "MM",
     "of the horizon's circle, 20 to 400 mm (default: as the paper holds).",
     read_diameter, 0},
    {"show", 0, "WHAT,...",
     "dots of 0.1 %, cells of 0.5 %, sun (default: dots, and with --latitude "
     "sun).",
     read_show, 0},
    {0},
};
