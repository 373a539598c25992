/* sky_chart.c - draws the curve of sky_chart.h between two scales. */
#include "charts/sky_chart.h"

#include <math.h>

#include "charts/sheet/axis.h"
#include "charts/sheet/page.h"

static void draw_scales(cairo_t *cr, const struct pp_style *style,
                        const struct pp_axis *across, const struct pp_axis *up)
{
    pp_axis_grid_across(cr, style, up, across->from, across->to);
    pp_axis_grid_up(cr, style, across, up->to, up->from);
    pp_axis_draw_up(cr, style, up, across->from);
    double reach = pp_axis_draw_across(cr, style, across, up->from);

    struct pp_lettering title = {.size = PP_TEXT_BODY, .down = 1.0};
    pp_lettering_draw(cr, style, &title, across->from - pp_axis_reach(cr, style, up),
                      up->to - 2.0 * style->scale,
                      "Luminance over that of a uniform sky as bright on the ground");
    title.down = 0.0;
    title.across = 1.0;
    pp_lettering_draw(cr, style, &title, across->to,
                      up->from + reach + 0.2 * style->scale,
                      "Angle from the horizon, 90 at the zenith (degrees)");
}

static void draw_curve(cairo_t *cr, const struct pp_style *style,
                       const struct pp_sky_sheet *sheet, const struct pp_axis *across,
                       const struct pp_axis *up)
{
    for (int i = 0; i <= PP_SKY_SHEET_STEPS; i++)
        cairo_line_to(cr, pp_axis_at(across, 180.0 * i / PP_SKY_SHEET_STEPS),
                      pp_axis_at(up, sheet->luminance[i]));
    pp_style_line(cr, style->thick, PP_INK);
    cairo_stroke(cr);
}

enum pp_status pp_sky_chart_draw(struct pp_canvas *canvas,
                                 const struct pp_sky_sheet *sheet, struct pp_error *err)
{
    (void)err;
    cairo_t *cr = pp_canvas_cairo(canvas);
    const struct pp_style style = pp_page_style(canvas);
    char subtitle[160];
    pp_page_sky(subtitle, sizeof subtitle, sheet->world);
    const char *name = sheet->world->name;
    const struct pp_page page = {name ? name : "Sky", subtitle,
                                 "From the horizon below the sun, or from any where "
                                 "there is none, over the zenith to the horizon "
                                 "opposite. The sun's disc is left out."};
    struct pp_box body = pp_page_draw(canvas, &style, &page);

    double most = 0.0;
    for (int i = 0; i <= PP_SKY_SHEET_STEPS; i++)
        most = fmax(most, sheet->luminance[i]);
    double left = body.x + 10.0 * style.scale, top = body.y + 9.5 * style.scale;
    double width = body.width - 15.0 * style.scale;
    double height = fmin(body.height - 20.0 * style.scale, width);
    struct pp_axis across =
        pp_axis_linear(0.0, 180.0, left, left + width, 15.0 * style.scale, false);
    struct pp_axis up =
        pp_axis_linear(0.0, most, top + height, top, 7.0 * style.scale, true);
    draw_scales(cr, &style, &across, &up);
    draw_curve(cr, &style, sheet, &across, &up);
    return PP_OK;
}
