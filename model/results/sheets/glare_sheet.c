/* glare_sheet.c - see glare_sheet.h. */
#include "model/results/sheets/glare_sheet.h"

#include <math.h>
#include <stdlib.h>

const double pp_glare_sheet_limits[PP_GLARE_LIMITS] = {0.35, 0.40, 0.45};

const char *pp_glare_sheet_class(double dgp)
{
    static const char *const classes[PP_GLARE_LIMITS + 1] = {
        "imperceptible", "perceptible", "disturbing", "intolerable"};
    int class = 0;
    while (class < PP_GLARE_LIMITS && dgp >= pp_glare_sheet_limits[class])
        class ++;
    return classes[class];
}

const char *pp_glare_sheet_level(const struct pp_glare_year *year, double occupied_h)
{
    static const char *const levels[PP_GLARE_LIMITS] = {"high", "medium", "minimum"};
    for (int i = 0; i < PP_GLARE_LIMITS; i++)
        if (year->above_h[i].value <= PP_GLARE_SHARE * occupied_h * (1.0 + 1e-9))
            return levels[i];
    return "none";
}

double pp_glare_sheet_luminance(const struct pp_glare_part *part)
{
    return part->light / part->omega_sr;
}

double pp_glare_sheet_index(const struct pp_glare_part *part)
{
    return sqrt(part->square / part->sum);
}

const char *pp_glare_sheet_devices(const struct pp_glare_sheet *sheet)
{
    return !sheet->has_devices ? "Windows have no blinds"
           : sheet->is_year    ? "Blinds, screens and curtains are closed in all hours"
                               : "Blinds, screens and curtains are closed";
}

void pp_glare_sheet_clear(struct pp_glare_sheet *sheet)
{
    for (int i = 0; i < sheet->view_count; i++) {
        if (sheet->moments)
            free(sheet->moments[i].parts);
        if (sheet->years)
            free(sheet->years[i].dgp);
    }
    free(sheet->moments);
    free(sheet->years);
    sheet->moments = NULL;
    sheet->years = NULL;
    pp_annual_sheet_clear(&sheet->annual);
}
