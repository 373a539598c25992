/* board_sheets.c - see board_sheets.h. */
#include "model/results/board_sheets.h"

#include <math.h>
#include <stdlib.h>

void pp_board_sheets_window_sum(struct pp_board_window *window, double worth)
{
    window->sky = window->external = 0.0;
    for (int i = 0; i < window->count; i++) {
        const struct pp_board_piece *piece = &window->pieces[i];
        double share = window->allowance * piece->factor * piece->counted * worth;
        *(piece->hidden ? &window->external : &window->sky) += share;
    }
}

void pp_board_sheets_windows_add(const struct pp_board_window *windows, int count,
                                 double *sky, double *external)
{
    for (int i = 0; i < count; i++) {
        *sky += windows[i].sky;
        *external += windows[i].external;
    }
}

bool pp_board_sheets_windows_hidden(const struct pp_board_window *windows, int count)
{
    for (int w = 0; w < count; w++)
        for (int p = 0; p < windows[w].count; p++)
            if (windows[w].pieces[p].hidden)
                return true;
    return false;
}

void pp_board_sheets_window_extent(const struct pp_board_window *window, double low[2],
                                   double high[2])
{
    for (int p = 0; p < window->count; p++) {
        struct pp_bounds2 bounds = pp_region_bounds(&window->pieces[p].outline);
        for (int k = 0; k < 2; k++) {
            low[k] = fmin(low[k], bounds.low[k]);
            high[k] = fmax(high[k], bounds.high[k]);
        }
    }
}

void pp_board_sheets_windows_destroy(struct pp_board_window *windows, int count)
{
    for (int w = 0; w < count; w++) {
        for (int p = 0; p < windows[w].count; p++) {
            pp_region_clear(&windows[w].pieces[p].outline);
            free(windows[w].pieces[p].squares);
        }
        free(windows[w].pieces);
    }
    free(windows);
}

void pp_board_sheets_waldram_clear(struct pp_waldram_sheet *sheet)
{
    for (int i = 0; i < sheet->count; i++) {
        struct pp_waldram_panel *panel = &sheet->panels[i];
        pp_board_sheets_windows_destroy(panel->windows, panel->count);
        pp_curve_list_clear(&panel->parallel);
        pp_curve_list_clear(&panel->across);
    }
    free(sheet->panels);
    sheet->panels = NULL;
    sheet->count = 0;
}

void pp_board_sheets_pepper_pot_clear(struct pp_pepper_pot_sheet *sheet)
{
    for (int i = 0; i < sheet->count; i++) {
        struct pp_pepper_pot_panel *panel = &sheet->panels[i];
        pp_board_sheets_windows_destroy(panel->windows, panel->count);
        free(panel->dots);
    }
    free(sheet->panels);
    sheet->panels = NULL;
    sheet->count = 0;
}
