/* annual_result.h - annual results of rooms, the input of the annual reports. */
#ifndef PP_REPORTS_ANNUAL_ANNUAL_RESULT_H
#define PP_REPORTS_ANNUAL_ANNUAL_RESULT_H

#include <stdbool.h>

#include "model/results/sheets/annual_sheet.h"
#include "model/results/sheets/hand_year_sheet.h"

struct pp_annual_result {
    struct pp_annual_sheet sheet;
    struct pp_hand_year_sheet hand; /* without columns: no hand methods */
    const char *file;               /* as typed; not owned */
};

struct pp_annual_results {
    struct pp_annual_result *list;
    int count;
    bool several; /* print a list, even of a single room */
    bool more_than_one_file;
};

/* A figure and its name in reports: "udi-good", "per cent". */
struct pp_annual_figure_name {
    const char *name;  /* name in JSON and CSV; an autonomy's name lacks its target */
    const char *title; /* for readers; NULL: not in the table of points */
    int index;         /* index of the member in struct pp_annual_figures */
    double unit;       /* factor on the value for printing */
    int digits;        /* as printed */
};

/* All figures except the autonomies, of which there is one for each illuminance; the
 * last name is NULL. */
extern const struct pp_annual_figure_name pp_annual_result_names[];

/* Index of the autonomy, or the continuous autonomy, at a sheet's target i. */
int pp_annual_result_autonomy(int i, bool continuous);

#endif
