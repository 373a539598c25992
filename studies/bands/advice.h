/* advice.h - recommends a method for the average and for each point of a room. The
 * recommended method is the one whose band in the atlas is narrowest.
 *
 * If bands are about equally narrow, the method that is first in the report is chosen.
 * At points, the method with the narrowest bands over all points is preferred. At a
 * point where another method's band is narrower by a fifth, that method is chosen
 * instead. The width of a band is the logarithm of high / low.
 */
#ifndef PP_STUDIES_BANDS_ADVICE_H
#define PP_STUDIES_BANDS_ADVICE_H

#include "model/results/report.h"
#include "studies/bands/band_table.h"

enum { PP_ADVICE_OTHERS = 3 };

/* The points for which one method, in one regime, is the best; or the average. */
struct pp_advice_item {
    struct pp_band_record best;
    struct pp_band_record others[PP_ADVICE_OTHERS]; /* next best methods at the first of
                                                     * the points */
    int other_count;
    bool of_average;
    int *points; /* indices of receivers; owned */
    int point_count;
    /* Figures of the method corrected by the median ratio of the band, as fractions.
     * One for each point, or one for the average; owned. */
    double *corrected;
};

struct pp_advice {
    struct pp_advice_item *items; /* the item for the average is first */
    int count;
    char why_not[256]; /* reason why there is no advice; empty if there is advice */
};

/* Recommends methods from the daylight factors of a report. The report must have a
 * column for each candidate method. The caller clears *advice, also after a failure. */
enum pp_status pp_advice_of(struct pp_advice *advice, struct pp_report *report,
                            struct pp_error *err);
void pp_advice_clear(struct pp_advice *advice);

#endif
