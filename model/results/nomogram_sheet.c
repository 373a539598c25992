/* nomogram_sheet.c - see nomogram_sheet.h. */
#include "model/results/nomogram_sheet.h"

#include <stdlib.h>

void pp_nomogram_sheet_clear(struct pp_nomogram_sheet *sheet)
{
    for (int i = 0; i < PP_NOMOGRAM_STEMS; i++)
        free(sheet->scales[i].marks);
    free(sheet->curve.marks);
    free(sheet->windows);
    *sheet = (struct pp_nomogram_sheet){0};
}
