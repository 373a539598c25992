/* plan_strip.c - see plan_strip.h. */
#include "charts/room/plan_strip.h"

#include <math.h>
#include <stdio.h>

#include "charts/room/room_plan.h"

double pp_plan_strip_height(const struct pp_style *style, int key_count)
{
    double keys =
        key_count * (1.35 * style->text[PP_TEXT_BODY]) + 0.7 * style->scale * key_count;
    return fmax(keys, 14.0 * style->scale);
}

void pp_plan_strip_draw(cairo_t *cr, const struct pp_style *style, struct pp_box strip,
                        double scale, double north_rad, const struct pp_key *keys,
                        int key_count)
{
    struct pp_box bar = pp_room_plan_scale_bar(cr, style, 1000.0 / scale,
                                               strip.x + 1.0 * style->scale, strip.y);
    char words[32];
    snprintf(words, sizeof words, "1:%.0f", scale);
    struct pp_lettering set = {.size = PP_TEXT_BODY, .bold = true};
    pp_lettering_draw(cr, style, &set, strip.x, bar.y + bar.height + style->scale,
                      words);
    struct pp_lettering note = {.size = PP_TEXT_SMALL, .grey = PP_GREY_TEXT};
    pp_lettering_draw(cr, style, &note, strip.x,
                      bar.y + bar.height + style->scale
                          + 1.35 * style->text[PP_TEXT_BODY],
                      "printed at 100\u00a0%");
    double radius = 3.8 * style->scale;
    double right = strip.x + strip.width;
    if (isfinite(north_rad)) {
        double north = right - radius - 3.5 * style->scale;
        pp_room_plan_north_arrow(cr, style, north_rad, north,
                                 strip.y + radius + 2.5 * style->scale, radius);
        right = north - radius - 4.0 * style->scale;
    }
    double left =
        fmax(bar.x + bar.width + 8.0 * style->scale, strip.x + 0.40 * strip.width);
    pp_legend_draw(cr, style, keys, key_count, left, strip.y, right - left);
}
