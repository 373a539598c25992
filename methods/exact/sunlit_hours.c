/* sunlit_hours.c - see sunlit_hours.h. */
#include "methods/exact/sunlit_hours.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "model/base/array.h"
#include "model/base/text.h"
#include "model/light/sun.h"
#include "model/light/sun_path.h"

/* The sun's path on one day, in the world's axes: p + q cos h + r sin h, where h is the
 * hour angle. */
struct path {
    struct pp_vec3 p, q, r;
    /* The path is a circle at a constant angle from the pole of the sky (unit
     * vector). */
    struct pp_vec3 pole;
    double cos_apart, sin_apart;
};

/* Converts a vector (east, north, up) to the world's axes. */
static struct pp_vec3 in_world(struct pp_vec3 v, double north)
{
    return pp_vec(v.x * cos(north) - v.y * sin(north),
                  v.x * sin(north) + v.y * cos(north), v.z);
}

static struct path path_of(struct pp_sunlit_place place, double declination)
{
    double phi = place.latitude_rad;
    struct pp_vec3 noon = pp_sun_path_direction(phi, declination, 0.0);
    struct pp_vec3 night = pp_sun_path_direction(phi, declination, PP_PI);
    struct pp_vec3 west = pp_sun_path_direction(phi, declination, PP_PI / 2.0);
    struct pp_vec3 p = pp_vec_scale(pp_vec_add(noon, night), 0.5);
    return (struct path){
        .p = in_world(p, place.north_rad),
        .q = in_world(pp_vec_sub(noon, p), place.north_rad),
        .r = in_world(pp_vec_sub(west, p), place.north_rad),
        .pole = in_world(pp_vec(0.0, cos(phi), sin(phi)), place.north_rad),
        .cos_apart = sin(declination),
        .sin_apart = cos(declination),
    };
}

/* True if the sun's circle does not touch a cone's cap: the cap's axis is farther from
 * the circle than the cap's radius. The circle is at least 60 degrees from either pole
 * and a cap is no wider, so that neither pole lies between them. */
static bool is_clear_of(const struct path *path, const struct pp_hidden_cone *cone)
{
    double along = pp_vec_dot(cone->axis, path->pole);
    double even = path->cos_apart * cone->cos_radius;
    double odd = path->sin_apart * cone->sin_radius;
    return cone->cos_radius > 0.0 && (along < even - odd || along > even + odd);
}

/* The hour angles at which c + a cos h + b sin h > 0, as an arc about `middle`. half: 0
 * for none, pi for all. */
struct arc {
    double middle, half;
};

static struct arc arc_of(double a, double b, double c)
{
    double radius = hypot(a, b);
    return (struct arc){atan2(b, a), c >= radius    ? PP_PI
                                     : c <= -radius ? 0.0
                                                    : acos(-c / radius)};
}

static enum pp_status append_sunlit_period(struct pp_sunlit_day *day, double from,
                                           double to, struct pp_error *err)
{
    enum pp_status status = pp_array_reserve(&day->times, &day->capacity,
                                             day->count + 1, sizeof *day->times, err);
    if (status != PP_OK)
        return status;
    day->times[day->count][0] = from;
    day->times[day->count++][1] = to;
    return PP_OK;
}

/* Intersects the times from index `first` on with the arc, which repeats with a period
 * of one turn. */
static enum pp_status keep_sunlit_arc(struct pp_sunlit_day *day, int first,
                                      struct arc arc, struct pp_error *err)
{
    enum pp_status status = PP_OK;
    if (arc.half >= PP_PI)
        return PP_OK;
    int count = day->count, kept = first;
    for (int i = first; i < count && status == PP_OK; i++) {
        double from = day->times[i][0], to = day->times[i][1];
        for (int turn = -1; turn <= 1 && status == PP_OK; turn++) {
            double middle = arc.middle + 2.0 * PP_PI * turn;
            double low = fmax(from, middle - arc.half);
            double high = fmin(to, middle + arc.half);
            if (low < high)
                status = append_sunlit_period(day, low, high, err);
        }
    }
    for (int i = count; i < day->count; i++, kept++) {
        day->times[kept][0] = day->times[i][0];
        day->times[kept][1] = day->times[i][1];
    }
    day->count = kept;
    return status;
}

/* Adds the times at which a cone hides the sun. */
static enum pp_status add_cone(struct pp_sunlit_day *hidden, const struct path *path,
                               const struct pp_vec3 *half_spaces, int count,
                               struct pp_error *err)
{
    int first = hidden->count;
    enum pp_status status = append_sunlit_period(hidden, -PP_PI, PP_PI, err);
    for (int i = 0; i < count && status == PP_OK && hidden->count > first; i++) {
        struct pp_vec3 n = half_spaces[i];
        status = keep_sunlit_arc(hidden, first,
                                 arc_of(pp_vec_dot(n, path->q), pp_vec_dot(n, path->r),
                                        pp_vec_dot(n, path->p)),
                                 err);
    }
    return status;
}

static int by_start(const void *a, const void *b)
{
    const double *p = a, *q = b;
    return (p[0] > q[0]) - (p[0] < q[0]);
}

void pp_sunlit_hours_unite(struct pp_sunlit_day *day)
{
    int count = 0;
    if (day->count > 0)
        qsort(day->times, (size_t)day->count, sizeof *day->times, by_start);
    for (int i = 0; i < day->count; i++) {
        if (count > 0 && day->times[i][0] <= day->times[count - 1][1]) {
            day->times[count - 1][1] = fmax(day->times[count - 1][1], day->times[i][1]);
            continue;
        }
        day->times[count][0] = day->times[i][0];
        day->times[count++][1] = day->times[i][1];
    }
    day->count = count;
}

/* Adds the parts of the time from `from` to `end` outside the hidden times, which are
 * disjoint. */
static enum pp_status add_rest(struct pp_sunlit_day *day,
                               const struct pp_sunlit_day *hidden, double from,
                               double end, struct pp_error *err)
{
    enum pp_status status = PP_OK;
    for (int i = 0; i < hidden->count && status == PP_OK; i++) {
        double to = fmin(hidden->times[i][0], end);
        if (to > from)
            status = append_sunlit_period(day, from, to, err);
        from = fmax(from, hidden->times[i][1]);
    }
    return status == PP_OK && from < end ? append_sunlit_period(day, from, end, err)
                                         : status;
}

/* The times at which the sun is above an altitude and not hidden. */
static enum pp_status add_above(struct pp_sunlit_day *day,
                                const struct pp_hidden_cones *cones,
                                struct pp_sunlit_place place,
                                const struct pp_sunlit_sun *sun, double above_rad,
                                struct pp_error *err)
{
    struct path path = path_of(place, sun->declination_rad);
    /* The sun's altitude is greatest at noon: q.z >= 0 and r.z = 0. */
    struct arc up = arc_of(fmax(path.q.z, 0.0), 0.0, path.p.z - sin(above_rad));
    double from = fmax(sun->from_rad, -up.half), to = fmin(sun->to_rad, up.half);
    struct pp_sunlit_day hidden = {0};
    enum pp_status status = PP_OK;
    for (int i = 0; cones && from < to && i < cones->count && status == PP_OK; i++) {
        int first = i > 0 ? cones->list[i - 1].end : 0;
        if (!is_clear_of(&path, &cones->list[i]))
            status = add_cone(&hidden, &path, cones->half_spaces + first,
                              cones->list[i].end - first, err);
    }
    pp_sunlit_hours_unite(&hidden);
    if (status == PP_OK)
        status = add_rest(day, &hidden, from, to, err);
    pp_sunlit_hours_clear(&hidden);
    return status;
}

enum pp_status pp_sunlit_hours_add(struct pp_sunlit_day *day,
                                   const struct pp_hidden_cones *cones,
                                   struct pp_sunlit_place place,
                                   const struct pp_sunlit_sun *sun,
                                   struct pp_error *err)
{
    return add_above(day, cones, place, sun, 0.0, err);
}

/* The sun's declination on a day of 2025 at an hour of local time at the place. */
static double declination_at(struct pp_sunlit_place place, int month, int date,
                             double hour)
{
    double east =
        isfinite(place.longitude_rad) ? place.longitude_rad * 12.0 / PP_PI : 0.0;
    double days = pp_sun_days_since_2000(2025, month, date, hour - east);
    return pp_sun_at(days, 0.0, 0.0).declination_rad;
}

enum pp_status pp_sunlit_hours_of_day(struct pp_sunlit_day *day,
                                      const struct pp_hidden_cones *cones,
                                      struct pp_sunlit_place place, int month, int date,
                                      struct pp_error *err)
{
    return pp_sunlit_hours_above(day, cones, place, month, date, 0.0, err);
}

enum pp_status pp_sunlit_hours_above(struct pp_sunlit_day *day,
                                     const struct pp_hidden_cones *cones,
                                     struct pp_sunlit_place place, int month, int date,
                                     double above_rad, struct pp_error *err)
{
    enum pp_status status = PP_OK;
    for (int hour = 0; hour < 24 && status == PP_OK; hour++) {
        struct pp_sunlit_sun sun = {
            .declination_rad = declination_at(place, month, date, hour + 0.5),
            .from_rad = (hour - 12) * PP_PI / 12.0,
            .to_rad = (hour - 11) * PP_PI / 12.0,
        };
        status = add_above(day, cones, place, &sun, above_rad, err);
    }
    pp_sunlit_hours_unite(day);
    return status;
}

int pp_sunlit_hours_drop_short(struct pp_sunlit_day *day, double shortest_h)
{
    int kept = 0, all = day->count;
    for (int i = 0; i < all; i++) {
        double from = day->times[i][0], to = day->times[i][1];
        if ((to - from) * 12.0 / PP_PI < shortest_h)
            continue;
        day->times[kept][0] = from;
        day->times[kept++][1] = to;
    }
    day->count = kept;
    return all - kept;
}

void pp_sunlit_hours_words(char *text, size_t room, const struct pp_sunlit_day *day)
{
    snprintf(text, room, "%s", day->count > 0 ? "" : "none");
    for (int i = 0; i < day->count; i++) {
        int minutes[2];
        for (int k = 0; k < 2; k++)
            minutes[k] = (int)lround((day->times[i][k] / PP_PI + 1.0) * 720.0);
        pp_text_append(text, room, "%s%02d:%02d-%02d:%02d", i ? ", " : "",
                       minutes[0] / 60, minutes[0] % 60, minutes[1] / 60,
                       minutes[1] % 60);
    }
}

double pp_sunlit_hours_sum(const struct pp_sunlit_day *day)
{
    double sum = 0.0;
    for (int i = 0; i < day->count; i++)
        sum += day->times[i][1] - day->times[i][0];
    return sum * 12.0 / PP_PI;
}

void pp_sunlit_hours_clear(struct pp_sunlit_day *day)
{
    free(day->times);
    *day = (struct pp_sunlit_day){0};
}

/* Sum of the times in hours, with each hour of solar time weighted by its share. */
static double weighted_sum(const struct pp_sunlit_day *day, const double share[24])
{
    double sum = 0.0;
    for (int i = 0; i < day->count; i++)
        for (int hour = 0; hour < 24; hour++) {
            double from = fmax(day->times[i][0] * 12.0 / PP_PI + 12.0, hour);
            double to = fmin(day->times[i][1] * 12.0 / PP_PI + 12.0, hour + 1);
            sum += from < to ? (to - from) * share[hour] : 0.0;
        }
    return sum;
}

static bool is_winter(int month, int day)
{
    return month > 9 || month < 3 || (month == 9 ? day >= 21 : month == 3 && day <= 21);
}

enum pp_status pp_sunlit_hours_of_year(struct pp_sunlit_year *year,
                                       const struct pp_hidden_cones *cones,
                                       struct pp_sunlit_place place,
                                       const double (*share)[24], struct pp_error *err)
{
    static const int days[] = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
    struct pp_sunlit_day today = {0};
    enum pp_status status = PP_OK;
    *year = (struct pp_sunlit_year){0};
    for (int month = 1; month <= 12; month++)
        for (int day = 1; day <= days[month - 1] && status == PP_OK; day++) {
            today.count = 0;
            struct pp_sunlit_sun sun = {declination_at(place, month, day, 12.0), -PP_PI,
                                        PP_PI};
            status = pp_sunlit_hours_add(&today, cones, place, &sun, err);
            double hours = share ? weighted_sum(&today, share[month - 1])
                                 : pp_sunlit_hours_sum(&today);
            year->all += hours;
            year->winter += is_winter(month, day) ? hours : 0.0;
        }
    pp_sunlit_hours_clear(&today);
    return status;
}
