/* report_bands.h - adds the band of the atlas to each hand figure of a report.
 *
 * Bands hold for rooms like those of the atlas: under an overcast sky or one of ISO
 * 15469 (band_table.h), with features within the ranges of its rooms, empty, and with a
 * convex plan.
 */
#ifndef PP_STUDIES_BANDS_REPORT_BANDS_H
#define PP_STUDIES_BANDS_REPORT_BANDS_H

#include "model/results/report.h"
#include "studies/bands/band_features.h"

/* Fills the bands of the report's columns, or gives the reason in report->no_bands.
 * Points that do not face up, or are in places unlike those of the atlas, have none. */
enum pp_status pp_report_bands_fill(struct pp_report *report, struct pp_error *err);

/* The features of the report's room. *why: why the atlas does not cover it, kept with
 * the report's sentences; NULL: it does. */
enum pp_status pp_report_bands_features(double features[PP_BAND_FEATURES],
                                        const char **why, struct pp_report *report,
                                        struct pp_error *err);

/* Adds the features of a point of a room that the atlas covers; false: no point of the
 * atlas is in such a place. */
bool pp_report_bands_point(double features[PP_BAND_FEATURES],
                           const struct pp_report *report, int index);

/* True if a column can have bands: not the simulated ones, nor those by a user's own
 * tables or formulae. */
bool pp_report_bands_has(const struct pp_report *report,
                         const struct pp_column *column);

#endif
