/* draw_board.c - the diagrams of the drawing board: blank, or with the windows of a
 * room as seen from its point. */
#include "api/chart_kind.h"
#include "charts/drawing_board/brs_table_chart.h"
#include "charts/drawing_board/nomogram_chart.h"
#include "charts/drawing_board/pepper_pot_chart.h"
#include "charts/drawing_board/protractor_chart.h"
#include "charts/drawing_board/protractor_worked.h"
#include "charts/drawing_board/waldram_chart.h"
#include "charts/room/exercise_chart.h"
#include "methods/brs/brs_sheet_fill.h"
#include "methods/nomogram/nomogram_sheet_fill.h"
#include "methods/pepper_pot/pepper_pot_dots.h"
#include "methods/pepper_pot/pepper_pot_sheet_fill.h"
#include "methods/protractor/protractor_sheet_fill.h"
#include "methods/waldram/waldram_sheet_fill.h"

/* Draws the exercise. *blank is set to true if the empty diagram must follow on the
 * next sheet, and to false for formats with only one sheet. */
static enum pp_status draw_exercise(bool *blank, struct pp_canvas *canvas,
                                    const struct pp_study_room *room, const char *tool,
                                    const char *unit, double viewing_mm,
                                    struct pp_error *err)
{
    const struct pp_exercise exercise = {.world = room->world,
                                         .light = &room->light,
                                         .receiver = room->receivers[0],
                                         .tool = tool,
                                         .unit = unit,
                                         .viewing_mm = viewing_mm};
    *blank = pp_canvas_has_sheets(canvas);
    enum pp_status status = pp_exercise_chart_draw(canvas, &exercise, err);
    return status == PP_OK && *blank ? pp_canvas_next_sheet(canvas, err) : status;
}

/* True if the first opening is glazed. */
static bool is_glazed(const struct pp_study_room *room)
{
    return room->world->opening_count > 0 && room->world->openings[0].glass.panes > 0;
}

static enum pp_status draw_waldram(struct pp_canvas *canvas, struct pp_study_room *room,
                                   const struct pp_study_options *study,
                                   const struct pp_chart_choice *choice, bool *finished,
                                   struct pp_error *err)
{
    const struct pp_board_options *options = &choice->board;
    (void)study;
    (void)finished;
    struct pp_waldram_sheet sheet;
    enum pp_status status =
        room ? pp_waldram_sheet_fill_room(&sheet, room->world, &room->light,
                                          room->receivers, err)
             : pp_waldram_sheet_fill_blank(&sheet, &options->sky,
                                           options->glazed != PP_NO, err);
    if (status == PP_OK && options->unsolved) {
        bool blank;
        pp_board_sheets_waldram_clear(&sheet);
        status = draw_exercise(&blank, canvas, room, "a Waldram diagram",
                               "squares \u00d7 0.1\u00a0%", 0.0, err);
        if (status != PP_OK || !blank)
            return status;
        status =
            pp_waldram_sheet_fill_blank(&sheet, &room->light.sky, is_glazed(room), err);
    }
    if (status == PP_OK && options->inclined)
        status =
            pp_waldram_sheet_fill_inclined(&sheet, options->inclined_deg * PP_RAD, err);
    if (status == PP_OK)
        status = pp_waldram_chart_draw(canvas, &sheet, err);
    pp_board_sheets_waldram_clear(&sheet);
    return status;
}

static enum pp_status draw_pepper_pot(struct pp_canvas *canvas,
                                      struct pp_study_room *room,
                                      const struct pp_study_options *study,
                                      const struct pp_chart_choice *choice,
                                      bool *finished, struct pp_error *err)
{
    const struct pp_board_options *options = &choice->board;
    (void)study;
    (void)finished;
    double worth = options->fine ? PP_PEPPER_POT_FINE_WORTH : PP_PEPPER_POT_WORTH;
    struct pp_pepper_pot_sheet sheet;
    enum pp_status status =
        room ? pp_pepper_pot_sheet_fill_room(&sheet, room->world, &room->light,
                                             room->receivers, worth, err)
             : pp_pepper_pot_sheet_fill_blank(&sheet, &options->sky,
                                              options->glazed != PP_NO,
                                              options->vertical == PP_YES, worth, err);
    double viewing_mm = options->viewing_mm;
    if (status == PP_OK && options->unsolved) {
        bool blank, upright = sheet.upright, any = sheet.any;
        viewing_mm = viewing_mm > 0.0 ? viewing_mm : 30.0;
        if (!any)
            pp_board_sheets_pepper_pot_clear(&sheet);
        status = draw_exercise(&blank, canvas, room, "the pepper-pot diagram",
                               options->fine ? "dots \u00d7 0.01\u00a0%"
                                             : "dots \u00d7 0.1\u00a0%",
                               viewing_mm, err);
        if (status != PP_OK || !blank) {
            if (any)
                pp_board_sheets_pepper_pot_clear(&sheet);
            return status;
        }
        if (any)
            pp_pepper_pot_sheet_fill_unsolved(&sheet);
        else
            status = pp_pepper_pot_sheet_fill_blank(
                &sheet, &room->light.sky, is_glazed(room), upright, worth, err);
    }
    if (status == PP_OK)
        status = pp_pepper_pot_chart_draw(canvas, &sheet, viewing_mm, err);
    pp_board_sheets_pepper_pot_clear(&sheet);
    return status;
}

/* Selects the protractor given by the options: a published one, or one for any glass
 * and slope. */
static enum pp_status choose_protractor(struct pp_protractor *protractor,
                                        const struct pp_board_options *options,
                                        struct pp_error *err)
{
    if (options->any_protractor) {
        *protractor = (struct pp_protractor){.sky = options->sky,
                                             .glass = options->glass,
                                             .slope_rad = options->slope_rad};
        return PP_OK;
    }
    return pp_protractor_scale_published(protractor,
                                         options->number ? options->number : 2, err);
}

/* Draws the exercise, then the room's protractor as a blank form. */
static enum pp_status draw_protractor_exercise(struct pp_canvas *canvas,
                                               const struct pp_study_room *room,
                                               struct pp_protractor_sheet *sheet,
                                               struct pp_error *err)
{
    bool blank;
    enum pp_status status =
        draw_exercise(&blank, canvas, room, "a daylight protractor", NULL, 0.0, err);
    if (status != PP_OK || !blank)
        return status;
    sheet->world = NULL;
    return pp_protractor_chart_draw(canvas, sheet, err);
}

static enum pp_status draw_protractor(struct pp_canvas *canvas,
                                      struct pp_study_room *room,
                                      const struct pp_study_options *study,
                                      const struct pp_chart_choice *choice,
                                      bool *finished, struct pp_error *err)
{
    const struct pp_board_options *options = &choice->board;
    (void)study;
    (void)finished;
    double arc_mm = pp_protractor_chart_arc_mm(canvas, room != NULL);
    struct pp_mark_spacing spacing = {0.75 / arc_mm, (3.2 + 0.03 * arc_mm) / arc_mm};
    struct pp_protractor_sheet sheet = {0};
    struct pp_protractor protractor;
    enum pp_status status;
    if (room) {
        status = pp_protractor_sheet_fill_room(&sheet, room->world, &room->light,
                                               room->receivers, spacing, err);
        if (status == PP_OK)
            status = options->unsolved
                         ? draw_protractor_exercise(canvas, room, &sheet, err)
                         : pp_protractor_worked_draw(canvas, &sheet, err);
    } else {
        status = choose_protractor(&protractor, options, err);
        if (status == PP_OK)
            status = pp_protractor_sheet_fill_blank(&sheet, &protractor,
                                                    options->glass_words, spacing, err);
        if (status == PP_OK)
            status = pp_protractor_chart_draw(canvas, &sheet, err);
    }
    pp_protractor_sheet_clear(&sheet);
    return status;
}

static enum pp_status draw_brs_table(struct pp_canvas *canvas,
                                     struct pp_study_room *room,
                                     const struct pp_study_options *study,
                                     const struct pp_chart_choice *choice,
                                     bool *finished, struct pp_error *err)
{
    const struct pp_board_options *options = &choice->board;
    (void)study, (void)finished;
    struct pp_brs_sheet sheet = {0};
    enum pp_status status = PP_OK;
    if (!room && options->sky.kind != PP_SKY_OVERCAST)
        return pp_fail(
            err, PP_BAD_INPUT,
            "the BRS table is for the CIE overcast sky only; expected --sky overcast");
    if (room)
        status = pp_brs_sheet_fill_room(&sheet, room->world, &room->light,
                                        room->receivers, err);
    else
        pp_brs_sheet_fill_blank(&sheet);
    if (status == PP_OK && options->unsolved) {
        bool blank;
        pp_brs_sheet_clear(&sheet);
        status =
            draw_exercise(&blank, canvas, room, "the BRS simplified daylight table",
                          "readings", 0.0, err);
        if (status != PP_OK || !blank)
            return status;
        pp_brs_sheet_fill_blank(&sheet);
    }
    if (status == PP_OK)
        status = pp_brs_table_chart_draw(canvas, &sheet, err);
    pp_brs_sheet_clear(&sheet);
    return status;
}

static enum pp_status draw_one_nomogram(struct pp_canvas *canvas,
                                        struct pp_study_room *room,
                                        enum pp_nomogram_kind kind,
                                        struct pp_error *err)
{
    const struct pp_nomogram_spacing spacing = {
        pp_nomogram_chart_height_mm(canvas), pp_canvas_width_mm(canvas),
        pp_nomogram_chart_fine_mm(canvas), pp_nomogram_chart_number_mm(canvas)};
    struct pp_nomogram_sheet sheet;
    enum pp_status status =
        room ? pp_nomogram_sheet_fill_room(&sheet, kind, room->world, &room->light,
                                           room->receivers, spacing, err)
             : pp_nomogram_sheet_fill_blank(&sheet, kind, spacing, err);
    if (status == PP_OK)
        status = pp_nomogram_chart_draw(canvas, &sheet, err);
    pp_nomogram_sheet_clear(&sheet);
    return status;
}

static enum pp_status draw_nomogram(struct pp_canvas *canvas,
                                    struct pp_study_room *room,
                                    const struct pp_study_options *study,
                                    const struct pp_chart_choice *choice,
                                    bool *finished, struct pp_error *err)
{
    (void)study, (void)finished;
    return draw_one_nomogram(canvas, room, choice->board.nomogram, err);
}

static enum pp_status draw_position_nomogram(struct pp_canvas *canvas,
                                             struct pp_study_room *room,
                                             const struct pp_study_options *study,
                                             const struct pp_chart_choice *choice,
                                             bool *finished, struct pp_error *err)
{
    (void)study, (void)choice, (void)finished;
    return draw_one_nomogram(canvas, room, PP_NOMOGRAM_POSITION, err);
}

const struct pp_chart_kind pp_draw_waldram = {
    .name = "waldram",
    .summary = "Waldram diagram, blank or with the windows of a room",
    .board = true,
    .from_point = true,
    .landscape = true,
    .draw = draw_waldram,
};

const struct pp_chart_kind pp_draw_pepper_pot = {
    .name = "pepper-pot",
    .summary = "pepper-pot diagram, blank or with the windows of a room",
    .board = true,
    .from_point = true,
    .landscape = true,
    .draw = draw_pepper_pot,
};

const struct pp_chart_kind pp_draw_protractor = {
    .name = "protractor",
    .summary =
        "BRS daylight protractor, blank or laid on the section and plan of a room",
    .board = true,
    .from_point = true,
    .draw = draw_protractor,
};

const struct pp_chart_kind pp_draw_nomogram = {
    .name = "nomogram",
    .summary = "nomogram of the internally reflected component, blank or with the "
               "readings for a room",
    .board = true,
    .draw = draw_nomogram,
};

const struct pp_chart_kind pp_draw_position_nomogram = {
    .name = "position-nomogram",
    .summary = "nomogram of the internally reflected component at a point, by the "
               "method irc-atlas",
    .board = true,
    .from_point = true,
    .landscape = true,
    .draw = draw_position_nomogram,
};

const struct pp_chart_kind pp_draw_brs_table = {
    .name = "brs-table",
    .summary = "BRS simplified daylight table, blank or with the readings for a room",
    .board = true,
    .from_point = true,
    .draw = draw_brs_table,
};
