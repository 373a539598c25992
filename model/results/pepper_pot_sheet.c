/* pepper_pot_sheet.c - see pepper_pot_sheet.h. */
#include "model/results/pepper_pot_sheet.h"

#include <stdlib.h>

void pp_pepper_pot_sheet_clear(struct pp_pepper_pot_sheet *sheet)
{
    for (int i = 0; i < sheet->count; i++) {
        struct pp_pepper_pot_panel *panel = &sheet->panels[i];
        pp_board_windows_destroy(panel->windows, panel->count);
        free(panel->dots);
    }
    free(sheet->panels);
    sheet->panels = NULL;
    sheet->count = 0;
}
