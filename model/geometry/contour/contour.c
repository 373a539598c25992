/* contour.c - joins the crossings of a level (level_crossing.h) into curves, and joins
 * curves and parts of the region's edge into outlines. */
#include "model/geometry/contour/contour.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/array.h"
#include "model/geometry/contour/level_crossing.h"
#include "model/geometry/min_max.h"

/* True if the level may cross the triangle. Inside the triangle the function is assumed
 * to exceed the range of the three corner values by up to half of that range. */
static bool is_near(const struct pp_field *field, int triangle)
{
    const int *t = field->mesh.triangles[triangle];
    double low = INFINITY, high = -INFINITY;
    for (int i = 0; i < 3; i++) {
        double value = field->values[t[i]];
        low = pp_min(value, low);
        high = pp_max(value, high);
    }
    double more = 0.5 * (high - low);
    return low - more <= field->level && field->level <= high + more;
}

/* Halves triangles near the level down to three quarters of the coarse size (chosen by
 * trial). */
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
                status = pp_field_fill(field, err);
            if (status != PP_OK)
                return status;
            changed = true;
        }
    }
    return PP_OK;
}

/* Reserves a curve end for each edge of the mesh. Ends already found for this level
 * keep their positions; their links to crossings are cleared. */
static enum pp_status reserve_ends(struct pp_field *field, struct pp_error *err)
{
    int had = field->end_count, count = field->mesh.edge_count;
    enum pp_status status = pp_array_reserve(&field->ends, &field->end_room, count,
                                             sizeof *field->ends, err);
    if (status != PP_OK)
        return status;
    memset(field->ends + had, 0, (size_t)(count - had) * sizeof *field->ends);
    field->end_count = count;
    for (int i = 0; i < count; i++)
        field->ends[i].leaving = field->ends[i].arriving = -1;
    return PP_OK;
}

/* Finds the crossings of all triangles. Then halves triangles longer than least_m that
 * the curve leaves and re-enters. *again: there were such triangles. */
static enum pp_status cross_triangles(struct pp_field *field, double least_m,
                                      bool *again, struct pp_error *err)
{
    int count = field->mesh.triangle_count, left_count = 0;
    int *left = malloc((size_t)count * sizeof *left);
    field->crossing_count = field->between_count = 0;
    enum pp_status status = left ? reserve_ends(field, err) : pp_fail_memory(err);
    for (int t = 0; t < count && status == PP_OK; t++) {
        bool leaves;
        status = pp_level_crossing_follow(field, t, &leaves, err);
        if (leaves && pp_mesh_longest(&field->mesh, t) > least_m)
            left[left_count++] = t;
    }
    for (int i = 0; i < left_count && status == PP_OK; i++)
        status = pp_mesh_halve(&field->mesh, left[i], err);
    if (status == PP_OK && left_count > 0)
        status = pp_field_fill(field, err);
    *again = left_count > 0;
    free(left);
    return status;
}

/* Finds the crossings of a level. Triangles that the curve leaves and re-enters are
 * halved, down to 1/64 of the coarse size: at a crease of the function the curve has
 * corners. */
static enum pp_status find_crossings(struct pp_field *field, double level,
                                     struct pp_error *err)
{
    field->level = level;
    field->stamp++;
    enum pp_status status = halve_near(field, err);
    for (bool again = true; again && status == PP_OK;)
        status = cross_triangles(
            field, fmax(field->coarse / 64.0, 4.0 * field->tolerance), &again, err);
    return status;
}

/* Joins the crossings from `first` on into one curve. */
static enum pp_status join_crossings(struct pp_field *field, int first,
                                     struct pp_curve *curve, struct pp_error *err)
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
    pp_curve_add_point(curve, field->ends[field->crossings[first].from].xy);
    for (int i = first; i >= 0 && !field->crossings[i].used;) {
        struct pp_crossing *crossing = &field->crossings[i];
        crossing->used = true;
        for (int k = 0; k < crossing->count; k++)
            pp_curve_add_point(curve, field->between[crossing->first + k]);
        pp_curve_add_point(curve, field->ends[crossing->to].xy);
        curve->closed = crossing->to == field->crossings[first].from;
        i = field->ends[crossing->to].leaving;
    }
    if (curve->closed && curve->count > 1
        && memcmp(curve->xy[curve->count - 1], curve->xy[0], sizeof(double[2])) == 0)
        curve->count--;
    return PP_OK;
}

/* Adds all curves of the level, open ones first, however short. */
static enum pp_status trace_contours(struct pp_field *field, double level,
                                     struct pp_curve_list *curves, struct pp_error *err)
{
    enum pp_status status = find_crossings(field, level, err);
    for (int pass = 0; pass < 2; pass++)
        for (int i = 0; i < field->crossing_count && status == PP_OK; i++) {
            const struct pp_crossing *crossing = &field->crossings[i];
            bool begins = field->ends[crossing->from].arriving < 0;
            if (crossing->used || (pass == 0 && !begins))
                continue;
            struct pp_curve curve;
            status = join_crossings(field, i, &curve, err);
            if (status == PP_OK)
                status = pp_curve_list_add(curves, curve, err);
        }
    return status;
}

enum pp_status pp_contour_curves(struct pp_field *field, double level,
                                 struct pp_curve_list *curves, struct pp_error *err)
{
    struct pp_curve_list all = {0};
    enum pp_status status = trace_contours(field, level, &all, err);
    for (int i = 0; i < all.count; i++) {
        struct pp_curve *curve = &all.list[i];
        if (status != PP_OK || curve->count < (curve->closed ? 3 : 2)
            || pp_curve_length(curve) < 2.0 * field->tolerance)
            continue;
        status = pp_curve_list_add(curves, *curve, err);
        curve->xy = 0;
    }
    pp_curve_list_clear(&all);
    return status;
}

/* ---- outlines ---- */

/* Position on the region's edge where a curve begins or ends. */
struct boundary_end {
    int ring;
    double along; /* segment number plus fraction of the segment, from the ring's
                   * first point */
    int curve;
    bool taken;
};

/* Finds the position on the region's edge that is nearest to a point. */
static void find_landing(const struct pp_region *region, const double xy[2],
                         struct boundary_end *landing)
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
    const struct boundary_end *p = a, *q = b;
    if (p->ring != q->ring)
        return p->ring - q->ring;
    if (p->along != q->along)
        return p->along < q->along ? -1 : 1;
    return p->curve - q->curve;
}

/* First landing at or after a position on a closed ring; -1: no landing on it. */
static int next_landing(const struct boundary_end *landings, int count, int ring,
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

/* Adds the points of a ring from one position to another, in its direction. */
static enum pp_status add_arc(struct pp_curve *outline, int *room,
                              const struct pp_ring *ring, double from, double to,
                              struct pp_error *err)
{
    int first = (int)floor(from) + 1, last = (int)floor(to);
    if (to < from)
        last += ring->count;
    for (int i = first; i <= last; i++) {
        enum pp_status status = pp_array_reserve(&outline->xy, room, outline->count + 1,
                                                 sizeof *outline->xy, err);
        if (status != PP_OK)
            return status;
        pp_curve_add_point(outline, ring->xy[i % ring->count]);
    }
    return PP_OK;
}

/* Adds the points of a curve in reverse order. A reversed curve has lower values on its
 * left. */
static enum pp_status add_backwards(struct pp_curve *outline, int *room,
                                    const struct pp_curve *curve, struct pp_error *err)
{
    for (int i = curve->count - 1; i >= 0; i--) {
        enum pp_status status = pp_array_reserve(&outline->xy, room, outline->count + 1,
                                                 sizeof *outline->xy, err);
        if (status != PP_OK)
            return status;
        pp_curve_add_point(outline, curve->xy[i]);
    }
    return PP_OK;
}

/* Traces one outline: in reverse along curves, and along the region's edge from each
 * curve to the next. `ends`: sorted final points of the curves; `first`: index of the
 * final point to begin with. */
static enum pp_status trace_outline(const struct pp_field *field,
                                    const struct pp_curve_list *curves,
                                    struct boundary_end *ends, int end_count, int first,
                                    struct pp_curve_list *outlines,
                                    struct pp_error *err)
{
    struct pp_curve outline = {.level = field->level, .closed = true};
    int room = 0;
    enum pp_status status = PP_OK;
    for (int i = first; i >= 0 && !ends[i].taken && status == PP_OK;) {
        ends[i].taken = true;
        const struct pp_curve *curve = &curves->list[ends[i].curve];
        status = add_backwards(&outline, &room, curve, err);
        struct boundary_end landed = {0};
        find_landing(&field->region, curve->xy[0], &landed);
        i = next_landing(ends, end_count, landed.ring, landed.along);
        if (i >= 0 && status == PP_OK)
            status = add_arc(&outline, &room, &field->region.rings[landed.ring],
                             landed.along, ends[i].along, err);
    }
    if (status != PP_OK || outline.count < 3) {
        free(outline.xy);
        return status;
    }
    return pp_curve_list_add(outlines, outline, err);
}

static enum pp_status add_whole_outline(struct pp_curve_list *outlines, double level,
                                        const double (*xy)[2], int count,
                                        bool backwards, struct pp_error *err)
{
    struct pp_curve outline = {.level = level, .closed = true, .count = count};
    if (count < 3)
        return PP_OK;
    outline.xy = malloc((size_t)count * sizeof *outline.xy);
    if (!outline.xy)
        return pp_fail_memory(err);
    for (int i = 0; i < count; i++)
        memcpy(outline.xy[i], xy[backwards ? count - 1 - i : i], sizeof(double[2]));
    return pp_curve_list_add(outlines, outline, err);
}

enum pp_status pp_contour_below(struct pp_field *field, double level,
                                struct pp_curve_list *outlines, struct pp_error *err)
{
    struct pp_curve_list curves = {0};
    enum pp_status status = trace_contours(field, level, &curves, err);
    struct boundary_end *ends = calloc((size_t)curves.count + 1, sizeof *ends);
    if (!ends && status == PP_OK)
        status = pp_fail_memory(err);

    /* Closed curves are outlines. The ends of open curves are collected. */
    int end_count = 0;
    for (int i = 0; i < curves.count && status == PP_OK; i++) {
        const struct pp_curve *curve = &curves.list[i];
        if (curve->closed) {
            status = add_whole_outline(outlines, level, (const double(*)[2])curve->xy,
                                       curve->count, true, err);
        } else {
            ends[end_count].curve = i;
            find_landing(&field->region, curve->xy[curve->count - 1],
                         &ends[end_count++]);
        }
    }
    if (end_count)
        qsort(ends, (size_t)end_count, sizeof *ends, compare_landings);
    for (int i = 0; i < end_count && status == PP_OK; i++)
        if (!ends[i].taken)
            status = trace_outline(field, &curves, ends, end_count, i, outlines, err);

    /* Rings of the region that no curve meets are outlines if the function does not
     * exceed the level there. */
    for (int r = 0; r < field->region.count && status == PP_OK; r++) {
        const struct pp_ring *ring = &field->region.rings[r];
        bool met = false;
        for (int i = 0; i < end_count; i++)
            met = met || ends[i].ring == r;
        double value = 0.0;
        if (!met)
            status = pp_field_evaluate(field, ring->xy[0], &value, err);
        if (!met && status == PP_OK && !(value > level))
            status = add_whole_outline(outlines, level, (const double(*)[2])ring->xy,
                                       ring->count, false, err);
    }
    free(ends);
    pp_curve_list_clear(&curves);
    return status;
}
