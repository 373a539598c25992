/* waldram_squares.c - draws outlines on the diagram by bisecting their edges, and adds
 * up the areas below their edges square by square. */
#include "methods/waldram/waldram_squares.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/array.h"
#include "model/geometry/min_max.h"

enum { DEEPEST = 12 }; /* halvings of one straight edge */

/* Largest distance, in squares, from the middle of a chord to the middle of its edge
 * before a triangle is added. With a quarter of this distance, the sums of overlays
 * change by at most 1e-4, relative. */
static const double NEAR = 0.008;

/* Tolerance within which an edge counts as vertical, relative to the width of a
 * square. */
static const double PLUMB = 1e-9;

void pp_waldram_squares_size(const struct pp_waldram *waldram, double *width,
                             double *height)
{
    *width = 2.0 * pp_waldram_scale_x(waldram, PP_PI / 2.0) / PP_WALDRAM_COLUMNS;
    *height = PP_WALDRAM_WORTH / *width;
}

/* A line under construction. */
struct droop_polyline {
    double (*xy)[2];
    int count, capacity;
    bool failed;
};

static void add_point(struct droop_polyline *line, double x, double y)
{
    if (pp_array_reserve(&line->xy, &line->capacity, line->count + 1, sizeof *line->xy,
                         NULL)
        != PP_OK) {
        line->failed = true;
        return;
    }
    line->xy[line->count][0] = x;
    line->xy[line->count][1] = y;
    line->count++;
}

/* A point of the diagram, with its azimuth, which may exceed 180 degrees. */
struct diagram_point {
    double azimuth, x, y;
};

struct mapping {
    const struct pp_waldram *waldram;
    double width, height; /* size of a square */
};

/* The point of direction u (right, ahead, up), with an azimuth within 180 degrees of
 * `near`. */
static struct diagram_point diagram_point_of(const struct mapping *mapping,
                                             struct pp_vec3 u, double near)
{
    double azimuth = u.x == 0.0 && u.y == 0.0 ? near : atan2(u.x, u.y);
    azimuth += 2.0 * PP_PI * round((near - azimuth) / (2.0 * PP_PI));
    return (struct diagram_point){azimuth,
                                  pp_waldram_scale_x(mapping->waldram, azimuth),
                                  pp_waldram_scale_y_toward(mapping->waldram, u)};
}

/* Adds the points after `from` up to `to` of the straight edge from direction a to b.
 * The edge is halved until the middle of a chord is near the middle of the edge; a
 * vertical edge is its own chord. Between the last chord and the edge a triangle of
 * equal area is added (a parabola fills 2/3 of its box, a triangle 1/2, so that the
 * triangle needs 4/3 of the height); counts then have no bias. */
static void add_droop_edge(struct droop_polyline *line, const struct mapping *mapping,
                           struct pp_vec3 a, struct diagram_point from,
                           struct pp_vec3 b, struct diagram_point to, int depth)
{
    struct pp_vec3 middle = pp_vec_scale(pp_vec_add(a, b), 0.5);
    struct diagram_point half = diagram_point_of(mapping, middle, from.azimuth);
    double run = (to.x - from.x) / mapping->width;
    double dx = (half.x - (from.x + to.x) / 2.0) / mapping->width;
    double dy = (half.y - (from.y + to.y) / 2.0) / mapping->height;
    if (fabs(run) < PLUMB && fabs(dx) < PLUMB) {
        add_point(line, to.x, to.y);
        return;
    }
    if (depth < DEEPEST && (fabs(run) > 4.0 || dx * dx + dy * dy > NEAR * NEAR)) {
        add_droop_edge(line, mapping, a, from, middle, half, depth + 1);
        add_droop_edge(line, mapping, middle, half, b, to, depth + 1);
        return;
    }
    add_point(line, half.x + dx / 3.0 * mapping->width,
              half.y + dy / 3.0 * mapping->height);
    add_point(line, to.x, to.y);
}

static struct droop_polyline ring_outline(const struct mapping *mapping,
                                          const struct pp_window_axes *axes,
                                          const struct pp_ring *ring)
{
    struct droop_polyline line = {0};
    struct pp_vec3 last = {0.0, 0.0, 0.0};
    struct diagram_point first = {0}, from = {0};
    for (int i = 0; i <= ring->count; i++) {
        struct pp_vec3 here = pp_waldram_scale_direction(mapping->waldram, axes,
                                                         ring->xy[i % ring->count]);
        if (i == 0) {
            from = first = diagram_point_of(mapping, here, 0.0);
            add_point(&line, first.x, first.y);
        } else {
            /* The far end's azimuth is continued from the near end's through the edge's
             * middle, so that it does not jump by 360 degrees. */
            struct pp_vec3 middle = pp_vec_scale(pp_vec_add(last, here), 0.5);
            struct diagram_point half = diagram_point_of(mapping, middle, from.azimuth);
            struct diagram_point to = diagram_point_of(mapping, here, half.azimuth);
            if (last.z * here.z < 0.0) {
                double t = last.z / (last.z - here.z);
                struct pp_vec3 cut = pp_vec_along(last, t, pp_vec_sub(here, last));
                struct diagram_point at = diagram_point_of(mapping, cut, from.azimuth);
                add_droop_edge(&line, mapping, last, from, cut, at, 0);
                add_droop_edge(&line, mapping, cut, at, here, to, 0);
            } else {
                add_droop_edge(&line, mapping, last, from, here, to, 0);
            }
            from = to;
        }
        last = here;
    }
    if (fabs(from.azimuth - first.azimuth) > PP_PI) {
        /* The outline goes once around the zenith: the region extends up to the top. */
        double top = pp_waldram_scale_y(mapping->waldram, PP_PI / 2.0);
        add_point(&line, from.x, top);
        add_point(&line, first.x, top);
    } else if (line.count > 0) {
        line.count--; /* the last point repeats the first */
    }
    return line;
}

enum pp_status pp_waldram_squares_outline(struct pp_region *outline,
                                          const struct pp_waldram *waldram,
                                          const struct pp_window_axes *axes,
                                          const struct pp_region *region,
                                          struct pp_error *err)
{
    struct mapping mapping = {.waldram = waldram};
    pp_waldram_squares_size(waldram, &mapping.width, &mapping.height);
    *outline = (struct pp_region){0};
    if (region->count == 0)
        return PP_OK;
    outline->rings = calloc(region->count, sizeof *outline->rings);
    if (!outline->rings)
        return pp_fail_memory(err);
    for (int r = 0; r < region->count; r++) {
        struct droop_polyline line = ring_outline(&mapping, axes, &region->rings[r]);
        outline->rings[outline->count++] = (struct pp_ring){line.count, line.xy};
        if (line.failed) {
            pp_region_clear(outline);
            return pp_fail_memory(err);
        }
    }
    return PP_OK;
}

/* Mean height of an edge from y0 to y1 above a square's lower side, clamped to the
 * square. */
static double mean_within(double y0, double y1, double height)
{
    double low = pp_min(y0, y1), high = pp_max(y0, y1);
    double from = pp_clamp(low, 0.0, height), to = pp_clamp(high, 0.0, height);
    if (!(to > from))
        return from;
    return ((to - from) * (from + to) / 2.0 + pp_max(high - height, 0.0) * height)
           / (high - low);
}

/* The squares that a region may cover: rows from 0, columns from `first`. */
struct square_field {
    int first, columns, rows;
    double width, height; /* size of a square */
    double *parts;        /* the area within each square, column by column */
};

/* Adds to each square of a column the area below the edge from p to q, negative if the
 * edge runs to the right. */
static void add_below(struct square_field *field, int column, const double *p,
                      const double *q)
{
    double left = column * field->width, right = (column + 1) * field->width;
    double from = pp_clamp(p[0], left, right), to = pp_clamp(q[0], left, right);
    if (from == to)
        return;
    double rise = q[1] - p[1], run = q[0] - p[0], height = field->height;
    double y0 = p[1] + (from - p[0]) / run * rise;
    double y1 = p[1] + (to - p[0]) / run * rise;
    double top = pp_max(y0, y1), bottom = pp_min(y0, y1);
    double *parts = field->parts + (column - field->first) * field->rows;
    int row = 0;
    for (; row < field->rows && bottom - row * height >= height; row++)
        parts[row] += (from - to) * height;
    for (; row < field->rows && row * height < top; row++)
        parts[row] +=
            (from - to) * mean_within(y0 - row * height, y1 - row * height, height);
}

/* Column that contains x; faster than floor(). */
static int square_column(const struct square_field *field, double x)
{
    double columns = x / field->width;
    int whole = (int)columns;
    return whole - (columns < whole);
}

/* Adds the area of a ring to the squares: by Green's theorem the sum of the areas below
 * its edges. */
static void add_ring_squares(struct square_field *field, const struct pp_ring *ring)
{
    int end = field->first + field->columns;
    int from = ring->count > 0 ? square_column(field, ring->xy[0][0]) : 0;
    for (int i = 0; i < ring->count; i++) {
        const double *p = ring->xy[i], *q = ring->xy[i + 1 < ring->count ? i + 1 : 0];
        int to = square_column(field, q[0]);
        int first = from < to ? from : to, last = from < to ? to : from;
        for (int k = first > field->first ? first : field->first; k <= last && k < end;
             k++)
            add_below(field, k, p, q);
        from = to;
    }
}

/* Estimates one column's squares and appends those that are covered at least in part;
 * *carried is the sum of the rounding errors so far. */
static bool count_column(struct pp_waldram_count *count, double *carried,
                         const double *parts, int rows, int column, double square)
{
    for (int row = 0; row < rows; row++) {
        double part = parts[row] / square;
        if (part < 1e-9)
            continue;
        double wanted = part + *carried;
        double estimated = part > 1.0 - 1e-9 ? 1.0 : round(wanted * 10.0) / 10.0;
        estimated = fmin(fmax(estimated, 0.0), 1.0);
        *carried = wanted - estimated;
        if (pp_array_append(&count->list, count->count, sizeof *count->list, NULL)
            != PP_OK)
            return false;
        count->list[count->count++] =
            (struct pp_waldram_square){column, row, part, estimated};
        count->squares += estimated;
    }
    return true;
}

enum pp_status pp_waldram_squares_count_outline(struct pp_waldram_count *count,
                                                const struct pp_waldram *waldram,
                                                const struct pp_region *outline,
                                                struct pp_error *err)
{
    *count = (struct pp_waldram_count){0};
    struct square_field field = {0};
    double low = INFINITY, high = -INFINITY;
    pp_waldram_squares_size(waldram, &field.width, &field.height);
    field.rows = (int)ceil(pp_waldram_scale_y(waldram, PP_PI / 2.0) / field.height);
    for (int r = 0; r < outline->count; r++)
        for (int i = 0; i < outline->rings[r].count; i++) {
            double x = outline->rings[r].xy[i][0];
            low = pp_min(x, low);
            high = pp_max(x, high);
        }

    if (low < high) { /* else nothing is visible */
        field.first = (int)floor(low / field.width);
        field.columns = (int)ceil(high / field.width) - field.first;
    }
    field.parts = calloc((size_t)(field.columns * field.rows) + 1, sizeof *field.parts);
    bool ok = field.parts != NULL;
    double carried = 0.0;
    for (int r = 0; ok && r < outline->count; r++)
        add_ring_squares(&field, &outline->rings[r]);
    for (int k = 0; ok && k < field.columns; k++)
        ok = count_column(count, &carried, field.parts + k * field.rows, field.rows,
                          field.first + k, field.width * field.height);
    free(field.parts);
    if (ok)
        return PP_OK;
    pp_waldram_squares_clear(count);
    return pp_fail_memory(err);
}

enum pp_status pp_waldram_squares_count(struct pp_waldram_count *count,
                                        const struct pp_waldram *waldram,
                                        const struct pp_window_axes *axes,
                                        const struct pp_region *region,
                                        struct pp_error *err)
{
    *count = (struct pp_waldram_count){0};
    struct pp_region outline;
    enum pp_status status =
        pp_waldram_squares_outline(&outline, waldram, axes, region, err);
    if (status == PP_OK)
        status = pp_waldram_squares_count_outline(count, waldram, &outline, err);
    pp_region_clear(&outline);
    return status;
}

void pp_waldram_squares_clear(struct pp_waldram_count *count)
{
    free(count->list);
    *count = (struct pp_waldram_count){0};
}
