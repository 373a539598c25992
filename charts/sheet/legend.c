/* legend.c - draws or measures a column of samples with text. One function does both,
 * so that a measured legend has the size of the drawn one.
 */
#include "charts/sheet/legend.h"

#include <math.h>

#include "charts/sheet/hatch.h"

static double sample_width(const struct pp_style *style)
{
    return 7.0 * style->scale;
}

void pp_legend_bar(cairo_t *cr, const struct pp_style *style, enum pp_marker marker,
                   double x, double y, double y_low, double y_high)
{
    double cap = 0.55 * style->marker;
    pp_style_line(cr, style->thin, PP_INK);
    cairo_move_to(cr, x, y_low);
    cairo_line_to(cr, x, y_high);
    for (int i = 0; i < 2; i++) {
        double end = i ? y_high : y_low;
        cairo_move_to(cr, x - cap, end);
        cairo_line_to(cr, x + cap, end);
    }
    cairo_stroke(cr);
    pp_style_marker(cr, style, marker, x, y);
}

static void draw_sample(cairo_t *cr, const struct pp_style *style,
                        const struct pp_key *key, double x, double y)
{
    double width = sample_width(style), half = 1.3 * style->scale;
    switch (key->kind) {
    case PP_KEY_LINE:
    case PP_KEY_MARKED_LINE:
        pp_style_pen(cr, style, &key->curve);
        pp_style_grey(cr, key->grey);
        cairo_move_to(cr, x, y);
        cairo_line_to(cr, x + width, y);
        cairo_stroke(cr);
        if (key->kind == PP_KEY_MARKED_LINE)
            pp_style_marker(cr, style, key->curve.marker, x + 0.5 * width, y);
        break;
    case PP_KEY_SAMPLED:
        pp_legend_bar(cr, style, key->curve.marker, x + 0.5 * width, y, y + half,
                      y - half);
        break;
    case PP_KEY_MARKER:
        pp_style_marker(cr, style, key->curve.marker, x + 0.5 * width, y);
        break;
    case PP_KEY_TINT:
        pp_style_grey(cr, key->grey);
        cairo_rectangle(cr, x, y - half, width, 2.0 * half);
        cairo_fill(cr);
        break;
    case PP_KEY_COLOUR:
        cairo_set_source_rgb(cr, key->colour[0], key->colour[1], key->colour[2]);
        cairo_rectangle(cr, x, y - half, width, 2.0 * half);
        cairo_fill_preserve(cr);
        pp_style_line(cr, style->hair, PP_INK);
        cairo_stroke(cr);
        break;
    case PP_KEY_HATCH:
        cairo_rectangle(cr, x, y - half, width, 2.0 * half);
        pp_hatch_path(cr, (struct pp_box){x, y - half, width, 2.0 * half},
                      key->curve.dashes[0] * style->scale, style->hair, PP_GREY_TEXT);
        break;
    }
}

static struct pp_box legend(cairo_t *cr, const struct pp_style *style,
                            const struct pp_key *keys, int count, double x, double y,
                            double width, bool drawn)
{
    double indent = sample_width(style) + 1.5 * style->scale;
    struct pp_lettering words = {
        .size = PP_TEXT_BODY, .width = fmax(width - indent, 5.0), .lines = 2};
    struct pp_box all = {x, y, 0.0, 0.0};
    for (int i = 0; i < count; i++) {
        double top = y + all.height;
        struct pp_box box =
            pp_lettering_measure(cr, style, &words, x + indent, top, keys[i].words);
        if (drawn) {
            pp_lettering_draw(cr, style, &words, x + indent, top, keys[i].words);
            draw_sample(cr, style, &keys[i], x, top + 0.65 * style->text[PP_TEXT_BODY]);
        }
        all.width = fmax(all.width, indent + box.width);
        all.height += box.height + (i + 1 < count ? 0.7 * style->scale : 0.0);
    }
    return all;
}

struct pp_box pp_legend_draw(cairo_t *cr, const struct pp_style *style,
                             const struct pp_key *keys, int count, double x, double y,
                             double width)
{
    return legend(cr, style, keys, count, x, y, width, true);
}

struct pp_box pp_legend_measure(cairo_t *cr, const struct pp_style *style,
                                const struct pp_key *keys, int count, double x,
                                double y, double width)
{
    return legend(cr, style, keys, count, x, y, width, false);
}
