/* hand_year_sheet.h - annual daylight of a room's points by hand methods, as printed.
 *
 * studies/year/hand/hand_year.h fills it. Illuminances are in lx, shares 0 to 1; hours
 * are occupied hours.
 */
#ifndef PP_MODEL_RESULTS_SHEETS_HAND_YEAR_SHEET_H
#define PP_MODEL_RESULTS_SHEETS_HAND_YEAR_SHEET_H

#include "model/results/sheets/annual_sheet.h"
#include "model/results/steps.h"

/* Figures of one point by one method; NAN if the method does not apply. */
struct pp_hand_figures {
    double autonomy[PP_ANNUAL_ILLUMINANCES_MOST]; /* share of hours with E >= target */
    double udi_below, udi_low, udi_good, udi_above; /* as in pp_annual_figures */
    double mean_lx;
};

enum { PP_HAND_FIGURES = sizeof(struct pp_hand_figures) / sizeof(double) };

/* Likely range of the simulated daylight autonomy, for each target; NAN: not known. */
struct pp_hand_range {
    double low[PP_ANNUAL_ILLUMINANCES_MOST], high[PP_ANNUAL_ILLUMINANCES_MOST];
};

/* Results of one method. */
struct pp_hand_column {
    const char *name, *summary, *source, *assumptions; /* static */
    const char *why; /* reason why the method does not apply; NULL: it does; static */
    struct pp_hand_figures *points; /* by receiver; owned */
    struct pp_hand_figures mean;
    struct pp_hand_range *ranges; /* by receiver; owned */
    struct pp_steps hour, year;   /* calculation for one hour and for the year; empty
                                 * unless requested */
};

struct pp_hand_year_sheet {
    int receiver_count;
    double *df;       /* daylight factors in use, by receiver; owned */
    char words[640];  /* origin of the daylight factors, and of the factors of other
                      * skies */
    char ranges[320]; /* meaning of the ranges, or the reason why there are none */
    char when[64];    /* hour of the explanation; empty: none */
    bool finished;
    int column_count;
    struct pp_hand_column *columns; /* by method; owned */
};

void pp_hand_year_sheet_clear(struct pp_hand_year_sheet *sheet);

#endif
