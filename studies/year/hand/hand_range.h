/* hand_range.h - likely ranges of the simulated daylight autonomy around the figure of a
 * hand method.
 *
 * tables/year_ranges.csv has the 2nd and 98th percentiles of the difference between
 * simulated and hand figures in 12 rooms in three climates, by method, orientation and
 * size of the hand figure (bench/year_methods.sh). The ranges hold for simulated
 * daylight factors of Moon and Spencer's sky, 8 to 18 h on all days, and targets of 200
 * to 750 lx.
 */
#ifndef PP_STUDIES_YEAR_HAND_HAND_RANGE_H
#define PP_STUDIES_YEAR_HAND_HAND_RANGE_H

/* Fraction of simulated figures within their range, in rooms held out of the fit. */
#define PP_HAND_RANGE_COVERAGE                                                         \
    "95 of 100 simulated figures were within them, in rooms held out, in the same "    \
    "three climates (34 to 42 degrees north)"

struct pp_hand_interval {
    double low, high; /* fractions of the hours; NAN: not known */
};

/* facade: 0 equator, 1 east, 2 pole, 3 west (hand_case.h); -1 has no range. */
struct pp_hand_interval pp_hand_range_of(const char *method, int facade,
                                         double autonomy);

#endif
