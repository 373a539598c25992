/* pepper_pot_sheet_fill.c - fills a sheet of the pepper-pot diagram with dots and
 * windows. */
#include "methods/pepper_pot/pepper_pot_sheet_fill.h"

#include <math.h>
#include <stdlib.h>

#include "methods/diagram_windows.h"
#include "methods/method.h"
#include "methods/pepper_pot/pepper_pot_cloud.h"
#include "methods/pepper_pot/pepper_pot_dots.h"
#include "methods/view/window_drawing.h"

static enum pp_status copy_dots(struct pp_pepper_pot_panel *panel,
                                const double (*dots)[2], int count,
                                struct pp_error *err)
{
    panel->dots = calloc((size_t)count + 1, sizeof *panel->dots);
    if (!panel->dots)
        return pp_fail_memory(err);
    panel->dot_count = count;
    for (int i = 0; i < count; i++) {
        panel->dots[i].a = dots[i][0];
        panel->dots[i].b = dots[i][1];
    }
    return PP_OK;
}

static enum pp_status fill_dots(struct pp_pepper_pot_panel *panel,
                                const struct pp_pepper_pot *pot, struct pp_error *err)
{
    panel->glazed = pot->glazed;
    panel->whole = pot->whole;
    return copy_dots(panel, (const double(*)[2])pot->dots, pot->count, err);
}

/* Dots for any sky, slope and receiver. */
static enum pp_status fill_cloud(struct pp_pepper_pot_panel *panel,
                                 const struct pp_opening *opening,
                                 const struct pp_sky *sky, struct pp_vec3 normal,
                                 double worth, struct pp_error *err)
{
    struct pp_pepper_pot_cloud cloud;
    const struct pp_glass glass =
        opening->glass.panes > 0 ? pp_glass_clear_single() : opening->glass;
    const struct pp_window_axes axes = {opening->along, opening->up,
                                        pp_vec_scale(opening->inner.normal, -1.0)};
    enum pp_status status =
        pp_pepper_pot_cloud_init(&cloud, sky, &glass, &axes, normal, worth, err);
    if (status != PP_OK)
        return status;
    panel->glazed = opening->glass.panes > 0;
    panel->any_slope = fabs(opening->inner.normal.z) > 1e-6;
    panel->whole = cloud.whole;
    status = copy_dots(panel, (const double(*)[2])cloud.dots, cloud.count, err);
    pp_pepper_pot_cloud_clear(&cloud);
    return status;
}

/* Dots for vertical windows under the overcast or the uniform sky. */
static enum pp_status fill_pot(struct pp_pepper_pot_panel *panel,
                               const struct pp_opening *opening,
                               const struct pp_sky *sky, struct pp_vec3 normal,
                               bool upright, double worth, struct pp_error *err)
{
    double facing = atan2(pp_vec_dot(normal, opening->along),
                          -pp_vec_dot(normal, opening->inner.normal));
    struct pp_pepper_pot *pot;
    enum pp_status status = pp_pepper_pot_dots_create(
        &pot, sky, opening->glass.panes > 0, upright, facing, worth, err);
    if (status != PP_OK)
        return status;
    status = fill_dots(panel, pot, err);
    pp_pepper_pot_dots_destroy(pot);
    return status;
}

static void count_dots(struct pp_pepper_pot_panel *panel, struct pp_board_piece *piece)
{
    for (int i = 0; i < panel->dot_count; i++) {
        struct pp_pepper_pot_dot *dot = &panel->dots[i];
        if (pp_region_contains(&piece->outline, dot->a, dot->b)) {
            dot->counted = true;
            piece->counted += 1.0;
        }
    }
}

static enum pp_status fill_window(struct pp_pepper_pot_panel *panel,
                                  struct pp_board_window *window,
                                  const struct pp_world *world,
                                  const struct pp_outside_light *light,
                                  const struct pp_opening *opening,
                                  struct pp_vec3 point, double worth,
                                  struct pp_error *err)
{
    struct pp_window_drawing drawing;
    enum pp_status status = pp_diagram_windows_begin(
        window, &drawing, &pp_method_pepper_pot, world, light, opening, point, err);
    if (status != PP_OK)
        return status;
    for (int i = 0; i < drawing.count; i++) {
        struct pp_drawn_part *part = &drawing.parts[i];
        struct pp_board_piece *piece = &window->pieces[window->count++];
        /* Moves the outline from the drawing to the sheet. */
        *piece = (struct pp_board_piece){
            .outline = part->region, .hidden = part->hidden, .factor = part->factor};
        part->region = (struct pp_region){0};
        count_dots(panel, piece);
    }
    pp_board_sheets_window_sum(window, worth);
    pp_window_drawing_clear(&drawing);
    return PP_OK;
}

/* Fills the panel of the windows that share a diagram with opening `first`. */
static enum pp_status fill_panel(struct pp_pepper_pot_panel *panel,
                                 const struct pp_pepper_pot_sheet *sheet,
                                 const struct pp_world *world,
                                 const struct pp_outside_light *light, int first,
                                 const struct pp_receiver *receiver,
                                 struct pp_error *err)
{
    const struct pp_opening *opening = &world->openings[first];
    double worth = sheet->worth;
    enum pp_status status =
        sheet->any
            ? fill_cloud(panel, opening, &light->sky, receiver->normal, worth, err)
            : fill_pot(panel, opening, &light->sky, receiver->normal, sheet->upright,
                       worth, err);
    if (status != PP_OK)
        return status;
    panel->face = pp_diagram_windows_face(world, opening);
    panel->windows = calloc((size_t)pp_diagram_windows_count_alike(world, first),
                            sizeof *panel->windows);
    if (status == PP_OK && !panel->windows)
        status = pp_fail_memory(err);
    for (int i = first; i < world->opening_count && status == PP_OK; i++)
        if (pp_diagram_windows_first_alike(world, i) == first)
            status = fill_window(panel, &panel->windows[panel->count++], world, light,
                                 &world->openings[i], receiver->position, worth, err);
    return status;
}

enum pp_status pp_pepper_pot_sheet_fill_blank(struct pp_pepper_pot_sheet *sheet,
                                              const struct pp_sky *sky, bool glazed,
                                              bool upright, double worth,
                                              struct pp_error *err)
{
    *sheet = (struct pp_pepper_pot_sheet){
        .blank = true, .upright = upright, .sky = *sky, .worth = worth};
    struct pp_pepper_pot *pot;
    enum pp_status status =
        pp_pepper_pot_dots_create(&pot, sky, glazed, upright, 0.0, worth, err);
    if (status != PP_OK)
        return status;
    sheet->panels = calloc(1, sizeof *sheet->panels);
    if (!sheet->panels) {
        status = pp_fail_memory(err);
    } else {
        sheet->count = 1;
        status = fill_dots(sheet->panels, pot, err);
    }
    pp_pepper_pot_dots_destroy(pot);
    if (status != PP_OK)
        pp_board_sheets_pepper_pot_clear(sheet);
    return status;
}

enum pp_status pp_pepper_pot_sheet_fill_room(struct pp_pepper_pot_sheet *sheet,
                                             const struct pp_world *world,
                                             const struct pp_outside_light *light,
                                             const struct pp_receiver *receiver,
                                             double worth, struct pp_error *err)
{
    *sheet = (struct pp_pepper_pot_sheet){0};
    bool upright = fabs(receiver->normal.z) < 1e-6;
    enum pp_status status =
        pp_diagram_windows_check(&pp_method_pepper_pot, world, light, receiver, err);
    sheet->any = status != PP_OK
                 && pp_diagram_windows_check(&pp_method_pepper_pot_sky, world, light,
                                             receiver, NULL)
                        == PP_OK;
    if (sheet->any)
        status = PP_OK;
    if (status == PP_OK && world->opening_count == 0)
        status = pp_pepper_pot_sheet_fill_blank(sheet, &light->sky, false, upright,
                                                worth, err);
    if (status != PP_OK)
        return status;
    sheet->name = world->name;
    sheet->blank = false;
    sheet->upright = upright;
    sheet->aslant = fabs(receiver->normal.z) > 1e-6 && receiver->normal.z < 1.0 - 1e-9;
    sheet->point = receiver->position;
    sheet->sky = light->sky;
    sheet->worth = worth;
    if (world->opening_count == 0)
        return PP_OK;
    sheet->panels =
        calloc((size_t)pp_diagram_windows_diagram_count(world), sizeof *sheet->panels);
    if (!sheet->panels)
        return pp_fail_memory(err);
    for (int i = 0; i < world->opening_count && status == PP_OK; i++)
        if (pp_diagram_windows_first_alike(world, i) == i)
            status = fill_panel(&sheet->panels[sheet->count++], sheet, world, light, i,
                                receiver, err);
    for (int i = 0; i < sheet->count; i++)
        pp_board_sheets_windows_add(sheet->panels[i].windows, sheet->panels[i].count,
                                    &sheet->sky_component, &sheet->external);
    if (status != PP_OK)
        pp_board_sheets_pepper_pot_clear(sheet);
    return status;
}

void pp_pepper_pot_sheet_fill_unsolved(struct pp_pepper_pot_sheet *sheet)
{
    sheet->blank = true;
    for (int i = 0; i < sheet->count; i++) {
        struct pp_pepper_pot_panel *panel = &sheet->panels[i];
        panel->face = (struct pp_board_face){0};
        pp_board_sheets_windows_destroy(panel->windows, panel->count);
        panel->windows = NULL;
        panel->count = 0;
        for (int k = 0; k < panel->dot_count; k++)
            panel->dots[k].counted = false;
    }
}
