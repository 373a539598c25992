/* annual_words.h - the hours of an annual sheet, and sentences on the assumptions of
 * its figures. */
#ifndef PP_STUDIES_YEAR_ANNUAL_WORDS_H
#define PP_STUDIES_YEAR_ANNUAL_WORDS_H

#include "studies/year/annual.h"
#include "studies/year/blind_groups.h"
#include "studies/year/year_metrics.h"

/* Fills weather, period, blinds, notes, warnings, names of groups and hours of the sheet. */
enum pp_status pp_annual_words_fill(struct pp_annual_sheet *sheet,
                                    const struct pp_world *world,
                                    const struct pp_weather_year *year,
                                    const struct pp_annual_options *options,
                                    const struct pp_year_clock *clock,
                                    const struct pp_blind_groups *groups,
                                    struct pp_error *err);

/* The sentence on the simulation. */
void pp_annual_words_method(struct pp_annual_sheet *sheet,
                            const struct pp_annual_options *options, int samples,
                            int cells);

#endif
