/* overlay_chart.c - draws a circle for the horizon with rings of altitude, crosses,
 * cells and sun paths. Lines have white edges, so that they are visible on dark and
 * light photographs. */
#include "charts/sky/overlay_chart.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "charts/sheet/hatch.h"
#include "charts/sheet/labels.h"
#include "charts/sheet/page.h"
#include "model/light/sun_path.h"

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

/* ---- positions and lines ---- */

/* Drawing state of an overlay. */
struct overlay_plot {
    cairo_t *cr;
    struct pp_style style;
    const struct pp_overlay *overlay;
    struct pp_labels *labels;
    double x0, y0, radius; /* circle of the horizon, mm */
};

/* Position on paper of a direction (rad). North is up. East is on the left, or on the
 * right if the chart is a sheet. */
static void place_on_overlay(const struct overlay_plot *plot, double altitude,
                             double bearing, double xy[2])
{
    double r =
        plot->radius * pp_lens_radius(plot->overlay->lens, 0.5 * PP_PI - altitude);
    double east = plot->overlay->title ? 1.0 : -1.0;
    xy[0] = plot->x0 + east * r * sin(bearing);
    xy[1] = plot->y0 - r * cos(bearing);
}

/* Strokes the path in black on a wider white line. */
static void stroke_edged(const struct overlay_plot *plot, double weight_mm)
{
    pp_style_line(plot->cr, weight_mm + 0.3 * plot->style.scale, 1.0);
    cairo_stroke_preserve(plot->cr);
    pp_style_line(plot->cr, weight_mm, PP_INK);
    cairo_stroke(plot->cr);
}

/* ---- net ---- */

static void draw_rings(const struct overlay_plot *plot)
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
    stroke_edged(plot, plot->style.medium);
    double arm = 3.0 * plot->style.scale;
    cairo_move_to(cr, plot->x0 - arm, plot->y0);
    cairo_line_to(cr, plot->x0 + arm, plot->y0);
    cairo_move_to(cr, plot->x0, plot->y0 - arm);
    cairo_line_to(cr, plot->x0, plot->y0 + arm);
    stroke_edged(plot, plot->style.thin);
}

/* Draws bearings around the horizon: a tick every 10 degrees, a label every 30. */
static void draw_bearings(const struct overlay_plot *plot)
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

/* Labels altitudes along a radius that does not follow any sun path. */
static void label_rings(const struct overlay_plot *plot)
{
    const struct pp_lettering set = {
        .size = PP_TEXT_SMALL, .grey = PP_GREY_TEXT, .across = 0.5, .down = 0.5};
    for (int altitude = 20; altitude < 90; altitude += 20) {
        double xy[2];
        char words[16];
        place_on_overlay(plot, altitude * PP_RAD, 15.0 * PP_RAD, xy);
        snprintf(words, sizeof words, "%d\u00b0", altitude);
        pp_labels_note_box(plot->labels,
                           pp_lettering_draw_on_white(plot->cr, &plot->style, &set,
                                                      xy[0], xy[1], words));
    }
}

/* ---- the sky in equal parts ---- */

static void draw_dots(const struct overlay_plot *plot)
{
    double arm = fmin(0.5 * plot->style.scale, 0.005 * plot->radius);
    for (int i = 0; i < plot->overlay->dot_count; i++) {
        const struct pp_sky_cell *cell = &plot->overlay->dots[i];
        double xy[2];
        place_on_overlay(plot, cell->altitude, cell->bearing, xy);
        cairo_move_to(plot->cr, xy[0] - arm, xy[1] - arm);
        cairo_line_to(plot->cr, xy[0] + arm, xy[1] + arm);
        cairo_move_to(plot->cr, xy[0] - arm, xy[1] + arm);
        cairo_line_to(plot->cr, xy[0] + arm, xy[1] - arm);
        stroke_edged(plot, plot->style.thin);
    }
}

/* Draws the lower edge of a cell and its side at the bearing `from`. The other edges
 * belong to the ring above and to the next cell. */
static void draw_cells(const struct overlay_plot *plot)
{
    const double step = PP_RAD;
    for (int i = 0; i < plot->overlay->cell_count; i++) {
        const struct pp_sky_cell *cell = &plot->overlay->cells[i];
        bool whole = cell->to - cell->from > 2.0 * PP_PI - 1e-9;
        double xy[2];
        if (!whole) {
            place_on_overlay(plot, cell->high, cell->from, xy);
            cairo_move_to(plot->cr, xy[0], xy[1]);
        }
        for (double b = cell->from; b < cell->to; b += step) {
            place_on_overlay(plot, cell->low, b, xy);
            cairo_line_to(plot->cr, xy[0], xy[1]);
        }
        place_on_overlay(plot, cell->low, cell->to, xy);
        cairo_line_to(plot->cr, xy[0], xy[1]);
        stroke_edged(plot, plot->style.thin);
    }
}

/* ---- the sun's paths ---- */

/* Sun paths to be drawn. Pairs of months share a path, since the paths of a pair differ
 * by at most 0.6 degrees. */
static const struct {
    int month;
    const char *words;
} paths[] = {{12, "Dec"},     {1, "Jan, Nov"}, {2, "Feb, Oct"}, {3, "Mar, Sep"},
             {4, "Apr, Aug"}, {5, "May, Jul"}, {6, "Jun"}};
enum { PATHS = sizeof paths / sizeof paths[0], DAY = 21, STEPS = 120 };

/* Finds the position of the sun on paper. Returns false if the sun is below the
 * horizon. */
static bool place_sun(const struct overlay_plot *plot, double declination, double hour,
                      double xy[2])
{
    struct pp_vec3 u =
        pp_sun_path_direction(plot->overlay->latitude_rad, declination, hour);
    double altitude = asin(fmin(fmax(u.z, -1.0), 1.0));
    place_on_overlay(plot, fmax(altitude, 0.0), atan2(u.x, u.y), xy);
    return altitude > -1e-9;
}

static void draw_path(const struct overlay_plot *plot, double declination)
{
    double sunset = pp_sun_path_sunset(plot->overlay->latitude_rad, declination);
    if (!(sunset > 0.0))
        return;
    for (int i = 0; i <= STEPS; i++) {
        double xy[2];
        place_sun(plot, declination, sunset * (2.0 * i / STEPS - 1.0), xy);
        cairo_line_to(plot->cr, xy[0], xy[1]);
    }
    stroke_edged(plot, plot->style.medium);
}

/* Draws an hour line from the December path to the June path, where the sun is above
 * the horizon. */
static void draw_hour(const struct overlay_plot *plot, int hour)
{
    double low = pp_sun_path_declination(12, DAY),
           high = pp_sun_path_declination(6, DAY);
    for (int i = 0; i <= STEPS; i++) {
        double xy[2], declination = low + (high - low) * i / STEPS;
        if (place_sun(plot, declination, (hour - 12) * 15.0 * PP_RAD, xy))
            cairo_line_to(plot->cr, xy[0], xy[1]);
        else
            cairo_new_sub_path(plot->cr);
    }
    pp_labels_note_path(plot->labels, plot->cr, -1);
    stroke_edged(plot, plot->style.thin);
}

/* Writes text on white unless it would cover other text written by this function. */
static void put_words(const struct overlay_plot *plot, const double xy[2],
                      const char *words)
{
    const struct pp_lettering set = {.size = PP_TEXT_SMALL, .across = 0.5, .down = 0.5};
    struct pp_box box =
        pp_lettering_measure(plot->cr, &plot->style, &set, xy[0], xy[1], words);
    for (int i = 0; i < plot->labels->count; i++)
        if (plot->labels->places[i].owner == 1
            && pp_lettering_boxes_overlap(
                box, (struct pp_box){plot->labels->places[i].x,
                                     plot->labels->places[i].y, 1e-6, 1e-6}))
            return;
    pp_lettering_draw_on_white(plot->cr, &plot->style, &set, xy[0], xy[1], words);
    for (double x = box.x; x <= box.x + box.width; x += 0.5)
        pp_labels_note(plot->labels, 1, x, box.y, x, box.y + box.height);
}

/* Writes the months on their paths, in the afternoon between two hour lines, and the
 * hours above the path of the longest day, towards the zenith. */
static void name_lines(const struct overlay_plot *plot)
{
    double latitude = plot->overlay->latitude_rad;
    double summer = pp_sun_path_declination(latitude < 0.0 ? 12 : 6, DAY);
    double xy[2];
    char words[16];
    for (int hour = 1; hour < 24; hour++) {
        double angle = (hour - 12) * 15.0 * PP_RAD;
        if (fabs(angle) > pp_sun_path_sunset(latitude, summer) - 2.0 * PP_RAD)
            continue;
        struct pp_vec3 u = pp_sun_path_direction(latitude, summer, angle);
        place_on_overlay(plot, fmin(asin(u.z) + 3.5 * PP_RAD, 0.5 * PP_PI),
                         atan2(u.x, u.y), xy);
        snprintf(words, sizeof words, "%d", hour);
        put_words(plot, xy, words);
    }
    for (int i = 0; i < PATHS; i++)
        for (int hour = 0; hour < 4; hour++) {
            double angle = (hour + 0.5) * 15.0 * PP_RAD;
            double declination = pp_sun_path_declination(paths[i].month, DAY);
            int before = plot->labels->count;
            if (angle > pp_sun_path_sunset(latitude, declination))
                break;
            if (place_sun(plot, declination, angle, xy))
                put_words(plot, xy, paths[i].words);
            if (plot->labels->count > before)
                break;
        }
}

/* Draws the paths of the 21st of each month, and the lines of whole hours of solar
 * time, with their names if there is space. */
static void draw_sun_paths(const struct overlay_plot *plot)
{
    for (int hour = 0; hour < 24; hour++)
        draw_hour(plot, hour);
    for (int i = 0; i < PATHS; i++)
        draw_path(plot, pp_sun_path_declination(paths[i].month, DAY));
    name_lines(plot);
}

/* Draws a mark for each hour with sunshine: a black dot if the sun is visible, else a
 * ring. */
static void draw_suns(const struct overlay_plot *plot)
{
    double radius = 0.45 * plot->style.scale;
    for (int i = 0; i < plot->overlay->sun_count; i++) {
        const struct pp_overlay_sun *sun = &plot->overlay->suns[i];
        double xy[2];
        place_on_overlay(plot, sun->altitude_rad, sun->bearing_rad, xy);
        cairo_new_path(plot->cr);
        cairo_arc(plot->cr, xy[0], xy[1], sun->visible ? radius : 0.7 * radius, 0.0,
                  2.0 * PP_PI);
        pp_style_line(plot->cr, plot->style.hair, PP_GREY_TEXT);
        if (sun->visible) {
            pp_style_grey(plot->cr, PP_INK);
            cairo_fill(plot->cr);
        } else
            cairo_stroke(plot->cr);
    }
}

/* ---- words ---- */

static void say_overlay_foot(char *foot, size_t room, const struct pp_overlay *overlay)
{
    pp_page_say(foot, room,
                "The overlay is for a photograph taken with the camera pointing "
                "vertically upwards. Print at 100\u00a0%%. Place the circle on the "
                "horizon (90\u00b0 from the zenith), with N to the north; east is on "
                "the left. Lens: %s, with the angle \u03b8 from the zenith at %s.",
                lens_names[overlay->lens], lens_rules[overlay->lens]);
    if (overlay->dots)
        pp_page_say(foot, room,
                    "There are %d crosses, each worth %.3g\u00a0%% of the horizontal "
                    "illuminance under the open sky. Count those on visible sky to "
                    "find the sky component without glass.",
                    overlay->dot_count, 100.0 / overlay->dot_count);
    if (overlay->cells)
        pp_page_say(foot, room, "There are %d cells, each worth %.3g\u00a0%%.",
                    overlay->cell_count, 100.0 / overlay->cell_count);
    if (overlay->sun)
        pp_page_say(foot, room,
                    "Sun paths are for the 21st of the named months; hours are in "
                    "solar time. If two months are named, the first is drawn; the "
                    "other differs by less than 0.6\u00b0.");
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
        snprintf(subtitle, room,
                 "%s divided into equal parts; sun paths at %.4g\u00b0 %s", sky,
                 latitude, side);
    else if (overlay->sun)
        snprintf(subtitle, room, "Sun paths at %.4g\u00b0 %s", latitude, side);
    else
        snprintf(subtitle, room, "%s divided into equal parts", sky);
    subtitle[0] = (char)(subtitle[0] == 'u' ? 'U' : subtitle[0]);
}

/* Writes the radius in the lower left corner, which is outside the circle. */
static void state_radius(const struct overlay_plot *plot, struct pp_box body)
{
    const struct pp_lettering set = {.size = PP_TEXT_SMALL, .down = 1.0};
    char words[64];
    snprintf(words, sizeof words, "R = %.4g\u00a0mm", plot->radius);
    pp_lettering_draw(plot->cr, &plot->style, &set, body.x, body.y + body.height,
                      words);
}

/* Sets centre and radius of the circle within the free space of the page. */
static enum pp_status lay_circle(struct overlay_plot *plot, struct pp_box body,
                                 struct pp_error *err)
{
    double border = 2.4 * plot->style.scale + 2.0 * plot->style.text[PP_TEXT_SMALL];
    double most = fmin(body.width, body.height) - 2.0 * border;
    double wanted = plot->overlay->diameter_mm;
    if (wanted > most)
        return pp_fail(err, PP_BAD_INPUT,
                       "--diameter is %g mm, but the sheet holds only %.0f; expected "
                       "less, or a larger --paper",
                       wanted, floor(most));
    plot->radius = 0.5 * (wanted > 0.0 ? wanted : 10.0 * floor(most / 10.0));
    plot->x0 = body.x + 0.5 * body.width;
    plot->y0 = body.y + 0.5 * body.height;
    return PP_OK;
}

/* ---- obstructions of the sky ---- */

static void trace_mask(const struct overlay_plot *plot, const struct pp_sky_mask *mask)
{
    double xy[2];
    for (int i = 0; i < mask->count; i++) {
        const struct pp_sky_mask_piece *piece = &mask->pieces[i];
        cairo_new_sub_path(plot->cr);
        for (int k = 0; k < piece->count; k++) {
            place_on_overlay(plot, piece->edges[k][1], piece->edges[k][0], xy);
            cairo_line_to(plot->cr, xy[0], xy[1]);
        }
        for (int k = piece->count - 1; k >= 0; k--) {
            place_on_overlay(plot, piece->edges[k][2], piece->edges[k][0], xy);
            cairo_line_to(plot->cr, xy[0], xy[1]);
        }
        if (piece->count)
            cairo_close_path(plot->cr);
    }
}

/* Draws the present obstruction in light grey. If there is a former state, the present
 * obstruction is hatched, and the former one is painted over it in grey. Only the new
 * parts then remain hatched. */
static void draw_masks(const struct overlay_plot *plot)
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
    struct overlay_plot plot = {.cr = pp_canvas_cairo(canvas),
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
        draw_suns(&plot);
        if (overlay->sun)
            draw_sun_paths(&plot);
    }
    free(labels);
    return status;
}
