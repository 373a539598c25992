/* waldram_sheet.c - see waldram_sheet.h. */
#include "model/waldram_sheet.h"

#include <stdlib.h>

static void clear_window(struct pp_waldram_window *window)
{
    for (int i = 0; i < window->count; i++) {
        pp_region_destroy(&window->pieces[i].outline);
        free(window->pieces[i].list);
    }
    free(window->pieces);
}

void pp_waldram_sheet_clear(struct pp_waldram_sheet *sheet)
{
    for (int i = 0; i < sheet->count; i++) {
        struct pp_waldram_panel *panel = &sheet->panels[i];
        for (int j = 0; j < panel->count; j++)
            clear_window(&panel->windows[j]);
        free(panel->windows);
        pp_curves_clear(&panel->parallel);
        pp_curves_clear(&panel->across);
    }
    free(sheet->panels);
    sheet->panels = NULL;
    sheet->count = 0;
}
