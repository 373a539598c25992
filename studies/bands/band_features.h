/* band_features.h - the features that define the regimes of bands: those of room and
 * point (room_features.h), and some of the hand figure itself.
 *
 *     figure     the hand figure, per cent
 *     sky        share of the sky component in the daylight factor of a pair
 *     outside    share of the externally reflected component in it
 *     inside     share of the internally reflected component in it
 *
 * The shares are NAN for columns that are not pairs of methods.
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

/* Names of the components in an atlas and in the table of bands: "sc", "erc", "irc",
 * "df". */
extern const char *const pp_band_features_components[PP_COMPONENT_COUNT];

/* "depth-head", ..., "inside". */
const char *pp_band_features_name(int feature);

/* The feature of that name, or -1. */
int pp_band_features_find(const char *name);

/* Names of the direct and the internal method in a column of a pair A+B; empty for
 * other columns. */
struct pp_band_parts {
    char direct[48], internal[48];
};
struct pp_band_parts pp_band_features_parts(enum pp_component component,
                                            const char *column);

/* Fills in the features of a figure: a daylight factor and its components (fractions;
 * NAN if unknown). */
void pp_band_features_own(double features[PP_BAND_FEATURES], double figure, double sc,
                          double erc, double irc);

/* A column of a report, and the columns of the components of which it is the sum; NULL
 * if there is none. */
struct pp_band_columns {
    const struct pp_column *whole, *sky, *external, *internal;
};
struct pp_band_columns pp_band_features_columns(const struct pp_report *report,
                                                const struct pp_column *column);

/* Fills in the features from a report's columns, at point `index`; -1: for the
 * average. */
void pp_band_features_of_columns(double features[PP_BAND_FEATURES],
                                 const struct pp_band_columns *columns, int index);

#endif
