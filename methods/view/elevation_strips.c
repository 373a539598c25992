/* elevation_strips.c - sweeps over the strips from left to right, with the obstructions
 * that cross each, nearest first. */
#include "methods/view/elevation_strips.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/array.h"

/* One strip and the parts that cross it. Obstructions are identified by their index in
 * the list, the nearest first. */
struct strip_sweep {
    const struct pp_elevation_part *seen;
    const struct pp_elevation_obstruction *list;
    int count;

    int edge_count;
    double *edges; /* jambs, from the left */
    int *by_left;  /* list indices ordered by left jamb. entered: number of them that
                    * the sweep has passed */
    int entered;

    double left, right; /* edges of the strip */
    int crossing_count;
    int *crossing; /* list indices of the obstructions that cross the strip, ascending:
                    * nearest first */

    int shown_count; /* number of crossing obstructions not wholly behind nearer ones */
    int *shown;
    int covered_count; /* number of disjoint ranges of height that the shown
                        * obstructions cover, from below */
    double (*covered)[2];
    double *levels; /* lower and upper edges of the shown obstructions */
};

static int by_size(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static int by_distance(const void *a, const void *b)
{
    const struct pp_elevation_obstruction *x = a, *y = b;
    if (x->distance_m != y->distance_m)
        return x->distance_m < y->distance_m ? -1 : 1;
    return (x->order > y->order) - (x->order < y->order);
}

/* An index in the list, with its left jamb. */
struct jamb_place {
    double left;
    int place;
};

static int by_left_jamb(const void *a, const void *b)
{
    const struct jamb_place *x = a, *y = b;
    if (x->left != y->left)
        return x->left < y->left ? -1 : 1;
    return (x->place > y->place) - (x->place < y->place);
}

static enum pp_status order_jambs(struct strip_sweep *sweep, struct pp_error *err)
{
    struct jamb_place *places = malloc(((size_t)sweep->count + 1) * sizeof *places);
    if (!places)
        return pp_fail_memory(err);
    const struct pp_elevation_part *seen = sweep->seen;
    sweep->edges[sweep->edge_count++] = seen->left;
    sweep->edges[sweep->edge_count++] = seen->right;
    for (int i = 0; i < sweep->count; i++) {
        const struct pp_elevation_part *o = &sweep->list[i].outline;
        places[i] = (struct jamb_place){o->left, i};
        double both[2] = {o->left, o->right};
        for (int k = 0; k < 2; k++)
            if (both[k] > seen->left && both[k] < seen->right)
                sweep->edges[sweep->edge_count++] = both[k];
    }
    qsort(sweep->edges, (size_t)sweep->edge_count, sizeof *sweep->edges, by_size);
    qsort(places, (size_t)sweep->count, sizeof *places, by_left_jamb);
    for (int i = 0; i < sweep->count; i++)
        sweep->by_left[i] = places[i].place;
    free(places);
    return PP_OK;
}

/* Moves the sweep to the strip between two jambs. */
static void move_to(struct strip_sweep *sweep, double left, double right)
{
    double middle = (left + right) / 2.0;
    sweep->left = left;
    sweep->right = right;
    int kept = 0;
    for (int i = 0; i < sweep->crossing_count; i++)
        if (middle < sweep->list[sweep->crossing[i]].outline.right)
            sweep->crossing[kept++] = sweep->crossing[i];
    while (sweep->entered < sweep->count) {
        int place = sweep->by_left[sweep->entered];
        const struct pp_elevation_part *o = &sweep->list[place].outline;
        if (!(middle > o->left))
            break;
        sweep->entered++;
        if (!(middle < o->right))
            continue;
        int at = kept++;
        for (; at > 0 && sweep->crossing[at - 1] > place; at--)
            sweep->crossing[at] = sweep->crossing[at - 1];
        sweep->crossing[at] = place;
    }
    sweep->crossing_count = kept;
}

/* Adds a range of heights to the covered ones. Returns false if the range was already
 * covered. */
static bool cover(struct strip_sweep *sweep, double low, double high)
{
    double(*covered)[2] = sweep->covered;
    int first = 0, count = sweep->covered_count;
    while (first < count && covered[first][1] < low)
        first++;
    if (first < count && covered[first][0] <= low && covered[first][1] >= high)
        return false;
    int last = first;
    for (; last < count && covered[last][0] <= high; last++) {
        low = fmin(low, covered[last][0]);
        high = fmax(high, covered[last][1]);
    }
    memmove(covered + first + 1, covered + last,
            (size_t)(count - last) * sizeof *covered);
    covered[first][0] = low;
    covered[first][1] = high;
    sweep->covered_count = count - (last - first) + 1;
    return true;
}

/* Reflectance of the nearest obstruction at a height; NAN: sky. */
static double reflectance_at(const struct strip_sweep *sweep, double z)
{
    for (int i = 0; i < sweep->shown_count; i++) {
        const struct pp_elevation_part *o = &sweep->list[sweep->shown[i]].outline;
        if (z > o->low && z < o->high)
            return o->reflectance;
    }
    return NAN;
}

static bool same_light(double a, double b)
{
    return a == b || (isnan(a) && isnan(b));
}

/* Finds the edges of the visible parts of the strip, from below. Returns their
 * number. */
static int find_levels(struct strip_sweep *sweep)
{
    const struct pp_elevation_part *seen = sweep->seen;
    int levels = 0;
    sweep->shown_count = sweep->covered_count = 0;
    sweep->levels[levels++] = seen->low;
    sweep->levels[levels++] = seen->high;
    for (int i = 0; i < sweep->crossing_count; i++) {
        const struct pp_elevation_part *o = &sweep->list[sweep->crossing[i]].outline;
        double both[2] = {o->low, o->high};
        if (!(o->high > seen->low && o->low < seen->high)
            || !cover(sweep, fmax(o->low, seen->low), fmin(o->high, seen->high)))
            continue;
        sweep->shown[sweep->shown_count++] = sweep->crossing[i];
        for (int k = 0; k < 2; k++)
            if (both[k] > seen->low && both[k] < seen->high)
                sweep->levels[levels++] = both[k];
    }
    qsort(sweep->levels, (size_t)levels, sizeof *sweep->levels, by_size);
    return levels;
}

/* Adds the parts of the strip, from below: one for each contiguous range that shows the
 * same light. */
static enum pp_status add_strip(struct pp_elevation *elevation, int *capacity,
                                struct strip_sweep *sweep, struct pp_error *err)
{
    int levels = find_levels(sweep), first = elevation->count;
    for (int i = 0; i + 1 < levels; i++) {
        struct pp_elevation_part part = {sweep->left, sweep->right, sweep->levels[i],
                                         sweep->levels[i + 1], NAN};
        if (!(part.high > part.low))
            continue;
        part.reflectance = reflectance_at(sweep, (part.low + part.high) / 2.0);
        if (elevation->count > first
            && same_light(elevation->parts[elevation->count - 1].reflectance,
                          part.reflectance)) {
            elevation->parts[elevation->count - 1].high = part.high;
            continue;
        }
        enum pp_status status =
            pp_array_reserve(&elevation->parts, capacity, elevation->count + 1,
                             sizeof *elevation->parts, err);
        if (status != PP_OK)
            return status;
        elevation->parts[elevation->count++] = part;
    }
    return PP_OK;
}

/* Joins the strip whose parts begin at index `now` to the one whose parts begin at
 * `before`, if all parts continue across the border. Returns false if they do not. */
static bool join_strips(struct pp_elevation *elevation, int before, int now)
{
    int count = elevation->count - now;
    struct pp_elevation_part *a = elevation->parts + before,
                             *b = elevation->parts + now;
    if (now - before != count)
        return false;
    for (int i = 0; i < count; i++)
        if (a[i].low != b[i].low || a[i].high != b[i].high || a[i].right != b[i].left
            || !same_light(a[i].reflectance, b[i].reflectance))
            return false;
    for (int i = 0; i < count; i++)
        a[i].right = b[i].right;
    elevation->count = now;
    return true;
}

static enum pp_status add_strips(struct pp_elevation *elevation,
                                 struct strip_sweep *sweep, struct pp_error *err)
{
    int capacity = 0, before = 0;
    enum pp_status status = order_jambs(sweep, err);
    for (int i = 0; i + 1 < sweep->edge_count && status == PP_OK; i++) {
        if (!(sweep->edges[i + 1] > sweep->edges[i]))
            continue;
        int now = elevation->count;
        move_to(sweep, sweep->edges[i], sweep->edges[i + 1]);
        status = add_strip(elevation, &capacity, sweep, err);
        if (status == PP_OK && (now == before || !join_strips(elevation, before, now)))
            before = now;
    }
    return status;
}

/* Adds an opening without obstructions as one part. */
static enum pp_status add_whole_opening(struct pp_elevation *elevation,
                                        const struct pp_elevation_part *seen,
                                        struct pp_error *err)
{
    elevation->parts = malloc(sizeof *elevation->parts);
    if (!elevation->parts)
        return pp_fail_memory(err);
    elevation->parts[0] = *seen;
    elevation->parts[0].reflectance = NAN;
    elevation->count = 1;
    return PP_OK;
}

enum pp_status pp_elevation_strips_cut(struct pp_elevation *elevation,
                                       const struct pp_elevation_part *seen,
                                       struct pp_elevation_obstructions *obstructions,
                                       struct pp_error *err)
{
    if (obstructions->count == 0)
        return add_whole_opening(elevation, seen, err);
    size_t most = 2 * (size_t)obstructions->count + 2;
    double *numbers = malloc(4 * most * sizeof *numbers);
    int *places = malloc(2 * most * sizeof *places);
    enum pp_status status = numbers && places ? PP_OK : pp_fail_memory(err);
    if (status == PP_OK) {
        qsort(obstructions->list, (size_t)obstructions->count,
              sizeof *obstructions->list, by_distance);
        struct strip_sweep sweep = {.seen = seen,
                                    .list = obstructions->list,
                                    .count = obstructions->count,
                                    .edges = numbers,
                                    .levels = numbers + most,
                                    .covered = (double(*)[2])(numbers + 2 * most),
                                    .by_left = places,
                                    .crossing = places + most / 2,
                                    .shown = places + most};
        status = add_strips(elevation, &sweep, err);
    }
    free(numbers);
    free(places);
    return status;
}
