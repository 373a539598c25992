/* atlas_bands.c - reads the values of each column from the table of an atlas, and fits
 * bands to them. */
#include "studies/bands/atlas_bands.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/array.h"

/* ---- columns of the table ---- */

/* Columns of the table for one component by one hand method: the method's value, the
 * simulated value in the simplified room, and the simulated value in the room itself.
 * -1: there is no such column. */
struct places {
    int hand, own, truth;
    int sc, erc, irc; /* columns of the components of a pair of methods; -1: none */
    int features[PP_ROOM_FEATURES];
};

static int find_atlas_column(const struct pp_atlas_table *table, const char *prefix,
                             const char *component, const char *name)
{
    char whole[128];
    snprintf(whole, sizeof whole, "%s%s.%s", prefix, component, name);
    return pp_atlas_table_find(table, whole);
}

/* Column of a feature; -1: there is none, or it is not used. The directions in which
 * openings face are used only under the skies of ISO 15469. Under an overcast sky the
 * light on an opening depends only on its slope. */
static int feature_column(const struct pp_atlas_table *table, int feature)
{
    bool by_slope =
        !table->iso && (feature == PP_ROOM_FACING || feature == PP_ROOM_OPPOSITE);
    return by_slope ? -1 : pp_atlas_table_find(table, pp_room_feature_names[feature]);
}

static struct places find_places(const struct pp_atlas_table *table,
                                 enum pp_component component, const char *name)
{
    const char *word = pp_band_features_components[component];
    struct pp_band_parts parts = pp_band_features_parts(component, name);
    struct places places = {
        .hand = find_atlas_column(table, "", word, name),
        .own = find_atlas_column(table, "own.", word, name),
        .truth = find_atlas_column(table, "", "true", word),
        .sc = find_atlas_column(table, "", pp_band_features_components[PP_SC],
                                parts.direct),
        .erc = find_atlas_column(table, "", pp_band_features_components[PP_ERC],
                                 parts.direct),
        .irc = find_atlas_column(table, "", pp_band_features_components[PP_IRC],
                                 parts.internal)};
    for (int i = 0; i < PP_ROOM_FEATURES; i++)
        places.features[i] = feature_column(table, i);
    return places;
}

/* Value as a fraction (values in the file are in per cent); NAN if it is missing. */
static double fraction_at(const struct pp_atlas_table *table, int row, int column)
{
    return pp_atlas_table_value(table, row, column) / 100.0;
}

static bool is_average(const struct pp_atlas_table *table, int row)
{
    return pp_atlas_table_value(table, row, table->point) < 0.0;
}

/* Adds the rows that have both a hand value and a simulated value. */
static enum pp_status take_figures(struct pp_band_figures *figures,
                                   const struct pp_atlas_table *table,
                                   const struct places *places, struct pp_error *err)
{
    enum pp_status status = PP_OK;
    bool averages = figures->place == PP_BAND_AVERAGE;
    for (int i = 0; i < table->row_count && status == PP_OK; i++) {
        double features[PP_BAND_FEATURES];
        struct pp_band_row row = {.room =
                                      (int)pp_atlas_table_value(table, i, table->room),
                                  .hand = fraction_at(table, i, places->hand),
                                  .own = fraction_at(table, i, places->own),
                                  .truth = fraction_at(table, i, places->truth),
                                  .features = features};
        if (is_average(table, i) != averages || !isfinite(row.hand)
            || !isfinite(row.truth))
            continue;
        for (int f = 0; f < PP_ROOM_FEATURES; f++)
            features[f] = pp_atlas_table_value(table, i, places->features[f]);
        pp_band_features_own(features, row.hand, fraction_at(table, i, places->sc),
                             fraction_at(table, i, places->erc),
                             fraction_at(table, i, places->irc));
        status = pp_band_figures_add(figures, &row, err);
    }
    return status;
}

/* ---- one column ---- */

static enum pp_status fit_column(struct pp_atlas_column *column,
                                 const struct pp_band_figures *figures,
                                 struct pp_error *err)
{
    column->place = figures->place;
    snprintf(column->component, sizeof column->component, "%s", figures->component);
    snprintf(column->name, sizeof column->name, "%s", figures->column);
    enum pp_status status = pp_band_fit(&column->entries, &column->entry_count, figures,
                                        &pp_band_tree_rules, err);
    if (status == PP_OK)
        status = pp_band_fit_try(&column->trials, &column->trial_count, &column->inside,
                                 figures, &pp_band_tree_rules, 0, err);
    return status;
}

/* Adds the bands of a column if enough rooms have values in it. */
static enum pp_status add_band_column(struct pp_atlas_bands *bands,
                                      const struct pp_atlas_table *table,
                                      enum pp_component component, const char *name,
                                      enum pp_band_place place, struct pp_error *err)
{
    struct pp_band_figures figures;
    struct places places = find_places(table, component, name);
    pp_band_figures_init(&figures, PP_BAND_FEATURES);
    figures.place = place;
    snprintf(figures.component, sizeof figures.component, "%s",
             pp_band_features_components[component]);
    snprintf(figures.column, sizeof figures.column, "%s", name);
    enum pp_status status = take_figures(&figures, table, &places, err);
    if (status == PP_OK)
        status = pp_array_append(&bands->columns, bands->column_count,
                                 sizeof *bands->columns, err);
    if (status == PP_OK) {
        struct pp_atlas_column *column = &bands->columns[bands->column_count++];
        *column = (struct pp_atlas_column){.place = place};
        status = fit_column(column, &figures, err);
        if (status == PP_OK && column->entry_count == 0) {
            free(column->entries);
            free(column->trials);
            bands->column_count--;
        }
    }
    pp_band_figures_clear(&figures);
    return status;
}

/* ---- the table ---- */

/* True if a heading such as "df.exact+bre" belongs to a hand method. *name is set to
 * the part after the dot. */
static bool is_hand(const char *heading, enum pp_component *component,
                    const char **name)
{
    for (int i = 0; i < PP_COMPONENT_COUNT; i++) {
        size_t length = strlen(pp_band_features_components[i]);
        if (strncmp(heading, pp_band_features_components[i], length) == 0
            && heading[length] == '.') {
            *component = (enum pp_component)i;
            *name = heading + length + 1;
            return true;
        }
    }
    return false;
}

static void count_rooms(struct pp_atlas_bands *bands,
                        const struct pp_atlas_table *table)
{
    int last = -1;
    for (int i = 0; i < table->row_count; i++) {
        int here = (int)pp_atlas_table_value(table, i, table->room);
        bands->rooms += here != last;
        last = here;
    }
}

static void find_spans(struct pp_atlas_bands *bands, const struct pp_atlas_table *table)
{
    for (int f = 0; f < PP_ROOM_FEATURES; f++) {
        int column = feature_column(table, f);
        struct pp_atlas_span *span = &bands->spans[f];
        *span = (struct pp_atlas_span){INFINITY, -INFINITY};
        for (int i = 0; i < table->row_count; i++) {
            double value = pp_atlas_table_value(table, i, column);
            span->from = fmin(span->from, value);
            span->to = fmax(span->to, value);
        }
    }
}

enum pp_status pp_atlas_bands_fit(struct pp_atlas_bands *bands,
                                  const struct pp_atlas_table *table,
                                  struct pp_error *err)
{
    *bands = (struct pp_atlas_bands){.iso = table->iso};
    count_rooms(bands, table);
    find_spans(bands, table);
    enum pp_status status = PP_OK;
    for (int i = 0; i < table->column_count && status == PP_OK; i++) {
        enum pp_component component;
        const char *name;
        if (!is_hand(table->names[i], &component, &name))
            continue;
        for (int place = PP_BAND_POINT; place <= PP_BAND_AVERAGE && status == PP_OK;
             place++)
            status = add_band_column(bands, table, component, name,
                                     (enum pp_band_place)place, err);
    }
    return status;
}

bool pp_atlas_bands_is_outside(const struct pp_band_trial *trial)
{
    return trial->rooms > 0
           && (trial->inside < 0.95 - trial->limit
               || trial->between > 0.95 + trial->limit);
}

int pp_atlas_bands_outside(const struct pp_atlas_bands *bands)
{
    int outside = 0;
    for (int i = 0; i < bands->column_count; i++)
        for (int k = 0; k < bands->columns[i].trial_count; k++)
            outside += pp_atlas_bands_is_outside(&bands->columns[i].trials[k]);
    return outside;
}

void pp_atlas_bands_clear(struct pp_atlas_bands *bands)
{
    for (int i = 0; i < bands->column_count; i++) {
        free(bands->columns[i].entries);
        free(bands->columns[i].trials);
    }
    free(bands->columns);
    *bands = (struct pp_atlas_bands){0};
}
