/* band_features.h - the features that define the regimes of bands: the features of room
 * and point (room_features.h), and these features of the value by a hand method:
 *
 *     figure     value by the hand method, per cent
 *     sky        fraction of a pair's daylight factor that is sky component
 *     outside    fraction that is externally reflected component
 *     inside     fraction that is internally reflected component
 *
 * sky, outside and inside are NAN for columns that are not pairs of methods.
 */
#ifndef PP_STUDIES_BANDS_BAND_FEATURES_H
#define PP_STUDIES_BANDS_BAND_FEATURES_H

#include "model/results/report.h"
#include "studies/research/atlas/room_features.h"

enum {
    PP_BAND_FIGURE = PP_ROOM_FEATURES,
    PP_BAND_SKY,
    PP_BAND_OUTSIDE,
    PP_BAND_INSIDE,
    PP_BAND_FEATURES,
};

/* Names of components in an atlas and in the table of bands: "sc", "erc", "irc",
 * "df". */
extern const char *const pp_band_features_components[PP_COMPONENT_COUNT];

/* Name of a feature: "depth-head", ..., "inside". */
const char *pp_band_features_name(int feature);

/* Finds a feature by name; -1: there is none. */
int pp_band_features_find(const char *name);

/* Names of the direct and the internal method in a pair A+B; empty for other
 * columns. */
struct pp_band_parts {
    char direct[48], internal[48];
};
struct pp_band_parts pp_band_features_parts(enum pp_component component,
                                            const char *column);

/* Sets the features of a value: of a daylight factor and its components (fractions; NAN
 * if unknown). */
void pp_band_features_own(double features[PP_BAND_FEATURES], double figure, double sc,
                          double erc, double irc);

/* A column of a report, and the columns of the components whose sum it is; NULL: there
 * is no such component. */
struct pp_band_columns {
    const struct pp_column *whole, *sky, *external, *internal;
};
struct pp_band_columns pp_band_features_columns(const struct pp_report *report,
                                                const struct pp_column *column);

/* Sets the features from the report's columns for point `index`; index -1: for the
 * average. */
void pp_band_features_of_columns(double features[PP_BAND_FEATURES],
                                 const struct pp_band_columns *columns, int index);

#endif
