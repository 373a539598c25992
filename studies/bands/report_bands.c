/* report_bands.c - checks whether the room of a report is similar to the rooms of the
 * atlas, and looks up the bands of the report's columns. */
#include "studies/bands/report_bands.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "methods/method.h"
#include "methods/variant.h"
#include "studies/bands/band_table.h"
#include "studies/bands/band_words.h"

/* ---- similarity to the rooms of the atlas ---- */

static bool plane_is_convex(const struct pp_region *plane)
{
    if (plane->count != 1)
        return false;
    const struct pp_ring *ring = &plane->rings[0];
    for (int i = 0; i < ring->count; i++) {
        const double *a = ring->xy[i], *b = ring->xy[(i + 1) % ring->count],
                     *c = ring->xy[(i + 2) % ring->count];
        if (pp_region_turn(a, b, c) < -1e-6)
            return false;
    }
    return true;
}

/* True if a wall has a dado whose reflectance differs from that of the wall by more
 * than 0.2. Walls in the atlas have a single reflectance. With a dado 1.1 m high and a
 * difference of 0.2, simulated values were outside the band of exact+split-flux in 5 of
 * 51 rooms; without a dado, in 3 of 90. */
static bool has_contrasting_dado(const struct pp_world *world)
{
    const double contrast = 0.2 + 1e-9; /* with a tolerance, so that 0.8 and 0.6 differ
                                         * by no more than 0.2 */
    for (int i = world->face_count; i < world->surface_count; i++) {
        const struct pp_surface *surface = &world->surfaces[i];
        if (surface->role == PP_COVER && !surface->is_door
            && fabs(surface->front - world->surfaces[surface->owner].front) > contrast)
            return true;
    }
    return false;
}

static bool has_scattering_pane(const struct pp_world *world)
{
    for (int i = 0; i < world->opening_count; i++)
        if (world->openings[i].scatter)
            return true;
    return false;
}

static bool has_screen(const struct pp_world *world)
{
    for (int i = 0; i < world->opening_count; i++)
        if (world->openings[i].device.kind == PP_DEVICE_SCREEN)
            return true;
    return false;
}

/* Reason why the atlas does not contain rooms of this kind; NULL: it does. */
static const char *why_not(const struct pp_world *world,
                           const struct pp_outside_light *light)
{
    return !pp_band_table_under(&light->sky)
               ? "the sky is neither overcast nor one of ISO 15469"
           : world->opening_count == 0       ? "the room has no opening"
           : !world->is_empty                ? "the room has surfaces inside it"
           : has_contrasting_dado(world)     ? "the walls have a dado"
           : !plane_is_convex(&world->plane) ? "the plan is not convex"
           : has_scattering_pane(world)      ? "a pane scatters light by direction"
           : has_screen(world)               ? "a window has a screen"
           : world->ground_is_open ? "the ground outside is treated as unshaded"
                                   : NULL;
}

/* True if a value is in a range, or NAN. There is a tolerance, because the limits of
 * ranges are rounded. */
static bool is_within(double value, double from, double to)
{
    double slack = 1e-3 * fmax(fabs(from), fabs(to));
    return isnan(value) || (value >= from - slack && value <= to + slack);
}

/* First feature, from index `first` to end - 1, whose value is outside its range in the
 * atlas; -1: none. *from, *to: the range. */
static int find_unlike(const struct pp_band_table *table, const double *features,
                       int first, int end, double *from, double *to)
{
    for (int i = first; i < end; i++)
        if (pp_band_table_span(from, to, table, i)
            && !is_within(features[i], *from, *to))
            return i;
    return -1;
}

enum pp_status pp_report_bands_features(double features[PP_BAND_FEATURES],
                                        const char **why, struct pp_report *report,
                                        struct pp_error *err)
{
    const char *kind = why_not(report->world, &report->light);
    double from, to;
    *why = NULL;
    for (int i = 0; i < PP_BAND_FEATURES; i++)
        features[i] = NAN;
    if (kind) {
        *why = pp_report_say(
            report, "no likely ranges, because the atlas has no similar rooms: %s",
            kind);
        return *why ? PP_OK : pp_fail_memory(err);
    }
    enum pp_status status =
        pp_room_features(features, report->world, &report->light, err);
    if (status != PP_OK)
        return status;
    int unlike = find_unlike(pp_band_table_under(&report->light.sky), features, 0,
                             PP_ROOM_OF_POINTS, &from, &to);
    if (unlike < 0)
        return PP_OK;
    *why = pp_report_say(report,
                         "no likely ranges, because the atlas has no similar rooms: %s "
                         "is %.3g; the atlas covers %.3g to %.3g",
                         pp_band_words_feature(unlike), features[unlike], from, to);
    return *why ? PP_OK : pp_fail_memory(err);
}

bool pp_report_bands_point(double features[PP_BAND_FEATURES],
                           const struct pp_report *report, int index)
{
    const struct pp_receiver *receiver = &report->receivers[index];
    double from, to;
    if (receiver->normal.z < 1.0 - 1e-9)
        return false;
    pp_room_features_at(features, report->world, receiver->position);
    return find_unlike(pp_band_table_under(&report->light.sky), features,
                       PP_ROOM_OF_POINTS, PP_ROOM_FEATURES, &from, &to)
           < 0;
}

/* ---- the bands of a column ---- */

bool pp_report_bands_has(const struct pp_report *report, const struct pp_column *column)
{
    const struct pp_method_options *options = report->options;
    bool own_table = options && options->lumen_table
                     && strncmp(column->name, "lumen", strlen("lumen")) == 0;
    return !own_table && !column->of_all_surfaces;
}

enum { OF_POINT = PP_ROOM_FEATURES - PP_ROOM_OF_POINTS };

/* Features of a point. known: false if the atlas has no points in a similar
 * position. */
struct place {
    bool known;
    double features[OF_POINT];
};

struct lookup {
    const struct pp_report *report;
    double *features;     /* features of the room, with space for the features of a
                           * point */
    struct place *places; /* features of each point */
    struct pp_band_index index;
    struct pp_band_regimes regimes;
    struct pp_band_columns columns; /* column that is looked up, and the columns of its
                                     * components */
};

static struct pp_band_ends band_of(const struct pp_band_record *record, double figure)
{
    if (!record || !isfinite(figure))
        return pp_band_none();
    const struct pp_band_quantiles *ratio = &record->entry.regime.ratio;
    return (struct pp_band_ends){
        pp_band_regime_truth(figure, ratio->low, PP_BAND_OFFSET),
        pp_band_regime_truth(figure, ratio->high, PP_BAND_OFFSET)};
}

static struct pp_band_ends band_at(struct lookup *lookup, int index)
{
    const struct place *place = &lookup->places[index];
    if (!place->known)
        return pp_band_none();
    memcpy(lookup->features + PP_ROOM_OF_POINTS, place->features,
           sizeof place->features);
    pp_band_features_of_columns(lookup->features, &lookup->columns, index);
    return band_of(
        pp_band_table_regime(&lookup->regimes, PP_BAND_POINT, lookup->features),
        lookup->columns.whole->points[index].value);
}

static struct pp_band_ends average_band(struct lookup *lookup)
{
    for (int i = PP_ROOM_OF_POINTS; i < PP_ROOM_FEATURES; i++)
        lookup->features[i] = NAN;
    pp_band_features_of_columns(lookup->features, &lookup->columns, -1);
    return band_of(
        pp_band_table_regime(&lookup->regimes, PP_BAND_AVERAGE, lookup->features),
        lookup->columns.whole->average.value);
}

static enum pp_status fill_column(struct lookup *lookup, struct pp_column *column,
                                  struct pp_error *err)
{
    const struct pp_report *report = lookup->report;
    pp_band_table_find(&lookup->regimes, &lookup->index, column->component,
                       column->name);
    lookup->columns = pp_band_features_columns(report, column);
    if (lookup->regimes.count[PP_BAND_AVERAGE] > 0)
        column->average_band = average_band(lookup);
    if (lookup->regimes.count[PP_BAND_POINT] == 0 || !column->points)
        return PP_OK;
    free(column->bands);
    column->bands =
        malloc(((size_t)report->receiver_count + 1) * sizeof *column->bands);
    if (!column->bands)
        return pp_fail_memory(err);
    for (int i = 0; i < report->receiver_count; i++)
        column->bands[i] = band_at(lookup, i);
    return PP_OK;
}

static enum pp_status find_places(struct lookup *lookup, struct pp_error *err)
{
    int count = lookup->report->receiver_count;
    lookup->places = malloc(((size_t)count + 1) * sizeof *lookup->places);
    for (int i = 0; lookup->places && i < count; i++) {
        struct place *place = &lookup->places[i];
        place->known = pp_report_bands_point(lookup->features, lookup->report, i);
        memcpy(place->features, lookup->features + PP_ROOM_OF_POINTS,
               sizeof place->features);
    }
    return lookup->places ? PP_OK : pp_fail_memory(err);
}

enum pp_status pp_report_bands_fill(struct pp_report *report, struct pp_error *err)
{
    double features[PP_BAND_FEATURES];
    struct lookup lookup = {.report = report, .features = features};
    enum pp_status status =
        pp_report_bands_features(features, &report->no_bands, report, err);
    if (status != PP_OK || report->no_bands)
        return status;
    pp_band_table_index(&lookup.index, pp_band_table_under(&report->light.sky));
    status = find_places(&lookup, err);
    for (int i = 0; status == PP_OK && i < report->column_count; i++)
        if (pp_report_bands_has(report, &report->columns[i]))
            status = fill_column(&lookup, &report->columns[i], err);
    free(lookup.places);
    return status;
}
