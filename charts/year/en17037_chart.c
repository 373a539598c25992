/* en17037_chart.c - see en17037_chart.h. */
#include "charts/year/en17037_chart.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "charts/room/room_plan.h"
#include "charts/sheet/page.h"
#include "charts/year/colour_scale.h"
#include "model/results/lattice.h"

/* Classes of illuminance, separated at the targets of the standard. */
static const struct pp_colour_scale target_scale = {
    {0.0, 100.0, 200.0, 300.0, 500.0, 750.0, 1500.0}, " lx"};

/* Overlap of neighbouring cells, so that rounding does not leave gaps between them. */
static const double CELL_OVERLAP_MM = 0.03;

struct page_plot {
    cairo_t *cr;
    struct pp_style style;
    const struct pp_en17037_sheet *sheet;
};

/* ---- levels ---- */

/* Draws three steps, one for each level. The levels that are reached are filled. */
static void draw_steps(const struct page_plot *plot, int reached, double x, double y,
                       double width, double height)
{
    double gap = 0.8 * plot->style.scale, step = (width - 2.0 * gap) / 3.0;
    for (int i = 0; i < 3; i++) {
        cairo_rectangle(plot->cr, x + i * (step + gap), y, step, height);
        pp_style_grey(plot->cr, i < reached ? 0.35 : 1.0);
        cairo_fill_preserve(plot->cr);
        pp_style_line(plot->cr, plot->style.hair, PP_GREY_LINE);
        cairo_stroke(plot->cr);
    }
}

/* Draws the levels of all parts side by side. Returns the height. */
static double draw_levels(const struct page_plot *plot, struct pp_box box)
{
    const struct pp_en17037_sheet *sheet = plot->sheet;
    double scale = plot->style.scale, gap = 2.0 * scale, pad = 1.5 * scale;
    double width = (box.width - gap * (sheet->part_count - 1)) / sheet->part_count;
    double height = 22.0 * scale;
    for (int i = 0; i < sheet->part_count; i++) {
        const struct pp_en17037_part *part = &sheet->parts[i];
        double x = box.x + i * (width + gap), inner = width - 2.0 * pad;
        struct pp_lettering title = {
            .size = PP_TEXT_SMALL, .width = inner, .lines = 2, .grey = PP_GREY_TEXT};
        struct pp_lettering level = {.size = PP_TEXT_BODY,
                                     .bold = true,
                                     .width = inner,
                                     .lines = 2,
                                     .down = 0.5};
        pp_lettering_draw(plot->cr, &plot->style, &title, x + pad, box.y + pad,
                          part->title);
        pp_lettering_draw(plot->cr, &plot->style, &level, x + pad, box.y + 13.0 * scale,
                          part->level);
        if (part->reached >= 0)
            draw_steps(plot, part->reached, x + pad, box.y + height - 3.6 * scale,
                       inner, 2.2 * scale);
        pp_style_line(plot->cr, plot->style.thin, PP_INK);
        cairo_rectangle(plot->cr, x, box.y, width, height);
        cairo_stroke(plot->cr);
    }
    return height;
}

/* ---- plans ---- */

static void fill_cells(const struct page_plot *plot, const struct pp_room_plan *plan,
                       const struct pp_en17037_map *map,
                       const struct pp_lattice *lattice)
{
    cairo_t *cr = plot->cr;
    double dx = lattice->x[1] - lattice->x[0], dy = lattice->y[1] - lattice->y[0];
    cairo_set_antialias(cr, CAIRO_ANTIALIAS_NONE);
    for (int row = 0; row < lattice->rows; row++)
        for (int column = 0; column < lattice->columns; column++) {
            int i = lattice->receivers[row * lattice->columns + column];
            if (i < 0)
                continue;
            double left = pp_plan_frame_x(plan, lattice->x[column] - 0.5 * dx);
            double top = pp_plan_frame_y(plan, lattice->y[row] + 0.5 * dy);
            pp_colour_scale_set(cr, &target_scale, map->lux[i]);
            cairo_rectangle(cr, left, top, plan->mm_per_m * dx + CELL_OVERLAP_MM,
                            plan->mm_per_m * dy + CELL_OVERLAP_MM);
            cairo_fill(cr);
        }
    cairo_set_antialias(cr, CAIRO_ANTIALIAS_DEFAULT);
}

/* Draws an arrow for each view, from the eye along the line of sight. */
static void draw_views(const struct page_plot *plot, const struct pp_room_plan *plan)
{
    const struct pp_world *world = plot->sheet->world;
    double scale = plot->style.scale, length = 7.0 * scale;
    for (int i = 0; i < world->view_count; i++) {
        const struct pp_world_view *view = &world->views[i];
        double x = pp_plan_frame_x(plan, view->eye.x);
        double y = pp_plan_frame_y(plan, view->eye.y);
        const double from[2] = {x, y};
        const double to[2] = {x + length * view->direction.x,
                              y - length * view->direction.y};
        cairo_arc(plot->cr, x, y, 1.4 * scale, 0.0, 2.0 * PP_PI);
        pp_style_grey(plot->cr, 1.0);
        cairo_fill(plot->cr);
        pp_style_line(plot->cr, 2.0 * plot->style.thick, 1.0);
        cairo_move_to(plot->cr, from[0], from[1]);
        cairo_line_to(plot->cr, to[0], to[1]);
        cairo_stroke(plot->cr);
        pp_style_marker(plot->cr, &plot->style, PP_DISC, x, y);
        pp_style_arrow(plot->cr, &plot->style, from, to, 2.0 * scale, 0.8 * scale);
    }
}

static enum pp_status draw_map_plan(const struct page_plot *plot,
                                    const struct pp_room_plan *fitted,
                                    const struct pp_en17037_map *map, struct pp_box box,
                                    struct pp_error *err)
{
    struct pp_room_plan plan = *fitted;
    struct pp_lattice lattice;
    double scale = plot->style.scale;
    struct pp_lettering title = {.size = PP_TEXT_SMALL, .bold = true};
    struct pp_lettering none = {.size = PP_TEXT_SMALL,
                                .across = 0.5,
                                .down = 0.5,
                                .width = box.width,
                                .grey = PP_GREY_TEXT};
    enum pp_status status = pp_lattice_find(&lattice, map->receivers, map->count, err);
    if (status != PP_OK)
        return status;
    pp_lettering_draw(plot->cr, &plot->style, &title, box.x, box.y, map->title);
    box.y += 5.0 * scale;
    box.height -= 5.0 * scale;
    pp_room_plan_place(&plan, &plot->style, box, true);
    if (lattice.columns > 0)
        fill_cells(plot, &plan, map, &lattice);
    pp_room_plan_draw(plot->cr, &plot->style, &plan);
    draw_views(plot, &plan);
    if (lattice.columns == 0)
        pp_lettering_draw_on_white(plot->cr, &plot->style, &none,
                                   box.x + 0.5 * box.width, box.y + 0.5 * box.height,
                                   map->count ? "no grid of points" : "not assessed");
    pp_lattice_clear(&lattice);
    return PP_OK;
}

/* Draws both plans, the north arrow, the legend and a scale bar, at most as high as the
 * box. *below is set to their lower edge. */
static enum pp_status draw_map_plans(const struct page_plot *plot, struct pp_box box,
                                     double *below, struct pp_error *err)
{
    const struct pp_en17037_sheet *sheet = plot->sheet;
    double scale = plot->style.scale, legend = 24.0 * scale, arrow = 8.0 * scale;
    double gap = 4.0 * scale, width = (box.width - 2.0 * (arrow + gap)) / 2.0;
    double height = box.height - legend;
    struct pp_room_plan plan = {.world = sheet->world};
    pp_room_plan_fit(&plan, sheet->world, &plot->style, width, height - 6.0 * scale);
    enum pp_status status = PP_OK;
    for (int i = 0; i < PP_EN17037_MAPS && status == PP_OK; i++)
        status = draw_map_plan(
            plot, &plan, &sheet->maps[i],
            (struct pp_box){box.x + i * (width + gap), box.y, width, height}, err);
    pp_room_plan_north_arrow(plot->cr, &plot->style, sheet->world->north_rad,
                             box.x + box.width - arrow, box.y + 12.0 * scale,
                             7.0 * scale);
    double y = box.y + 7.5 * scale
               + plan.mm_per_m * (plan.extent.high[1] - plan.extent.low[1])
               + pp_room_plan_border(&plan, &plot->style, PP_PLAN_ABOVE)
               + pp_room_plan_border(&plan, &plot->style, PP_PLAN_BELOW);
    pp_colour_scale_legend(plot->cr, &plot->style, &target_scale, box.x, y,
                           2.0 * width + gap);
    struct pp_box bar = pp_room_plan_scale_bar(plot->cr, &plot->style, plan.mm_per_m,
                                               box.x, y + 8.0 * scale);
    struct pp_lettering ratio = {.size = PP_TEXT_SMALL, .down = 1.0};
    char words[24];
    snprintf(words, sizeof words, "1:%g", plan.scale);
    pp_lettering_draw(plot->cr, &plot->style, &ratio, bar.x + bar.width + 3.0 * scale,
                      bar.y + bar.height, words);
    *below = bar.y + bar.height;
    return status;
}

/* ---- the table ---- */

enum { TABLE_COLUMNS = 4 };

/* Right edges of the columns of figures, and left edge of the verdicts, as fractions of
 * the width. */
static const double column_ends[TABLE_COLUMNS] = {0.52, 0.68, 0.81, 0.83};

static double row_mm(const struct pp_style *style)
{
    return 1.36 * style->text[PP_TEXT_SMALL];
}

static void draw_table_row(const struct page_plot *plot, struct pp_box box, double y,
                           const struct pp_en17037_row *row)
{
    const char *const cells[TABLE_COLUMNS] = {row->figure, row->wanted, row->over,
                                              row->verdict};
    struct pp_lettering text = {.size = PP_TEXT_SMALL, .bold = row->decides};
    struct pp_lettering what = text;
    what.width = 0.41 * box.width;
    what.lines = 1;
    pp_lettering_draw(plot->cr, &plot->style, &what, box.x + 3.0 * plot->style.scale, y,
                      row->what);
    for (int i = 0; i < TABLE_COLUMNS; i++) {
        text.across = i < TABLE_COLUMNS - 1 ? 1.0 : 0.0;
        pp_lettering_draw(plot->cr, &plot->style, &text,
                          box.x + column_ends[i] * box.width, y, cells[i]);
    }
}

/* Draws title, rows and basis of a part, with its upper edge at y. Returns the y of its
 * lower edge. */
static double draw_part(const struct page_plot *plot,
                        const struct pp_en17037_part *part, struct pp_box box, double y)
{
    double step = row_mm(&plot->style), scale = plot->style.scale;
    char words[128];
    struct pp_lettering title = {.size = PP_TEXT_SMALL, .bold = true};
    struct pp_lettering note = {
        .size = PP_TEXT_SMALL, .width = box.width - 3.0 * scale, .grey = PP_GREY_TEXT};
    pp_style_line(plot->cr, plot->style.hair, PP_GREY_LINE);
    cairo_move_to(plot->cr, box.x, y);
    cairo_line_to(plot->cr, box.x + box.width, y);
    cairo_stroke(plot->cr);
    y += 0.6 * scale;
    snprintf(words, sizeof words, "%s: %s", part->title, part->level);
    pp_lettering_draw(plot->cr, &plot->style, &title, box.x, y, words);
    y += step;
    for (int i = 0; i < part->row_count; i++, y += step)
        draw_table_row(plot, box, y, &part->rows[i]);
    if (part->basis[0])
        y += pp_lettering_draw(plot->cr, &plot->style, &note, box.x + 3.0 * scale, y,
                               part->basis)
                 .height;
    return y + 0.8 * scale;
}

/* Total height of all parts drawn by draw_part. */
static double table_height(const struct page_plot *plot, double width)
{
    double scale = plot->style.scale, sum = 0.0;
    for (int i = 0; i < plot->sheet->part_count; i++) {
        const struct pp_en17037_part *part = &plot->sheet->parts[i];
        struct pp_lettering note = {.size = PP_TEXT_SMALL,
                                    .width = width - 3.0 * scale};
        sum += (1 + part->row_count) * row_mm(&plot->style) + 1.4 * scale;
        if (part->basis[0])
            sum += pp_lettering_measure(plot->cr, &plot->style, &note, 0.0, 0.0,
                                        part->basis)
                       .height;
    }
    return sum;
}

enum pp_status pp_en17037_chart_draw(struct pp_canvas *canvas,
                                     const struct pp_en17037_sheet *sheet,
                                     struct pp_error *err)
{
    const double least_plan_mm = 50.0;
    struct page_plot plot = {pp_canvas_cairo(canvas), pp_page_style(canvas), sheet};
    char subtitle[256];
    snprintf(subtitle, sizeof subtitle, "EN 17037, daylight in buildings%s%s",
             sheet->place[0] ? "; " : "", sheet->place);
    const struct pp_page page = {
        .title = sheet->world->name, .subtitle = subtitle, .foot = sheet->room};
    struct pp_box box = pp_page_draw(canvas, &plot.style, &page);
    double scale = plot.style.scale, gap = 4.0 * scale;
    double levels = draw_levels(&plot, box) + gap;
    double table = table_height(&plot, box.width);
    double plans = fmax(box.height - levels - table - gap, least_plan_mm * scale);
    double y;
    enum pp_status status = draw_map_plans(
        &plot, (struct pp_box){box.x, box.y + levels, box.width, plans}, &y, err);
    y += gap;
    for (int i = 0; i < sheet->part_count; i++)
        y = draw_part(&plot, &sheet->parts[i], box, y);
    return status;
}
