/* hand_year_sheet.c - see hand_year_sheet.h. */
#include "model/results/sheets/hand_year_sheet.h"

#include <stdlib.h>

void pp_hand_year_sheet_clear(struct pp_hand_year_sheet *sheet)
{
    for (int i = 0; i < sheet->column_count; i++) {
        free(sheet->columns[i].points);
        free(sheet->columns[i].ranges);
        pp_steps_clear(&sheet->columns[i].hour);
        pp_steps_clear(&sheet->columns[i].year);
    }
    free(sheet->columns);
    free(sheet->df);
    *sheet = (struct pp_hand_year_sheet){.columns = NULL};
}
