/* waldram_sheet.c - see waldram_sheet.h. */
#include "model/results/waldram_sheet.h"

#include <stdlib.h>

void pp_waldram_sheet_clear(struct pp_waldram_sheet *sheet)
{
    for (int i = 0; i < sheet->count; i++) {
        struct pp_waldram_panel *panel = &sheet->panels[i];
        pp_board_windows_destroy(panel->windows, panel->count);
        pp_curves_clear(&panel->parallel);
        pp_curves_clear(&panel->across);
    }
    free(sheet->panels);
    sheet->panels = NULL;
    sheet->count = 0;
}
