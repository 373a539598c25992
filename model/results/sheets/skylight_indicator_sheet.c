/* skylight_indicator_sheet.c - frees what a sheet holds. */
#include "model/results/sheets/skylight_indicator_sheet.h"

void pp_skylight_indicator_sheet_clear(struct pp_skylight_indicator_sheet *sheet)
{
    pp_region_clear(&sheet->hidden);
}
