/* slats_chart.c - see slats_chart.h. */
#include "charts/slats_chart.h"

#include <math.h>
#include <stdio.h>

#include "charts/sheet/axis.h"
#include "charts/sheet/legend.h"
#include "charts/sheet/page.h"

enum { CURVES = 5, COLUMNS = 6, SLATS_SHOWN = 5, ARC_STEPS = 12 };

struct slats_plot {
    cairo_t *cr;
    struct pp_style style;
    const struct pp_slat_sheet *sheet;
    struct pp_axis across, up;
    struct pp_box field;
};

/* Value of curve number `curve`, in the order of the legend. */
static double curve_value(const struct pp_slat_parts *p, int curve)
{
    const double values[CURVES] = {p->straight + p->room_down + p->room_up, p->straight,
                                   p->room_up, p->room_down, p->back_up + p->back_down};
    return values[curve];
}

static const char *curve_words(int curve, bool vertical)
{
    static const char *const horizontal_words[CURVES] = {
        "total into the room", "straight through", "scattered into the room, upwards",
        "scattered into the room, downwards", "reflected outside"};
    static const char *const vertical_words[CURVES] = {
        "total into the room", "straight through",
        "scattered into the room, to the left", "scattered into the room, to the right",
        "reflected outside"};
    return vertical ? vertical_words[curve] : horizontal_words[curve];
}

static struct pp_curve_style curve_look(int curve)
{
    struct pp_curve_style look = pp_style_curve(curve);
    if (curve == 0)
        look.weight *= 1.5;
    return look;
}

static void draw_slat_curves(const struct slats_plot *plot)
{
    for (int curve = CURVES - 1; curve >= 0; curve--) {
        struct pp_curve_style look = curve_look(curve);
        for (int i = 0; i < PP_SLAT_SHEET_CURVE; i++)
            cairo_line_to(
                plot->cr, pp_axis_at(&plot->across, i - PP_SLAT_SHEET_CURVE / 2),
                pp_axis_at(&plot->up, curve_value(&plot->sheet->curve[i], curve)));
        pp_style_pen(plot->cr, &plot->style, &look);
        cairo_stroke(plot->cr);
    }
    cairo_set_dash(plot->cr, NULL, 0, 0.0);
}

static void draw_slat_plot(const struct slats_plot *plot)
{
    cairo_t *cr = plot->cr;
    const struct pp_style *style = &plot->style;
    double bottom = plot->field.y + plot->field.height;
    pp_axis_grid_across(cr, style, &plot->up, plot->across.from, plot->across.to);
    pp_axis_grid_up(cr, style, &plot->across, plot->field.y, bottom);
    pp_axis_draw_up(cr, style, &plot->up, plot->field.x);
    double reach = pp_axis_draw_across(cr, style, &plot->across, bottom);
    struct pp_lettering text = {.size = PP_TEXT_BODY, .down = 1.0};
    pp_lettering_draw(
        cr, style, &text, plot->field.x - pp_axis_reach(cr, style, &plot->up),
        plot->field.y - 2.5 * style->scale, "Share of the incident light");
    text = (struct pp_lettering){.size = PP_TEXT_BODY, .across = 1.0};
    pp_lettering_draw(cr, style, &text, plot->field.x + plot->field.width,
                      bottom + reach + 0.2 * style->scale,
                      plot->sheet->device.vertical
                          ? "Profile angle in plan (\u00b0), > 0 to the right"
                          : "Profile angle (\u00b0), > 0 downwards into the room");
    draw_slat_curves(plot);
}

/* Draws some slats in a box: in section, with the outside on the left, or vertical
 * slats in plan, with the outside below. */
static void draw_slat_section(const struct slats_plot *plot, struct pp_box box)
{
    const struct pp_slats *slats = &plot->sheet->device.slats;
    const struct pp_style *style = &plot->style;
    double high_m = (SLATS_SHOWN - 1) * slats->spacing + slats->width;
    double mm_per_m = fmin(box.height / high_m, 0.6 * box.width / slats->width);
    double x0 = box.x + 0.5 * box.width, y0 = box.y + 0.5 * box.height;
    pp_style_line(plot->cr, style->medium, PP_INK);
    for (int i = 0; i < SLATS_SHOWN; i++) {
        for (int k = 0; k <= ARC_STEPS; k++) {
            double a, b;
            pp_slats_point(slats, (double)k / ARC_STEPS, &a, &b);
            b += (i - 0.5 * (SLATS_SHOWN - 1)) * slats->spacing;
            if (plot->sheet->device.vertical) /* seen in plan: the outside is below */
                cairo_line_to(plot->cr, x0 - b * mm_per_m, y0 - a * mm_per_m);
            else
                cairo_line_to(plot->cr, x0 + a * mm_per_m, y0 - b * mm_per_m);
        }
        cairo_stroke(plot->cr);
    }
    struct pp_lettering text = {.size = PP_TEXT_SMALL, .grey = PP_GREY_TEXT};
    pp_lettering_draw(
        plot->cr, style, &text, box.x, box.y + box.height + 1.0 * style->scale,
        plot->sheet->device.vertical ? "plan: the outside is below"
                                     : "section: the outside is on the left");
}

/* Draws the table, which fills the height of the box. */
static void draw_slat_table(const struct slats_plot *plot, struct pp_box box)
{
    static const char *const heads[COLUMNS] = {"profile angle", "straight", NULL, NULL,
                                               "total",         "reflected"};
    const struct pp_slat_sheet *sheet = plot->sheet;
    bool vertical = sheet->device.vertical;
    double line = box.height / (sheet->row_count + 1.5);
    double step = box.width / (COLUMNS + 0.6);
    struct pp_lettering text = {.size = PP_TEXT_SMALL, .across = 1.0, .bold = true};
    for (int row = -1; row < sheet->row_count; row++) {
        double y = box.y + (row + 1 + (row >= 0 ? 0.3 : 0.0)) * line;
        for (int column = 0; column < COLUMNS; column++) {
            double x = box.x + (column + 1.6) * step;
            char words[32];
            if (row < 0)
                snprintf(words, sizeof words, "%s",
                         column == 2   ? (vertical ? "to the left" : "upwards")
                         : column == 3 ? (vertical ? "to the right" : "downwards")
                                       : heads[column]);
            else if (column == 0)
                snprintf(words, sizeof words, "%s", sheet->rows[row].words);
            else
                snprintf(words, sizeof words, "%.3f",
                         curve_value(&sheet->rows[row].parts,
                                     (int[]){0, 1, 2, 3, 0, 4}[column]));
            pp_lettering_draw(plot->cr, &plot->style, &text, x, y, words);
        }
        text.bold = false;
    }
    double y = box.y + 1.1 * line;
    pp_style_line(plot->cr, plot->style.thin, PP_INK);
    cairo_move_to(plot->cr, box.x, y);
    cairo_line_to(plot->cr, box.x + box.width, y);
    cairo_stroke(plot->cr);
}

static void draw_slat_side(const struct slats_plot *plot, struct pp_box box)
{
    struct pp_key keys[CURVES];
    for (int i = 0; i < CURVES; i++) {
        keys[i] = (struct pp_key){
            .kind = PP_KEY_LINE, .curve = curve_look(i), .grey = PP_INK};
        snprintf(keys[i].words, sizeof keys[i].words, "%s",
                 curve_words(i, plot->sheet->device.vertical));
    }
    struct pp_box used =
        pp_legend_draw(plot->cr, &plot->style, keys, CURVES, box.x, box.y, box.width);
    double gap = 5.0 * plot->style.scale;
    double top = used.y + used.height + gap;
    draw_slat_section(
        plot, (struct pp_box){box.x, top, box.width, box.y + box.height - top - gap});
}

void pp_slats_chart_draw(struct pp_canvas *canvas, const struct pp_slat_sheet *sheet)
{
    struct slats_plot plot = {
        .cr = pp_canvas_cairo(canvas), .style = pp_page_style(canvas), .sheet = sheet};
    const struct pp_style *style = &plot.style;
    char subtitle[256] = "", words[200] = "";
    pp_window_device_say(&sheet->device, words, sizeof words, "\u00b0");
    snprintf(subtitle, sizeof subtitle, "Light through a%s", words[0] ? words + 1 : "");
    const struct pp_page page = {
        sheet->title, subtitle,
        "The slats are infinitely long, have no thickness, and reflect diffusely; "
        "glass is not "
        "included. Straight light follows from the geometry of the slats, scattered "
        "light from a radiosity calculation with 24 strips on each side of a slat. The "
        "profile angle is the angle of the light in a section normal to the slats. The "
        "rows for all directions, for the sky and for the ground are for uniform light "
        "from everywhere outside, from its upper half and from its lower half."};
    struct pp_box body = pp_page_draw(canvas, style, &page);
    double left = 10.0 * style->scale, below = 12.0 * style->scale;
    double table = fmin(0.42 * body.height, 75.0 * style->scale);
    plot.field = (struct pp_box){body.x + left, body.y + 7.0 * style->scale,
                                 body.width - left - 4.0 * style->scale, 0.0};
    plot.field.height = fmin(body.height - table - below - 12.0 * style->scale,
                             0.75 * plot.field.width);
    plot.across =
        pp_axis_linear(-90.0, 90.0, plot.field.x, plot.field.x + plot.field.width,
                       9.0 * style->scale, false);
    plot.up = pp_axis_linear(0.0, 1.0, plot.field.y + plot.field.height, plot.field.y,
                             7.0 * style->scale, false);
    draw_slat_plot(&plot);
    double y = plot.field.y + plot.field.height + below;
    double wide = 0.62 * body.width;
    draw_slat_table(&plot, (struct pp_box){body.x, y, wide, table});
    draw_slat_side(&plot,
                   (struct pp_box){body.x + wide + 6.0 * style->scale, y,
                                   body.width - wide - 6.0 * style->scale, table});
}
