#include "model/geometry/contour/contour.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model/geometry/contour/field.h"

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
                status = pp_field_fill(field, err);
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
    status = pp_field_reserve((void **)&field->ends, &field->end_room,
                              field->mesh.edge_count, sizeof *field->ends, err);
    if (status != PP_OK)
        return status;
    memset(field->ends + had, 0, (size_t)(field->end_room - had) * sizeof *field->ends);
    for (int t = 0; t < field->mesh.triangle_count && status == PP_OK; t++)
        status = pp_level_crossing_follow(field, t, err);
    return status;
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

enum pp_status pp_contour_trace(struct pp_field *field, double level,
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
            status = join(field, i, &curve, err);
            if (status == PP_OK)
                status = pp_curve_list_add(curves, curve, err);
        }
    return status;
}

enum pp_status pp_contour_curves(struct pp_field *field, double level,
                                 struct pp_curve_list *curves, struct pp_error *err)
{
    struct pp_curve_list all = {0};
    enum pp_status status = pp_contour_trace(field, level, &all, err);
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
