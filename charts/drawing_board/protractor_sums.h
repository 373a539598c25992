/* protractor_sums.h - the sums below a worked protractor, in words. */
#ifndef PP_CHARTS_DRAWING_BOARD_PROTRACTOR_SUMS_H
#define PP_CHARTS_DRAWING_BOARD_PROTRACTOR_SUMS_H

#include <stdbool.h>
#include <stddef.h>

#include "model/results/protractor_sheet.h"

/* Most sums on one sheet; the rest is on further sheets. */
enum { PP_PROTRACTOR_SUMS_MOST = 6 };

struct pp_protractor_sums {
    int first, all; /* range of the readings, numbered from 0 */
    bool last;      /* the sheet with the result */
};

/* The readings of the sheet, a line each, numbered if there are several; then, on the
 * last sheet, the result. */
void pp_protractor_sums_say(char *text, size_t room,
                            const struct pp_protractor_sheet *sheet,
                            const struct pp_protractor_sums *sums);

/* Writes a reading with the precision of careful readers: to 0.01 %. */
void pp_protractor_sums_percent(char *text, size_t room, double fraction);

#endif
