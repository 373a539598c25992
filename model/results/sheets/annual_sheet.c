/* annual_sheet.c - see annual_sheet.h. */
#include "model/results/sheets/annual_sheet.h"

#include <math.h>
#include <stdlib.h>

const double pp_annual_sheet_levels_lx[PP_ANNUAL_LEVELS] = {100.0, 300.0, 500.0, 750.0};

struct pp_annual_leed pp_annual_sheet_leed(const struct pp_annual_sheet *sheet)
{
    struct pp_annual_leed leed = {.why_not = NULL};
    double sda = sheet->plane.sda.value;
    if (!sheet->has_blinds || !sheet->blinds_of_lm83)
        leed.why_not = "sDA needs blinds operated as in LM-83";
    else if (!sheet->is_grid)
        leed.why_not = "the points do not form a grid";
    else if (!sheet->standard_hours)
        leed.why_not = "the hours are not 8:00 to 18:00 on all days";
    else if (!pp_annual_sheet_has_sun(sheet))
        leed.why_not = "the weather has no direct sun, so ASE is not known";
    leed.points = leed.why_not ? 0 : (sda >= 0.40) + (sda >= 0.55) + (sda >= 0.75);
    leed.ase_to_explain = sheet->plane.ase.value > 0.10;
    return leed;
}

bool pp_annual_sheet_has_sun(const struct pp_annual_sheet *sheet)
{
    for (int i = 0; i < sheet->hour_count; i++)
        if (sheet->hours[i].direct_lx > 0.0)
            return true;
    return false;
}

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
    for (int k = 0; k < sheet->lighting_count; k++) {
        free(sheet->lighting[k].points);
        free(sheet->lighting[k].fraction);
    }
    free(sheet->lighting);
    free(sheet->points);
    free(sheet->groups);
    free(sheet->hours);
    free(sheet->lx);
    free(sheet->sun_lx);
    free(sheet->coefficients);
    *sheet = (struct pp_annual_sheet){.points = NULL};
}
