/* draw_site.c - the diagrams of the sky that a window faces, for its vertical sky
 * component: blank, or with what stands before one window of a room. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "api/chart_kind.h"
#include "charts/drawing_board/skylight_indicator_chart.h"
#include "charts/drawing_board/waldram_chart.h"
#include "methods/waldram/skylight_indicator_fill.h"
#include "methods/waldram/waldram_sheet_fill.h"

static bool is_upright(const struct pp_opening *opening)
{
    return fabs(opening->inner.normal.z) < sin(1.0 * PP_RAD);
}

static const char *wall_of(const struct pp_world *world, int opening)
{
    return world->surfaces[world->openings[opening].face].name;
}

/* By its line in the room file; -1: there is none. */
static int window_by_line(const struct pp_world *world, const char *words)
{
    char *end;
    long line = strtol(words, &end, 10);
    for (int i = 0; *end == 0 && i < world->opening_count; i++)
        if (world->openings[i].line == line)
            return i;
    return -1;
}

/* By its wall, whose only opening it is; -1: there are none, or several. */
static int window_by_wall(const struct pp_world *world, const char *words)
{
    int found = -1, count = 0;
    for (int i = 0; i < world->opening_count; i++)
        if (wall_of(world, i) && strcmp(wall_of(world, i), words) == 0) {
            found = i;
            count++;
        }
    return count == 1 ? found : -1;
}

/* The first upright window, unless the words choose one. */
static enum pp_status choose_window(int *window, const struct pp_world *world,
                                    const char *words, struct pp_error *err)
{
    *window = 0;
    if (words) {
        *window = window_by_wall(world, words);
        if (*window < 0)
            *window = window_by_line(world, words);
        if (*window < 0)
            return pp_fail(
                err, PP_BAD_INPUT,
                "--window is \"%.60s\"; expected the line of a window in the "
                "room file, or the name of a wall with one window",
                words);
    } else {
        while (*window < world->opening_count && !is_upright(&world->openings[*window]))
            ++*window;
    }
    if (*window == world->opening_count)
        return pp_fail(
            err, PP_BAD_INPUT,
            "the room has no upright window, and the vertical sky component is "
            "for one");
    if (!is_upright(&world->openings[*window]))
        return pp_fail(
            err, PP_BAD_INPUT,
            "the opening on line %d is not upright; the vertical sky component "
            "is for windows in walls",
            world->openings[*window].line);
    return PP_OK;
}

static enum pp_status draw_vertical_sky(struct pp_canvas *canvas,
                                        struct pp_study_room *room,
                                        const struct pp_study_options *study,
                                        const struct pp_chart_choice *choice,
                                        bool *finished, struct pp_error *err)
{
    (void)study, (void)finished;
    int window;
    struct pp_waldram_sheet sheet = {0};
    enum pp_status status =
        room ? choose_window(&window, room->world, choice->board.window, err) : PP_OK;
    if (status == PP_OK)
        status = room ? pp_waldram_sheet_fill_site(&sheet, room->world, window, err)
                      : pp_waldram_sheet_fill_upright(&sheet, &choice->board.sky, err);
    if (status == PP_OK && choice->board.inclined)
        status = pp_waldram_sheet_fill_inclined(
            &sheet, choice->board.inclined_deg * PP_RAD, err);
    if (status == PP_OK)
        status = pp_waldram_chart_draw(canvas, &sheet, err);
    pp_board_sheets_waldram_clear(&sheet);
    return status;
}

static enum pp_status draw_skylight_indicator(struct pp_canvas *canvas,
                                              struct pp_study_room *room,
                                              const struct pp_study_options *study,
                                              const struct pp_chart_choice *choice,
                                              bool *finished, struct pp_error *err)
{
    (void)study, (void)finished;
    int window;
    struct pp_skylight_indicator_sheet sheet = {0};
    enum pp_status status =
        room ? choose_window(&window, room->world, choice->board.window, err) : PP_OK;
    if (status == PP_OK)
        status =
            room ? pp_skylight_indicator_fill_site(&sheet, room->world, window, err)
                 : pp_skylight_indicator_fill_blank(&sheet, &choice->board.sky, err);
    if (status == PP_OK)
        status = pp_skylight_indicator_chart_draw(canvas, &sheet, err);
    pp_skylight_indicator_sheet_clear(&sheet);
    return status;
}

const struct pp_chart_kind pp_draw_vertical_sky = {
    .name = "vertical-sky",
    .summary = "Waldram diagram of the vertical sky component, blank or of a window",
    .board = true,
    .of_window = true,
    .landscape = true,
    .draw = draw_vertical_sky,
};

const struct pp_chart_kind pp_draw_skylight_indicator = {
    .name = "skylight-indicator",
    .summary = "marks of equal vertical sky component for a plan, blank or of a window",
    .board = true,
    .of_window = true,
    .landscape = true,
    .draw = draw_skylight_indicator,
};
