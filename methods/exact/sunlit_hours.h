/* sunlit_hours.h - duration of sunlight on a point, in closed form.
 *
 * At a constant declination the sun's direction at the hour angle h is
 *
 *     u(h) = p + q cos h + r sin h                  model/light/sun_path.h
 *
 * so that it crosses the plane of an edge where n.u = n.p + n.q cos h + n.r sin h = 0:
 * each half-space of a hidden cone is an arc of hour angles, and a cone is the
 * intersection of its arcs. The hours of sun are the time between sunrise and sunset
 * when the sun is outside all cones. The result is the possible hours, for a cloudless
 * sky, a flat horizon and a point sun; refraction is neglected.
 */
#ifndef PP_METHODS_EXACT_SUNLIT_HOURS_H
#define PP_METHODS_EXACT_SUNLIT_HOURS_H

#include "methods/exact/hidden_cones.h"

/* Position on the earth (radians); north_rad as in pp_world. Days are local: midnight
 * is earlier than that of Greenwich by the hour angle longitude_rad (east positive).
 * NAN: unknown, treated as Greenwich. */
struct pp_sunlit_place {
    double latitude_rad, north_rad, longitude_rad;
};

/* Times of sun in a day as intervals of the hour angle (rad, -pi to pi), in order and
 * disjoint. */
struct pp_sunlit_day {
    double (*times)[2];
    int count, capacity;
};

/* The sun between two hour angles (rad, -pi to pi), with one declination. */
struct pp_sunlit_sun {
    double declination_rad;
    double from_rad, to_rad;
};

/* Adds the times in the interval of `sun` at which the sun is above the horizon and not
 * hidden. If the day already contains times, call pp_sunlit_hours_unite afterwards. The
 * caller clears the day, even after a failure. */
enum pp_status pp_sunlit_hours_add(struct pp_sunlit_day *day,
                                   const struct pp_hidden_cones *cones,
                                   struct pp_sunlit_place place,
                                   const struct pp_sunlit_sun *sun,
                                   struct pp_error *err);

/* Hours of sun on a day of 2025, with the declination of the middle of each hour, which
 * is within 0.01 degrees of the true one. */
enum pp_status pp_sunlit_hours_of_day(struct pp_sunlit_day *day,
                                      const struct pp_hidden_cones *cones,
                                      struct pp_sunlit_place place, int month, int date,
                                      struct pp_error *err);

/* Finds the times as pp_sunlit_hours_of_day does, but only those with the sun above an
 * altitude (rad, 0 to below pi/2). */
enum pp_status pp_sunlit_hours_above(struct pp_sunlit_day *day,
                                     const struct pp_hidden_cones *cones,
                                     struct pp_sunlit_place place, int month, int date,
                                     double above_rad, struct pp_error *err);

/* Joins times that overlap. */
void pp_sunlit_hours_unite(struct pp_sunlit_day *day);

/* Removes times shorter than this (h), such as those of sun through a narrow gap.
 * Returns how many. */
int pp_sunlit_hours_drop_short(struct pp_sunlit_day *day, double shortest_h);

/* Writes the times in solar time: "08:12-10:40, 13:05-13:09", or "none". */
void pp_sunlit_hours_words(char *text, size_t room, const struct pp_sunlit_day *day);

/* The length of all times, in hours. */
double pp_sunlit_hours_sum(const struct pp_sunlit_day *day);
void pp_sunlit_hours_clear(struct pp_sunlit_day *day);

/* Hours of sun over all days of 2025, and over the days from 21 September to 21 March
 * (both included). Each day has the declination of its local noon. During a day the
 * declination differs by up to 0.2 degrees from the value at noon, in either direction
 * over the year. The effect on the year's hours was 0.04 h in the test. */
struct pp_sunlit_year {
    double all, winter;
};

/* cones NULL: an open horizontal plane. share: probability of sunshine by month
 * (January first) and hour of solar time (the first from midnight), so that the result
 * is in probable hours; NULL: all possible hours. */
enum pp_status pp_sunlit_hours_of_year(struct pp_sunlit_year *year,
                                       const struct pp_hidden_cones *cones,
                                       struct pp_sunlit_place place,
                                       const double (*share)[24], struct pp_error *err);

#endif
