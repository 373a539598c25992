/* year_chart.c - draws the parts of the sheet: map, plans and curves. */
#include "charts/year/year_chart.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "charts/sheet/axis.h"
#include "charts/sheet/page.h"
#include "charts/year/colour_scale.h"
#include "charts/year/depth_profile.h"
#include "model/results/lattice.h"
#include "model/results/sheets/lm83_grid.h"
#include "model/results/sheets/point_areas.h"

static const struct pp_colour_scale lux_scale = {
    {0.0, 1.0, 100.0, 300.0, 500.0, 1000.0, 3000.0}, " lx"};
static const struct pp_colour_scale share_scale = {
    {0.0, 20.0, 40.0, 50.0, 60.0, 75.0, 90.0}, " %"};
static const struct pp_colour_scale sun_scale = {
    {0.0, 1.0, 50.0, 100.0, 250.0, 500.0, 1000.0}, " h"};

/* Overlap of neighbouring cells, so that rounding does not leave gaps between them. */
static const double OVERLAP_MM = 0.03;

struct year_plot {
    cairo_t *cr;
    struct pp_style style;
    const struct pp_annual_sheet *sheet;
    struct pp_lattice lattice;
};

static void put_panel_title(const struct year_plot *plot, double x, double y,
                            const char *words)
{
    struct pp_lettering title = {.size = PP_TEXT_SMALL, .bold = true, .down = 1.0};
    pp_lettering_draw(plot->cr, &plot->style, &title, x, y, words);
}

/* Draws the axes of a panel and their grid lines. */
static void draw_panel_axes(const struct year_plot *plot, const struct pp_axis *across,
                            const struct pp_axis *up)
{
    pp_axis_grid_across(plot->cr, &plot->style, up, across->from, across->to);
    pp_axis_grid_up(plot->cr, &plot->style, across, up->to, up->from);
    pp_axis_draw_across(plot->cr, &plot->style, across, up->from);
    pp_axis_draw_up(plot->cr, &plot->style, up, across->from);
}

/* ---- days and hours ---- */

static int day_of_year(int month, int day)
{
    static const int before[] = {0, 31, 59, 90, 120, 151, 181, 212, 243, 273, 304, 334};
    return before[month - 1] + day - 1;
}

static double mean_of_points(const struct pp_annual_sheet *sheet, int hour)
{
    double sum = 0.0;
    for (int x = 0; x < sheet->receiver_count; x++)
        sum += pp_annual_sheet_lx(sheet, x, hour);
    return sum / sheet->receiver_count;
}

static void draw_map(const struct year_plot *plot, struct pp_box box)
{
    static const char *const months[] = {"Jan", "Feb", "Mar", "Apr", "May", "Jun",
                                         "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"};
    const struct pp_annual_sheet *sheet = plot->sheet;
    cairo_t *cr = plot->cr;
    double scale = plot->style.scale;
    put_panel_title(plot, box.x, box.y - 1.0 * scale,
                    "Mean illuminance at the points, by day and hour (standard time)");
    double left = box.x + 7.0 * scale, low = box.y + box.height - 5.0 * scale;
    double wide = box.x + box.width - left, high = low - box.y;
    double day = wide / 365.0;
    cairo_set_antialias(cr, CAIRO_ANTIALIAS_NONE);
    for (int i = 0; i < sheet->hour_count; i++) {
        const struct pp_annual_hour *hour = &sheet->hours[i];
        double lx = mean_of_points(sheet, i);
        int at = day_of_year(hour->month, hour->day);
        if (isnan(lx))
            continue;
        pp_colour_scale_set(cr, &lux_scale, lx);
        cairo_rectangle(cr, left + at * day,
                        low - (hour->start_h + hour->length_h) * high / 24.0,
                        day + OVERLAP_MM, hour->length_h * high / 24.0);
        cairo_fill(cr);
    }
    cairo_set_antialias(cr, CAIRO_ANTIALIAS_DEFAULT);
    struct pp_lettering month = {.size = PP_TEXT_SMALL, .across = 0.5};
    struct pp_lettering clock = {.size = PP_TEXT_SMALL, .across = 1.0, .down = 0.5};
    for (int m = 1; m <= 12; m++)
        pp_lettering_draw(cr, &plot->style, &month, left + (day_of_year(m, 15)) * day,
                          low + 0.5 * scale, months[m - 1]);
    for (int h = 0; h <= 24; h += 6) {
        char text[8];
        snprintf(text, sizeof text, "%d", h);
        pp_lettering_draw(cr, &plot->style, &clock, left - 1.0 * scale,
                          low - h * high / 24.0, text);
    }
    pp_style_line(cr, plot->style.thin, PP_INK);
    cairo_rectangle(cr, left, box.y, wide, high);
    cairo_stroke(cr);
}

/* ---- plans ---- */

/* A result at the points, and its appearance on a plan. */
struct plan_figure {
    const char *title;
    int index; /* position in struct pp_annual_figures */
    double unit;
    const struct pp_colour_scale *scale;
};

#define FIGURE(name)                                                                   \
    ((int)(offsetof(struct pp_annual_figures, name) / sizeof(struct pp_annual_value)))

static void draw_plan(const struct year_plot *plot, const struct plan_figure *figure,
                      struct pp_box box)
{
    const struct pp_lattice *lattice = &plot->lattice;
    const struct pp_annual_sheet *sheet = plot->sheet;
    const struct pp_world *world = sheet->world;
    cairo_t *cr = plot->cr;
    double scale = plot->style.scale, legend = 7.0 * scale;
    struct pp_bounds2 bounds = pp_region_bounds(&world->plane);
    double width_m = bounds.high[0] - bounds.low[0];
    double depth_m = bounds.high[1] - bounds.low[1];
    double mm = fmin(box.width / width_m, (box.height - legend) / depth_m);
    double left = box.x + 0.5 * (box.width - mm * width_m);
    double low = box.y + mm * depth_m;
    double dx = lattice->x[1] - lattice->x[0], dy = lattice->y[1] - lattice->y[0];
    put_panel_title(plot, box.x, box.y - 1.0 * scale, figure->title);
    cairo_set_antialias(cr, CAIRO_ANTIALIAS_NONE);
    for (int row = 0; row < lattice->rows; row++)
        for (int column = 0; column < lattice->columns; column++) {
            int x = lattice->receivers[row * lattice->columns + column];
            if (x < 0)
                continue;
            double value =
                figure->unit
                * pp_annual_sheet_figure(&sheet->points[x], figure->index)->value;
            pp_colour_scale_set(cr, figure->scale, value);
            cairo_rectangle(cr,
                            left + mm * (lattice->x[column] - 0.5 * dx - bounds.low[0]),
                            low - mm * (lattice->y[row] + 0.5 * dy - bounds.low[1]),
                            mm * dx + OVERLAP_MM, mm * dy);
            cairo_fill(cr);
        }
    cairo_set_antialias(cr, CAIRO_ANTIALIAS_DEFAULT);
    pp_style_line(cr, plot->style.medium, PP_INK);
    for (int r = 0; r < world->plane.count; r++) {
        const struct pp_ring *ring = &world->plane.rings[r];
        for (int i = 0; i < ring->count; i++) {
            double x = left + mm * (ring->xy[i][0] - bounds.low[0]);
            double y = low - mm * (ring->xy[i][1] - bounds.low[1]);
            if (i == 0)
                cairo_move_to(cr, x, y);
            else
                cairo_line_to(cr, x, y);
        }
        cairo_close_path(cr);
    }
    cairo_stroke(cr);
    pp_colour_scale_legend(cr, &plot->style, figure->scale, box.x, low + 1.5 * scale,
                           box.width);
}

static void draw_plans(const struct year_plot *plot, struct pp_box box)
{
    const struct plan_figure figures[] = {
        {"DA 300 lx, % of hours", FIGURE(autonomy_300), 100.0, &share_scale},
        {"UDI 300 to 3000 lx, %", FIGURE(udi_good), 100.0, &share_scale},
        {"Direct sun > 1000 lx, h", FIGURE(sun_h), 1.0, &sun_scale},
        {"DA 300 lx with blinds, %", FIGURE(blinds_autonomy), 100.0, &share_scale}};
    int count = plot->sheet->has_blinds ? 4 : 3;
    double gap = 5.0 * plot->style.scale;
    double width = (box.width - gap * (count - 1)) / count;
    for (int i = 0; i < count; i++)
        draw_plan(plot, &figures[i],
                  (struct pp_box){box.x + i * (width + gap), box.y, width, box.height});
}

/* ---- the curve ---- */

/* Percentage of the occupied hours in which the illuminance at a point is at least lx.
 * point -1: the mean over the points. */
static double share_with(const struct pp_annual_sheet *sheet, int point, double lx)
{
    double hours = 0.0;
    for (int i = 0; i < sheet->hour_count; i++) {
        const struct pp_annual_hour *hour = &sheet->hours[i];
        if (hour->sky < 0 || !(hour->occupied_h > 0.0))
            continue;
        double E =
            point < 0 ? mean_of_points(sheet, i) : pp_annual_sheet_lx(sheet, point, i);
        if (E >= lx)
            hours += hour->occupied_h;
    }
    return 100.0 * hours / sheet->occupied_h;
}

/* Draws the key of a curve: a sample of its line with words beside it. */
static void draw_curve_key(const struct year_plot *plot, int style, const char *words,
                           double x, double y)
{
    struct pp_curve_style look = pp_style_curve(style);
    pp_style_pen(plot->cr, &plot->style, &look);
    cairo_move_to(plot->cr, x, y);
    cairo_line_to(plot->cr, x + 7.0 * plot->style.scale, y);
    cairo_stroke(plot->cr);
    struct pp_lettering name = {.size = PP_TEXT_SMALL, .down = 0.5};
    pp_lettering_draw_on_white(plot->cr, &plot->style, &name,
                               x + 8.0 * plot->style.scale, y, words);
}

static void draw_share_curve(const struct year_plot *plot, const struct pp_axis *across,
                             const struct pp_axis *up, int point, int style,
                             const char *words, double y)
{
    enum { STEPS = 60 };
    cairo_t *cr = plot->cr;
    struct pp_curve_style look = pp_style_curve(style);
    pp_style_pen(cr, &plot->style, &look);
    for (int i = 0; i <= STEPS; i++) {
        double lx = across->low * pow(across->high / across->low, (double)i / STEPS);
        cairo_line_to(cr, pp_axis_at(across, lx),
                      pp_axis_at(up, share_with(plot->sheet, point, lx)));
    }
    cairo_stroke(cr);
    draw_curve_key(plot, style, words, across->from, y);
}

static void draw_curves(const struct year_plot *plot, struct pp_box box)
{
    const struct pp_annual_sheet *sheet = plot->sheet;
    double scale = plot->style.scale, key = 3.5 * scale;
    double low = box.y + box.height - (6.0 * scale + 3 * key);
    int dark = 0, bright = 0;
    for (int x = 1; x < sheet->receiver_count; x++) {
        double value = sheet->points[x].year_lxh.value;
        dark = value < sheet->points[dark].year_lxh.value ? x : dark;
        bright = value > sheet->points[bright].year_lxh.value ? x : bright;
    }
    struct pp_axis across = pp_axis_log(10.0, 50000.0, box.x + 8.0 * scale,
                                        box.x + box.width - 2.0 * scale, 9.0 * scale);
    struct pp_axis up = pp_axis_linear(0.0, 100.0, low, box.y, 5.0 * scale, true);
    put_panel_title(plot, box.x, box.y - 1.0 * scale,
                    "Occupied hours (%) with at least this illuminance (lx)");
    draw_panel_axes(plot, &across, &up);
    double y = low + 7.0 * scale;
    draw_share_curve(plot, &across, &up, bright, 1, "point with the most light", y);
    draw_share_curve(plot, &across, &up, -1, 0, "mean of the points", y + key);
    draw_share_curve(plot, &across, &up, dark, 2, "point with the least light",
                     y + 2 * key);
}

/* ---- by depth ---- */

static void draw_depth_curve(const struct year_plot *plot, const struct pp_axis *across,
                             const struct pp_axis *up,
                             const struct pp_depth_profile *profile, size_t member,
                             int style)
{
    struct pp_curve_style look = pp_style_curve(style);
    pp_style_pen(plot->cr, &plot->style, &look);
    for (int i = 0; i < profile->count; i++) {
        const struct pp_depth_step *step = &profile->steps[i];
        double value = *(const double *)((const char *)step + member);
        cairo_line_to(plot->cr, pp_axis_at(across, step->depth_m),
                      pp_axis_at(up, 100.0 * value));
    }
    cairo_stroke(plot->cr);
}

/* Draws daylight autonomy and useful illuminance against distance from the main window
 * wall. */
static void draw_depth(const struct year_plot *plot,
                       const struct pp_depth_profile *profile, struct pp_box box)
{
    static const struct {
        size_t member;
        const char *words;
    } curves[] = {
        {offsetof(struct pp_depth_step, autonomy), "DA 300 lx"},
        {offsetof(struct pp_depth_step, udi), "UDI 300 to 3000 lx"},
        {offsetof(struct pp_depth_step, blinds_autonomy), "DA 300 lx with blinds"}};
    int count = plot->sheet->has_blinds ? 3 : 2;
    double scale = plot->style.scale, key = 3.5 * scale;
    double low = box.y + box.height - (6.0 * scale + key * count);
    struct pp_axis across = pp_axis_linear(
        0.0, fmax(profile->steps[profile->count - 1].depth_m, 1.0), box.x + 8.0 * scale,
        box.x + box.width - 2.0 * scale, 9.0 * scale, true);
    struct pp_axis up = pp_axis_linear(0.0, 100.0, low, box.y, 5.0 * scale, true);
    put_panel_title(plot, box.x, box.y - 1.0 * scale,
                    "Occupied hours (%) by distance from the window wall (m)");
    draw_panel_axes(plot, &across, &up);
    for (int i = 0; i < count; i++) {
        draw_depth_curve(plot, &across, &up, profile, curves[i].member, i);
        draw_curve_key(plot, i, curves[i].words, across.from,
                       low + 7.0 * scale + key * i);
    }
}

/* ---- the sheet ---- */

static void say_year(char *foot, size_t room, const struct pp_annual_sheet *sheet)
{
    char grid[PP_LM83_GRID_WORDS];
    if (sheet->has_blinds)
        pp_page_say(foot, room, "sDA300/50 %.1f %%,", 100.0 * sheet->plane.sda.value);
    pp_page_say(foot, room, "DA300/50 area without blinds %.1f %%,",
                100.0 * sheet->plane.autonomous.value);
    if (pp_annual_sheet_has_sun(sheet))
        pp_page_say(foot, room, "ASE1000,250 %.1f %%", 100.0 * sheet->plane.ase.value);
    else
        pp_page_say(foot, room, "ASE not known, as the weather has no direct sun,");
    pp_page_say(foot, room,
                pp_point_areas_differ(sheet->receivers, sheet->receiver_count)
                    ? "of the plane, by %d points."
                    : "of %d points.",
                sheet->receiver_count);
    struct pp_annual_leed leed = pp_annual_sheet_leed(sheet);
    if (!leed.why_not)
        pp_page_say(foot, room,
                    "LEED v4.1, option 1, for this room alone: %d point%s%s.",
                    leed.points, leed.points == 1 ? "" : "s",
                    leed.ase_to_explain
                        ? "; ASE is above 10 %: explain how the space is protected "
                          "from glare"
                        : "");
    pp_lm83_grid_words(grid, sheet);
    if (!leed.why_not && grid[0])
        pp_page_say(foot, room, "Note: %s.", grid);
    pp_page_say(foot, room, "Weather: %s. Hours: %s. Blinds: %s.", sheet->weather,
                sheet->period, sheet->blinds);
    for (int i = 0; i < sheet->warning_count; i++)
        pp_page_say(foot, room, "Warning: %s.", sheet->warnings[i]);
}

/* Draws plans, if the points are a grid; curves over illuminance; and, if there are
 * points at several distances from a window wall, curves over distance. */
static void draw_lower_panels(const struct year_plot *plot,
                              const struct pp_depth_profile *profile, struct pp_box box)
{
    double gap = 6.0 * plot->style.scale, title = 5.0 * plot->style.scale;
    if (plot->lattice.columns > 0) {
        double wide = 0.30 * box.width;
        draw_plans(plot,
                   (struct pp_box){box.x, box.y, box.width - wide - gap, box.height});
        box = (struct pp_box){box.x + box.width - wide, box.y, wide, box.height};
    }
    struct pp_box second = box;
    if (profile->count > 1 && plot->lattice.columns > 0) {
        box.height = 0.5 * (box.height - title);
        second =
            (struct pp_box){box.x, box.y + box.height + title, box.width, box.height};
    } else if (profile->count > 1) {
        box.width = 0.5 * (box.width - gap);
        second.x += box.width + gap;
        second.width = box.width;
    }
    draw_curves(plot, box);
    if (profile->count > 1)
        draw_depth(plot, profile, second);
}

enum pp_status pp_year_chart_draw(struct pp_canvas *canvas,
                                  const struct pp_annual_sheet *sheet,
                                  struct pp_error *err)
{
    char foot[4096] = "";
    struct year_plot plot = {
        .cr = pp_canvas_cairo(canvas), .style = pp_page_style(canvas), .sheet = sheet};
    enum pp_status status =
        pp_lattice_find(&plot.lattice, sheet->receivers, sheet->receiver_count, err);
    if (status != PP_OK)
        return status;
    struct pp_depth_profile profile;
    status = pp_depth_profile_find(&profile, sheet, err);
    if (status != PP_OK) {
        pp_lattice_clear(&plot.lattice);
        return status;
    }
    say_year(foot, sizeof foot, sheet);
    const struct pp_page page = {sheet->world->name,
                                 "Daylight in every hour of a year, simulated", foot};
    struct pp_box box = pp_page_draw(canvas, &plot.style, &page);
    double scale = plot.style.scale;
    double legend = 8.0 * scale, title = 4.0 * scale;
    double top = 0.40 * box.height;
    draw_map(&plot,
             (struct pp_box){box.x, box.y + title, box.width, top - legend - title});
    pp_colour_scale_legend(plot.cr, &plot.style, &lux_scale, box.x + 7.0 * scale,
                           box.y + top - legend + 1.0 * scale, 0.5 * box.width);
    struct pp_box lower = {box.x, box.y + top + title, box.width,
                           box.height - top - title};
    draw_lower_panels(&plot, &profile, lower);
    pp_depth_profile_clear(&profile);
    pp_lattice_clear(&plot.lattice);
    return PP_OK;
}
