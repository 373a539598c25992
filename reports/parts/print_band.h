/* print_band.h - bands in text, and in JSON. */
#ifndef PP_REPORTS_PARTS_PRINT_BAND_H
#define PP_REPORTS_PARTS_PRINT_BAND_H

#include <stdbool.h>
#include <stddef.h>

#include "model/results/report.h"
#include "reports/parts/json.h"

/* Writes "0.82-1.31", in per cent without a unit; nothing if the band is unknown. */
void pp_print_band(char *text, size_t size, struct pp_band_ends band);

/* The band of a point (0 to `count` - 1) of a column, or of the average (`count`). */
struct pp_band_ends pp_print_band_at(const struct pp_column *column, int index,
                                     int count);

/* Adds "band": [0.82, 1.31], if known. False: out of memory. */
bool pp_print_band_json(struct json_object *object, struct pp_band_ends band);

/* Prints a note on the bands of a report, with those of the averages, or the reason why
 * it has none; nothing if bands were not requested. */
void pp_print_band_note(const struct pp_report *report, int width, FILE *out);

#endif
