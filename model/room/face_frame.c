/* face_frame.c - see face_frame.h. */
#include "model/room/face_frame.h"

#include <stdlib.h>
#include <string.h>

#include "model/geometry/polygon.h"
#include "model/geometry/tolerance.h"

enum pp_status pp_face_frame_init(struct pp_face_frame *sheet,
                                  const struct pp_surface *face, struct pp_error *err)
{
    int count = face->outline.count;
    *sheet = (struct pp_face_frame){.face = face, .count = count, .convex = true};
    /* Where the face is not quite plane, from its best plane. */
    sheet->origin = face->outline.vertices[0];
    double height = pp_polygon_height(&face->outline, sheet->origin);
    if (fabs(height) > PP_ROUNDING_M)
        sheet->origin = pp_vec_along(sheet->origin, -height, face->outline.normal);
    pp_polygon_plane_axes(face->outline.normal, &sheet->along, &sheet->up);
    sheet->xy = malloc(count * sizeof *sheet->xy);
    if (!sheet->xy)
        return pp_fail_memory(err);
    pp_polygon_flatten(face->outline.vertices, count, sheet->origin, sheet->along,
                       sheet->up, sheet->xy);
    for (int k = 0; k < 2; k++)
        sheet->low[k] = sheet->high[k] = sheet->xy[0][k];
    for (int i = 0; i < count; i++) {
        const double *a = sheet->xy[i], *b = sheet->xy[(i + 1) % count],
                     *c = sheet->xy[(i + 2) % count];
        for (int k = 0; k < 2; k++) {
            sheet->low[k] = fmin(sheet->low[k], a[k]);
            sheet->high[k] = fmax(sheet->high[k], a[k]);
        }
        if ((b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0]) < 0.0)
            sheet->convex = false;
    }
    return PP_OK;
}

void pp_face_frame_clear(struct pp_face_frame *sheet)
{
    free(sheet->xy);
    *sheet = (struct pp_face_frame){0};
}

struct pp_vec3 pp_face_frame_point(const struct pp_face_frame *sheet, double x,
                                   double y)
{
    return pp_vec_along(pp_vec_along(sheet->origin, x, sheet->along), y, sheet->up);
}

/* The area of the ring that lies outside the sheet's outline (m2). */
static enum pp_status area_outside(double *area_m2, struct pp_clipper *clipper,
                                   const struct pp_face_frame *sheet,
                                   const double (*xy)[2], int count,
                                   struct pp_error *err)
{
    struct pp_region ring = {0}, face = {0}, outside = {0};
    enum pp_status status = pp_region_of_ring(clipper, &ring, xy, count, err);
    if (status == PP_OK)
        status = pp_region_of_ring(clipper, &face, (const double(*)[2])sheet->xy,
                                   sheet->count, err);
    if (status == PP_OK)
        status = pp_region_difference(clipper, &outside, &ring, &face, err);
    *area_m2 = pp_region_area(&outside);
    pp_region_clear(&ring);
    pp_region_clear(&face);
    pp_region_clear(&outside);
    return status;
}

enum pp_status pp_face_frame_fit(const struct pp_face_frame *sheet,
                                 struct pp_clipper *clipper, double (*xy)[2], int count,
                                 double tolerance, double *out_m, struct pp_vec3 *where,
                                 double *out_m2, struct pp_error *err)
{
    const double(*outline)[2] = (const double(*)[2])sheet->xy;
    *out_m = *out_m2 = 0.0;
    for (int i = 0; i < count; i++) {
        double x = xy[i][0], y = xy[i][1], nearest[2];
        if (pp_polygon_ring_side(outline, sheet->count, x, y, 0.0) == PP_INSIDE)
            continue;
        double out =
            pp_polygon_ring_edge_distance(outline, sheet->count, x, y, nearest);
        if (out <= tolerance) {
            memcpy(xy[i], nearest, sizeof nearest);
        } else if (out > *out_m) {
            *out_m = out;
            *where = pp_face_frame_point(sheet, x, y);
        }
    }
    if (*out_m > 0.0 || sheet->convex)
        return PP_OK;
    double area_m2 = 0.0;
    enum pp_status status =
        area_outside(&area_m2, clipper, sheet, (const double(*)[2])xy, count, err);
    double extent_m = sheet->high[0] - sheet->low[0] + sheet->high[1] - sheet->low[1];
    if (area_m2 > tolerance * extent_m)
        *out_m2 = area_m2;
    return status;
}

static bool extents_overlap(const double (*a)[2], int a_count, const double (*b)[2],
                            int b_count)
{
    for (int k = 0; k < 2; k++) {
        double a_low = INFINITY, a_high = -INFINITY, b_low = INFINITY,
               b_high = -INFINITY;
        for (int i = 0; i < a_count; i++) {
            a_low = fmin(a_low, a[i][k]);
            a_high = fmax(a_high, a[i][k]);
        }
        for (int i = 0; i < b_count; i++) {
            b_low = fmin(b_low, b[i][k]);
            b_high = fmax(b_high, b[i][k]);
        }
        if (a_low > b_high - PP_ROUNDING_M || b_low > a_high - PP_ROUNDING_M)
            return false;
    }
    return true;
}

enum pp_status pp_face_frame_rings_overlap(struct pp_clipper *clipper,
                                           const double (*a)[2], int a_count,
                                           const double (*b)[2], int b_count,
                                           double *area_m2, struct pp_error *err)
{
    *area_m2 = 0.0;
    if (!extents_overlap(a, a_count, b, b_count))
        return PP_OK;
    struct pp_region first = {0}, second = {0}, both = {0};
    enum pp_status status = pp_region_of_ring(clipper, &first, a, a_count, err);
    if (status == PP_OK)
        status = pp_region_of_ring(clipper, &second, b, b_count, err);
    if (status == PP_OK)
        status = pp_region_intersection(clipper, &both, &first, &second, err);
    *area_m2 = pp_region_area(&both);
    pp_region_clear(&first);
    pp_region_clear(&second);
    pp_region_clear(&both);
    return status;
}
