/* pepper_pot_sheet.c - see pepper_pot_sheet.h. */
#include "model/pepper_pot_sheet.h"

#include <stdlib.h>

static void clear_window(struct pp_pepper_pot_window *window)
{
    for (int i = 0; i < window->count; i++)
        pp_region_destroy(&window->pieces[i].outline);
    free(window->pieces);
}

void pp_pepper_pot_sheet_clear(struct pp_pepper_pot_sheet *sheet)
{
    for (int i = 0; i < sheet->count; i++) {
        struct pp_pepper_pot_panel *panel = &sheet->panels[i];
        for (int j = 0; j < panel->count; j++)
            clear_window(&panel->windows[j]);
        free(panel->windows);
        free(panel->dots);
    }
    free(sheet->panels);
    sheet->panels = NULL;
    sheet->count = 0;
}
