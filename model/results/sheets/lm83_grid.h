/* lm83_grid.h - differences of a grid from that of LM-83: points at most 0.6 m apart, 0.76
 * m above the floor, over the whole plane. */
#ifndef PP_MODEL_RESULTS_SHEETS_LM83_GRID_H
#define PP_MODEL_RESULTS_SHEETS_LM83_GRID_H

#include "model/results/sheets/annual_sheet.h"

/* Puts the differences of the sheet's grid into words, with the elements of a room file
 * that avoid them; empty if there are none, or if the points are no grid. */
enum { PP_LM83_GRID_WORDS = 320 };
void pp_lm83_grid_words(char words[PP_LM83_GRID_WORDS],
                        const struct pp_annual_sheet *sheet);

#endif
