/* hand_range.c - see hand_range.h. */
#include "studies/year/hand/hand_range.h"

#include <math.h>
#include <string.h>

#include "model/geometry/min_max.h"

/* All in per cent; group: 0 equator, 1 east and west, 2 pole. */
static const struct year_range {
    const char *method;
    double group, least; /* from this hand figure up to that of the next row */
    double low, high;    /* to be added to the hand figure */
} ranges[] = {
#include "tables/year_ranges.inc"
};
enum { RANGES = sizeof ranges / sizeof *ranges };

struct pp_hand_interval pp_hand_range_of(const char *method, int facade,
                                         double autonomy)
{
    const struct year_range *found = NULL;
    double group = facade == 3 ? 1.0 : facade, hand = 100.0 * autonomy;
    for (int i = 0; i < RANGES; i++)
        if (ranges[i].group == group && strcmp(ranges[i].method, method) == 0
            && hand >= ranges[i].least)
            found = &ranges[i];
    if (!found)
        return (struct pp_hand_interval){NAN, NAN};
    return (struct pp_hand_interval){pp_clamp(hand + found->low, 0.0, 100.0) / 100.0,
                                     pp_clamp(hand + found->high, 0.0, 100.0) / 100.0};
}
