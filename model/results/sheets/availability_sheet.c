/* availability_sheet.c - see availability_sheet.h. */
#include "model/results/sheets/availability_sheet.h"

#include <stdlib.h>

void pp_availability_sheet_clear(struct pp_availability_sheet *sheet)
{
    for (int i = 0; i < sheet->period_count; i++) {
        free(sheet->periods[i].lx);
        free(sheet->periods[i].share);
    }
    free(sheet->rows);
    *sheet = (struct pp_availability_sheet){0};
}
