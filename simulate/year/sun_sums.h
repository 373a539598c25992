/* sun_sums.h - the sunlight that sunlit cells reflect to several receivers at once, by
 * hour and group of openings. */
#ifndef PP_SIMULATE_YEAR_SUN_SUMS_H
#define PP_SIMULATE_YEAR_SUN_SUMS_H

#include <stdint.h>

enum {
    PP_YEAR_GROUPS_MOST = 16,
    PP_YEAR_BLOCK = 16 /* receivers whose reflected sunlight is summed together */
};

/* Sun on one cell in one hour. */
struct pp_sun_entry {
    uint16_t cell;
    int16_t group; /* group of the opening of the sunlight; -1 for an outdoor cell */
    float lx;
};

/* The suns of one batch: entries of hour t are first[t] to first[t + 1] - 1. */
struct pp_sun_list {
    int *first;
    struct pp_sun_entry *entries;
    int capacity;
};

/* Weights of a block of receivers for one cell, or their sums. */
struct pp_sun_weights {
    float of[PP_YEAR_BLOCK];
};

/* The sunlit cells of a batch, and the weights of a block of receivers for each. */
struct pp_sun_sums {
    const struct pp_sun_list *list;
    const struct pp_sun_weights *inside;  /* [cell] */
    const struct pp_sun_weights *outdoor; /* [group][outdoor cell] */
    int hours, groups;
    int receivers;
};

/* Sums of each hour: out[hour][group]. */
void pp_sun_sums_find(struct pp_sun_weights *out, const struct pp_sun_sums *of);

#endif
