/* year_section.h - the simulated year of a room in a report: results with standard
 * errors, and assumptions. */
#ifndef PP_REPORTS_PAGE_YEAR_SECTION_H
#define PP_REPORTS_PAGE_YEAR_SECTION_H

#include "model/results/document.h"
#include "model/results/sheets/annual_sheet.h"

/* Adds the section. The simulation of the year must be finished. */
void pp_year_section(struct pp_document *document, const struct pp_annual_sheet *year);

/* Adds one table of all rooms, for a short report. count: 1 or more. The assumptions
 * printed are those of the first year, with the warnings of all years. */
void pp_year_section_rooms(struct pp_document *document,
                           const struct pp_annual_sheet *const *years, int count);

#endif
