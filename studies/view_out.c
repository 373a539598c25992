/* view_out.c - adds the sight angles and lines of sight of all openings. */
#include "studies/view_out.h"

#include <math.h>
#include <stdlib.h>

#include "methods/view/visible.h"
#include "model/base/array.h"
#include "model/geometry/region.h"

/* Lines of sight that end closer than this beyond the glass are ignored. */
static const double NEAR_M = 2.0;
/* Ground less than this angle below the horizon is treated as landscape. */
static const double LANDSCAPE_RAD = 5.0 * PP_RAD;
/* Greatest sine of the altitude of an opening's outward normal: openings that slope
 * more than 45 degrees from the vertical are ignored. */
static const double RISE_MOST = 0.70710678118654757;

/* Step of the golden ratio, which spreads the lines evenly over any height. */
static const double GOLDEN = 0.6180339887498949;

const double pp_view_out_angle_rad[4] = {0.0, 14.0 * PP_RAD, 28.0 * PP_RAD,
                                         54.0 * PP_RAD};
const double pp_view_out_distance_m[4] = {0.0, 6.0, 20.0, 50.0};

/* Range of bearings (rad) in [0, 4 pi), at most pi wide. */
struct bearing_span {
    double from, to;
};

/* Sums over all openings. */
struct view_sum {
    struct bearing_span *spans;
    int span_count, span_space;
    struct pp_view_line *lines;
    int line_count, line_space;
};

static int by_span_start(const void *a, const void *b)
{
    const struct bearing_span *s = a, *t = b;
    return (s->from > t->from) - (s->from < t->from);
}

/* Total width of the ranges on the circle, with overlaps counted once. Ranges that
 * extend beyond a full turn are split; the array must have space for twice the
 * count. */
static double spans_union(struct bearing_span *spans, int count)
{
    int all = count;
    for (int i = 0; i < count; i++)
        if (spans[i].to > 2.0 * PP_PI) {
            spans[all++] = (struct bearing_span){0.0, spans[i].to - 2.0 * PP_PI};
            spans[i].to = 2.0 * PP_PI;
        }
    if (all > 0)
        qsort(spans, (size_t)all, sizeof *spans, by_span_start);
    double sum = 0.0, end = 0.0;
    for (int i = 0; i < all; i++) {
        sum += fmax(0.0, spans[i].to - fmax(spans[i].from, end));
        end = fmax(end, spans[i].to);
    }
    return sum;
}

/* Moves lines nearer than `distance_m` to the front, followed by those at that distance.
 * ends: indices after both groups. weights: their solid angles. */
static void part_lines(int ends[2], double weights[2], struct pp_view_line *lines,
                       int count, double distance_m)
{
    weights[0] = weights[1] = 0.0;
    ends[0] = ends[1] = 0;
    for (int i = 0; i < count; i++) {
        struct pp_view_line line = lines[i];
        if (line.distance_m > distance_m)
            continue;
        bool nearer = line.distance_m < distance_m;
        weights[nearer ? 0 : 1] += line.solid_angle;
        lines[i] = lines[ends[1]];
        lines[ends[1]++] = line;
        if (nearer) {
            lines[ends[1] - 1] = lines[ends[0]];
            lines[ends[0]++] = line;
        }
    }
}

double pp_view_out_median_distance(struct pp_view_line *lines, int count)
{
    double half = 0.0, found = 0.0;
    for (int i = 0; i < count; i++)
        half += 0.5 * lines[i].solid_angle;
    while (count > 0) {
        /* The middle of three distances divides most lists well. */
        double a = lines[0].distance_m, b = lines[count / 2].distance_m;
        double c = lines[count - 1].distance_m, weights[2];
        int ends[2];
        found = fmax(fmin(a, b), fmin(fmax(a, b), c));
        part_lines(ends, weights, lines, count, found);
        if (weights[0] >= half && ends[0] > 0) {
            count = ends[0];
        } else if (weights[0] + weights[1] >= half) {
            return found;
        } else {
            half -= weights[0] + weights[1];
            lines += ends[1];
            count -= ends[1];
        }
    }
    return found;
}

/* Axes of the plane at unit distance in front of the eye (pp_visible_open_part). */
struct opening_axes {
    struct pp_vec3 along, up, out;
};

static struct pp_vec3 axes_direction(const struct opening_axes *axes, double x,
                                     double y)
{
    struct pp_vec3 v = pp_vec_scale(axes->along, x);
    return pp_vec_along(pp_vec_along(v, y, axes->up), 1.0, axes->out);
}

/* Adds the range of bearings of one ring of an opening's visible part. All bearings
 * differ by less than 90 degrees from that of the opening's normal. */
static enum pp_status add_bearings(struct view_sum *sum,
                                   const struct opening_axes *axes,
                                   const struct pp_ring *ring, struct pp_error *err)
{
    const double middle = atan2(axes->out.y, axes->out.x);
    double low = INFINITY, high = -INFINITY;
    for (int i = 0; i < ring->count; i++) {
        struct pp_vec3 u = axes_direction(axes, ring->xy[i][0], ring->xy[i][1]);
        double off = remainder(atan2(u.y, u.x) - middle, 2.0 * PP_PI);
        low = fmin(low, off);
        high = fmax(high, off);
    }
    double from = fmod(middle + low + 4.0 * PP_PI, 2.0 * PP_PI);
    enum pp_status status =
        pp_array_reserve(&sum->spans, &sum->span_space, 2 * (sum->span_count + 1),
                         sizeof *sum->spans, err);
    if (status == PP_OK)
        sum->spans[sum->span_count++] = (struct bearing_span){from, from + high - low};
    return status;
}

/* True if a skyline without a distance hides the direction `to`, as seen through an
 * opening in `face`. */
static bool is_behind_skyline(const struct pp_world *world, int face, struct pp_vec3 to,
                              struct pp_vec3 out)
{
    for (int i = 0; i < world->skyline_count; i++)
        if (pp_world_skyline_is_far(&world->skylines[i], face)
            && atan2(to.z, pp_vec_dot(to, out)) < world->skylines[i].angle_rad)
            return true;
    return false;
}

/* Layer in which a line of sight from the glass ends, and its distance; INFINITY for
 * the sky and for skylines without a distance. */
static enum pp_view_layer layer_seen(double *distance_m, const struct pp_world *world,
                                     const struct pp_light_scene *scene,
                                     const struct pp_light_ray *ray, int face)
{
    struct pp_light_hit hit;
    *distance_m = INFINITY;
    if (pp_light_scene_first(scene, ray, &hit)) {
        *distance_m = hit.distance_m;
        return PP_VIEW_LANDSCAPE;
    }
    if (ray->to.z >= 0.0)
        return is_behind_skyline(world, face, ray->to, ray->off) ? PP_VIEW_LANDSCAPE
                                                                 : PP_VIEW_SKY;
    *distance_m = fmax(0.0, (ray->from.z - world->ground_level_m) / -ray->to.z);
    return ray->to.z > -sin(LANDSCAPE_RAD) ? PP_VIEW_LANDSCAPE : PP_VIEW_GROUND;
}

/* Adds the lines of sight through the visible part of an opening. *layers is set to the
 * layers in which these lines end. */
static enum pp_status add_view_lines(
    struct view_sum *sum, int *layers, const struct pp_world *world,
    const struct pp_light_scene *scene, const struct pp_opening *opening,
    struct pp_vec3 eye, const struct opening_axes *axes, const struct pp_region *part,
    int lines, struct pp_error *err)
{
    const struct pp_bounds2 bounds = pp_region_bounds(part);
    const double wide = bounds.high[0] - bounds.low[0];
    const double high = bounds.high[1] - bounds.low[1];
    const double depth_m =
        pp_vec_dot(pp_vec_sub(opening->outer.vertices[0], eye), axes->out);
    enum pp_status status =
        pp_array_reserve(&sum->lines, &sum->line_space, sum->line_count + lines,
                         sizeof *sum->lines, err);
    for (int i = 0; i < lines && status == PP_OK; i++) {
        double x = bounds.low[0] + wide * (i + 0.5) / lines;
        double y = bounds.low[1] + high * fmod(0.5 + i * GOLDEN, 1.0);
        if (!pp_region_contains(part, x, y))
            continue;
        struct pp_vec3 v = axes_direction(axes, x, y);
        struct pp_light_ray ray = {.from = pp_vec_along(eye, depth_m, v),
                                   .off = axes->out,
                                   .to = pp_vec_unit(v),
                                   .space = PP_OUTDOORS};
        double distance_m;
        enum pp_view_layer layer =
            layer_seen(&distance_m, world, scene, &ray, opening->face);
        if (distance_m < NEAR_M)
            continue;
        *layers |= layer;
        sum->lines[sum->line_count++] = (struct pp_view_line){
            distance_m, wide * high / lines * pow(1.0 + x * x + y * y, -1.5)};
    }
    return status;
}

static int count_view_layers(int layers)
{
    return (layers & PP_VIEW_SKY ? 1 : 0) + (layers & PP_VIEW_LANDSCAPE ? 1 : 0)
           + (layers & PP_VIEW_GROUND ? 1 : 0);
}

static enum pp_status add_opening_view(struct view_sum *sum, struct pp_view_out *view,
                                       const struct pp_world *world,
                                       const struct pp_light_scene *scene,
                                       const struct pp_opening *opening,
                                       struct pp_vec3 eye, int lines,
                                       struct pp_error *err)
{
    const struct opening_axes axes = {opening->along, opening->up,
                                      pp_vec_scale(opening->inner.normal, -1.0)};
    int layers = 0;
    struct pp_region part;
    enum pp_status status = pp_visible_open_part(&part, world, opening, eye, err);
    if (status != PP_OK)
        return status;
    for (int i = 0; i < part.count && status == PP_OK; i++)
        status = add_bearings(sum, &axes, &part.rings[i], err);
    if (status == PP_OK && part.count > 0)
        status = add_view_lines(sum, &layers, world, scene, opening, eye, &axes, &part,
                                lines, err);
    pp_region_clear(&part);
    view->layers |= layers;
    if (layers & PP_VIEW_LANDSCAPE && count_view_layers(layers) > view->layers_together)
        view->layers_together = count_view_layers(layers);
    return status;
}

/* True if there is no clear view through the opening, because of a blind or a measured
 * pane that scatters. */
static bool is_blurred(const struct pp_opening *opening)
{
    return opening->blind
           || (opening->measured && opening->measured->kind != PP_MEASURED_CLEAR);
}

enum pp_status pp_view_out_from(struct pp_view_out *view, const struct pp_world *world,
                                const struct pp_light_scene *scene, struct pp_vec3 eye,
                                int lines, struct pp_error *err)
{
    struct view_sum sum = {0};
    enum pp_status status = PP_OK;
    *view = (struct pp_view_out){0};
    for (int i = 0; i < world->opening_count && status == PP_OK; i++) {
        const struct pp_opening *opening = &world->openings[i];
        if (opening->glass.diffusing || is_blurred(opening)
            || -opening->inner.normal.z > RISE_MOST)
            continue;
        status = add_opening_view(&sum, view, world, scene, opening, eye, lines, err);
    }
    if (status == PP_OK) {
        view->sight_angle_rad = spans_union(sum.spans, sum.span_count);
        view->distance_m = pp_view_out_median_distance(sum.lines, sum.line_count);
    }
    free(sum.spans);
    free(sum.lines);
    return status;
}

/* Highest level whose limit the figure reaches, with a tolerance for rounding. */
static enum pp_view_level view_level_of(double figure, const double bounds[4])
{
    int level = PP_VIEW_HIGH;
    while (level > PP_VIEW_NONE && figure < bounds[level] * (1.0 - 1e-9))
        level--;
    return (enum pp_view_level)level;
}

enum pp_view_level pp_view_out_angle_level(const struct pp_view_out *view)
{
    return view_level_of(view->sight_angle_rad, pp_view_out_angle_rad);
}

enum pp_view_level pp_view_out_distance_level(const struct pp_view_out *view)
{
    return view_level_of(view->distance_m, pp_view_out_distance_m);
}

enum pp_view_level pp_view_out_layer_level(const struct pp_view_out *view)
{
    return (enum pp_view_level)view->layers_together;
}

enum pp_view_level pp_view_out_level(const struct pp_view_out *view)
{
    enum pp_view_level level = pp_view_out_angle_level(view);
    if (pp_view_out_distance_level(view) < level)
        level = pp_view_out_distance_level(view);
    if (pp_view_out_layer_level(view) < level)
        level = pp_view_out_layer_level(view);
    return level;
}
