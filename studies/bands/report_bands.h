/* report_bands.h - adds the band from the atlas to each value by a hand method in a
 * report.
 *
 * A room has bands if it is similar to the rooms of the atlas: unfurnished, with a
 * convex plan, under an overcast sky or a sky of ISO 15469 (band_table.h), without a
 * contrasting dado, screens or panes that scatter light by direction, on ground that
 * objects can shade, and with features within the ranges in the atlas.
 */
#ifndef PP_STUDIES_BANDS_REPORT_BANDS_H
#define PP_STUDIES_BANDS_REPORT_BANDS_H

#include "model/results/report.h"
#include "studies/bands/band_features.h"

/* Adds the bands to the report's columns, or sets report->no_bands to the reason why
 * there are none. A point that does not face up, or whose features are outside the
 * ranges in the atlas, has no band. */
enum pp_status pp_report_bands_fill(struct pp_report *report, struct pp_error *err);

/* Sets the features of the report's room. *why: reason if the atlas has no similar
 * rooms, owned by the report; NULL: it has. */
enum pp_status pp_report_bands_features(double features[PP_BAND_FEATURES],
                                        const char **why, struct pp_report *report,
                                        struct pp_error *err);

/* Sets the features of a point in a room that is similar to those of the atlas. Returns
 * false if the atlas has no point in such a position. */
bool pp_report_bands_point(double features[PP_BAND_FEATURES],
                           const struct pp_report *report, int index);

/* False if a column cannot have bands, because it uses a user's own table or its
 * average is over all surfaces. Any other column has bands if its name is in the table
 * of bands. */
bool pp_report_bands_has(const struct pp_report *report,
                         const struct pp_column *column);

#endif
