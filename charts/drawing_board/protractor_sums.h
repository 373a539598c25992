/* protractor_sums.h - the readings and sums below a worked protractor, as text. */
#ifndef PP_CHARTS_DRAWING_BOARD_PROTRACTOR_SUMS_H
#define PP_CHARTS_DRAWING_BOARD_PROTRACTOR_SUMS_H

#include <stdbool.h>
#include <stddef.h>

#include "model/results/protractor_sheet.h"

/* Maximum number of readings on one sheet. The others are on further sheets. */
enum { PP_PROTRACTOR_SUMS_MOST = 6 };

struct pp_protractor_sums {
    int first, all; /* index of the first reading on the sheet; number of all
                     * readings */
    bool last;      /* the sheet with the result */
};

/* Writes the readings of the sheet, one per line, numbered if there are more than
 * PP_PROTRACTOR_SUMS_MOST in all. On the last sheet the result follows. */
void pp_protractor_sums_say(char *text, size_t room,
                            const struct pp_protractor_sheet *sheet,
                            const struct pp_protractor_sums *sums);

/* Writes a reading in per cent, without its sign, to two decimals, the precision of a
 * careful reader. */
void pp_protractor_sums_percent(char *text, size_t room, double fraction);

#endif
