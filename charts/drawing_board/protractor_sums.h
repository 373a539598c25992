/* protractor_sums.h - the sums below a worked protractor, in words. */
#ifndef PP_CHARTS_DRAWING_BOARD_PROTRACTOR_SUMS_H
#define PP_CHARTS_DRAWING_BOARD_PROTRACTOR_SUMS_H

#include <stdbool.h>
#include <stddef.h>

#include "model/results/protractor_sheet.h"

/* Most sums on one sheet; further sums go on further sheets. */
enum { PP_PROTRACTOR_SUMS_MOST = 6 };

struct pp_protractor_sums {
    int first, all; /* of the readings, which are numbered from 0 */
    bool last;      /* the sheet with the result */
};

/* The readings that the sheet has, a line each, numbered where there are more; then, on the
 * last sheet, the result. */
void pp_protractor_sums_say(char *text, size_t room,
                            const struct pp_protractor_sheet *sheet,
                            const struct pp_protractor_sums *sums);

/* A reading as careful readers take it: to a hundredth of a per cent. */
void pp_protractor_sums_percent(char *text, size_t room, double fraction);

#endif
