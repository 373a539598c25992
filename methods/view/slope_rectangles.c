/* slope_rectangles.c - turns the parts of the drawing into rectangles along the
 * section's axes. */
#include "methods/view/slope_rectangles.h"

#include <math.h>
#include <stdlib.h>

#include "methods/view/window_drawing.h"
#include "model/geometry/area_moments.h"

double pp_slope_rectangles_slope(const struct pp_opening *opening)
{
    struct pp_vec3 out = opening->inner.normal;
    return atan2(hypot(out.x, out.y), -out.z);
}

double pp_slope_rectangles_altitude(double b, struct pp_angle slope)
{
    double up = b * slope.sine + slope.cosine;
    double forward = slope.sine - b * slope.cosine;
    return fmax(atan2(up, forward), 0.0);
}

/* The axes of plan and section, in the opening's plane: `along` its horizontal edges,
 * `up` the slope. */
struct axes {
    bool turned; /* true: the axes are turned along the longer edges of a horizontal
                  * opening */
    struct pp_vec3 along, up;
};

static struct axes section_axes(const struct pp_opening *opening, double slope)
{
    if (slope < PP_SLOPE_RECTANGLES_TOLERANCE_RAD
        && opening->height_m > opening->width_m)
        return (struct axes){true, opening->up, pp_vec_scale(opening->along, -1.0)};
    return (struct axes){false, opening->along, opening->up};
}

/* Adds the area and extent of the part of a ring above the point's horizon, in the
 * section's axes. */
static enum pp_status add_ring_moments(struct pp_area_moments *sum,
                                       const struct pp_ring *ring,
                                       const struct axes *axes, double horizon,
                                       struct pp_error *err)
{
    size_t room = (size_t)ring->count * PP_AREA_MOMENTS_POINTS;
    double(*points)[2] = malloc(2 * (room + 1) * sizeof *points);
    if (!points)
        return pp_fail_memory(err);
    for (int i = 0; i < ring->count; i++) {
        const double *xy = ring->xy[i];
        points[i][0] = axes->turned ? xy[1] : xy[0];
        points[i][1] = axes->turned ? -xy[0] : xy[1];
    }
    struct pp_area_moments extent = pp_area_moments_in_box(
        points, points + room, ring->count, -INFINITY, INFINITY, horizon, INFINITY);
    free(points);
    sum->area += extent.area;
    sum->left = fmin(sum->left, extent.left);
    sum->right = fmax(sum->right, extent.right);
    sum->low = fmin(sum->low, extent.low);
    sum->high = fmax(sum->high, extent.high);
    return PP_OK;
}

/* The rectangle of an obstruction: it has the jambs and the head (the edge nearer to
 * the zenith) of the hidden part, and equal area. */
static struct pp_slope_rectangle obstruction_rectangle(
    const struct pp_area_moments *extent, double slope)
{
    double height = extent->area / (extent->right - extent->left);
    const struct pp_angle at = pp_angle_of(slope);
    bool behind = pp_slope_rectangles_altitude(extent->low, at)
                      + pp_slope_rectangles_altitude(extent->high, at)
                  > PP_PI;
    double low = behind ? extent->low : extent->high - height;
    return (struct pp_slope_rectangle){
        .left = extent->left, .right = extent->right, .low = low, .high = low + height};
}

/* The rectangle of equal area with the middle and the proportions of the bounding
 * box. */
static struct pp_slope_rectangle equal_rectangle(const struct pp_area_moments *extent)
{
    double width = extent->right - extent->left, height = extent->high - extent->low;
    double margin = (1.0 - sqrt(extent->area / (width * height))) / 2.0;
    if (!(margin > 1e-9))
        margin = 0.0;
    return (struct pp_slope_rectangle){.left = extent->left + margin * width,
                                       .right = extent->right - margin * width,
                                       .low = extent->low + margin * height,
                                       .high = extent->high - margin * height};
}

static enum pp_status region_extent(struct pp_area_moments *extent,
                                    const struct pp_region *region,
                                    const struct axes *axes, double horizon,
                                    struct pp_error *err)
{
    enum pp_status status = PP_OK;
    for (int r = 0; r < region->count && status == PP_OK; r++)
        status = add_ring_moments(extent, &region->rings[r], axes, horizon, err);
    return status;
}

struct pp_vec3 pp_slope_rectangles_along(const struct pp_opening *opening,
                                         double slope_rad)
{
    return section_axes(opening, slope_rad).along;
}

/* Fills in the rectangles of the drawing's parts, that of the whole opening first. */
static enum pp_status fill_slope_rectangles(struct pp_slope_rectangles *rectangles,
                                            const struct pp_window_drawing *drawing,
                                            const struct axes *axes,
                                            struct pp_error *err)
{
    double slope = rectangles->slope_rad;
    double horizon =
        slope < PP_SLOPE_RECTANGLES_TOLERANCE_RAD ? -INFINITY : -1.0 / tan(slope);
    struct pp_area_moments whole = pp_area_moments_empty();
    enum pp_status status = PP_OK;
    for (int i = 0; i < drawing->count && status == PP_OK; i++)
        status = region_extent(&whole, &drawing->parts[i].region, axes, horizon, err);
    if (status != PP_OK || !(whole.area > 0.0))
        return status;
    struct pp_slope_rectangle *all = &rectangles->list[rectangles->count++];
    *all = equal_rectangle(&whole);
    all->factor = 1.0;
    for (int i = 0; i < drawing->count && status == PP_OK; i++) {
        struct pp_area_moments extent = pp_area_moments_empty();
        if (!drawing->parts[i].hidden)
            continue;
        status = region_extent(&extent, &drawing->parts[i].region, axes, horizon, err);
        if (status != PP_OK || !(extent.area > 1e-12))
            continue;
        struct pp_slope_rectangle *part = &rectangles->list[rectangles->count++];
        *part = obstruction_rectangle(&extent, slope);
        part->hidden = true;
        part->factor = drawing->parts[i].factor;
    }
    return status;
}

enum pp_status pp_slope_rectangles_init(struct pp_slope_rectangles *rectangles,
                                        const struct pp_world *world,
                                        const struct pp_outside_light *light,
                                        const struct pp_opening *opening,
                                        struct pp_vec3 point, struct pp_error *err)
{
    struct pp_window_drawing drawing;
    *rectangles =
        (struct pp_slope_rectangles){.slope_rad = pp_slope_rectangles_slope(opening)};
    enum pp_status status =
        pp_window_drawing_init(&drawing, world, light, opening, point, err);
    if (status != PP_OK)
        return status;
    struct axes axes = section_axes(opening, rectangles->slope_rad);
    rectangles->list = calloc((size_t)drawing.count + 1, sizeof *rectangles->list);
    status = rectangles->list ? fill_slope_rectangles(rectangles, &drawing, &axes, err)
                              : pp_fail_memory(err);
    pp_window_drawing_clear(&drawing);
    if (status != PP_OK)
        pp_slope_rectangles_clear(rectangles);
    return status;
}

void pp_slope_rectangles_clear(struct pp_slope_rectangles *rectangles)
{
    free(rectangles->list);
    *rectangles = (struct pp_slope_rectangles){0};
}
