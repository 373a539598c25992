/* advice.h - recommends a method for the average and for each point of a room: the one
 * whose band in the atlas is narrowest.
 *
 * If bands are about equally narrow, the method that comes first is chosen. At points
 * this is the method with the narrowest bands over all points, unless another method's
 * band at the point is narrower by a fifth (in logarithms of high over low).
 */
#ifndef PP_STUDIES_BANDS_ADVICE_H
#define PP_STUDIES_BANDS_ADVICE_H

#include "model/results/report.h"
#include "studies/bands/band_table.h"

enum { PP_ADVICE_OTHERS = 3 };

/* The points, or the average, for which one method in one regime is the best. */
struct pp_advice_item {
    struct pp_band_record best;
    struct pp_band_record others[PP_ADVICE_OTHERS]; /* the next best methods at the
                                                     * first of the points */
    int other_count;
    bool of_average;
    int *points; /* indices of receivers; owned */
    int point_count;
    /* The method's figures times the median ratio of the band, fractions: one for each
     * point, or one for the average; owned. */
    double *corrected;
};

struct pp_advice {
    struct pp_advice_item *items; /* the average's first */
    int count;
    char why_not[256]; /* reason if there is no advice, else empty */
};

/* Recommends methods from the daylight factors of a report, which must have columns of
 * all the methods to choose from. The caller clears *advice in any case. */
enum pp_status pp_advice_of(struct pp_advice *advice, struct pp_report *report,
                            struct pp_error *err);
void pp_advice_clear(struct pp_advice *advice);

#endif
