/* gbxml_prism.c - floor, ceiling and walls as polygons. */
#include "formats/gbxml/gbxml_prism.h"

#include <math.h>
#include <stdlib.h>

static const double level_m = 0.02;

static void find_prism_extent(double *low, double *high,
                              const struct pp_gbxml_polygon *list, int count)
{
    for (int i = 0; i < count; i++)
        for (int k = 0; k < list[i].count; k++) {
            *low = fmin(*low, list[i].corners[k].z);
            *high = fmax(*high, list[i].corners[k].z);
        }
}

/* Area of the polygon's plan; 0 if the polygon is not level at height z. */
static double level_area(const struct pp_gbxml_polygon *polygon, double z)
{
    double area = 0.0;
    for (int i = 0; i < polygon->count; i++) {
        const struct pp_vec3 *a = &polygon->corners[i];
        const struct pp_vec3 *b = &polygon->corners[(i + 1) % polygon->count];
        if (fabs(a->z - z) > level_m)
            return 0.0;
        area += 0.5 * (a->x * b->y - b->x * a->y);
    }
    return fabs(area);
}

static const struct pp_gbxml_polygon *find_floor(
    const struct pp_gbxml_space *space, const struct pp_gbxml_polygon *polygons,
    int count, double z)
{
    const struct pp_gbxml_polygon *largest = NULL;
    double most = 0.0;
    if (level_area(&space->floor, z) > 0.0)
        return &space->floor;
    for (int i = 0; i < space->shell_count + count; i++) {
        const struct pp_gbxml_polygon *one = i < space->shell_count
                                                 ? &space->shell[i]
                                                 : &polygons[i - space->shell_count];
        double area = level_area(one, z);
        if (area > most) {
            most = area;
            largest = one;
        }
    }
    return largest;
}

enum pp_status pp_gbxml_prism_make(struct pp_gbxml_shell *shell, const char **why,
                                   const struct pp_gbxml_space *space,
                                   const struct pp_gbxml_polygon *polygons, int count,
                                   struct pp_error *err)
{
    double low = INFINITY, high = -INFINITY;
    *shell = (struct pp_gbxml_shell){0};
    find_prism_extent(&low, &high, space->shell, space->shell_count);
    find_prism_extent(&low, &high, polygons, count);
    const struct pp_gbxml_polygon *floor = find_floor(space, polygons, count, low);
    *why = floor ? NULL : "has no level floor";
    if (*why)
        return PP_OK;
    const int n = floor->count;
    struct pp_gbxml_polygon *sides = calloc((size_t)n + 2, sizeof *sides);
    struct pp_vec3 *corners = calloc(6 * (size_t)n, sizeof *corners);
    enum pp_status status = sides && corners ? PP_OK : pp_fail_memory(err);
    for (int i = 0; i < n && status == PP_OK; i++) {
        struct pp_vec3 at = floor->corners[i], next = floor->corners[(i + 1) % n];
        struct pp_vec3 *wall = corners + 2 * n + 4 * i;
        at.z = next.z = low;
        corners[i] = wall[0] = at;
        wall[1] = next;
        at.z = next.z = high;
        corners[n + i] = wall[3] = at;
        wall[2] = next;
        sides[2 + i] = (struct pp_gbxml_polygon){wall, 4};
    }
    if (status == PP_OK) {
        sides[0] = (struct pp_gbxml_polygon){corners, n};
        sides[1] = (struct pp_gbxml_polygon){corners + n, n};
        status = pp_gbxml_shell_make(shell, why, sides, n + 2, err);
    }
    free(sides);
    free(corners);
    return status;
}
