/* draw_slats.c - transmittance of a blind by profile angle. The blind is given by an
 * option or belongs to a window of the room. */
#include <math.h>
#include <stdio.h>

#include "api/chart_kind.h"
#include "api/choose_window.h"
#include "charts/slats_chart.h"
#include "model/light/slats/slat_cell.h"

/* Finds the blind of the chosen window, or of the first window with a blind. */
static enum pp_status blind_of_room(struct pp_window_device *device,
                                    const struct pp_world *world, const char *words,
                                    struct pp_error *err)
{
    int window = 0;
    if (words) {
        enum pp_status status = pp_choose_window(&window, world, words, false, err);
        if (status != PP_OK)
            return status;
    } else {
        while (window + 1 < world->opening_count && !world->openings[window].blind)
            window++;
    }
    if (world->opening_count == 0 || !world->openings[window].blind)
        return pp_fail(err, PP_BAD_INPUT,
                       "%s has no blind; expected a window with a blind, or no room "
                       "file and --slats",
                       words ? world->openings[window].label : "the room");
    *device = world->openings[window].device;
    return PP_OK;
}

static void fill_slat_sheet(struct pp_slat_sheet *sheet,
                            const struct pp_slat_cell *cell)
{
    struct pp_slat_light light;
    for (int i = 0; i < PP_SLAT_SHEET_CURVE; i++) {
        pp_slat_cell_light(cell, (i - PP_SLAT_SHEET_CURVE / 2) * PP_RAD, &light);
        sheet->curve[i] = pp_slat_cell_parts(&light);
    }
    for (int deg = -75; deg <= 75; deg += 15) {
        pp_slat_cell_light(cell, deg * PP_RAD, &light);
        snprintf(sheet->rows[sheet->row_count].words,
                 sizeof sheet->rows[sheet->row_count].words, "%d\u00b0", deg);
        sheet->rows[sheet->row_count++].parts = pp_slat_cell_parts(&light);
    }
    const struct {
        const char *words;
        double low, high;
    } halves[] = {
        {"all directions", -0.5 * PP_PI, 0.5 * PP_PI},
        {sheet->device.vertical ? "from the left" : "sky", 0.0, 0.5 * PP_PI},
        {sheet->device.vertical ? "from the right" : "ground", -0.5 * PP_PI, 0.0}};
    for (int i = 0; i < 3; i++) {
        pp_slat_cell_diffuse(cell, halves[i].low, halves[i].high, &light);
        snprintf(sheet->rows[sheet->row_count].words,
                 sizeof sheet->rows[sheet->row_count].words, "%s", halves[i].words);
        sheet->rows[sheet->row_count++].parts = pp_slat_cell_parts(&light);
    }
}

static enum pp_status draw_slats(struct pp_canvas *canvas, struct pp_study_room *room,
                                 const struct pp_study_options *study,
                                 const struct pp_chart_choice *choice, bool *finished,
                                 struct pp_error *err)
{
    (void)study, (void)finished;
    struct pp_slat_sheet sheet = {
        .title = room && room->world->name ? room->world->name : "Venetian blind",
        .device = {.kind = PP_DEVICE_BLIND, .slats = choice->board.slats}};
    struct pp_slat_cell *cell = NULL;
    enum pp_status status = PP_OK;
    if (room)
        status = blind_of_room(&sheet.device, room->world, choice->board.window, err);
    if (status == PP_OK)
        status = pp_slat_cell_create(&cell, &sheet.device.slats, err);
    if (status != PP_OK)
        return status;
    fill_slat_sheet(&sheet, cell);
    pp_slats_chart_draw(canvas, &sheet);
    pp_slat_cell_destroy(cell);
    return PP_OK;
}

const struct pp_chart_kind pp_draw_slats = {
    .name = "slats",
    .summary = "light through a blind by profile angle: straight, scattered, reflected",
    .board = true,
    .of_window = true,
    .draw = draw_slats,
};
