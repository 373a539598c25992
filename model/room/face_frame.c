/* face_frame.c - see face_frame.h. */
#include "model/room/face_frame.h"

#include <stdlib.h>
#include <string.h>

#include "model/geometry/polygon.h"
#include "model/geometry/tolerance.h"

enum pp_status pp_face_frame_init(struct pp_face_frame *frame,
                                  const struct pp_surface *face, struct pp_error *err)
{
    int count = face->outline.count;
    *frame = (struct pp_face_frame){.face = face, .count = count, .convex = true};
    /* Slightly uneven faces use their best-fit plane. */
    frame->origin = face->outline.vertices[0];
    double height = pp_polygon_height(&face->outline, frame->origin);
    if (fabs(height) > PP_ROUNDING_M)
        frame->origin = pp_vec_along(frame->origin, -height, face->outline.normal);
    pp_polygon_plane_axes(face->outline.normal, &frame->along, &frame->up);
    frame->xy = malloc(count * sizeof *frame->xy);
    if (!frame->xy)
        return pp_fail_memory(err);
    pp_polygon_flatten(face->outline.vertices, count, frame->origin, frame->along,
                       frame->up, frame->xy);
    frame->bounds = pp_bounds2_empty();
    for (int i = 0; i < count; i++) {
        const double *a = frame->xy[i], *b = frame->xy[(i + 1) % count],
                     *c = frame->xy[(i + 2) % count];
        pp_bounds2_add(&frame->bounds, a[0], a[1]);
        if ((b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0]) < 0.0)
            frame->convex = false;
    }
    return PP_OK;
}

void pp_face_frame_clear(struct pp_face_frame *frame)
{
    free(frame->xy);
    *frame = (struct pp_face_frame){0};
}

struct pp_vec3 pp_face_frame_point(const struct pp_face_frame *frame, double x,
                                   double y)
{
    return pp_vec_along(pp_vec_along(frame->origin, x, frame->along), y, frame->up);
}

/* Area (m2) of the ring outside the face. */
static enum pp_status area_outside(double *area_m2, struct pp_clipper *clipper,
                                   const struct pp_face_frame *frame,
                                   const double (*xy)[2], int count,
                                   struct pp_error *err)
{
    struct pp_region ring = {0}, face = {0}, outside = {0};
    enum pp_status status = pp_clipper_of_ring(clipper, &ring, xy, count, err);
    if (status == PP_OK)
        status = pp_clipper_of_ring(clipper, &face, (const double(*)[2])frame->xy,
                                    frame->count, err);
    if (status == PP_OK)
        status = pp_clipper_difference(clipper, &outside, &ring, &face, err);
    *area_m2 = pp_region_area(&outside);
    pp_region_clear(&ring);
    pp_region_clear(&face);
    pp_region_clear(&outside);
    return status;
}

enum pp_status pp_face_frame_fit(const struct pp_face_frame *frame,
                                 struct pp_clipper *clipper, double (*xy)[2], int count,
                                 double tolerance, double *out_m, struct pp_vec3 *where,
                                 double *out_m2, struct pp_error *err)
{
    const double(*outline)[2] = (const double(*)[2])frame->xy;
    *out_m = *out_m2 = 0.0;
    for (int i = 0; i < count; i++) {
        double x = xy[i][0], y = xy[i][1], nearest[2];
        if (pp_polygon_ring_side(outline, frame->count, x, y, 0.0) == PP_INSIDE)
            continue;
        double out =
            pp_polygon_ring_edge_distance(outline, frame->count, x, y, nearest);
        if (out <= tolerance) {
            memcpy(xy[i], nearest, sizeof nearest);
        } else if (out > *out_m) {
            *out_m = out;
            *where = pp_face_frame_point(frame, x, y);
        }
    }
    if (*out_m > 0.0 || frame->convex)
        return PP_OK;
    double area_m2 = 0.0;
    enum pp_status status =
        area_outside(&area_m2, clipper, frame, (const double(*)[2])xy, count, err);
    double extent_m = frame->bounds.high[0] - frame->bounds.low[0]
                      + frame->bounds.high[1] - frame->bounds.low[1];
    if (area_m2 > tolerance * extent_m)
        *out_m2 = area_m2;
    return status;
}

static struct pp_bounds2 outline_bounds(const double (*xy)[2], int count)
{
    struct pp_bounds2 bounds = pp_bounds2_empty();
    for (int i = 0; i < count; i++)
        pp_bounds2_add(&bounds, xy[i][0], xy[i][1]);
    return bounds;
}

static bool bounds_overlap(struct pp_bounds2 a, struct pp_bounds2 b)
{
    for (int k = 0; k < 2; k++)
        if (a.low[k] > b.high[k] - PP_ROUNDING_M
            || b.low[k] > a.high[k] - PP_ROUNDING_M)
            return false;
    return true;
}

enum pp_status pp_face_frame_rings_overlap(struct pp_clipper *clipper,
                                           const double (*a)[2], int a_count,
                                           const double (*b)[2], int b_count,
                                           double *area_m2, struct pp_error *err)
{
    *area_m2 = 0.0;
    if (!bounds_overlap(outline_bounds(a, a_count), outline_bounds(b, b_count)))
        return PP_OK;
    struct pp_region first = {0}, second = {0}, both = {0};
    enum pp_status status = pp_clipper_of_ring(clipper, &first, a, a_count, err);
    if (status == PP_OK)
        status = pp_clipper_of_ring(clipper, &second, b, b_count, err);
    if (status == PP_OK)
        status = pp_clipper_intersection(clipper, &both, &first, &second, err);
    *area_m2 = pp_region_area(&both);
    pp_region_clear(&first);
    pp_region_clear(&second);
    pp_region_clear(&both);
    return status;
}
