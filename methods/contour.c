#include "methods/contour.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "methods/mesh.h"

/* Longest edge of the first triangles, over the figure's diagonal. */
#define COARSE (1.0 / 24.0)
/* The same along the figure's edge, over that: what comes in there is steepest there.
 */
#define FINE_EDGE 0.25
/* How often a chord between two crossings is halved at most. */
enum { DEEPEST = 10 };

/* A piece of a curve across one triangle, from edge to edge, higher values on its
 * left. */
struct crossing {
    int from, to;     /* edges */
    int first, count; /* points in between, in field.between */
    bool used;
};

struct end {   /* where curves leave and enter, of one edge */
    int stamp; /* of the level that the rest is about */
    double xy[2];
    int leaving, arriving; /* the crossing that begins, that ends here; -1: none */
};

struct pp_field {
    struct pp_mesh mesh;
    struct pp_region region; /* a copy */
    pp_field_function function;
    void *context;
    double tolerance, coarse;
    double *values; /* at the mesh's nodes */
    int value_count, value_room;
    long evaluations;

    /* Of the level in work. */
    double level;
    int stamp;
    struct end *ends; /* by edge */
    int end_room;
    struct crossing *crossings;
    int crossing_count, crossing_room;
    double (*between)[2];
    int between_count, between_room;
};

static enum pp_status need_room(void **list, int *room, int count, size_t size,
                                struct pp_error *err)
{
    if (count < *room)
        return PP_OK;
    int more = *room ? *room : 256;
    while (count >= more)
        more *= 2;
    void *larger = realloc(*list, (size_t)more * size);
    if (!larger)
        return pp_fail_memory(err);
    *list = larger;
    *room = more;
    return PP_OK;
}

static enum pp_status evaluate(struct pp_field *field, const double xy[2],
                               double *value, struct pp_error *err)
{
    field->evaluations++;
    return field->function(field->context, xy[0], xy[1], value, err);
}

/* Evaluates at the nodes that are new. */
static enum pp_status fill_values(struct pp_field *field, struct pp_error *err)
{
    enum pp_status status =
        need_room((void **)&field->values, &field->value_room, field->mesh.node_count,
                  sizeof *field->values, err);
    while (field->value_count < field->mesh.node_count && status == PP_OK) {
        int node = field->value_count;
        status = evaluate(field, field->mesh.nodes[node], &field->values[node], err);
        if (status == PP_OK)
            field->value_count++;
    }
    return status;
}

/* --- making --------------------------------------------------------------------------
 */

static double diagonal_of(const struct pp_region *region)
{
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    for (int r = 0; r < region->count; r++)
        for (int i = 0; i < region->rings[r].count; i++)
            for (int k = 0; k < 2; k++) {
                low[k] = fmin(low[k], region->rings[r].xy[i][k]);
                high[k] = fmax(high[k], region->rings[r].xy[i][k]);
            }
    return hypot(high[0] - low[0], high[1] - low[1]);
}

/* Has the triangle a side on the figure's edge? */
static bool is_on_edge(const struct pp_mesh *mesh, int triangle)
{
    const int *t = mesh->triangles[triangle];
    for (int i = 0; i < 3; i++) {
        const int *two =
            mesh->edges[pp_mesh_edge(mesh, t[i], t[(i + 1) % 3])].triangles;
        if (two[0] < 0 || two[1] < 0)
            return true;
    }
    return false;
}

static enum pp_status halve_coarse(struct pp_field *field, struct pp_error *err)
{
    struct pp_mesh *mesh = &field->mesh;
    enum pp_status status = PP_OK;
    for (int t = 0; t < mesh->triangle_count && status == PP_OK; t++)
        while (status == PP_OK
               && pp_mesh_longest(mesh, t)
                      > (is_on_edge(mesh, t) ? FINE_EDGE : 1.0) * field->coarse)
            status = pp_mesh_halve(mesh, t, err);
    return status;
}

enum pp_status pp_field_create(struct pp_field **field_out,
                               const struct pp_region *region,
                               pp_field_function function, void *context,
                               double tolerance, struct pp_error *err)
{
    *field_out = 0;
    if (!(tolerance > 0.0))
        return pp_fail(err, PP_BAD_INPUT,
                       "tolerance of contours is %g; it must be more than 0",
                       tolerance);
    if (region->count == 0)
        return pp_fail(err, PP_BAD_INPUT,
                       "there is nothing to draw contours on: the figure is empty");
    struct pp_field *field = calloc(1, sizeof *field);
    if (!field)
        return pp_fail_memory(err);
    field->function = function;
    field->context = context;
    field->tolerance = tolerance;
    field->coarse = COARSE * diagonal_of(region);
    enum pp_status status = pp_region_copy(&field->region, region, err);
    if (status == PP_OK)
        status = pp_mesh_create(&field->mesh, region, err);
    if (status == PP_OK)
        status = halve_coarse(field, err);
    if (status == PP_OK)
        status = fill_values(field, err);
    if (status != PP_OK) {
        pp_field_destroy(field);
        return status;
    }
    *field_out = field;
    return PP_OK;
}

void pp_field_destroy(struct pp_field *field)
{
    if (!field)
        return;
    pp_mesh_clear(&field->mesh);
    pp_region_destroy(&field->region);
    free(field->values);
    free(field->ends);
    free(field->crossings);
    free(field->between);
    free(field);
}

void pp_field_range(const struct pp_field *field, double *lowest, double lowest_xy[2],
                    double *highest, double highest_xy[2])
{
    int low = 0, high = 0;
    for (int i = 1; i < field->value_count; i++) {
        if (field->values[i] < field->values[low])
            low = i;
        if (field->values[i] > field->values[high])
            high = i;
    }
    *lowest = field->values[low];
    *highest = field->values[high];
    memcpy(lowest_xy, field->mesh.nodes[low], sizeof(double[2]));
    memcpy(highest_xy, field->mesh.nodes[high], sizeof(double[2]));
}

long pp_field_evaluations(const struct pp_field *field)
{
    return field->evaluations;
}

/* --- the level on a straight line ----------------------------------------------------
 */

/* The place between a and b, on different sides of the level by ga and gb (value less
 * level; higher is > 0), to within the tolerance. Brent's zeroin [BRE73]: secant
 * or inverse quadratic steps, halving where they don't help; it ends by a bracket, so
 * that it holds for steps too. */
static enum pp_status find_level(struct pp_field *field, const double a_xy[2],
                                 double ga, const double b_xy[2], double gb,
                                 double found[2], struct pp_error *err)
{
    double length = hypot(b_xy[0] - a_xy[0], b_xy[1] - a_xy[1]);
    double tolerance = 0.5 * field->tolerance / length;
    double a = 0.0, b = 1.0, c = 0.0, gc = ga;
    double step = 1.0, before = 1.0;
    for (;;) {
        /* b is the best so far, c on the other side of the level, a the one before. */
        if ((gb > 0.0) == (gc > 0.0)) {
            c = a;
            gc = ga;
            step = before = b - a;
        }
        if (fabs(gc) < fabs(gb)) {
            a = b, b = c, c = a;
            ga = gb, gb = gc, gc = ga;
        }
        double half = 0.5 * (c - b);
        if (!(fabs(half) > tolerance) || gb == 0.0)
            break;
        if (fabs(before) < tolerance || fabs(ga) <= fabs(gb)) {
            step = before = half;
        } else {
            double p, q, s = gb / ga;
            if (a == c) {
                p = 2.0 * half * s;
                q = 1.0 - s;
            } else {
                double r = gb / gc, t = ga / gc;
                p = s * (2.0 * half * t * (t - r) - (b - a) * (r - 1.0));
                q = (t - 1.0) * (r - 1.0) * (s - 1.0);
            }
            if (p > 0.0)
                q = -q;
            p = fabs(p);
            if (2.0 * p
                < fmin(3.0 * half * q - fabs(tolerance * q), fabs(before * q))) {
                before = step;
                step = p / q;
            } else {
                step = before = half;
            }
        }
        a = b;
        ga = gb;
        b += fabs(step) > tolerance ? step : copysign(tolerance, half);
        double xy[2], value;
        for (int k = 0; k < 2; k++)
            xy[k] = a_xy[k] + b * (b_xy[k] - a_xy[k]);
        enum pp_status status = evaluate(field, xy, &value, err);
        if (status != PP_OK)
            return status;
        gb = value - field->level;
    }
    for (int k = 0; k < 2; k++)
        found[k] = a_xy[k] + b * (b_xy[k] - a_xy[k]);
    return PP_OK;
}

/* --- one triangle --------------------------------------------------------------------
 */

/* A triangle that the level crosses: its corner A stands alone on its side. The curve
 * runs from edge AB to edge AC and is met by each ray from A to a place on BC. */
struct fan {
    const double *a, *b, *c;
    bool a_high;
};

static void between_of(const double p[2], const double q[2], double share, double xy[2])
{
    for (int k = 0; k < 2; k++)
        xy[k] = p[k] + share * (q[k] - p[k]);
}

/* Where the ray from A to BC at `share` meets the chord p q, as a share of that ray. */
static double chord_on_ray(const struct fan *fan, const double r[2], const double p[2],
                           const double q[2])
{
    double ux = r[0] - fan->a[0], uy = r[1] - fan->a[1];
    double vx = q[0] - p[0], vy = q[1] - p[1];
    double wx = p[0] - fan->a[0], wy = p[1] - fan->a[1];
    double across = ux * vy - uy * vx;
    double share = fabs(across) > 0.0 ? (wx * vy - wy * vx) / across : 0.5;
    return fmin(fmax(share, 0.0), 1.0);
}

/* The curve's place on the ray from A to r, near `guess` (a share of the ray, where the
 * chord is); *strays tells whether that is further from the chord than the tolerance.
 * Looks at the chord, a tolerance beside it, then ever further until the level lies
 * between. */
static enum pp_status find_on_ray(struct pp_field *field, const struct fan *fan,
                                  const double r[2], double guess, double found[2],
                                  bool *strays, struct pp_error *err)
{
    double length = hypot(r[0] - fan->a[0], r[1] - fan->a[1]);
    double near[2], far[2], near_value, far_value, near_step = 0.0;
    *strays = false;
    between_of(fan->a, r, guess, near);
    memcpy(found, near, sizeof near);
    if (!(length > field->tolerance))
        return PP_OK;
    enum pp_status status = evaluate(field, near, &near_value, err);
    if (status != PP_OK)
        return status;
    bool near_high = near_value > field->level;
    double way = near_high == fan->a_high ? 1.0 : -1.0; /* away from A, or towards it */

    double share = guess, step = field->tolerance / length;
    for (;;) {
        share = fmin(fmax(guess + way * step, 0.0), 1.0);
        between_of(fan->a, r, share, far);
        status = evaluate(field, far, &far_value, err);
        if (status != PP_OK)
            return status;
        if ((far_value > field->level) != near_high)
            break;
        if (share <= 0.0 || share >= 1.0)
            return PP_OK; /* no level on this ray after all: keep to the chord */
        /* A little beyond where a straight line would put the level. */
        double rise = (far_value - near_value) / (step - near_step);
        double reach = 1.2 * (field->level - far_value) / rise;
        *strays = true;
        memcpy(near, far, sizeof near);
        near_value = far_value;
        near_step = step;
        step += fmin(fmax(reach, step), 31.0 * step);
    }
    if (!*strays)
        return PP_OK;
    return find_level(field, near, near_value - field->level, far,
                      far_value - field->level, found, err);
}

static enum pp_status add_between(struct pp_field *field, const double xy[2],
                                  struct pp_error *err)
{
    enum pp_status status =
        need_room((void **)&field->between, &field->between_room, field->between_count,
                  sizeof *field->between, err);
    if (status == PP_OK)
        memcpy(field->between[field->between_count++], xy, sizeof(double[2]));
    return status;
}

/* Puts the points in that the curve needs between p, on the ray to BC at p_share, and
 * q, at q_share. */
static enum pp_status follow(struct pp_field *field, const struct fan *fan,
                             const double p[2], double p_share, const double q[2],
                             double q_share, int depth, struct pp_error *err)
{
    if (depth == 0 || hypot(q[0] - p[0], q[1] - p[1]) < 2.0 * field->tolerance)
        return PP_OK;
    double share = 0.5 * (p_share + q_share);
    double r[2], m[2];
    between_of(fan->b, fan->c, share, r);
    bool strays;
    enum pp_status status =
        find_on_ray(field, fan, r, chord_on_ray(fan, r, p, q), m, &strays, err);
    if (status != PP_OK || !strays)
        return status;
    status = follow(field, fan, p, p_share, m, share, depth - 1, err);
    if (status == PP_OK)
        status = add_between(field, m, err);
    if (status == PP_OK)
        status = follow(field, fan, m, share, q, q_share, depth - 1, err);
    return status;
}

/* The place of the level on an edge, found once. */
static enum pp_status end_on_edge(struct pp_field *field, int edge,
                                  struct pp_error *err)
{
    struct end *end = &field->ends[edge];
    if (end->stamp == field->stamp)
        return PP_OK;
    *end = (struct end){.stamp = field->stamp, .leaving = -1, .arriving = -1};
    int a = field->mesh.edges[edge].a, b = field->mesh.edges[edge].b;
    return find_level(field, field->mesh.nodes[a], field->values[a] - field->level,
                      field->mesh.nodes[b], field->values[b] - field->level, end->xy,
                      err);
}

static enum pp_status cross_triangle(struct pp_field *field, int triangle,
                                     struct pp_error *err)
{
    const int *t = field->mesh.triangles[triangle];
    bool high[3];
    for (int i = 0; i < 3; i++)
        high[i] = field->values[t[i]] > field->level;
    if (high[0] == high[1] && high[1] == high[2])
        return PP_OK;
    int alone = high[1] == high[2] ? 0 : high[2] == high[0] ? 1 : 2;
    int a = t[alone], b = t[(alone + 1) % 3], c = t[(alone + 2) % 3];

    /* Higher values are on the left: from AB to AC where A is high. */
    int from = pp_mesh_edge(&field->mesh, a, b), to = pp_mesh_edge(&field->mesh, a, c);
    struct fan fan = {field->mesh.nodes[a], field->mesh.nodes[b], field->mesh.nodes[c],
                      high[alone]};
    if (!high[alone]) {
        int other = from;
        from = to;
        to = other;
        fan.b = field->mesh.nodes[c];
        fan.c = field->mesh.nodes[b];
    }
    enum pp_status status = end_on_edge(field, from, err);
    if (status == PP_OK)
        status = end_on_edge(field, to, err);
    if (status == PP_OK)
        status = need_room((void **)&field->crossings, &field->crossing_room,
                           field->crossing_count, sizeof *field->crossings, err);
    if (status != PP_OK)
        return status;
    int first = field->between_count;
    status = follow(field, &fan, field->ends[from].xy, 0.0, field->ends[to].xy, 1.0,
                    DEEPEST, err);
    field->ends[from].leaving = field->ends[to].arriving = field->crossing_count;
    field->crossings[field->crossing_count++] =
        (struct crossing){from, to, first, field->between_count - first, false};
    return status;
}

/* --- one level -----------------------------------------------------------------------
 */

/* Could the level cross the triangle, or come near it? */
static bool is_near(const struct pp_field *field, int triangle)
{
    const int *t = field->mesh.triangles[triangle];
    double low = INFINITY, high = -INFINITY;
    for (int i = 0; i < 3; i++) {
        low = fmin(low, field->values[t[i]]);
        high = fmax(high, field->values[t[i]]);
    }
    double more = 0.5 * (high - low);
    return low - more <= field->level && field->level <= high + more;
}

/* Halves triangles near the level down to three quarters of the coarse size. */
static enum pp_status halve_near(struct pp_field *field, struct pp_error *err)
{
    bool changed = true;
    while (changed) {
        changed = false;
        for (int t = 0; t < field->mesh.triangle_count; t++) {
            if (!is_near(field, t)
                || pp_mesh_longest(&field->mesh, t) <= 0.75 * field->coarse)
                continue;
            enum pp_status status = pp_mesh_halve(&field->mesh, t, err);
            if (status == PP_OK)
                status = fill_values(field, err);
            if (status != PP_OK)
                return status;
            changed = true;
        }
    }
    return PP_OK;
}

static enum pp_status find_crossings(struct pp_field *field, double level,
                                     struct pp_error *err)
{
    field->level = level;
    field->stamp++;
    field->crossing_count = field->between_count = 0;
    enum pp_status status = halve_near(field, err);
    if (status != PP_OK)
        return status;
    int had = field->end_room;
    status = need_room((void **)&field->ends, &field->end_room, field->mesh.edge_count,
                       sizeof *field->ends, err);
    if (status != PP_OK)
        return status;
    memset(field->ends + had, 0, (size_t)(field->end_room - had) * sizeof *field->ends);
    for (int t = 0; t < field->mesh.triangle_count && status == PP_OK; t++)
        status = cross_triangle(field, t, err);
    return status;
}

/* Adds a point unless it is the one before. */
static void add_point(struct pp_curve *curve, const double xy[2])
{
    if (curve->count && memcmp(curve->xy[curve->count - 1], xy, sizeof(double[2])) == 0)
        return;
    memcpy(curve->xy[curve->count++], xy, sizeof(double[2]));
}

/* Joins the crossings from `first` on to one curve. */
static enum pp_status join(struct pp_field *field, int first, struct pp_curve *curve,
                           struct pp_error *err)
{
    int room = 2;
    for (int i = first; i >= 0; i = field->ends[field->crossings[i].to].leaving) {
        room += 1 + field->crossings[i].count;
        if (field->crossings[i].to == field->crossings[first].from)
            break;
    }
    *curve = (struct pp_curve){.level = field->level};
    curve->xy = malloc((size_t)room * sizeof *curve->xy);
    if (!curve->xy)
        return pp_fail_memory(err);
    add_point(curve, field->ends[field->crossings[first].from].xy);
    for (int i = first; i >= 0 && !field->crossings[i].used;) {
        struct crossing *crossing = &field->crossings[i];
        crossing->used = true;
        for (int k = 0; k < crossing->count; k++)
            add_point(curve, field->between[crossing->first + k]);
        add_point(curve, field->ends[crossing->to].xy);
        curve->closed = crossing->to == field->crossings[first].from;
        i = field->ends[crossing->to].leaving;
    }
    if (curve->closed && curve->count > 1
        && memcmp(curve->xy[curve->count - 1], curve->xy[0], sizeof(double[2])) == 0)
        curve->count--;
    return PP_OK;
}

static enum pp_status add_curve(struct pp_curves *curves, struct pp_curve curve,
                                struct pp_error *err)
{
    struct pp_curve *list =
        realloc(curves->list, (size_t)(curves->count + 1) * sizeof *list);
    if (!list) {
        free(curve.xy);
        return pp_fail_memory(err);
    }
    curves->list = list;
    list[curves->count++] = curve;
    return PP_OK;
}

/* All curves of the level, open ones first, the least of them too. */
static enum pp_status trace(struct pp_field *field, double level,
                            struct pp_curves *curves, struct pp_error *err)
{
    enum pp_status status = find_crossings(field, level, err);
    for (int pass = 0; pass < 2; pass++)
        for (int i = 0; i < field->crossing_count && status == PP_OK; i++) {
            const struct crossing *crossing = &field->crossings[i];
            bool begins = field->ends[crossing->from].arriving < 0;
            if (crossing->used || (pass == 0 && !begins))
                continue;
            struct pp_curve curve;
            status = join(field, i, &curve, err);
            if (status == PP_OK)
                status = add_curve(curves, curve, err);
        }
    return status;
}

enum pp_status pp_field_contour(struct pp_field *field, double level,
                                struct pp_curves *curves, struct pp_error *err)
{
    struct pp_curves all = {0};
    enum pp_status status = trace(field, level, &all, err);
    for (int i = 0; i < all.count; i++) {
        struct pp_curve *curve = &all.list[i];
        if (status != PP_OK || curve->count < (curve->closed ? 3 : 2)
            || pp_curve_length(curve) < 2.0 * field->tolerance)
            continue;
        status = add_curve(curves, *curve, err);
        curve->xy = 0;
    }
    pp_curves_clear(&all);
    return status;
}

/* --- what lies below a level ---------------------------------------------------------
 */

/* Where on the figure's edge a curve begins or ends. */
struct landing {
    int ring;
    double along; /* the ring, from its first point: segment number + share of it */
    int curve;
    bool taken;
};

static void land(const struct pp_region *region, const double xy[2],
                 struct landing *landing)
{
    double nearest = INFINITY;
    for (int r = 0; r < region->count; r++)
        for (int i = 0; i < region->rings[r].count; i++) {
            const double *a = region->rings[r].xy[i];
            const double *b = region->rings[r].xy[(i + 1) % region->rings[r].count];
            double dx = b[0] - a[0], dy = b[1] - a[1];
            double share = ((xy[0] - a[0]) * dx + (xy[1] - a[1]) * dy)
                           / fmax(dx * dx + dy * dy, DBL_MIN);
            share = fmin(fmax(share, 0.0), 1.0);
            double off = hypot(a[0] + share * dx - xy[0], a[1] + share * dy - xy[1]);
            if (off < nearest) {
                nearest = off;
                landing->ring = r;
                landing->along = i + share;
            }
        }
}

static int compare_landings(const void *a, const void *b)
{
    const struct landing *p = a, *q = b;
    if (p->ring != q->ring)
        return p->ring - q->ring;
    if (p->along != q->along)
        return p->along < q->along ? -1 : 1;
    return p->curve - q->curve;
}

/* The first landing at or after a place on a ring, round and round; -1: none left. */
static int next_landing(const struct landing *landings, int count, int ring,
                        double along)
{
    int round = -1;
    for (int i = 0; i < count; i++) {
        if (landings[i].ring != ring)
            continue;
        if (landings[i].along >= along)
            return i;
        if (round < 0)
            round = i;
    }
    return round;
}

/* Adds a ring's points from one place on it to another, in its direction. */
static enum pp_status add_arc(struct pp_curve *outline, int *room,
                              const struct pp_ring *ring, double from, double to,
                              struct pp_error *err)
{
    int first = (int)floor(from) + 1, last = (int)floor(to);
    if (to < from)
        last += ring->count;
    for (int i = first; i <= last; i++) {
        enum pp_status status = need_room((void **)&outline->xy, room, outline->count,
                                          sizeof *outline->xy, err);
        if (status != PP_OK)
            return status;
        add_point(outline, ring->xy[i % ring->count]);
    }
    return PP_OK;
}

/* Adds a curve's points from its end to its beginning: lower values on the left. */
static enum pp_status add_backwards(struct pp_curve *outline, int *room,
                                    const struct pp_curve *curve, struct pp_error *err)
{
    for (int i = curve->count - 1; i >= 0; i--) {
        enum pp_status status = need_room((void **)&outline->xy, room, outline->count,
                                          sizeof *outline->xy, err);
        if (status != PP_OK)
            return status;
        add_point(outline, curve->xy[i]);
    }
    return PP_OK;
}

/* One outline: along curves backwards, and where one lands on the figure's edge, along
 * that to the next. `ends` are the curves' ends (where they set out, backwards),
 * sorted; `first` is where to begin. */
static enum pp_status walk(const struct pp_field *field, const struct pp_curves *curves,
                           struct landing *ends, int end_count, int first,
                           struct pp_curves *outlines, struct pp_error *err)
{
    struct pp_curve outline = {.level = field->level, .closed = true};
    int room = 0;
    enum pp_status status = PP_OK;
    for (int i = first; i >= 0 && !ends[i].taken && status == PP_OK;) {
        ends[i].taken = true;
        const struct pp_curve *curve = &curves->list[ends[i].curve];
        status = add_backwards(&outline, &room, curve, err);
        struct landing landed = {0};
        land(&field->region, curve->xy[0], &landed);
        i = next_landing(ends, end_count, landed.ring, landed.along);
        if (i >= 0 && status == PP_OK)
            status = add_arc(&outline, &room, &field->region.rings[landed.ring],
                             landed.along, ends[i].along, err);
    }
    if (status != PP_OK || outline.count < 3) {
        free(outline.xy);
        return status;
    }
    return add_curve(outlines, outline, err);
}

static enum pp_status add_whole(struct pp_curves *outlines, double level,
                                const double (*xy)[2], int count, bool backwards,
                                struct pp_error *err)
{
    struct pp_curve outline = {.level = level, .closed = true, .count = count};
    if (count < 3)
        return PP_OK;
    outline.xy = malloc((size_t)count * sizeof *outline.xy);
    if (!outline.xy)
        return pp_fail_memory(err);
    for (int i = 0; i < count; i++)
        memcpy(outline.xy[i], xy[backwards ? count - 1 - i : i], sizeof(double[2]));
    return add_curve(outlines, outline, err);
}

enum pp_status pp_field_below(struct pp_field *field, double level,
                              struct pp_curves *outlines, struct pp_error *err)
{
    struct pp_curves curves = {0};
    enum pp_status status = trace(field, level, &curves, err);
    struct landing *ends = calloc((size_t)curves.count + 1, sizeof *ends);
    if (!ends && status == PP_OK)
        status = pp_fail_memory(err);

    /* Closed curves are outlines by themselves; of open ones, gather the ends. */
    int end_count = 0;
    for (int i = 0; i < curves.count && status == PP_OK; i++) {
        const struct pp_curve *curve = &curves.list[i];
        if (curve->closed) {
            status = add_whole(outlines, level, (const double(*)[2])curve->xy,
                               curve->count, true, err);
        } else {
            ends[end_count].curve = i;
            land(&field->region, curve->xy[curve->count - 1], &ends[end_count++]);
        }
    }
    if (end_count)
        qsort(ends, (size_t)end_count, sizeof *ends, compare_landings);
    for (int i = 0; i < end_count && status == PP_OK; i++)
        if (!ends[i].taken)
            status = walk(field, &curves, ends, end_count, i, outlines, err);

    /* Edges of the figure that no curve meets are outlines where they are low. */
    for (int r = 0; r < field->region.count && status == PP_OK; r++) {
        const struct pp_ring *ring = &field->region.rings[r];
        bool met = false;
        for (int i = 0; i < end_count; i++)
            met = met || ends[i].ring == r;
        double value = 0.0;
        if (!met)
            status = evaluate(field, ring->xy[0], &value, err);
        if (!met && status == PP_OK && !(value > level))
            status = add_whole(outlines, level, (const double(*)[2])ring->xy,
                               ring->count, false, err);
    }
    free(ends);
    pp_curves_clear(&curves);
    return status;
}
