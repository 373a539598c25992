/* picture_sheet.c - see picture_sheet.h. */
#include "model/results/sheets/picture_sheet.h"

#include <stdlib.h>

void pp_picture_sheet_clear(struct pp_picture_sheet *sheet)
{
    pp_raster_clear(&sheet->raster);
    pp_curve_list_clear(&sheet->lines);
    pp_curve_list_clear(&sheet->grid);
    free(sheet->words);
    free(sheet->marks);
    *sheet = (struct pp_picture_sheet){0};
}
