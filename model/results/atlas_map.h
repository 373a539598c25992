/* atlas_map.h - errors of a method over the rooms of an atlas (many simulated rooms),
 * by classes of one or two room features.
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
    const char *words; /* name of the feature; NULL: no scale; not owned */
    int count;         /* number of classes; 1 if there is no scale */
    double edges[PP_ATLAS_CLASSES + 1]; /* ascending */
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
    struct pp_atlas_scale across, up; /* features; up.count is 1 if there is only one */

    /* Quantiles for class u of `up` and class a of `across`, at index u *
     * PP_ATLAS_CLASSES + a. real: compared with the simulation of the room as it is;
     * own: compared with a simulation of the world that the method assumes, if there is
     * one. */
    struct pp_atlas_quantiles real[PP_ATLAS_CELLS], own[PP_ATLAS_CELLS];
};

#endif
