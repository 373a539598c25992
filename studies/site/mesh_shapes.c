/* mesh_shapes.c - see mesh_shapes.h. Vertical triangles are seen only as lines. All
 * other triangles are oriented counter-clockwise as seen from above. An edge shared by
 * two triangles of a part then occurs in both directions, and the other edges bound the
 * part. */
#include "studies/site/mesh_shapes.h"

#include <math.h>
#include <stdlib.h>

#include "model/base/array.h"

static const double SAME_M = 1e-3;     /* corners closer than this are treated as
                                        * equal */
static const double STRAIGHT_M = 1e-4; /* a corner closer than this to the line between
                                        * its neighbours is omitted */
static const double UPRIGHT = 1e-3;    /* a triangle is vertical if z of its normal is
                                        * below this */
static const double BEND_RAD = 20 * PP_RAD; /* smallest bend that is drawn as an edge */
static const double PLANE_RAD = 0.5 * PP_RAD;
static const double RISE_M = 2.0, PLANE_RISE_M = 10.0;

struct mesh_corner {
    struct pp_vec3 at;
    int user; /* 3 x index of the triangle + number of its corner */
};

struct mesh_triangle {
    int corners[3]; /* indices in `places` */
    struct pp_vec3 normal;
    bool is_upright;
    int part; /* index of the parent in the tree of the part; a root is its own
               * parent */
    /* Valid only for roots: size and other properties of the part. */
    int size;
    bool is_plane;
    double low_m, high_m;
};

/* Edge of a triangle, between two places. */
struct mesh_edge {
    int low, high; /* indices in `places`, low < high */
    int triangle;
    bool forwards;  /* runs from low to high in its triangle */
    bool is_unseen; /* on the outline of a part, but not drawn */
};

struct mesh_parts {
    struct mesh_corner *users;
    struct pp_vec3 *places;
    struct mesh_triangle *triangles;
    struct mesh_edge *edges, *bounds; /* bounds: edges on the outlines of parts */
    int triangle_count, place_count, edge_count, bound_count;
};

/* ---- triangles that share corners ---- */

static long step_of(double x)
{
    return lround(x / SAME_M);
}

static int by_place(const void *left, const void *right)
{
    const struct mesh_corner *a = left, *b = right;
    const double p[3] = {a->at.x, a->at.y, a->at.z}, q[3] = {b->at.x, b->at.y, b->at.z};
    for (int k = 0; k < 3; k++) {
        long from = step_of(p[k]), to = step_of(q[k]);
        if (from != to)
            return from < to ? -1 : 1;
    }
    return (a->user > b->user) - (a->user < b->user);
}

static bool same_place(struct pp_vec3 a, struct pp_vec3 b)
{
    return step_of(a.x) == step_of(b.x) && step_of(a.y) == step_of(b.y)
           && step_of(a.z) == step_of(b.z);
}

static void number_places(struct mesh_parts *parts)
{
    int count = 3 * parts->triangle_count;
    if (count > 0)
        qsort(parts->users, (size_t)count, sizeof *parts->users, by_place);
    for (int i = 0; i < count; i++) {
        const struct mesh_corner *corner = &parts->users[i];
        if (i == 0 || !same_place(corner->at, parts->users[i - 1].at))
            parts->places[parts->place_count++] = corner->at;
        parts->triangles[corner->user / 3].corners[corner->user % 3] =
            parts->place_count - 1;
    }
}

/* Orients a triangle counter-clockwise from above. */
static void settle_triangle(struct mesh_parts *parts, int index)
{
    struct mesh_triangle *triangle = &parts->triangles[index];
    struct pp_vec3 p[3];
    for (int k = 0; k < 3; k++)
        p[k] = parts->places[triangle->corners[k]];
    triangle->normal =
        pp_vec_unit(pp_vec_cross(pp_vec_sub(p[1], p[0]), pp_vec_sub(p[2], p[0])));
    triangle->is_upright = fabs(triangle->normal.z) < UPRIGHT;
    triangle->part = index;
    triangle->size = 1;
    triangle->is_plane = true;
    triangle->low_m = fmin(p[0].z, fmin(p[1].z, p[2].z));
    triangle->high_m = fmax(p[0].z, fmax(p[1].z, p[2].z));
    if (triangle->normal.z < 0.0 && !triangle->is_upright) {
        int corner = triangle->corners[1];
        triangle->corners[1] = triangle->corners[2];
        triangle->corners[2] = corner;
        triangle->normal = pp_vec_scale(triangle->normal, -1.0);
    }
}

static int by_edge(const void *left, const void *right)
{
    const struct mesh_edge *a = left, *b = right;
    if (a->low != b->low)
        return a->low < b->low ? -1 : 1;
    if (a->high != b->high)
        return a->high < b->high ? -1 : 1;
    return (a->triangle > b->triangle) - (a->triangle < b->triangle);
}

static void find_edges(struct mesh_parts *parts)
{
    for (int i = 0; i < parts->triangle_count; i++) {
        const int *corners = parts->triangles[i].corners;
        bool empty = corners[0] == corners[1] || corners[1] == corners[2]
                     || corners[2] == corners[0];
        if (empty)
            continue;
        settle_triangle(parts, i);
        for (int k = 0; k < 3; k++) {
            int from = corners[k], to = corners[(k + 1) % 3];
            parts->edges[parts->edge_count++] = (struct mesh_edge){
                from < to ? from : to, from < to ? to : from, i, from < to, false};
        }
    }
    if (parts->edge_count > 0)
        qsort(parts->edges, (size_t)parts->edge_count, sizeof *parts->edges, by_edge);
}

/* ---- parts ---- */

static int root_of(struct mesh_parts *parts, int triangle)
{
    struct mesh_triangle *list = parts->triangles;
    while (list[triangle].part != triangle) {
        list[triangle].part = list[list[triangle].part].part;
        triangle = list[triangle].part;
    }
    return triangle;
}

/* True if the common edge of two triangles, given as a pair of edges, need not be
 * drawn. */
static bool is_smooth(const struct mesh_parts *parts, const struct mesh_edge *pair)
{
    const struct mesh_triangle *a = &parts->triangles[pair[0].triangle];
    const struct mesh_triangle *b = &parts->triangles[pair[1].triangle];
    return !a->is_upright && !b->is_upright && pair[0].forwards != pair[1].forwards
           && pp_vec_dot(a->normal, b->normal) > cos(BEND_RAD);
}

/* Greatest permitted rise (m) of the part made by joining two parts, given by their
 * roots. The rise may be greater for parts in a common plane, since only bent parts are
 * cut at a small rise. */
static double rise_of(const struct mesh_triangle *a, const struct mesh_triangle *b)
{
    return pp_vec_dot(a->normal, b->normal) > cos(PLANE_RAD) && a->is_plane
                   && b->is_plane
               ? PLANE_RISE_M
               : RISE_M;
}

/* Joins two parts, unless the rise of the result would be too great. The root of the
 * larger part remains. */
static void join_mesh_parts(struct mesh_parts *parts, const struct mesh_edge *pair)
{
    int one = root_of(parts, pair[0].triangle), two = root_of(parts, pair[1].triangle);
    bool first = parts->triangles[one].size >= parts->triangles[two].size;
    struct mesh_triangle *root = &parts->triangles[first ? one : two];
    struct mesh_triangle *other = &parts->triangles[first ? two : one];
    double low = fmin(root->low_m, other->low_m);
    double high = fmax(root->high_m, other->high_m);
    if (one == two || high - low > rise_of(root, other))
        return;
    root->is_plane = rise_of(root, other) > RISE_M;
    root->size += other->size;
    root->low_m = low;
    root->high_m = high;
    other->part = first ? one : two;
}

/* Number of edges from index i that join the same two places. */
static int run_of(const struct mesh_parts *parts, int i)
{
    int count = 1;
    while (i + count < parts->edge_count
           && parts->edges[i + count].low == parts->edges[i].low
           && parts->edges[i + count].high == parts->edges[i].high)
        count++;
    return count;
}

static void find_parts(struct mesh_parts *parts)
{
    for (int i = 0, run; i < parts->edge_count; i += run) {
        run = run_of(parts, i);
        if (run == 2 && is_smooth(parts, &parts->edges[i]))
            join_mesh_parts(parts, &parts->edges[i]);
    }
}

static int from_of(const struct mesh_edge *edge)
{
    return edge->forwards ? edge->low : edge->high;
}

static int to_of(const struct mesh_edge *edge)
{
    return edge->forwards ? edge->high : edge->low;
}

/* Compares by part (stored in `triangle`), then by start and end of the edge. */
static int by_start(const void *left, const void *right)
{
    const struct mesh_edge *a = left, *b = right;
    if (a->triangle != b->triangle)
        return a->triangle < b->triangle ? -1 : 1;
    if (from_of(a) != from_of(b))
        return from_of(a) < from_of(b) ? -1 : 1;
    return (to_of(a) > to_of(b)) - (to_of(a) < to_of(b));
}

/* ---- shapes ---- */

/* Adds an empty shape to the sheet. */
static enum pp_status begin_shape(struct pp_site_sheet *sheet, int corners,
                                  struct pp_error *err)
{
    enum pp_status status =
        pp_array_append(&sheet->shapes, sheet->shape_count, sizeof *sheet->shapes, err);
    if (status != PP_OK)
        return status;
    struct pp_site_shape *shape = &sheet->shapes[sheet->shape_count++];
    *shape = (struct pp_site_shape){.top_m = -INFINITY};
    shape->corners = malloc((size_t)corners * sizeof *shape->corners);
    shape->ends = malloc((size_t)corners * sizeof *shape->ends);
    shape->unseen = malloc((size_t)corners * sizeof *shape->unseen);
    return shape->corners && shape->ends && shape->unseen ? PP_OK : pp_fail_memory(err);
}

static void add_shape_corner(struct pp_site_shape *shape, struct pp_vec3 at,
                             bool unseen)
{
    shape->top_m = fmax(shape->top_m, at.z);
    shape->corners[shape->count] = at;
    shape->unseen[shape->count++] = unseen;
}

/* Adds an open edge of vertical triangles as a line. Omits vertical edges, and lower
 * edges of a triangle, since its upper edge gives the line. */
static enum pp_status add_line(struct pp_site_sheet *sheet,
                               const struct mesh_parts *parts,
                               const struct mesh_edge *edge, struct pp_error *err)
{
    struct pp_vec3 a = parts->places[edge->low], b = parts->places[edge->high], c = a;
    for (int k = 0; k < 3; k++) {
        int place = parts->triangles[edge->triangle].corners[k];
        if (place != edge->low && place != edge->high)
            c = parts->places[place];
    }
    double length2 = (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y);
    if (length2 < SAME_M * SAME_M)
        return PP_OK;
    double along = ((c.x - a.x) * (b.x - a.x) + (c.y - a.y) * (b.y - a.y)) / length2;
    if (c.z > a.z + along * (b.z - a.z))
        return PP_OK;
    enum pp_status status = begin_shape(sheet, 2, err);
    if (status != PP_OK)
        return status;
    struct pp_site_shape *shape = &sheet->shapes[sheet->shape_count - 1];
    add_shape_corner(shape, a, false);
    add_shape_corner(shape, b, true);
    shape->ends[shape->ring_count++] = 2;
    return PP_OK;
}

/* Lists the edges that bound parts, sorted by part, and adds open edges of vertical
 * triangles as lines. */
static enum pp_status find_bounds(struct pp_site_sheet *sheet, struct mesh_parts *parts,
                                  struct pp_error *err)
{
    enum pp_status status = PP_OK;
    for (int i = 0, run; i < parts->edge_count && status == PP_OK; i += run) {
        run = run_of(parts, i);
        const struct mesh_edge *edges = &parts->edges[i];
        bool smooth = run == 2 && is_smooth(parts, edges);
        if (smooth
            && root_of(parts, edges[0].triangle) == root_of(parts, edges[1].triangle))
            continue;
        if (run == 1 && parts->triangles[edges->triangle].is_upright)
            status = add_line(sheet, parts, edges, err);
        for (int k = 0; k < run; k++) {
            if (parts->triangles[edges[k].triangle].is_upright)
                continue;
            struct mesh_edge bound = edges[k];
            bound.triangle = root_of(parts, bound.triangle);
            bound.is_unseen = smooth;
            parts->bounds[parts->bound_count++] = bound;
        }
    }
    if (parts->bound_count > 0)
        qsort(parts->bounds, (size_t)parts->bound_count, sizeof *parts->bounds,
              by_start);
    return status;
}

/* Omits corners of a shape's last ring that are on the line between their neighbours,
 * if both edges are drawn or both are not. */
static void straighten(struct pp_site_shape *shape, int first)
{
    int kept = first;
    for (int i = first; i < shape->count; i++) {
        struct pp_vec3 at = shape->corners[i];
        struct pp_vec3 before =
            shape->corners[kept > first ? kept - 1 : shape->count - 1];
        struct pp_vec3 next = shape->corners[i + 1 < shape->count ? i + 1 : first];
        bool was = shape->unseen[kept > first ? kept - 1 : shape->count - 1];
        struct pp_vec3 along = pp_vec_sub(next, before);
        double length = pp_vec_length(along);
        bool straight = length > 0.0 && was == shape->unseen[i]
                        && pp_vec_dot(pp_vec_sub(at, before), along) > 0.0
                        && pp_vec_dot(pp_vec_sub(next, at), along) > 0.0
                        && pp_vec_length(pp_vec_cross(pp_vec_sub(at, before), along))
                               < STRAIGHT_M * length;
        if (straight && shape->count - i + kept - first > 3)
            continue;
        shape->unseen[kept] = shape->unseen[i];
        shape->corners[kept++] = at;
    }
    shape->count = kept;
}

/* Index of the next edge of a part that begins at a place and is not yet in a ring; -1:
 * none. */
static int find_next(const struct mesh_parts *parts, const bool *used, int first,
                     int end, int place)
{
    int low = first, high = end;
    while (low < high) {
        int middle = low + (high - low) / 2;
        if (from_of(&parts->bounds[middle]) < place)
            low = middle + 1;
        else
            high = middle;
    }
    for (; low < end && from_of(&parts->bounds[low]) == place; low++)
        if (!used[low])
            return low;
    return -1;
}

/* Adds a part as a shape. Its edges are bounds[first] to bounds[end - 1]. */
static enum pp_status add_part(struct pp_site_sheet *sheet,
                               const struct mesh_parts *parts, bool *used, int first,
                               int end, struct pp_error *err)
{
    enum pp_status status = begin_shape(sheet, end - first, err);
    if (status != PP_OK)
        return status;
    struct pp_site_shape *shape = &sheet->shapes[sheet->shape_count - 1];
    shape->is_level = true;
    for (int i = first; i < end; i++) {
        int begun = shape->count;
        for (int k = used[i] ? -1 : i; k >= 0;
             k = find_next(parts, used, first, end, to_of(&parts->bounds[k]))) {
            used[k] = true;
            add_shape_corner(shape, parts->places[from_of(&parts->bounds[k])],
                             parts->bounds[k].is_unseen);
        }
        if (shape->count == begun)
            continue;
        straighten(shape, begun);
        shape->ends[shape->ring_count++] = shape->count;
    }
    return PP_OK;
}

static enum pp_status add_parts(struct pp_site_sheet *sheet,
                                const struct mesh_parts *parts, struct pp_error *err)
{
    bool *used = calloc((size_t)parts->bound_count + 1, sizeof *used);
    enum pp_status status = used ? PP_OK : pp_fail_memory(err);
    for (int i = 0, end; i < parts->bound_count && status == PP_OK; i = end) {
        end = i + 1;
        while (end < parts->bound_count
               && parts->bounds[end].triangle == parts->bounds[i].triangle)
            end++;
        status = add_part(sheet, parts, used, i, end, err);
    }
    free(used);
    return status;
}

/* Copies the triangles of the mesh, in the axes of the building. */
static void take_triangles(struct mesh_parts *parts, const struct pp_world *world,
                           const struct pp_world_mesh *mesh)
{
    for (int i = 0; i < mesh->side_count; i++) {
        const struct pp_polygon *outline =
            &world->surfaces[mesh->first_side + i].outline;
        for (int k = 0; k < 3; k++)
            parts->users[3 * parts->triangle_count + k] = (struct mesh_corner){
                pp_placement_to_building(&world->placement, outline->vertices[k]),
                3 * parts->triangle_count + k};
        parts->triangle_count++;
    }
}

enum pp_status pp_mesh_shapes_add(struct pp_site_sheet *sheet,
                                  const struct pp_world *world,
                                  const struct pp_world_mesh *mesh,
                                  struct pp_error *err)
{
    size_t corners = 3 * (size_t)mesh->side_count + 1;
    struct mesh_parts parts = {
        .users = malloc(corners * sizeof *parts.users),
        .places = malloc(corners * sizeof *parts.places),
        .triangles = calloc((size_t)mesh->side_count + 1, sizeof *parts.triangles),
        .edges = malloc(corners * sizeof *parts.edges),
        .bounds = malloc(corners * sizeof *parts.bounds)};
    enum pp_status status =
        parts.users && parts.places && parts.triangles && parts.edges && parts.bounds
            ? PP_OK
            : pp_fail_memory(err);
    if (status == PP_OK) {
        take_triangles(&parts, world, mesh);
        number_places(&parts);
        find_edges(&parts);
        find_parts(&parts);
        status = find_bounds(sheet, &parts, err);
    }
    if (status == PP_OK)
        status = add_parts(sheet, &parts, err);
    free(parts.users);
    free(parts.places);
    free(parts.triangles);
    free(parts.edges);
    free(parts.bounds);
    return status;
}
