/* field.c - see field.h. */
#include "model/geometry/contour/field.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/array.h"

/* Longest edge of the initial triangles divided by the region's diagonal; chosen by
 * trial. */
#define COARSE (1.0 / 24.0)
/* Longest side of a triangle on the region's edge, as a fraction of the longest side
 * elsewhere: light changes most next to windows. Without this limit, the highest level
 * in a hall of 100 m was missed. */
#define FINE_EDGE 0.25

enum pp_status pp_field_evaluate(struct pp_field *field, const double xy[2],
                                 double *value, struct pp_error *err)
{
    if (pp_known_values_find(&field->known, xy, value))
        return PP_OK;
    field->evaluations++;
    enum pp_status status = field->function(field->context, xy[0], xy[1], value, err);
    return status == PP_OK ? pp_known_values_add(&field->known, xy, *value, err)
                           : status;
}

enum pp_status pp_field_fill(struct pp_field *field, struct pp_error *err)
{
    enum pp_status status =
        pp_array_reserve(&field->values, &field->value_room, field->mesh.node_count,
                         sizeof *field->values, err);
    while (field->value_count < field->mesh.node_count && status == PP_OK) {
        int node = field->value_count;
        status = pp_field_evaluate(field, field->mesh.nodes[node], &field->values[node],
                                   err);
        if (status == PP_OK)
            field->value_count++;
    }
    return status;
}

static double diagonal_of(const struct pp_region *region)
{
    struct pp_bounds2 bounds = pp_region_bounds(region);
    return hypot(bounds.high[0] - bounds.low[0], bounds.high[1] - bounds.low[1]);
}

/* True if the triangle has a side on the region's edge. */
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
                       "the tolerance for contours is %g; expected more than 0",
                       tolerance);
    if (region->count == 0)
        return pp_fail(err, PP_BAD_INPUT, "there is no area for the contours");
    struct pp_field *field = calloc(1, sizeof *field);
    if (!field)
        return pp_fail_memory(err);
    field->function = function;
    field->context = context;
    field->tolerance = tolerance;
    field->coarse = COARSE * diagonal_of(region);
    enum pp_status status = pp_region_copy(&field->region, region, err);
    if (status == PP_OK)
        status = pp_mesh_init(&field->mesh, region, err);
    if (status == PP_OK)
        status = halve_coarse(field, err);
    if (status == PP_OK)
        status = pp_field_fill(field, err);
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
    pp_region_clear(&field->region);
    free(field->values);
    pp_known_values_clear(&field->known);
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

double pp_field_share_below(const struct pp_field *field, double level)
{
    double below = 0.0, all = 0.0;
    for (int t = 0; t < field->mesh.triangle_count; t++) {
        const int *corner = field->mesh.triangles[t];
        const double *a = field->mesh.nodes[corner[0]];
        const double *b = field->mesh.nodes[corner[1]];
        const double *c = field->mesh.nodes[corner[2]];
        double area =
            0.5 * fabs((b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]));
        double mean = (field->values[corner[0]] + field->values[corner[1]]
                       + field->values[corner[2]])
                      / 3.0;
        all += area;
        below += mean < level ? area : 0.0;
    }
    return all > 0.0 ? below / all : 0.0;
}

long pp_field_evaluations(const struct pp_field *field)
{
    return field->evaluations;
}
