/* report_bands.h - adds the band from the atlas to each hand figure of a report.
 *
 * A room has bands if it is like the rooms of the atlas: empty, with a convex plan,
 * under an overcast sky or one of ISO 15469 (band_table.h), and with features within
 * the ranges of the atlas.
 */
#ifndef PP_STUDIES_BANDS_REPORT_BANDS_H
#define PP_STUDIES_BANDS_REPORT_BANDS_H

#include "model/results/report.h"
#include "studies/bands/band_features.h"

/* Fills in the bands of the report's columns, or the reason in report->no_bands. Points
 * that do not face up, or whose features are outside the ranges of the atlas, have
 * none. */
enum pp_status pp_report_bands_fill(struct pp_report *report, struct pp_error *err);

/* Features of the report's room. *why: the reason if the atlas does not cover the room,
 * stored with the report's sentences; NULL: it covers the room. */
enum pp_status pp_report_bands_features(double features[PP_BAND_FEATURES],
                                        const char **why, struct pp_report *report,
                                        struct pp_error *err);

/* Adds the features of a point of a room that the atlas covers; false: no point of the
 * atlas is in such a place. */
bool pp_report_bands_point(double features[PP_BAND_FEATURES],
                           const struct pp_report *report, int index);

/* False if a column cannot have bands: it is by a user's own table, or its average is
 * over all surfaces. Other columns have bands if the table of bands has their name. */
bool pp_report_bands_has(const struct pp_report *report,
                         const struct pp_column *column);

#endif
