/* draw_envelope.c - see draw_envelope.h. */
#include "api/draw_envelope.h"

#include <stdlib.h>
#include <string.h>

#include "charts/drawing_board/waldram_chart.h"
#include "charts/site/site_chart.h"
#include "methods/waldram/waldram_sheet_fill.h"
#include "model/results/sheets/site_sheet.h"
#include "model/room/room_light.h"
#include "studies/criteria/windows/vertical_sky.h"
#include "studies/site/site_study.h"

/* The rooms of the building in its present state, resolved. */
struct standing_rooms {
    struct pp_study_room *list;
    const struct pp_study_room **before; /* former states: NULL for each room */
    int count;
};

static void clear_standing_rooms(struct standing_rooms *rooms)
{
    for (int i = 0; i < rooms->count; i++)
        pp_study_room_clear(&rooms->list[i]);
    free(rooms->list);
    free(rooms->before);
}

static enum pp_status add_room(struct standing_rooms *rooms,
                               struct pp_building *building, int index,
                               const char *file, struct pp_error *err)
{
    const struct pp_room *room = pp_building_room(building, index);
    struct pp_world *world = NULL;
    struct pp_outside_light light;
    struct pp_mistakes mistakes;
    pp_mistakes_init(&mistakes, file);
    enum pp_status status = pp_world_create(&world, room, &mistakes, err);
    pp_mistakes_clear(&mistakes);
    if (status == PP_OK)
        status = pp_room_light(&light, room, err);
    if (status != PP_OK) {
        pp_world_destroy(world);
        return status;
    }
    pp_study_room_init(&rooms->list[rooms->count++], file, building, index, room, world,
                       &light);
    return PP_OK;
}

/* Replaces the named block on the sheet by the cells of the envelope. The sheet shows
 * the building as pp_plot_envelope_find left it. */
static enum pp_status add_envelope_cells(struct pp_site_sheet *sheet,
                                         const struct pp_plot_envelope *envelope,
                                         const char *block, struct pp_error *err)
{
    int kept = 0;
    for (int i = 0; i < sheet->shape_count; i++) {
        struct pp_site_shape *shape = &sheet->shapes[i];
        if (shape->name && strcmp(shape->name, block) == 0)
            pp_site_sheet_clear_shape(shape);
        else
            sheet->shapes[kept++] = *shape;
    }
    sheet->shape_count = kept;
    sheet->cells = calloc((size_t)envelope->cells.count + 1, sizeof *sheet->cells);
    if (!sheet->cells)
        return pp_fail_memory(err);
    for (int i = 0; i < envelope->cells.count; i++) {
        const struct pp_building_cell *cell = &envelope->cells.list[i];
        struct pp_site_cell *drawn = &sheet->cells[sheet->cell_count++];
        drawn->height_m = cell->height_m;
        for (int k = 0; k < 4; k++) {
            struct pp_vec3 corner = pp_plot_cells_corner(cell, k);
            drawn->corners[k][0] = corner.x;
            drawn->corners[k][1] = corner.y;
        }
    }
    sheet->cells_m3 = envelope->volume_m3;
    return PP_OK;
}

static enum pp_status resolve_standing_rooms(struct standing_rooms *rooms,
                                             struct pp_building *building,
                                             const char *file, struct pp_error *err)
{
    int count = pp_building_room_count(building);
    enum pp_status status = PP_OK;
    rooms->list = calloc((size_t)count + 1, sizeof *rooms->list);
    rooms->before = calloc((size_t)count + 1, sizeof(struct pp_study_room *));
    if (!rooms->list || !rooms->before)
        return pp_fail_memory(err);
    for (int i = 0; i < count && status == PP_OK; i++)
        status = add_room(rooms, building, i, file, err);
    return status;
}

static enum pp_status draw_plot_plan(struct pp_canvas *canvas,
                                     const struct standing_rooms *rooms,
                                     const struct pp_plot_envelope *found,
                                     const struct pp_plot_envelope_task *task,
                                     struct pp_error *err)
{
    const struct pp_site_rooms site = {rooms->list, rooms->before, rooms->count,
                                       task->rule.french_m};
    struct pp_site_sheet sheet;
    enum pp_status status = pp_site_study_make(&sheet, &site, err);
    if (status == PP_OK)
        status = add_envelope_cells(&sheet, found, task->block, err);
    if (status == PP_OK)
        status = pp_site_chart_draw(canvas, &sheet, err);
    pp_site_sheet_clear(&sheet);
    return status;
}

/* Finds the window that limits the envelope. Returns its room and sets *opening to its
 * index; NULL: no window limits it. */
static const struct pp_world *find_deciding(int *opening,
                                            const struct standing_rooms *rooms,
                                            const struct pp_plot_envelope *found)
{
    if (found->deciding < 0)
        return NULL;
    const struct pp_retained_sky_place *due = &found->retained.list[found->deciding];
    for (int i = 0; i < rooms->count; i++) {
        const struct pp_study_room *room = &rooms->list[i];
        if (pp_building_place(room->building, room->index) != due->place)
            continue;
        for (*opening = 0; *opening < room->world->opening_count; ++*opening)
            if (room->world->openings[*opening].line == due->line)
                return room->world;
    }
    return NULL;
}

static enum pp_status draw_sky(struct pp_canvas *canvas, const struct pp_world *world,
                               int opening, double french_m, struct pp_error *err)
{
    struct pp_waldram_sheet sheet = {0};
    enum pp_status status = pp_canvas_next_sheet(canvas, err);
    if (status == PP_OK)
        status = pp_waldram_sheet_fill_site(
            &sheet, world, opening,
            pp_vertical_sky_point(&world->openings[opening], french_m), err);
    if (status == PP_OK)
        status = pp_waldram_chart_draw(canvas, &sheet, err);
    pp_board_sheets_waldram_clear(&sheet);
    return status;
}

enum pp_status pp_draw_envelope(struct pp_canvas *canvas,
                                const struct pp_plot_envelope *found,
                                const struct pp_plot_envelope_task *task,
                                const char *file, struct pp_error *err)
{
    struct standing_rooms rooms = {0};
    int opening = 0;
    enum pp_status status = resolve_standing_rooms(&rooms, task->building, file, err);
    if (status == PP_OK)
        status = draw_plot_plan(canvas, &rooms, found, task, err);
    if (status == PP_OK && pp_canvas_has_sheets(canvas)) {
        const struct pp_world *world = find_deciding(&opening, &rooms, found);
        status =
            world ? draw_sky(canvas, world, opening, task->rule.french_m, err) : PP_OK;
    }
    clear_standing_rooms(&rooms);
    return status;
}
