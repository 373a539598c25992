/* atlas_map.h - errors of a method over the rooms of an atlas, by one or two of the
 * rooms' features, as drawn.
 *
 * studies/research/atlas/atlas_mapping.h fills it; charts/atlas_chart.h draws it. */
#ifndef PP_MODEL_RESULTS_ATLAS_MAP_H
#define PP_MODEL_RESULTS_ATLAS_MAP_H

#include <stdbool.h>

enum {
    PP_ATLAS_CLASSES = 10, /* of a number, at most */
    PP_ATLAS_CELLS = PP_ATLAS_CLASSES * PP_ATLAS_CLASSES,
    PP_ATLAS_ENOUGH = 10, /* rooms for quantiles */
};

/* Classes of a number, between edges; the last edge may be INFINITY. */
struct pp_atlas_scale {
    const char *words; /* name of the number; not owned */
    int count;         /* of classes; 1 and no words: there is no such scale */
    double edges[PP_ATLAS_CLASSES + 1]; /* rising */
};

/* Ratio of the method's result to the simulated value: median, and 5th and 95th
 * percentiles. NAN of fewer than PP_ATLAS_ENOUGH rooms. */
struct pp_atlas_quantiles {
    int rooms;
    double low, median, high;
};

struct pp_atlas_map {
    const char *column; /* of the method: "df.exact+bre"; not owned */
    bool averages;      /* over working planes, not at points */
    int rooms;          /* that were asked, in all */
    int blind;          /* values left out because their true value is too uncertain */
    struct pp_atlas_scale across, up; /* up.count 1: a map by one number */

    /* Quantiles of class u up and a across at u PP_ATLAS_CLASSES + a: in the room as it
     * is, and in the world that the method calculates in, where that was traced. */
    struct pp_atlas_quantiles real[PP_ATLAS_CELLS], own[PP_ATLAS_CELLS];
};

#endif
