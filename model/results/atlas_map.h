/* atlas_map.h - errors of a method over the rooms of an atlas, by classes of one or two
 * room features.
 *
 * studies/research/atlas/atlas_mapping.h fills it; charts/atlas_chart.h draws it.
 */
#ifndef PP_MODEL_RESULTS_ATLAS_MAP_H
#define PP_MODEL_RESULTS_ATLAS_MAP_H

#include <stdbool.h>

enum {
    PP_ATLAS_CLASSES = 10, /* largest number of classes of a feature */
    PP_ATLAS_CELLS = PP_ATLAS_CLASSES * PP_ATLAS_CLASSES,
    PP_ATLAS_ENOUGH = 10, /* rooms needed for quantiles */
};

/* Classes of a feature, between edges; the last edge may be INFINITY. */
struct pp_atlas_scale {
    const char *words; /* name of the feature; not owned */
    int count;         /* number of classes; 1 without words: no scale */
    double edges[PP_ATLAS_CLASSES + 1]; /* rising */
};

/* Ratio of the method's result to the simulated value: median, 5th and 95th percentile.
 * NAN for fewer than PP_ATLAS_ENOUGH rooms. */
struct pp_atlas_quantiles {
    int rooms;
    double low, median, high;
};

struct pp_atlas_map {
    const char *column; /* method's column, "df.exact+bre"; not owned */
    bool averages;      /* averages over working planes, not values at points */
    int rooms;          /* total number of rooms considered */
    int blind;          /* values left out because the simulated value is too
                         * uncertain */
    struct pp_atlas_scale across, up; /* up.count 1: a map by one feature */

    /* Quantiles of class u of `up` and a of `across`, at index u PP_ATLAS_CLASSES + a.
     * real: in the room as it is; own: in the world that the method assumes, if that
     * was simulated. */
    struct pp_atlas_quantiles real[PP_ATLAS_CELLS], own[PP_ATLAS_CELLS];
};

#endif
