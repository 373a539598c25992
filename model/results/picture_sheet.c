#include "model/results/picture_sheet.h"

#include <stdlib.h>

void pp_picture_sheet_clear(struct pp_picture_sheet *sheet)
{
    pp_raster_clear(&sheet->raster);
    pp_curves_clear(&sheet->lines);
    pp_curves_clear(&sheet->grid);
    free(sheet->words);
    free(sheet->marks);
    *sheet = (struct pp_picture_sheet){0};
}
