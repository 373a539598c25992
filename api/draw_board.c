/* draw_board.c - the diagrams that are worked at the drawing board: blank, or with a
 * room's windows seen from its one point. */
#include "api/chart_kind.h"
#include "charts/drawing_board/nomogram_chart.h"
#include "charts/drawing_board/pepper_pot_chart.h"
#include "charts/drawing_board/protractor_chart.h"
#include "charts/drawing_board/protractor_worked.h"
#include "charts/drawing_board/waldram_chart.h"
#include "methods/nomogram/nomogram_sheet_fill.h"
#include "methods/pepper_pot/pepper_pot_dots.h"
#include "methods/pepper_pot/pepper_pot_sheet_fill.h"
#include "methods/protractor/protractor_sheet_fill.h"
#include "methods/waldram/waldram_sheet_fill.h"

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
    if (status == PP_OK)
        status = pp_pepper_pot_chart_draw(canvas, &sheet, options->viewing_mm, err);
    pp_board_sheets_pepper_pot_clear(&sheet);
    return status;
}

/* The protractor that the options ask for: a published one, or any. */
static enum pp_status choose_protractor(struct pp_protractor *protractor,
                                        const struct pp_board_options *options,
                                        struct pp_error *err)
{
    if (options->any_protractor) {
        *protractor =
            (struct pp_protractor){options->sky, options->glass, options->slope_rad};
        return PP_OK;
    }
    return pp_protractor_scale_published(protractor,
                                         options->number ? options->number : 2, err);
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
            status = pp_protractor_worked_draw(canvas, &sheet, err);
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

static enum pp_status draw_nomogram(struct pp_canvas *canvas,
                                    struct pp_study_room *room,
                                    const struct pp_study_options *study,
                                    const struct pp_chart_choice *choice,
                                    bool *finished, struct pp_error *err)
{
    const struct pp_board_options *options = &choice->board;
    (void)study;
    (void)finished;
    const struct pp_nomogram_spacing spacing = {pp_nomogram_chart_height_mm(canvas),
                                                pp_nomogram_chart_fine_mm(canvas),
                                                pp_nomogram_chart_number_mm(canvas)};
    struct pp_nomogram_sheet sheet;
    enum pp_status status =
        room ? pp_nomogram_sheet_fill_room(&sheet, options->nomogram, room->world,
                                           &room->light, spacing, err)
             : pp_nomogram_sheet_fill_blank(&sheet, options->nomogram, spacing, err);
    if (status == PP_OK)
        status = pp_nomogram_chart_draw(canvas, &sheet, err);
    pp_nomogram_sheet_clear(&sheet);
    return status;
}

const struct pp_chart_kind pp_draw_waldram = {
    .name = "waldram",
    .summary = "Waldram diagram, blank or with a room's windows",
    .board = true,
    .from_point = true,
    .landscape = true,
    .draw = draw_waldram,
};

const struct pp_chart_kind pp_draw_pepper_pot = {
    .name = "pepper-pot",
    .summary = "pepper-pot diagram, blank or with a room's windows",
    .board = true,
    .from_point = true,
    .landscape = true,
    .draw = draw_pepper_pot,
};

const struct pp_chart_kind pp_draw_protractor = {
    .name = "protractor",
    .summary = "BRS daylight protractor, blank or laid on a room's section and plan",
    .board = true,
    .from_point = true,
    .draw = draw_protractor,
};

const struct pp_chart_kind pp_draw_nomogram = {
    .name = "nomogram",
    .summary =
        "nomogram of the internally reflected component, blank or with a room's lines",
    .board = true,
    .draw = draw_nomogram,
};
