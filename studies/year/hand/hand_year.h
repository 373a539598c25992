/* hand_year.h - the year's daylight of a room by hand methods (year_method.h). */
#ifndef PP_STUDIES_YEAR_HAND_HAND_YEAR_H
#define PP_STUDIES_YEAR_HAND_HAND_YEAR_H

#include "model/results/sheets/hand_year_sheet.h"
#include "studies/study_room.h"
#include "studies/year/annual.h"
#include "studies/year/hand/year_method.h"

struct pp_hand_year_options {
    struct pp_year_methods_choice methods;
    enum pp_standard_sky overcast; /* sky of the simulated daylight factors */
    const char *df; /* selection of hand methods (methods/selection.h) with one daylight
                     * factor, in place of simulated ones; NULL: none */
    bool explain;   /* true: record the calculation at the first point */
    struct pp_month_day date; /* date of the hour to explain; month 0: explain only the
                               * year's figures */
    double clock_h;
};

/* Evaluates the points of a room. annual: the options of the simulated year: hours,
 * targets, paths, seed. PP_BAD_INPUT if the hour is dark or unknown, or if the selection
 * does not give one daylight factor for each point. The caller clears *sheet, even after
 * a failure. */
enum pp_status pp_hand_year_of_room(struct pp_hand_year_sheet *sheet,
                                    const struct pp_study_room *room,
                                    const struct pp_weather_year *year,
                                    const struct pp_annual_options *annual,
                                    const struct pp_hand_year_options *options,
                                    struct pp_error *err);

#endif
