/* annual_sheet.c - see annual_sheet.h. */
#include "model/results/sheets/annual_sheet.h"

#include <math.h>
#include <stdlib.h>

const double pp_annual_sheet_levels_lx[PP_ANNUAL_LEVELS] = {100.0, 300.0, 500.0, 750.0};

double pp_annual_sheet_lx(const struct pp_annual_sheet *sheet, int receiver, int hour)
{
    const struct pp_annual_hour *at = &sheet->hours[hour];
    if (!at->known)
        return NAN;
    return at->sky < 0 ? 0.0
                       : sheet->lx[(size_t)receiver * (size_t)sheet->sky_count
                                   + (size_t)at->sky];
}

void pp_annual_sheet_clear(struct pp_annual_sheet *sheet)
{
    free(sheet->points);
    free(sheet->groups);
    free(sheet->hours);
    free(sheet->lx);
    free(sheet->sun_lx);
    *sheet = (struct pp_annual_sheet){.points = NULL};
}
