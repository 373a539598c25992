/* band_features.c - names of features, and the fractions of a daylight factor due to
 * its components. */
#include "studies/bands/band_features.h"

#include <stdio.h>
#include <string.h>

#include "model/base/text.h"

const char *const pp_band_features_components[PP_COMPONENT_COUNT] = {
    [PP_SC] = "sc", [PP_ERC] = "erc", [PP_IRC] = "irc", [PP_DF] = "df"};

static const char *const own_names[] = {"figure", "sky", "outside", "inside"};

const char *pp_band_features_name(int feature)
{
    return feature < PP_ROOM_FEATURES ? pp_room_feature_names[feature]
                                      : own_names[feature - PP_ROOM_FEATURES];
}

int pp_band_features_find(const char *name)
{
    for (int i = 0; i < PP_BAND_FEATURES; i++)
        if (pp_text_is_same(pp_band_features_name(i), name))
            return i;
    return -1;
}

struct pp_band_parts pp_band_features_parts(enum pp_component component,
                                            const char *column)
{
    struct pp_band_parts parts = {"", ""};
    const char *plus = strchr(column, '+');
    if (component != PP_DF || !plus)
        return parts;
    snprintf(parts.direct, sizeof parts.direct, "%.*s", (int)(plus - column), column);
    snprintf(parts.internal, sizeof parts.internal, "%s", plus + 1);
    return parts;
}

void pp_band_features_own(double features[PP_BAND_FEATURES], double figure, double sc,
                          double erc, double irc)
{
    features[PP_BAND_FIGURE] = 100.0 * figure;
    features[PP_BAND_SKY] = figure > 0.0 ? sc / figure : NAN;
    features[PP_BAND_OUTSIDE] = figure > 0.0 ? erc / figure : NAN;
    features[PP_BAND_INSIDE] = figure > 0.0 ? irc / figure : NAN;
}

struct pp_band_columns pp_band_features_columns(const struct pp_report *report,
                                                const struct pp_column *column)
{
    struct pp_band_columns columns = {.whole = column};
    struct pp_band_parts parts =
        pp_band_features_parts(column->component, column->name);
    if (parts.direct[0]) {
        columns.sky = pp_report_find(report, PP_SC, parts.direct);
        columns.external = pp_report_find(report, PP_ERC, parts.direct);
        columns.internal = pp_report_find(report, PP_IRC, parts.internal);
    }
    return columns;
}

static double value_at(const struct pp_column *column, int index)
{
    return !column          ? NAN
           : index < 0      ? column->average.value
           : column->points ? column->points[index].value
                            : NAN;
}

void pp_band_features_of_columns(double features[PP_BAND_FEATURES],
                                 const struct pp_band_columns *columns, int index)
{
    pp_band_features_own(
        features, value_at(columns->whole, index), value_at(columns->sky, index),
        value_at(columns->external, index), value_at(columns->internal, index));
}
