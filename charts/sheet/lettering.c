/* lettering.c - lays out text with Pango, unhinted, and draws or measures it. */
#include "charts/sheet/lettering.h"

#include <stdio.h>

#include <pango/pangocairo.h>

/* Fonts in order of preference. The last is an alias that exists on every machine. */
static const char families[] =
    "Source Sans 3, Source Sans Pro, Nimbus Sans, Liberation Sans, "
    "DejaVu Sans Condensed, DejaVu Sans, sans-serif";

bool pp_lettering_boxes_overlap(struct pp_box a, struct pp_box b)
{
    return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height
           && b.y < a.y + a.height;
}

/* Type size for all layouts (mm), which are then scaled. For each new size, Pango
 * searches the fonts of the machine again, with two threads. */
static const double laid_out_mm = 4.0;

static double enlargement(const struct pp_style *style, const struct pp_lettering *text)
{
    return style->text[text->size] / laid_out_mm;
}

/* Lays out text at the size laid_out_mm; the caller scales the layout. */
static PangoLayout *layout_of(cairo_t *cr, const struct pp_style *style,
                              const struct pp_lettering *text, const char *words)
{
    PangoLayout *layout = pango_cairo_create_layout(cr);
    PangoContext *context = pango_layout_get_context(layout);
    cairo_font_options_t *options = cairo_font_options_create();
    cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
    cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
    pango_cairo_context_set_font_options(context, options);
    cairo_font_options_destroy(options);
    pango_context_set_round_glyph_positions(context, FALSE);
    /* fixed, not from the locale, so that a sheet has the same bytes everywhere */
    pango_context_set_language(context, pango_language_from_string("en"));
    pango_layout_context_changed(layout);

    PangoFontDescription *font = pango_font_description_new();
    pango_font_description_set_family_static(font, families);
    pango_font_description_set_absolute_size(font, laid_out_mm * PANGO_SCALE);
    if (text->bold)
        pango_font_description_set_weight(font, PANGO_WEIGHT_BOLD);
    if (text->italic)
        pango_font_description_set_style(font, PANGO_STYLE_ITALIC);
    pango_layout_set_font_description(layout, font);
    pango_font_description_free(font);

    if (text->width > 0.0) {
        pango_layout_set_width(
            layout, (int)(text->width / enlargement(style, text) * PANGO_SCALE));
        pango_layout_set_wrap(layout, PANGO_WRAP_WORD_CHAR);
        pango_layout_set_ellipsize(layout, text->lines ? PANGO_ELLIPSIZE_END
                                                       : PANGO_ELLIPSIZE_NONE);
        pango_layout_set_height(layout, text->lines ? -text->lines : -1);
    }
    if (text->across == 0.5)
        pango_layout_set_alignment(layout, PANGO_ALIGN_CENTER);
    if (text->across == 1.0)
        pango_layout_set_alignment(layout, PANGO_ALIGN_RIGHT);
    pango_layout_set_auto_dir(layout, FALSE);
    char *valid = g_utf8_make_valid(words, -1);
    if (text->markup)
        pango_layout_set_markup(layout, valid, -1);
    else
        pango_layout_set_text(layout, valid, -1);
    g_free(valid);
    return layout;
}

static struct pp_box box_of(PangoLayout *layout, const struct pp_style *style,
                            const struct pp_lettering *text, double x, double y)
{
    PangoRectangle logical;
    pango_layout_get_extents(layout, 0, &logical);
    double unit = enlargement(style, text) / PANGO_SCALE;
    double width = logical.width * unit, height = logical.height * unit;
    return (struct pp_box){x - text->across * width, y - text->down * height, width,
                           height};
}

struct pp_box pp_lettering_measure(cairo_t *cr, const struct pp_style *style,
                                   const struct pp_lettering *text, double x, double y,
                                   const char *words)
{
    PangoLayout *layout = layout_of(cr, style, text, words);
    struct pp_box box = box_of(layout, style, text, x, y);
    g_object_unref(layout);
    return box;
}

static struct pp_box draw_lettering(cairo_t *cr, const struct pp_style *style,
                                    const struct pp_lettering *text, double x, double y,
                                    const char *words, bool cleared)
{
    PangoLayout *layout = layout_of(cr, style, text, words);
    struct pp_box box = box_of(layout, style, text, x, y);
    PangoRectangle logical;
    pango_layout_get_extents(layout, 0, &logical);

    cairo_save(cr);
    cairo_translate(cr, x, y);
    cairo_rotate(cr, text->turn_rad);
    cairo_translate(cr, box.x - x, box.y - y);
    if (cleared) {
        double pad = 0.12 * style->text[text->size];
        pp_style_grey(cr, 1.0);
        cairo_rectangle(cr, -pad, 0.0, box.width + 2.0 * pad, box.height);
        cairo_fill(cr);
    }
    pp_style_grey(cr, text->grey);
    /* In a layout of fixed width, aligned lines do not start at the left edge. */
    double scale = enlargement(style, text);
    cairo_scale(cr, scale, scale);
    cairo_move_to(cr, -(double)logical.x / PANGO_SCALE, 0.0);
    pango_cairo_show_layout(cr, layout);
    cairo_restore(cr);
    cairo_new_path(cr);
    g_object_unref(layout);
    return box;
}

struct pp_box pp_lettering_draw(cairo_t *cr, const struct pp_style *style,
                                const struct pp_lettering *text, double x, double y,
                                const char *words)
{
    return draw_lettering(cr, style, text, x, y, words, false);
}

struct pp_box pp_lettering_draw_on_white(cairo_t *cr, const struct pp_style *style,
                                         const struct pp_lettering *text, double x,
                                         double y, const char *words)
{
    return draw_lettering(cr, style, text, x, y, words, true);
}

int pp_lettering_font(const char *words, char *family, size_t room)
{
    PangoContext *context =
        pango_font_map_create_context(pango_cairo_font_map_get_default());
    PangoFontDescription *wanted = pango_font_description_new();
    pango_font_description_set_family_static(wanted, families);
    PangoFont *font = pango_context_load_font(context, wanted);
    PangoFontDescription *found = font ? pango_font_describe(font) : NULL;
    const char *name = found ? pango_font_description_get_family(found) : NULL;
    snprintf(family, room, "%s", name ? name : "");

    PangoLayout *layout = pango_layout_new(context);
    pango_layout_set_font_description(layout, wanted);
    pango_layout_set_text(layout, words, -1);
    int missing = pango_layout_get_unknown_glyphs_count(layout);
    g_object_unref(layout);
    pango_font_description_free(found);
    if (font)
        g_object_unref(font);
    pango_font_description_free(wanted);
    g_object_unref(context);
    return missing;
}
