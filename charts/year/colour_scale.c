/* colour_scale.c - see colour_scale.h. */
#include "charts/year/colour_scale.h"

#include <stdio.h>

/* Colours whose lightness increases evenly. Blue and yellow can be distinguished with
 * any type of colour vision. */
static const double colours[PP_COLOUR_CLASSES][3] = {
    {0.00, 0.13, 0.30}, {0.19, 0.26, 0.42}, {0.34, 0.36, 0.43}, {0.49, 0.48, 0.47},
    {0.65, 0.61, 0.46}, {0.82, 0.75, 0.39}, {1.00, 0.92, 0.40}};

int pp_colour_scale_class(const struct pp_colour_scale *scale, double value)
{
    int i = 0;
    while (i + 1 < PP_COLOUR_CLASSES && value >= scale->limits[i + 1])
        i++;
    return i;
}

void pp_colour_scale_set(cairo_t *cr, const struct pp_colour_scale *scale, double value)
{
    const int i = pp_colour_scale_class(scale, value);
    cairo_set_source_rgb(cr, colours[i][0], colours[i][1], colours[i][2]);
}

double pp_colour_scale_legend(cairo_t *cr, const struct pp_style *style,
                              const struct pp_colour_scale *scale, double x, double y,
                              double width_mm)
{
    double patch = width_mm / PP_COLOUR_CLASSES, height = 2.5 * style->scale;
    struct pp_lettering words = {.size = PP_TEXT_SMALL, .across = 0.5};
    for (int i = 0; i < PP_COLOUR_CLASSES; i++) {
        cairo_set_source_rgb(cr, colours[i][0], colours[i][1], colours[i][2]);
        cairo_rectangle(cr, x + i * patch, y, patch, height);
        cairo_fill(cr);
    }
    double free_from = x;
    for (int i = 1; i < PP_COLOUR_CLASSES; i++) {
        char text[32];
        snprintf(text, sizeof text, "%g%s", scale->limits[i],
                 i + 1 == PP_COLOUR_CLASSES ? scale->unit : "");
        struct pp_box box = pp_lettering_measure(cr, style, &words, x + i * patch,
                                                 y + height + 0.3 * style->scale, text);
        if (box.x < free_from)
            continue;
        pp_lettering_draw(cr, style, &words, x + i * patch,
                          y + height + 0.3 * style->scale, text);
        free_from = box.x + box.width + 0.5 * style->scale;
    }
    return height + 3.5 * style->scale;
}
