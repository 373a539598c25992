/* waldram_sheet_fill.c - fills a sheet of Waldram's diagram with its scales, droop
 * lines and windows. */
#include "methods/waldram/waldram_sheet_fill.h"

#include <math.h>
#include <stdlib.h>

#include "methods/diagram_windows.h"
#include "methods/exact/exterior.h"
#include "methods/method.h"
#include "methods/waldram/waldram_droop_lines.h"
#include "methods/waldram/waldram_site.h"
#include "methods/waldram/waldram_squares.h"

static enum pp_status fill_scales(struct pp_waldram_panel *panel,
                                  const struct pp_waldram *waldram,
                                  struct pp_error *err)
{
    double width, height;
    pp_waldram_squares_size(waldram, &width, &height);
    panel->glazed = waldram->glazed;
    panel->low = -PP_WALDRAM_COLUMNS / 2;
    panel->high = PP_WALDRAM_COLUMNS / 2;
    panel->top = pp_waldram_scale_y(waldram, PP_PI / 2.0) / height;
    panel->whole = pp_waldram_scale_total_area(waldram);
    for (int i = 0; i <= 180; i++)
        panel->azimuth[i] = pp_waldram_scale_x(waldram, i * PP_RAD) / width;
    for (int i = 0; i <= 90; i++)
        panel->altitude[i] = pp_waldram_scale_y(waldram, i * PP_RAD) / height;
    bool good = pp_waldram_droop_lines(&panel->parallel, waldram, 0.0, width, height)
                && pp_waldram_droop_lines(&panel->across, waldram, NAN, width, height);
    return good ? PP_OK : pp_fail_memory(err);
}

enum pp_status pp_waldram_sheet_fill_inclined(struct pp_waldram_sheet *sheet,
                                              double incline_rad, struct pp_error *err)
{
    enum pp_status status = PP_OK;
    sheet->inclined = true;
    sheet->incline_rad = incline_rad;
    for (int i = 0; i < sheet->count && status == PP_OK; i++) {
        struct pp_waldram_panel *panel = &sheet->panels[i];
        struct pp_waldram waldram;
        double width, height;
        status = sheet->upright
                     ? pp_waldram_scale_init_upright(&waldram, &sheet->sky,
                                                     pp_vec(0.0, 1.0, 0.0), err)
                     : pp_waldram_scale_init(&waldram, &sheet->sky, panel->glazed, err);
        if (status != PP_OK)
            return status;
        pp_waldram_squares_size(&waldram, &width, &height);
        pp_curve_list_clear(&panel->across);
        if (!pp_waldram_droop_lines(&panel->across, &waldram, incline_rad, width,
                                    height))
            status = pp_fail_memory(err);
    }
    return status;
}

/* Converts X and Y to numbers of squares. */
static void to_squares(struct pp_region *outline, double width, double height)
{
    for (int r = 0; r < outline->count; r++)
        for (int i = 0; i < outline->rings[r].count; i++) {
            outline->rings[r].xy[i][0] /= width;
            outline->rings[r].xy[i][1] /= height;
        }
}

/* Stores the counts. */
static enum pp_status fill_squares(struct pp_board_piece *piece,
                                   const struct pp_waldram_count *count,
                                   struct pp_error *err)
{
    piece->counted = count->squares;
    piece->squares = malloc(((size_t)count->count + 1) * sizeof *piece->squares);
    piece->square_count = piece->squares ? count->count : 0;
    for (int i = 0; i < piece->square_count; i++)
        piece->squares[i] =
            (struct pp_counted_square){count->list[i].column, count->list[i].row,
                                       (int)lrint(10.0 * count->list[i].estimated)};
    return piece->squares ? PP_OK : pp_fail_memory(err);
}

static enum pp_status fill_piece(struct pp_board_piece *piece,
                                 const struct pp_waldram *waldram,
                                 const struct pp_window_axes *axes,
                                 const struct pp_drawn_part *part, struct pp_error *err)
{
    struct pp_waldram_count count;
    piece->hidden = part->hidden;
    piece->factor = part->factor;
    enum pp_status status =
        pp_waldram_squares_count(&count, waldram, axes, &part->region, err);
    if (status != PP_OK)
        return status;
    status = fill_squares(piece, &count, err);
    pp_waldram_squares_clear(&count);
    if (status != PP_OK)
        return status;

    double width, height;
    pp_waldram_squares_size(waldram, &width, &height);
    status =
        pp_waldram_squares_outline(&piece->outline, waldram, axes, &part->region, err);
    to_squares(&piece->outline, width, height);
    return status;
}

static enum pp_status fill_window(struct pp_board_window *window,
                                  const struct pp_waldram *waldram,
                                  const struct pp_world *world,
                                  const struct pp_outside_light *light,
                                  const struct pp_opening *opening,
                                  struct pp_vec3 point, struct pp_error *err)
{
    struct pp_window_drawing drawing;
    enum pp_status status = pp_diagram_windows_begin(
        window, &drawing, &pp_method_waldram, world, light, opening, point, err);
    if (status != PP_OK)
        return status;
    for (int i = 0; i < drawing.count && status == PP_OK; i++) {
        struct pp_board_piece *piece = &window->pieces[window->count++];
        status = fill_piece(piece, waldram, &drawing.axes, &drawing.parts[i], err);
    }
    pp_board_sheets_window_sum(window, PP_WALDRAM_WORTH);
    pp_window_drawing_clear(&drawing);
    return status;
}

/* Widens the panel from azimuths of 90 to 180 degrees if a sloping opening needs it. */
static void widen(struct pp_waldram_panel *panel)
{
    for (int w = 0; w < panel->count && !panel->glazed; w++)
        for (int p = 0; p < panel->windows[w].count; p++) {
            const struct pp_board_piece *piece = &panel->windows[w].pieces[p];
            for (int i = 0; i < piece->square_count; i++)
                if (piece->squares[i].column < panel->low
                    || piece->squares[i].column >= panel->high) {
                    panel->low = -PP_WALDRAM_COLUMNS;
                    panel->high = PP_WALDRAM_COLUMNS;
                    return;
                }
        }
}

/* Fills the panel of the windows that share a diagram with opening `first`. */
static enum pp_status fill_panel(struct pp_waldram_panel *panel,
                                 const struct pp_world *world,
                                 const struct pp_outside_light *light, int first,
                                 struct pp_vec3 point, struct pp_error *err)
{
    const struct pp_opening *opening = &world->openings[first];
    struct pp_waldram waldram;
    enum pp_status status =
        pp_waldram_scale_init(&waldram, &light->sky, opening->glass.panes > 0, err);
    if (status == PP_OK)
        status = fill_scales(panel, &waldram, err);
    panel->face = pp_diagram_windows_face(world, opening);
    panel->windows = calloc((size_t)pp_diagram_windows_count_alike(world, first),
                            sizeof *panel->windows);
    if (status == PP_OK && !panel->windows)
        status = pp_fail_memory(err);
    for (int i = first; i < world->opening_count && status == PP_OK; i++)
        if (pp_diagram_windows_first_alike(world, i) == first)
            status = fill_window(&panel->windows[panel->count++], &waldram, world,
                                 light, &world->openings[i], point, err);
    widen(panel);
    return status;
}

/* Fills a sheet with one diagram, without windows. */
static enum pp_status fill_single(struct pp_waldram_sheet *sheet,
                                  const struct pp_waldram *waldram,
                                  struct pp_error *err)
{
    *sheet = (struct pp_waldram_sheet){.blank = true,
                                       .upright = waldram->upright,
                                       .sky = waldram->sky,
                                       .worth = PP_WALDRAM_WORTH};
    sheet->panels = calloc(1, sizeof *sheet->panels);
    if (!sheet->panels)
        return pp_fail_memory(err);
    sheet->count = 1;
    enum pp_status status = fill_scales(sheet->panels, waldram, err);
    if (status != PP_OK)
        pp_board_sheets_waldram_clear(sheet);
    return status;
}

enum pp_status pp_waldram_sheet_fill_blank(struct pp_waldram_sheet *sheet,
                                           const struct pp_sky *sky, bool glazed,
                                           struct pp_error *err)
{
    *sheet = (struct pp_waldram_sheet){0};
    struct pp_waldram waldram;
    enum pp_status status = pp_waldram_scale_init(&waldram, sky, glazed, err);
    return status == PP_OK ? fill_single(sheet, &waldram, err) : status;
}

enum pp_status pp_waldram_sheet_fill_upright(struct pp_waldram_sheet *sheet,
                                             const struct pp_sky *sky,
                                             struct pp_error *err)
{
    *sheet = (struct pp_waldram_sheet){0};
    struct pp_waldram waldram;
    enum pp_status status =
        pp_waldram_scale_init_upright(&waldram, sky, pp_vec(0.0, 1.0, 0.0), err);
    return status == PP_OK ? fill_single(sheet, &waldram, err) : status;
}

/* Fills in the pieces of sky and of obstructions with their squares; takes ownership of
 * the site's outlines. */
static enum pp_status fill_site_pieces(struct pp_board_window *window,
                                       const struct pp_waldram *waldram,
                                       struct pp_waldram_site *site,
                                       struct pp_error *err)
{
    struct pp_waldram_count count;
    double width, height;
    window->pieces = calloc(2, sizeof *window->pieces);
    if (!window->pieces)
        return pp_fail_memory(err);
    window->count = 2;
    window->pieces[0] = (struct pp_board_piece){.factor = 1.0};
    window->pieces[1] = (struct pp_board_piece){.hidden = true};
    enum pp_status status = pp_waldram_site_join(site, err);
    if (status != PP_OK)
        return status;
    status = pp_waldram_squares_count_outline(&count, waldram, &site->sky, err);
    if (status == PP_OK)
        status = fill_squares(&window->pieces[0], &count, err);
    pp_waldram_squares_clear(&count);
    window->pieces[0].outline = site->sky;
    window->pieces[1].outline = site->hidden;
    *site = (struct pp_waldram_site){0};
    pp_waldram_squares_size(waldram, &width, &height);
    for (int i = 0; i < 2; i++)
        to_squares(&window->pieces[i].outline, width, height);
    return status;
}

enum pp_status pp_waldram_sheet_fill_site(struct pp_waldram_sheet *sheet,
                                          const struct pp_world *world, int opening,
                                          struct pp_vec3 point, struct pp_error *err)
{
    const struct pp_opening *window = &world->openings[opening];
    const struct pp_sky overcast = pp_sky_overcast();
    struct pp_waldram waldram;
    struct pp_waldram_site site = {0};
    *sheet = (struct pp_waldram_sheet){0};
    enum pp_status status = pp_waldram_scale_init_upright(
        &waldram, &overcast, pp_vec_scale(window->inner.normal, -1.0), err);
    if (status == PP_OK)
        status = fill_single(sheet, &waldram, err);
    if (status != PP_OK)
        return status;
    struct pp_waldram_panel *panel = sheet->panels;
    sheet->blank = false;
    sheet->name = world->name;
    sheet->point = point;
    sheet->off_middle =
        pp_vec_length(pp_vec_sub(point, pp_exterior_opening_centroid(window))) > 0.0;
    panel->face = pp_diagram_windows_face(world, window);
    panel->windows = calloc(1, sizeof *panel->windows);
    status = panel->windows ? pp_waldram_site_init(&site, &waldram, world, sheet->point,
                                                   window->face, err)
                            : pp_fail_memory(err);
    if (status == PP_OK) {
        panel->count = 1;
        panel->windows[0] =
            (struct pp_board_window){.label = window->label, .allowance = 1.0};
        status = fill_site_pieces(panel->windows, &waldram, &site, err);
        pp_board_sheets_window_sum(panel->windows, PP_WALDRAM_WORTH);
        sheet->sky_component = panel->windows[0].sky;
    }
    pp_waldram_site_clear(&site);
    if (status != PP_OK)
        pp_board_sheets_waldram_clear(sheet);
    return status;
}

enum pp_status pp_waldram_sheet_fill_room(struct pp_waldram_sheet *sheet,
                                          const struct pp_world *world,
                                          const struct pp_outside_light *light,
                                          const struct pp_receiver *receiver,
                                          struct pp_error *err)
{
    *sheet = (struct pp_waldram_sheet){0};
    enum pp_status status =
        pp_diagram_windows_check(&pp_method_waldram, world, light, receiver, err);
    if (status == PP_OK && world->opening_count == 0)
        status = pp_waldram_sheet_fill_blank(sheet, &light->sky, false, err);
    if (status != PP_OK)
        return status;
    sheet->name = world->name;
    sheet->blank = false;
    sheet->point = receiver->position;
    sheet->sky = light->sky;
    sheet->worth = PP_WALDRAM_WORTH;
    if (world->opening_count == 0)
        return PP_OK;
    sheet->panels =
        calloc((size_t)pp_diagram_windows_diagram_count(world), sizeof *sheet->panels);
    if (!sheet->panels)
        return pp_fail_memory(err);
    for (int i = 0; i < world->opening_count && status == PP_OK; i++)
        if (pp_diagram_windows_first_alike(world, i) == i)
            status = fill_panel(&sheet->panels[sheet->count++], world, light, i,
                                receiver->position, err);
    for (int i = 0; i < sheet->count; i++)
        pp_board_sheets_windows_add(sheet->panels[i].windows, sheet->panels[i].count,
                                    &sheet->sky_component, &sheet->external);
    if (status != PP_OK)
        pp_board_sheets_waldram_clear(sheet);
    return status;
}
