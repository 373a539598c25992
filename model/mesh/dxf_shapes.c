/* dxf_shapes.c - see dxf_shapes.h. */
#include "model/mesh/dxf_shapes.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/array.h"

/* Bits of group code 70. */
enum { CLOSED = 1, CLOSED_ACROSS = 32, POLYGON_MESH = 16, POLYFACE = 64 };
enum { OF_SPLINE_FRAME = 16, MESH_CORNER = 64, FACE_RECORD = 128 };

struct pp_vec3 pp_dxf_shapes_moved(const struct pp_dxf_move *move, struct pp_vec3 p)
{
    struct pp_vec3 moved = pp_vec_along(move->origin, p.x, move->axes[0]);
    moved = pp_vec_along(moved, p.y, move->axes[1]);
    return pp_vec_along(moved, p.z, move->axes[2]);
}

static enum pp_status dxf_number(double *number, const struct pp_dxf_entity *e,
                                 int code, double fallback, struct pp_error *err)
{
    return pp_dxf_tags_number(number, e->tags, e->from, e->to, code, fallback, e->lines,
                              err);
}

/* Reads a number and truncates it to a whole one; 0 if it is too large. */
static enum pp_status count_of(int *count, const struct pp_dxf_entity *e, int code,
                               struct pp_error *err)
{
    double number;
    enum pp_status status = dxf_number(&number, e, code, 0.0, err);
    *count = status == PP_OK && fabs(number) <= PP_MESH_CORNERS_MOST ? (int)number : 0;
    return status;
}

static int line_of(const struct pp_dxf_entity *e)
{
    return e->tags->list[e->from].line;
}

enum pp_status pp_dxf_shapes_point(struct pp_vec3 *point, const struct pp_dxf_entity *e,
                                   int first, struct pp_error *err)
{
    enum pp_status status = dxf_number(&point->x, e, first, 0.0, err);
    if (status == PP_OK)
        status = dxf_number(&point->y, e, first + 10, 0.0, err);
    return status == PP_OK ? dxf_number(&point->z, e, first + 20, 0.0, err) : status;
}

enum pp_status pp_dxf_shapes_axes(struct pp_dxf_move *move,
                                  const struct pp_dxf_entity *e, struct pp_error *err)
{
    struct pp_vec3 normal;
    enum pp_status status = pp_dxf_shapes_point(&normal, e, 210, err);
    double length = pp_vec_length(normal);
    normal = length > 0.0 && isfinite(length) ? pp_vec_scale(normal, 1.0 / length)
                                              : pp_vec(0.0, 0.0, 1.0);
    bool is_steep = fabs(normal.x) < 1.0 / 64.0 && fabs(normal.y) < 1.0 / 64.0;
    struct pp_vec3 world = is_steep ? pp_vec(0.0, 1.0, 0.0) : pp_vec(0.0, 0.0, 1.0);
    struct pp_vec3 x = pp_vec_unit(pp_vec_cross(world, normal));
    *move = (struct pp_dxf_move){.axes = {x, pp_vec_cross(normal, x), normal}};
    return status;
}

/* Adds a corner in the entity's coordinates. */
static enum pp_status add_dxf_corner(const struct pp_dxf_entity *e, struct pp_vec3 p,
                                     int line, struct pp_error *err)
{
    return pp_mesh_lines_say(
        e->lines, line,
        pp_mesh_triangles_add_corner(e->mesh, pp_dxf_shapes_moved(e->move, p)), err);
}

static enum pp_status add_dxf_face(const struct pp_dxf_entity *e, const int *corners,
                                   int count, int line, struct pp_error *err)
{
    return pp_mesh_lines_say(e->lines, line,
                             pp_mesh_triangles_add_face(e->mesh, corners, count), err);
}

enum pp_status pp_dxf_shapes_face(const struct pp_dxf_entity *e, struct pp_error *err)
{
    int first = e->mesh->corner_count, corners[4] = {first, first + 1, first + 2};
    int count =
        pp_dxf_tags_find(e->tags, e->from, e->to, 13) ? 4 : 3; /* else a triangle */
    corners[3] = first + 3;
    enum pp_status status = PP_OK;
    for (int i = 0; i < count && status == PP_OK; i++) {
        struct pp_vec3 p;
        status = pp_dxf_shapes_point(&p, e, 10 + i, err);
        if (status == PP_OK)
            status = add_dxf_corner(e, p, line_of(e), err);
    }
    return status == PP_OK ? add_dxf_face(e, corners, count, line_of(e), err) : status;
}

/* ---- extruded outlines ---- */

/* Outline in the entity's own axes, at its elevation. */
struct outline {
    struct pp_vec3 *list;
    int count, space;
    bool closed;
    double thickness;
};

static enum pp_status append_outline_point(struct outline *outline, struct pp_vec3 p,
                                           struct pp_error *err)
{
    enum pp_status status =
        pp_array_reserve(&outline->list, &outline->space, outline->count + 1,
                         sizeof *outline->list, err);
    if (status == PP_OK)
        outline->list[outline->count++] = p;
    return status;
}

/* Adds walls over the outline's edges and, if it is closed, floor and lid. */
static enum pp_status raise(const struct pp_dxf_entity *e,
                            const struct outline *outline, struct pp_error *err)
{
    int n = outline->count, first = e->mesh->corner_count, line = line_of(e);
    struct pp_dxf_move own;
    enum pp_status status = pp_dxf_shapes_axes(&own, e, err);
    int *ring = malloc((size_t)(n + 1) * sizeof *ring);
    if (!ring)
        return pp_fail_memory(err);
    for (int i = 0; i < 2 * n && status == PP_OK; i++) {
        struct pp_vec3 p = outline->list[i % n];
        p.z += i < n ? 0.0 : outline->thickness;
        status = add_dxf_corner(e, pp_dxf_shapes_moved(&own, p), line, err);
    }
    for (int i = 0; i < (outline->closed ? n : n - 1) && status == PP_OK; i++) {
        int a = first + i, b = first + (i + 1) % n;
        status = add_dxf_face(e, (int[]){a, b, b + n, a + n}, 4, line, err);
    }
    for (int lid = 0; lid < 2 && outline->closed && n > 2 && status == PP_OK; lid++) {
        for (int i = 0; i < n; i++)
            ring[i] = first + lid * n + i;
        status = add_dxf_face(e, ring, n, line, err);
    }
    free(ring);
    return status;
}

static enum pp_status refuse_arc(const struct pp_dxf_entity *e, int line,
                                 struct pp_error *err)
{
    return pp_mesh_lines_fail(e->lines, line, err,
                              "%s: there is an arc (group 42); expected straight edges",
                              e->tags->list[e->from].value);
}

enum pp_status pp_dxf_shapes_lwpolyline(const struct pp_dxf_entity *e,
                                        struct pp_error *err)
{
    struct outline outline = {0};
    double elevation;
    int flags;
    enum pp_status status = dxf_number(&outline.thickness, e, 39, 0.0, err);
    if (status != PP_OK || outline.thickness == 0.0)
        return status;
    status = dxf_number(&elevation, e, 38, 0.0, err);
    if (status == PP_OK)
        status = count_of(&flags, e, 70, err);
    outline.closed = status == PP_OK && flags & CLOSED;
    for (int i = e->from; i < e->to && status == PP_OK; i++) {
        const struct pp_dxf_tag *tag = &e->tags->list[i];
        double x, y, bulge = 0.0;
        if (tag->code == 42)
            status =
                pp_dxf_tags_number(&bulge, e->tags, i, i + 1, 42, 0.0, e->lines, err);
        if (bulge != 0.0)
            status = refuse_arc(e, tag->line, err);
        if (tag->code != 10)
            continue;
        status = pp_dxf_tags_number(&x, e->tags, i, i + 1, 10, 0.0, e->lines, err);
        int end = i + 2 < e->to ? i + 2 : e->to;
        if (status == PP_OK)
            status = pp_dxf_tags_number(&y, e->tags, i, end, 20, 0.0, e->lines, err);
        if (status == PP_OK)
            status = append_outline_point(&outline, pp_vec(x, y, elevation), err);
    }
    if (status == PP_OK && outline.count > 1)
        status = raise(e, &outline, err);
    free(outline.list);
    return status;
}

/* In the file the corners are in the order first, second, fourth, third. */
enum pp_status pp_dxf_shapes_solid(const struct pp_dxf_entity *e, struct pp_error *err)
{
    static const int order[] = {10, 11, 13, 12};
    struct outline outline = {.closed = true};
    enum pp_status status = dxf_number(&outline.thickness, e, 39, 0.0, err);
    bool has_fourth = pp_dxf_tags_find(e->tags, e->from, e->to, 13) != NULL;
    for (int i = 0; i < 4 && status == PP_OK && outline.thickness != 0.0; i++) {
        struct pp_vec3 p;
        if (order[i] == 13 && !has_fourth)
            continue;
        status = pp_dxf_shapes_point(&p, e, order[i], err);
        if (status == PP_OK)
            status = append_outline_point(&outline, p, err);
    }
    if (status == PP_OK && outline.count > 2)
        status = raise(e, &outline, err);
    free(outline.list);
    return status;
}

/* ---- MESH ---- */

/* Reads the tag at `at` as a whole number of that code, from 0 to `most`. */
static enum pp_status whole_at(int *whole, const struct pp_dxf_entity *e, int at,
                               int code, int most, struct pp_error *err)
{
    double number = -1.0;
    int line = at < e->to ? e->tags->list[at].line : line_of(e);
    enum pp_status status = pp_dxf_tags_number(
        &number, e->tags, at, at < e->to ? at + 1 : at, code, -1.0, e->lines, err);
    if (status == PP_OK && (number != floor(number) || number < 0.0 || number > most))
        return pp_mesh_lines_fail(e->lines, line, err,
                                  "MESH: expected a whole number from 0 to %d in group "
                                  "%d",
                                  most, code);
    *whole = (int)number;
    return status;
}

/* Adds the corners after the tag at `at` (code 92, their number). *corners: number
 * read. */
static enum pp_status read_mesh_corners(int *corners, const struct pp_dxf_entity *e,
                                        int at, struct pp_error *err)
{
    int found = 0;
    enum pp_status status = whole_at(corners, e, at, 92, PP_MESH_CORNERS_MOST, err);
    for (int i = at + 1; i < e->to && found < *corners && status == PP_OK; i++) {
        struct pp_dxf_entity corner = *e;
        struct pp_vec3 p;
        if (e->tags->list[i].code != 10)
            continue;
        corner.from = i;
        corner.to = i + 3 < e->to ? i + 3 : e->to;
        status = pp_dxf_shapes_point(&p, &corner, 10, err);
        if (status == PP_OK)
            status = add_dxf_corner(e, p, line_of(&corner), err);
        found++;
    }
    if (status == PP_OK && found < *corners)
        return pp_mesh_lines_fail(e->lines, e->tags->list[at].line, err,
                                  "MESH: has %d corners; expected %d", found, *corners);
    return status;
}

/* Adds the faces of the list after the tag at `at` (code 93, its length). All values
 * have code 90; each face is the number of its corners and their indices from 0. */
static enum pp_status read_mesh_faces(const struct pp_dxf_entity *e, int at, int first,
                                      int corners, struct pp_error *err)
{
    int length, sides = 0;
    enum pp_status status = whole_at(&length, e, at, 93, PP_MESH_CORNERS_MOST, err);
    for (int i = at + 1, end = at + 1 + length; i < end && status == PP_OK;
         i += 1 + sides) {
        status = whole_at(&sides, e, i, 90, end - i - 1, err);
        int *face = status == PP_OK ? malloc(((size_t)sides + 1) * sizeof *face) : NULL;
        if (status == PP_OK && !face)
            status = pp_fail_memory(err);
        for (int k = 0; k < sides && status == PP_OK; k++) {
            status = whole_at(&face[k], e, i + 1 + k, 90, corners - 1, err);
            face[k] += first;
        }
        if (status == PP_OK && sides > 2)
            status = add_dxf_face(e, face, sides, e->tags->list[i].line, err);
        free(face);
    }
    return status;
}

enum pp_status pp_dxf_shapes_mesh(const struct pp_dxf_entity *e, struct pp_error *err)
{
    int first = e->mesh->corner_count, corners = 0;
    enum pp_status status = PP_OK;
    for (int i = e->from; i < e->to && status == PP_OK; i++) {
        if (e->tags->list[i].code == 92)
            status = read_mesh_corners(&corners, e, i, err);
        if (status == PP_OK && e->tags->list[i].code == 93)
            return read_mesh_faces(e, i, first, corners, err);
    }
    return status;
}

/* ---- POLYLINE with its VERTEX entities ---- */

/* The vertex at `at`, as a separate entity. */
static struct pp_dxf_entity vertex_at(const struct pp_dxf_entity *e, int at)
{
    struct pp_dxf_entity vertex = *e;
    vertex.from = at;
    vertex.to = pp_dxf_tags_next(e->tags, at);
    return vertex;
}

static bool is_vertex(const struct pp_dxf_entity *e, int at)
{
    return strcmp(e->tags->list[at].value, "VERTEX") == 0;
}

/* Adds a face of a polyface mesh: up to four corner numbers, from 1, negative if the
 * edge is not drawn. */
static enum pp_status add_record(const struct pp_dxf_entity *vertex, int first,
                                 int count, struct pp_error *err)
{
    int corners[4], sides = 0, line = line_of(vertex);
    for (int k = 0; k < 4; k++) {
        int index;
        if (count_of(&index, vertex, 71 + k, err) != PP_OK)
            return PP_BAD_INPUT;
        index = abs(index);
        if (index > count)
            return pp_mesh_lines_fail(vertex->lines, line, err,
                                      "VERTEX: refers to corner %d of the mesh; "
                                      "expected one of the %d corners above it",
                                      index, count);
        if (index > 0)
            corners[sides++] = first + index - 1;
    }
    return sides > 2 ? add_dxf_face(vertex, corners, sides, line, err) : PP_OK;
}

static enum pp_status read_polyface(const struct pp_dxf_entity *e, struct pp_error *err)
{
    int first = e->mesh->corner_count, count = 0, flags;
    enum pp_status status = PP_OK;
    for (int at = pp_dxf_tags_next(e->tags, e->from); at < e->to && status == PP_OK;
         at = pp_dxf_tags_next(e->tags, at)) {
        struct pp_dxf_entity vertex = vertex_at(e, at);
        struct pp_vec3 p;
        if (!is_vertex(e, at))
            continue;
        status = count_of(&flags, &vertex, 70, err);
        if (status != PP_OK || !(flags & FACE_RECORD))
            continue;
        if (!(flags & MESH_CORNER)) {
            status = add_record(&vertex, first, count, err);
            continue;
        }
        status = pp_dxf_shapes_point(&p, &vertex, 10, err);
        if (status == PP_OK)
            status = add_dxf_corner(e, p, line_of(&vertex), err);
        count++;
    }
    return status;
}

/* Reads the corners of the polyline in its own axes, without spline frame points. If
 * arcs_count, an arc is an error. */
static enum pp_status read_corners(struct outline *outline,
                                   const struct pp_dxf_entity *e, bool arcs_count,
                                   struct pp_error *err)
{
    enum pp_status status = PP_OK;
    for (int at = pp_dxf_tags_next(e->tags, e->from); at < e->to && status == PP_OK;
         at = pp_dxf_tags_next(e->tags, at)) {
        struct pp_dxf_entity vertex = vertex_at(e, at);
        struct pp_vec3 p;
        double bulge = 0.0;
        int flags = 0;
        if (!is_vertex(e, at))
            continue;
        status = count_of(&flags, &vertex, 70, err);
        if (status == PP_OK)
            status = pp_dxf_shapes_point(&p, &vertex, 10, err);
        if (status == PP_OK && arcs_count)
            status = dxf_number(&bulge, &vertex, 42, 0.0, err);
        if (status == PP_OK && bulge != 0.0)
            status = refuse_arc(e, line_of(&vertex), err);
        if (status == PP_OK && !(flags & OF_SPLINE_FRAME))
            status = append_outline_point(outline, p, err);
    }
    return status;
}

/* Reads a mesh of M times N corners in rows; a closed direction ends where it
 * begins. */
static enum pp_status read_net(const struct pp_dxf_entity *e, int flags,
                               struct pp_error *err)
{
    struct outline net = {0};
    int first = e->mesh->corner_count, m = 0, n = 0;
    enum pp_status status = count_of(&m, e, 71, err);
    if (status == PP_OK)
        status = count_of(&n, e, 72, err);
    if (status == PP_OK)
        status = read_corners(&net, e, false, err);
    if (status == PP_OK && (m < 2 || n < 2 || (double)m * n != net.count))
        status =
            pp_mesh_lines_fail(e->lines, line_of(e), err,
                               "POLYLINE: a mesh of %d by %d has %d corners; expected "
                               "the product of both numbers, each 2 or more",
                               m, n, net.count);
    for (int i = 0; i < net.count && status == PP_OK; i++)
        status = add_dxf_corner(e, net.list[i], line_of(e), err);
    for (int i = 0; i < (flags & CLOSED ? m : m - 1) && status == PP_OK; i++)
        for (int k = 0; k < (flags & CLOSED_ACROSS ? n : n - 1) && status == PP_OK;
             k++) {
            int a = first + i * n, b = first + (i + 1) % m * n, next = (k + 1) % n;
            status = add_dxf_face(e, (int[]){a + k, a + next, b + next, b + k}, 4,
                                  line_of(e), err);
        }
    free(net.list);
    return status;
}

enum pp_status pp_dxf_shapes_polyline(const struct pp_dxf_entity *e,
                                      struct pp_error *err)
{
    struct outline outline = {0};
    struct pp_dxf_entity head = vertex_at(e, e->from);
    int flags;
    enum pp_status status = count_of(&flags, &head, 70, err);
    if (status == PP_OK && flags & POLYFACE)
        return read_polyface(e, err);
    if (status == PP_OK && flags & POLYGON_MESH)
        return read_net(e, flags, err);
    if (status == PP_OK)
        status = dxf_number(&outline.thickness, &head, 39, 0.0, err);
    if (status != PP_OK || outline.thickness == 0.0)
        return status;
    outline.closed = flags & CLOSED;
    status = read_corners(&outline, e, true, err);
    if (status == PP_OK && outline.count > 1)
        status = raise(&head, &outline, err);
    free(outline.list);
    return status;
}
