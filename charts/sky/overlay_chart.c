/* overlay_chart.c - a circle that is the horizon, and in it rings of altitude, dots, cells
 * and paths; lines have a white edge, so that they are seen on dark and on light. */
#include "charts/sky/overlay_chart.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "charts/sheet/hatch.h"
#include "charts/sheet/labels.h"
#include "charts/sheet/page.h"
#include "charts/sky/overlay_plot.h"
#include "charts/sky/overlay_sun.h"

static const char *const lens_names[PP_LENS_COUNT] = {
    [PP_LENS_EQUIDISTANT] = "equidistant",
    [PP_LENS_EQUISOLID] = "equisolid",
    [PP_LENS_STEREOGRAPHIC] = "stereographic",
    [PP_LENS_ORTHOGRAPHIC] = "orthographic",
};
static const char *const lens_rules[PP_LENS_COUNT] = {
    [PP_LENS_EQUIDISTANT] = "r = R \u03b8/90\u00b0",
    [PP_LENS_EQUISOLID] = "r = R sin(\u03b8/2)/sin 45\u00b0",
    [PP_LENS_STEREOGRAPHIC] = "r = R tan(\u03b8/2)",
    [PP_LENS_ORTHOGRAPHIC] = "r = R sin \u03b8",
};

/* ---- net ---- */

static void draw_rings(const struct pp_overlay_plot *plot)
{
    cairo_t *cr = plot->cr;
    for (int altitude = 10; altitude < 90; altitude += 10) {
        double r = plot->radius
                   * pp_lens_radius(plot->overlay->lens, (90 - altitude) * PP_RAD);
        cairo_new_path(cr);
        cairo_arc(cr, plot->x0, plot->y0, r, 0.0, 2.0 * PP_PI);
        pp_style_line(cr, plot->style.hair, PP_GREY_LINE);
        cairo_stroke(cr);
    }
    cairo_arc(cr, plot->x0, plot->y0, plot->radius, 0.0, 2.0 * PP_PI);
    pp_overlay_plot_stroke(plot, plot->style.medium);
    double arm = 3.0 * plot->style.scale;
    cairo_move_to(cr, plot->x0 - arm, plot->y0);
    cairo_line_to(cr, plot->x0 + arm, plot->y0);
    cairo_move_to(cr, plot->x0, plot->y0 - arm);
    cairo_line_to(cr, plot->x0, plot->y0 + arm);
    pp_overlay_plot_stroke(plot, plot->style.thin);
}

/* Bearings round the horizon: a tick each ten degrees, a word each thirty. */
static void draw_bearings(const struct pp_overlay_plot *plot)
{
    static const char *const winds[] = {"N", "E", "S", "W"};
    const double tick = 1.5 * plot->style.scale;
    const struct pp_lettering set = {.size = PP_TEXT_SMALL, .across = 0.5, .down = 0.5};
    for (int degree = 0; degree < 360; degree += 10) {
        double x = (plot->overlay->title ? 1.0 : -1.0) * sin(degree * PP_RAD),
               y = -cos(degree * PP_RAD);
        double length = degree % 30 ? tick : 1.6 * tick;
        double out = plot->radius + 1.6 * tick + plot->style.text[PP_TEXT_SMALL];
        char words[16];
        cairo_move_to(plot->cr, plot->x0 + plot->radius * x,
                      plot->y0 + plot->radius * y);
        cairo_line_to(plot->cr, plot->x0 + (plot->radius + length) * x,
                      plot->y0 + (plot->radius + length) * y);
        pp_style_line(plot->cr, plot->style.thin, PP_INK);
        cairo_stroke(plot->cr);
        if (degree % 30)
            continue;
        snprintf(words, sizeof words, "%d\u00b0", degree);
        pp_lettering_draw(plot->cr, &plot->style, &set, plot->x0 + out * x,
                          plot->y0 + out * y, degree % 90 ? words : winds[degree / 90]);
    }
}

/* Altitudes along a radius on which no path turns. */
static void label_rings(const struct pp_overlay_plot *plot)
{
    const struct pp_lettering set = {
        .size = PP_TEXT_SMALL, .grey = PP_GREY_TEXT, .across = 0.5, .down = 0.5};
    for (int altitude = 20; altitude < 90; altitude += 20) {
        double xy[2];
        char words[16];
        pp_overlay_plot_place(plot, altitude * PP_RAD, 15.0 * PP_RAD, xy);
        snprintf(words, sizeof words, "%d\u00b0", altitude);
        pp_labels_note_box(plot->labels,
                           pp_lettering_draw_on_white(plot->cr, &plot->style, &set,
                                                      xy[0], xy[1], words));
    }
}

/* ---- the sky in equal parts ---- */

static void draw_dots(const struct pp_overlay_plot *plot)
{
    double arm = fmin(0.5 * plot->style.scale, 0.005 * plot->radius);
    for (int i = 0; i < plot->overlay->dot_count; i++) {
        const struct pp_sky_cell *cell = &plot->overlay->dots[i];
        double xy[2];
        pp_overlay_plot_place(plot, cell->altitude, cell->bearing, xy);
        cairo_move_to(plot->cr, xy[0] - arm, xy[1] - arm);
        cairo_line_to(plot->cr, xy[0] + arm, xy[1] + arm);
        cairo_move_to(plot->cr, xy[0] - arm, xy[1] + arm);
        cairo_line_to(plot->cr, xy[0] + arm, xy[1] - arm);
        pp_overlay_plot_stroke(plot, plot->style.thin);
    }
}

/* A cell's lower edge and its left side; the ring and the cell beside it have the rest. */
static void draw_cells(const struct pp_overlay_plot *plot)
{
    const double step = PP_RAD;
    for (int i = 0; i < plot->overlay->cell_count; i++) {
        const struct pp_sky_cell *cell = &plot->overlay->cells[i];
        bool whole = cell->to - cell->from > 2.0 * PP_PI - 1e-9;
        double xy[2];
        if (!whole) {
            pp_overlay_plot_place(plot, cell->high, cell->from, xy);
            cairo_move_to(plot->cr, xy[0], xy[1]);
        }
        for (double b = cell->from; b < cell->to; b += step) {
            pp_overlay_plot_place(plot, cell->low, b, xy);
            cairo_line_to(plot->cr, xy[0], xy[1]);
        }
        pp_overlay_plot_place(plot, cell->low, cell->to, xy);
        cairo_line_to(plot->cr, xy[0], xy[1]);
        pp_overlay_plot_stroke(plot, plot->style.thin);
    }
}

/* ---- words ---- */

static void say_overlay_foot(char *foot, size_t room, const struct pp_overlay *overlay)
{
    pp_page_say(
        foot, room,
        "For a photograph taken level, looking up: print at 100\u00a0%%, lay the "
        "circle on the horizon (90\u00b0 from the zenith), N to the north; east is "
        "on the left. Lens: %s, angle \u03b8 from the zenith at %s.",
        lens_names[overlay->lens], lens_rules[overlay->lens]);
    if (overlay->dots)
        pp_page_say(
            foot, room,
            "%d crosses, each worth %.3g\u00a0%% of a level plane's light under "
            "the open sky: those that the photograph shows on the sky, counted, "
            "are the sky component without glass.",
            overlay->dot_count, 100.0 / overlay->dot_count);
    if (overlay->cells)
        pp_page_say(foot, room, "%d cells, each worth %.3g\u00a0%%.",
                    overlay->cell_count, 100.0 / overlay->cell_count);
    if (overlay->sun)
        pp_page_say(
            foot, room,
            "Sun paths of the 21st of the months named, hours by solar time; of "
            "two months named together the first is drawn, the other's is within "
            "0.6\u00b0.");
}

static void overlay_titles(const struct pp_overlay *overlay, char *title,
                           char *subtitle, size_t room)
{
    char sky[96];
    double latitude = fabs(overlay->latitude_rad) / PP_RAD;
    const char *side = overlay->latitude_rad < 0.0 ? "S" : "N";
    pp_page_sky_words(sky, sizeof sky, &overlay->sky, 0.0);
    snprintf(title, room, "Overlay for %s fisheye photographs",
             lens_names[overlay->lens]);
    if (overlay->sun && (overlay->dots || overlay->cells))
        snprintf(subtitle, room, "%s in equal parts; sun paths at %.4g\u00b0 %s", sky,
                 latitude, side);
    else if (overlay->sun)
        snprintf(subtitle, room, "Sun paths at %.4g\u00b0 %s", latitude, side);
    else
        snprintf(subtitle, room, "%s in equal parts", sky);
    subtitle[0] = (char)(subtitle[0] == 'u' ? 'U' : subtitle[0]);
}

/* Writes the radius in the lower left corner, which the circle leaves free. */
static void state_radius(const struct pp_overlay_plot *plot, struct pp_box body)
{
    const struct pp_lettering set = {.size = PP_TEXT_SMALL, .down = 1.0};
    char words[64];
    snprintf(words, sizeof words, "R = %.4g\u00a0mm", plot->radius);
    pp_lettering_draw(plot->cr, &plot->style, &set, body.x, body.y + body.height,
                      words);
}

/* Place and size of the circle in the space that the page leaves. */
static enum pp_status lay_circle(struct pp_overlay_plot *plot, struct pp_box body,
                                 struct pp_error *err)
{
    double border = 2.4 * plot->style.scale + 2.0 * plot->style.text[PP_TEXT_SMALL];
    double most = fmin(body.width, body.height) - 2.0 * border;
    double wanted = plot->overlay->diameter_mm;
    if (wanted > most)
        return pp_fail(err, PP_BAD_INPUT,
                       "--diameter is %g mm, and the sheet holds %.0f; expected less, "
                       "or a larger --paper",
                       wanted, floor(most));
    plot->radius = 0.5 * (wanted > 0.0 ? wanted : 10.0 * floor(most / 10.0));
    plot->x0 = body.x + 0.5 * body.width;
    plot->y0 = body.y + 0.5 * body.height;
    return PP_OK;
}

/* ---- obstructions of the sky ---- */

static void trace_mask(const struct pp_overlay_plot *plot,
                       const struct pp_sky_mask *mask)
{
    double xy[2];
    for (int i = 0; i < mask->count; i++) {
        const struct pp_sky_mask_piece *piece = &mask->pieces[i];
        cairo_new_sub_path(plot->cr);
        for (int k = 0; k < piece->count; k++) {
            pp_overlay_plot_place(plot, piece->edges[k][1], piece->edges[k][0], xy);
            cairo_line_to(plot->cr, xy[0], xy[1]);
        }
        for (int k = piece->count - 1; k >= 0; k--) {
            pp_overlay_plot_place(plot, piece->edges[k][2], piece->edges[k][0], xy);
            cairo_line_to(plot->cr, xy[0], xy[1]);
        }
        if (piece->count)
            cairo_close_path(plot->cr);
    }
}

/* Draws the obstruction now in light grey, and the former one within it, so that new
 * parts stand out hatched. */
static void draw_masks(const struct pp_overlay_plot *plot)
{
    const struct pp_overlay *overlay = plot->overlay;
    cairo_t *cr = plot->cr;
    struct pp_box box = {plot->x0 - plot->radius, plot->y0 - plot->radius,
                         2.0 * plot->radius, 2.0 * plot->radius};
    if (!overlay->now)
        return;
    cairo_save(cr);
    cairo_arc(cr, plot->x0, plot->y0, plot->radius, 0.0, 2.0 * PP_PI);
    cairo_clip(cr);
    cairo_set_fill_rule(cr, CAIRO_FILL_RULE_WINDING);
    trace_mask(plot, overlay->now);
    pp_style_grey(cr, 0.80);
    cairo_fill(cr);
    if (overlay->before) {
        trace_mask(plot, overlay->now);
        pp_hatch_path(cr, box, 1.3 * plot->style.scale, plot->style.thin, PP_GREY_TEXT);
        trace_mask(plot, overlay->before);
        pp_style_grey(cr, 0.80);
        cairo_fill(cr);
    }
    cairo_restore(cr);
}

enum pp_status pp_overlay_chart_draw(struct pp_canvas *canvas,
                                     const struct pp_overlay *overlay,
                                     struct pp_error *err)
{
    struct pp_labels *labels = calloc(1, sizeof *labels);
    struct pp_overlay_plot plot = {.cr = pp_canvas_cairo(canvas),
                                   .style = pp_page_style(canvas),
                                   .overlay = overlay,
                                   .labels = labels};
    char title[256], subtitle[256], foot[1024] = "";
    if (!labels)
        return pp_fail_memory(err);
    overlay_titles(overlay, title, subtitle, sizeof title);
    say_overlay_foot(foot, sizeof foot, overlay);
    const struct pp_page page = {overlay->title ? overlay->title : title,
                                 overlay->title ? overlay->subtitle : subtitle,
                                 overlay->title ? overlay->foot : foot};
    struct pp_box body = pp_page_draw(canvas, &plot.style, &page);
    enum pp_status status = lay_circle(&plot, body, err);
    if (status == PP_OK) {
        labels->field = body;
        draw_masks(&plot);
        draw_rings(&plot);
        draw_bearings(&plot);
        draw_cells(&plot);
        draw_dots(&plot);
        label_rings(&plot);
        state_radius(&plot, body);
        if (overlay->sun)
            pp_overlay_sun_draw(&plot);
    }
    free(labels);
    return status;
}
