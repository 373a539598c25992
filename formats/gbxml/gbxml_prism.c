/* gbxml_prism.c - floor, ceiling and walls as polygons. */
#include "formats/gbxml/gbxml_prism.h"

#include <math.h>
#include <stdlib.h>

/* level_m: tolerance for a horizontal polygon, and for walls on a floor. storey_m:
 * slabs up to this height above the lowest corner belong to the floor. gap_m: gaps
 * between slabs up to this width are filled. grid_m: corners of slabs are rounded to
 * multiples of this. */
static const double level_m = 0.02, storey_m = 1.0, gap_m = 0.6, grid_m = 1e-3;

static void find_prism_extent(double *low, double *high,
                              const struct pp_gbxml_polygon *list, int count)
{
    for (int i = 0; i < count; i++)
        for (int k = 0; k < list[i].count; k++) {
            *low = fmin(*low, list[i].corners[k].z);
            *high = fmax(*high, list[i].corners[k].z);
        }
}

/* Area of the polygon in plan; 0 if it is not horizontal. */
static double level_area(const struct pp_gbxml_polygon *polygon)
{
    double area = 0.0;
    for (int i = 0; i < polygon->count; i++) {
        const struct pp_vec3 *a = &polygon->corners[i];
        const struct pp_vec3 *b = &polygon->corners[(i + 1) % polygon->count];
        if (fabs(a->z - polygon->corners[0].z) > level_m)
            return 0.0;
        area += 0.5 * (a->x * b->y - b->x * a->y);
    }
    return fabs(area);
}

static int count_pieces(const struct pp_region *region)
{
    int count = 0;
    for (int i = 0; i < region->count; i++)
        count += pp_region_ring_area((const double(*)[2])region->rings[i].xy,
                                     region->rings[i].count)
                 > 0.0;
    return count;
}

/* Joins pieces of floor separated by a narrow gap, for example a partition. On failure
 * the region stays as it is. */
static void close_gaps(struct pp_region *floor, struct pp_clipper *clipper)
{
    struct pp_region closed;
    struct pp_error said = {0};
    if (count_pieces(floor) < 2
        || pp_clipper_close_gaps(clipper, &closed, floor, gap_m, &said) != PP_OK)
        return;
    pp_region_clear(floor);
    *floor = closed;
}

/* Union in plan of all horizontal polygons near the lowest corner of the list. */
static enum pp_status unite_floor(struct pp_region *floor,
                                  const struct pp_gbxml_polygon *list, int count,
                                  struct pp_clipper *clipper, struct pp_error *err)
{
    struct pp_region *slabs = calloc((size_t)count + 1, sizeof *slabs);
    enum pp_status status = slabs ? PP_OK : pp_fail_memory(err);
    double low = INFINITY, high = -INFINITY;
    int slab_count = 0;
    struct pp_error said = {0};
    *floor = (struct pp_region){0};
    find_prism_extent(&low, &high, list, count);
    for (int i = 0; i < count && status == PP_OK; i++) {
        if (!(level_area(&list[i]) > 0.0) || list[i].corners[0].z > low + storey_m)
            continue;
        double(*xy)[2] = malloc((size_t)list[i].count * sizeof *xy);
        if (!xy)
            status = pp_fail_memory(err);
        for (int k = 0; xy && k < list[i].count; k++) {
            xy[k][0] = list[i].corners[k].x;
            xy[k][1] = list[i].corners[k].y;
        }
        if (xy
            && pp_clipper_of_ring(clipper, &slabs[slab_count], (const double(*)[2])xy,
                                  list[i].count, &said)
                   == PP_OK)
            slab_count++;
        free(xy);
    }
    if (status == PP_OK && slab_count > 0) {
        pp_clipper_set_grid(clipper, grid_m);
        if (pp_clipper_union(clipper, floor, slabs, slab_count, &said) == PP_SYSTEM)
            status = pp_fail_memory(err);
        close_gaps(floor, clipper);
        pp_clipper_set_grid(clipper, 0.0);
    }
    for (int i = 0; i < slab_count; i++)
        pp_region_clear(&slabs[i]);
    free(slabs);
    return status;
}

/* Index of the region's largest ring; -1: none. */
static int largest_ring(const struct pp_region *region)
{
    int largest = -1;
    double most = 0.0;
    for (int i = 0; i < region->count; i++) {
        double area = pp_region_ring_area((const double(*)[2])region->rings[i].xy,
                                          region->rings[i].count);
        if (area > most)
            most = area, largest = i;
    }
    return largest;
}

/* Finds the floor; it is empty if there is none. */
static enum pp_status find_floor(struct pp_region *floor,
                                 const struct pp_gbxml_space *space,
                                 const struct pp_gbxml_polygon *polygons, int count,
                                 struct pp_clipper *clipper, struct pp_error *err)
{
    const struct {
        const struct pp_gbxml_polygon *list;
        int count;
    } sources[] = {{&space->floor, space->floor.count > 0},
                   {space->shell, space->shell_count},
                   {polygons, count}};
    double least = INFINITY;
    *floor = (struct pp_region){0};
    for (int i = 0; i < 3; i++) {
        struct pp_region found;
        enum pp_status status =
            unite_floor(&found, sources[i].list, sources[i].count, clipper, err);
        if (status != PP_OK)
            return status;
        double off = isnan(space->area_m2)
                         ? i
                         : fabs(pp_region_area(&found) / space->area_m2 - 1.0);
        if (found.count > 0 && off < least - 0.01) {
            pp_region_clear(floor);
            *floor = found;
            least = off;
        } else {
            pp_region_clear(&found);
        }
    }
    return PP_OK;
}

/* Height of the lowest horizontal polygon more than storey_m above `low` that is at
 * least half as large as `area`; `ceiling` if that is lower. */
static double find_ceiling(const struct pp_gbxml_polygon *list, int count, double low,
                           double area, double ceiling)
{
    for (int i = 0; i < count; i++)
        if (level_area(&list[i]) >= 0.5 * area && list[i].corners[0].z > low + storey_m)
            ceiling = fmin(ceiling, list[i].corners[0].z);
    return ceiling;
}

/* Height of the highest corner of all polygons whose lowest corner is at floor
 * level. */
static double find_wall_top(const struct pp_gbxml_polygon *list, int count, double low,
                            double top)
{
    for (int i = 0; i < count; i++) {
        double foot = INFINITY, head = -INFINITY;
        find_prism_extent(&foot, &head, &list[i], 1);
        if (foot < low + level_m)
            top = fmax(top, head);
    }
    return top;
}

/* Height of the prism's ceiling; low and high: lowest and highest corner of all
 * polygons. */
static double find_lid(const struct pp_gbxml_space *space,
                       const struct pp_gbxml_polygon *polygons, int count, double area,
                       double low, double high)
{
    double by_volume =
        low + space->volume_m3 / (isnan(space->area_m2) ? area : space->area_m2);
    if (by_volume > low + storey_m && by_volume < high + 0.03 * (high - low))
        return fmin(by_volume, high);
    double lid = find_ceiling(space->shell, space->shell_count, low, area, INFINITY);
    lid = find_ceiling(polygons, count, low, area, lid);
    if (isfinite(lid))
        return lid;
    lid = find_wall_top(space->shell, space->shell_count, low, -INFINITY);
    lid = find_wall_top(polygons, count, low, lid);
    return lid > low + level_m ? lid : high;
}

/* Adds the prism's polygons: floor, lid and walls. */
static enum pp_status make_prism(struct pp_gbxml_shell *shell, const char **why,
                                 const struct pp_ring *floor, double low, double high,
                                 struct pp_error *err)
{
    const int n = floor->count;
    struct pp_gbxml_polygon *sides = calloc((size_t)n + 2, sizeof *sides);
    struct pp_vec3 *corners = calloc(6 * (size_t)n, sizeof *corners);
    enum pp_status status = sides && corners ? PP_OK : pp_fail_memory(err);
    for (int i = 0; i < n && status == PP_OK; i++) {
        const double *at = floor->xy[i], *next = floor->xy[(i + 1) % n];
        struct pp_vec3 *wall = corners + 2 * n + 4 * i;
        corners[i] = wall[0] = pp_vec(at[0], at[1], low);
        corners[n + i] = wall[3] = pp_vec(at[0], at[1], high);
        wall[1] = pp_vec(next[0], next[1], low);
        wall[2] = pp_vec(next[0], next[1], high);
        sides[2 + i] = (struct pp_gbxml_polygon){wall, 4};
    }
    if (status == PP_OK) {
        sides[0] = (struct pp_gbxml_polygon){corners, n};
        sides[1] = (struct pp_gbxml_polygon){corners + n, n};
        status = pp_gbxml_shell_make(shell, why, sides, n + 2, PP_GBXML_SAME_M, err);
    }
    free(sides);
    free(corners);
    return status;
}

/* Removes corners of the ring that lie on the line between their neighbours. */
static void straighten(struct pp_ring *ring)
{
    for (int i = 0; i < ring->count && ring->count > 3;) {
        int n = ring->count;
        const double *a = ring->xy[(i + n - 1) % n], *b = ring->xy[i],
                     *c = ring->xy[(i + 1) % n];
        double long_m = hypot(c[0] - a[0], c[1] - a[1]);
        if (!(fabs(pp_region_turn(a, b, c)) < grid_m * long_m)) {
            i++;
            continue;
        }
        for (int k = i; k + 1 < n; k++) {
            ring->xy[k][0] = ring->xy[k + 1][0];
            ring->xy[k][1] = ring->xy[k + 1][1];
        }
        ring->count--;
    }
}

enum pp_status pp_gbxml_prism_make(struct pp_gbxml_shell *shell, const char **why,
                                   const struct pp_gbxml_space *space,
                                   const struct pp_gbxml_polygon *polygons, int count,
                                   double lid_least_m, struct pp_clipper *clipper,
                                   struct pp_error *err)
{
    double low = INFINITY, high = -INFINITY;
    struct pp_region floor;
    *shell = (struct pp_gbxml_shell){0};
    find_prism_extent(&low, &high, space->shell, space->shell_count);
    find_prism_extent(&low, &high, polygons, count);
    enum pp_status status = find_floor(&floor, space, polygons, count, clipper, err);
    int ring = largest_ring(&floor);
    *why = ring >= 0 ? NULL : "has no horizontal floor";
    if (status == PP_OK && !*why) {
        struct pp_ring *outer = &floor.rings[ring];
        straighten(outer);
        double area = pp_region_ring_area((const double(*)[2])outer->xy, outer->count);
        double lid = fmax(find_lid(space, polygons, count, area, low, high),
                          fmin(lid_least_m, high));
        status = make_prism(shell, why, outer, low, lid, err);
    }
    pp_region_clear(&floor);
    return status;
}
