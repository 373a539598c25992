/* hand_figures.h - annual figures of a point by a hand method, from its hours, and the
 * same calculation with its steps.
 */
#ifndef PP_STUDIES_YEAR_HAND_HAND_FIGURES_H
#define PP_STUDIES_YEAR_HAND_HAND_FIGURES_H

#include "model/results/sheets/hand_year_sheet.h"
#include "studies/year/hand/year_method.h"

/* Figures of a method that does not apply: NAN. */
struct pp_hand_figures pp_hand_figures_none(void);

/* Evaluates the method in all occupied hours. Hours of darkness have 0 lx. The
 * figures are NAN if an illuminance is not known. steps (may be
 * NULL) receives the calculation of the figures from the numbers of hours. */
void pp_hand_figures_of(struct pp_hand_figures *figures, const struct pp_hand_case *of,
                        const struct pp_year_method *method, const void *tools,
                        const struct pp_formulary *formulary, int point,
                        const double *illuminances_lx, int illuminance_count,
                        struct pp_steps *steps);

/* Records the calculation of one hour. */
void pp_hand_figures_hour(const struct pp_hand_case *of,
                          const struct pp_year_method *method, const void *tools,
                          const struct pp_formulary *formulary, int point,
                          const struct pp_hand_hour *hour, struct pp_steps *steps);

#endif
