/* annual_result.h - annual results of rooms, which the annual reports print. */
#ifndef PP_REPORTS_ANNUAL_ANNUAL_RESULT_H
#define PP_REPORTS_ANNUAL_ANNUAL_RESULT_H

#include <stdbool.h>

#include "model/results/sheets/annual_sheet.h"
#include "model/results/sheets/hand_year_sheet.h"

struct pp_annual_result {
    struct pp_annual_sheet sheet;
    struct pp_hand_year_sheet hand; /* no columns: hand methods were not used */
    const char *file;               /* as typed; not owned */
};

struct pp_annual_results {
    struct pp_annual_result *list;
    int count;
    bool several; /* print a list, even for a single room */
    bool more_than_one_file;
    bool hourly; /* JSON has the illuminances of all hours */
};

/* A figure and its appearance in reports. */
struct pp_annual_figure_name {
    const char *name;  /* name in JSON and CSV, such as "udi-good"; for an autonomy,
                        * without the target */
    const char *title; /* heading for readers; NULL: not in the table of points */
    int index;         /* position in struct pp_annual_figures */
    double unit;       /* factor by which the value is multiplied for printing */
    int digits;        /* number of decimals printed */
};

/* All figures except the autonomies, since there is one autonomy for each target. The
 * last name is NULL. */
extern const struct pp_annual_figure_name pp_annual_result_names[];

/* Position in struct pp_annual_figures of the autonomy, or continuous autonomy, for
 * target i of a sheet. */
int pp_annual_result_autonomy(int i, bool continuous);

#endif
