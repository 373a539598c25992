/* model_options.c - reads the options of scale models. */
#include "cli/chart/model_options.h"

#include <string.h>

#include "api/chart_kind.h"
#include "model/base/text.h"

static enum pp_status read_scale(const char *text, void *place, struct pp_error *err)
{
    struct pp_model_options *options = place;
    double scale;
    if (!pp_text_parse_number(text, &scale) || !(scale >= 2.0 && scale <= 500.0))
        return pp_fail(err, PP_BAD_INPUT, "a number from 2 to 500: 20 for 1:20");
    options->scale = scale;
    options->typed = "--scale";
    return PP_OK;
}

static enum pp_status read_mirror_box(const char *text, void *place,
                                      struct pp_error *err)
{
    struct pp_model_options *options = place;
    const char *comma = strchr(text, ',');
    char first[32] = "";
    double rho = -1.0, height = -1.0;
    if (comma && (size_t)(comma - text) < sizeof first)
        memcpy(first, text, (size_t)(comma - text));
    if (!pp_text_parse_number(first, &rho) || !(rho > 0.0 && rho <= 1.0)
        || !pp_text_parse_number(comma + 1, &height)
        || !(height >= 0.01 && height <= 10.0))
        return pp_fail(err, PP_BAD_INPUT,
                       "the mirrors' reflectance, above 0 to 1, and the box's height "
                       "over its width, 0.01 to 10: 0.85,0.5");
    options->box = (struct pp_mirror_box){rho, height};
    options->has_box = true;
    options->typed = "--mirror-box";
    return PP_OK;
}

const struct pp_option pp_model_options[] = {
    {"scale", 0, "N", "1:N, from 2 to 500 (default 20).", read_scale, 0},
    {"mirror-box", 0, "RHO,K",
     "Of the artificial sky that it is for: the mirrors' reflectance, and the box's "
     "height over its width (default 0.85,0.5).",
     read_mirror_box, 0},
    {0},
};
