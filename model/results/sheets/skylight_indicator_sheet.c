/* skylight_indicator_sheet.c - frees the contents of a sheet. */
#include "model/results/sheets/skylight_indicator_sheet.h"

void pp_skylight_indicator_sheet_clear(struct pp_skylight_indicator_sheet *sheet)
{
    pp_region_clear(&sheet->hidden);
}
