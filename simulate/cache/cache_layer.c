/* cache_layer.c - insertion of records among their neighbours, and interpolation. */
#include "simulate/cache/cache_layer.h"

#include <math.h>
#include <stdlib.h>

#include "model/base/array.h"

/* Least weight of a record in a mean; excludes records at the edge of their ellipse. */
static const double LEAST_WEIGHT = 1e-6;

/* An entry that is being inserted. */
struct newcomer {
    struct pp_cache_layer *layer;
    struct pp_cache_entry *entry;
};

/* Limits each radius to the same radius of the record `by` plus the distance between
 * the two records. */
static void limit(struct pp_cache_entry *entry, const struct pp_cache_entry *by,
                  double distance_m)
{
    for (int i = 0; i < 2; i++)
        entry->is.radii_m[i] =
            fmin(entry->is.radii_m[i], by->is.radii_m[i] + distance_m);
}

static void limit_neighbour(void *context, int record)
{
    struct newcomer *newcomer = context;
    struct pp_cache_entry *other = &newcomer->layer->entries[record];
    if (other->is.space != newcomer->entry->is.space
        || pp_vec_dot(other->is.normal, newcomer->entry->is.normal) < 0.0)
        return;
    double distance =
        pp_vec_length(pp_vec_sub(other->is.point, newcomer->entry->is.point));
    limit(newcomer->entry, other, distance);
    limit(other, newcomer->entry, distance);
}

static double reach_of(const struct pp_cache_entry *entry)
{
    return fmax(entry->is.radii_m[0], entry->is.radii_m[1]);
}

enum pp_status pp_cache_layer_put(struct pp_cache_layer *layer,
                                  const struct pp_cache_entry *entry,
                                  struct pp_error *err)
{
    enum pp_status status =
        pp_array_reserve(&layer->entries, &layer->entry_capacity,
                         layer->entry_count + 1, sizeof *layer->entries, err);
    if (status != PP_OK)
        return status;
    layer->entries[layer->entry_count] = *entry;
    pp_cache_entry_unsmooth(&layer->entries[layer->entry_count]);
    status = pp_cache_octree_add(&layer->tree, layer->entry_count, entry->is.point,
                                 reach_of(entry), err);
    layer->entry_count += status == PP_OK;
    return status;
}

enum pp_status pp_cache_layer_add(struct pp_cache_layer *layer,
                                  const struct pp_cache_entry *entry,
                                  struct pp_error *err)
{
    struct pp_cache_entry fitted = *entry;
    struct newcomer newcomer = {layer, &fitted};
    pp_cache_octree_visit_near(&layer->tree, fitted.is.point, reach_of(&fitted),
                               limit_neighbour, &newcomer);
    return pp_cache_layer_put(layer, &fitted, err);
}

enum pp_status pp_cache_layer_rebuild_tree(struct pp_cache_layer *layer,
                                           struct pp_error *err)
{
    enum pp_status status = pp_cache_octree_reset(&layer->tree, err);
    for (int i = 0; status == PP_OK && i < layer->entry_count; i++)
        status = pp_cache_octree_add(&layer->tree, i, layer->entries[i].is.point,
                                     reach_of(&layer->entries[i]), err);
    return status;
}

bool pp_cache_layer_covers(const struct pp_cache_layer *layer,
                           const struct pp_cache_place *place)
{
    struct pp_cache_octree_iterator iterator =
        pp_cache_octree_iterator(&layer->tree, place->point);
    int record;
    while (pp_cache_octree_next(&iterator, &record))
        if (1.0 - pp_cache_entry_distance(&layer->entries[record], place, 1.0)
            > LEAST_WEIGHT)
            return true;
    return false;
}

double pp_cache_layer_guess(const struct pp_cache_layer *layer,
                            const struct pp_cache_place *place)
{
    double nearest = INFINITY, guess = 0.0;
    struct pp_cache_octree_iterator iterator =
        pp_cache_octree_iterator(&layer->tree, place->point);
    int record;
    while (pp_cache_octree_next(&iterator, &record)) {
        const struct pp_cache_entry *entry = &layer->entries[record];
        double distance = pp_cache_entry_distance(entry, place, INFINITY);
        if (distance < nearest && distance < 1e9) {
            nearest = distance;
            guess = entry->is.radii_m[0];
        }
    }
    return guess;
}

bool pp_cache_layer_read(const struct pp_cache_layer *layer,
                         const struct pp_cache_place *place, struct pp_rgb *value)
{
    struct pp_rgb sum = pp_rgb_grey(0.0);
    double weights = 0.0;
    struct pp_cache_octree_iterator iterator =
        pp_cache_octree_iterator(&layer->tree, place->point);
    int record;
    while (pp_cache_octree_next(&iterator, &record)) {
        const struct pp_cache_entry *entry = &layer->entries[record];
        double weight = 1.0 - pp_cache_entry_distance(entry, place, 1.0);
        if (!(weight > LEAST_WEIGHT))
            continue;
        sum = pp_rgb_along(sum, weight, pp_cache_entry_read(entry, place));
        weights += weight;
    }
    if (!(weights > 0.0))
        return false;
    *value = pp_rgb_scale(sum, 1.0 / weights);
    return true;
}
