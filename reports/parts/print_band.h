/* print_band.h - prints bands as text and as JSON. */
#ifndef PP_REPORTS_PARTS_PRINT_BAND_H
#define PP_REPORTS_PARTS_PRINT_BAND_H

#include <stdbool.h>
#include <stddef.h>

#include "model/results/report.h"
#include "reports/parts/json.h"

/* Writes a band in per cent without unit, "0.82-1.31"; writes "" if the band is
 * unknown. */
void pp_print_band(char *text, size_t size, struct pp_band_ends band);

/* Band of a column at a point (index 0 to count - 1) or for the average (index
 * `count`). */
struct pp_band_ends pp_print_band_at(const struct pp_column *column, int index,
                                     int count);

/* Adds "band": [0.82, 1.31], if known. Returns false if memory is exhausted. */
bool pp_print_band_json(struct json_object *object, struct pp_band_ends band);

/* Prints a note on the bands of a report, including those of averages, or the reason
 * why there are none. Prints nothing if bands were not requested. */
void pp_print_band_note(const struct pp_report *report, int width, FILE *out);

#endif
