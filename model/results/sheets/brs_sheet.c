/* brs_sheet.c - frees the contents of a sheet. */
#include "model/results/sheets/brs_sheet.h"

#include <stdlib.h>

void pp_brs_sheet_clear(struct pp_brs_sheet *sheet)
{
    free(sheet->windows);
    free(sheet->readings);
    *sheet = (struct pp_brs_sheet){0};
}
