/* protractor_sheet.c - see protractor_sheet.h. */
#include "model/results/protractor_sheet.h"

#include <stdlib.h>

void pp_protractor_sheet_readings_clear(struct pp_protractor_readings *readings)
{
    free(readings->list);
    *readings = (struct pp_protractor_readings){0};
}

void pp_protractor_sheet_scale_clear(struct pp_protractor_scale *scale)
{
    for (int i = 0; i < scale->line_count; i++)
        free(scale->lines[i].jamb_rad);
    free(scale->lines);
    free(scale->marks);
    *scale = (struct pp_protractor_scale){0};
}

void pp_protractor_sheet_clear(struct pp_protractor_sheet *sheet)
{
    pp_protractor_sheet_readings_clear(&sheet->read);
    pp_protractor_sheet_scale_clear(&sheet->scale);
}
