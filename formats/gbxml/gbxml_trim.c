/* gbxml_trim.c - compares the faces of every two rooms whose extents overlap. */
#include "formats/gbxml/gbxml_trim.h"

#include <math.h>
#include <stdlib.h>

#include "model/geometry/bounds.h"
#include "model/geometry/polygon.h"
#include "model/geometry/polygons_cross.h"

/* trim_m: largest overlap that is trimmed. noted_m: moves larger than this are noted.
 * against: faces are opposite if the cosine between their normals is below this.
 * plane_m: corners within this distance of a face's plane move with the face. */
static const double trim_m = 0.02, noted_m = 5e-3, against = -0.9999, plane_m = 1e-3;

static struct pp_bounds3 room_bounds(const struct pp_gbxml_room *room)
{
    struct pp_bounds3 bounds = pp_bounds3_empty();
    for (int i = 0; i < room->shell.corner_count; i++)
        pp_bounds3_add(&bounds, room->shell.corners[i]);
    return bounds;
}

/* True if the extents overlap by more than `least` along all axes. */
static bool overlap_extents(const struct pp_bounds3 *a, const struct pp_bounds3 *b,
                            double least)
{
    return fmin(a->high.x, b->high.x) - fmax(a->low.x, b->low.x) > least
           && fmin(a->high.y, b->high.y) - fmax(a->low.y, b->low.y) > least
           && fmin(a->high.z, b->high.z) - fmax(a->low.z, b->low.z) > least;
}

static enum pp_status list_bounds(struct pp_bounds3 **bounds,
                                  struct pp_gbxml_room *const *rooms, int count,
                                  struct pp_error *err)
{
    *bounds = calloc((size_t)count + 1, sizeof **bounds);
    if (!*bounds)
        return pp_fail_memory(err);
    for (int i = 0; i < count; i++)
        (*bounds)[i] = room_bounds(rooms[i]);
    return PP_OK;
}

/* ---- trimming ---- */

static struct pp_vec3 trim_normal(const struct pp_gbxml_shell *shell, int face)
{
    struct pp_vec3 normal = pp_gbxml_shell_normal(shell, face);
    double length = pp_vec_length(normal);
    return length > 0.0 ? pp_vec_scale(normal, 1.0 / length) : normal;
}

static struct pp_vec3 trim_corner(const struct pp_gbxml_shell *shell, int face, int i)
{
    return shell->corners[shell->faces[face].corners[i]];
}

/* Extent of a face along two axes. */
static struct pp_bounds2 face_extent(const struct pp_gbxml_shell *shell, int face,
                                     struct pp_vec3 along, struct pp_vec3 up)
{
    struct pp_bounds2 extent = pp_bounds2_empty();
    for (int i = 0; i < shell->faces[face].count; i++) {
        struct pp_vec3 at = trim_corner(shell, face, i);
        pp_bounds2_add(&extent, pp_vec_dot(at, along), pp_vec_dot(at, up));
    }
    return extent;
}

/* Depth to which the face `other` of the second room reaches into the first room
 * through its opposite face `own`; 0 if they are not opposite, do not overlap in their
 * plane, or the depth exceeds trim_m. */
static double face_overlap(const struct pp_gbxml_shell *shell, int own,
                           const struct pp_gbxml_shell *behind, int other)
{
    struct pp_vec3 normal = trim_normal(shell, own), along, up;
    if (pp_vec_dot(normal, trim_normal(behind, other)) > against)
        return 0.0;
    double deep = pp_vec_dot(
        pp_vec_sub(trim_corner(behind, other, 0), trim_corner(shell, own, 0)), normal);
    if (!(deep > 1e-5 && deep <= trim_m * (1.0 + 1e-6)))
        return 0.0;
    pp_polygon_plane_axes(normal, &along, &up);
    struct pp_bounds2 a = face_extent(shell, own, along, up),
                      b = face_extent(behind, other, along, up);
    for (int k = 0; k < 2; k++)
        if (!(fmin(a.high[k], b.high[k]) - fmax(a.low[k], b.low[k]) > trim_m))
            return 0.0;
    return deep;
}

/* Moves the face, and all corners in its plane, inwards by `by` metres. */
static void move_face(struct pp_gbxml_shell *shell, int face, double by)
{
    struct pp_vec3 normal = trim_normal(shell, face), at = trim_corner(shell, face, 0);
    for (int i = 0; i < shell->corner_count; i++) {
        struct pp_vec3 *corner = &shell->corners[i];
        if (fabs(pp_vec_dot(pp_vec_sub(*corner, at), normal)) < plane_m)
            *corner = pp_vec_along(*corner, by, normal);
    }
}

/* Trims the second room where it overlaps the first; returns the largest move. */
static double trim_pair(const struct pp_gbxml_shell *first,
                        struct pp_gbxml_shell *second)
{
    double most = 0.0;
    for (int i = 0; i < second->face_count; i++)
        for (int k = 0; k < first->face_count; k++) {
            double deep = face_overlap(first, k, second, i);
            if (deep > 0.0)
                move_face(second, i, deep);
            most = fmax(most, deep);
        }
    return most;
}

void pp_gbxml_trim_rooms(struct pp_gbxml_room *const *rooms,
                         struct pp_gbxml_space *const *spaces, int count,
                         struct pp_mistakes *notes)
{
    for (int k = 0; k < count; k++)
        for (int i = 0; i < k; i++) {
            struct pp_bounds3 a = room_bounds(rooms[i]), b = room_bounds(rooms[k]);
            double moved = overlap_extents(&a, &b, 0.0)
                               ? trim_pair(&rooms[i]->shell, &rooms[k]->shell)
                               : 0.0;
            if (moved > noted_m)
                pp_mistakes_add(notes, spaces[k]->line,
                                "space \"%.60s\" extends %.0f mm into the space "
                                "\"%.60s\" and is cut off there",
                                spaces[k]->id, 1e3 * moved, spaces[i]->id);
        }
}

/* ---- leaving out ---- */

/* The faces of a room as polygons. */
struct room_polygons {
    struct pp_polygon *list;
    int count;
};

static void clear_polygons(struct room_polygons *polygons)
{
    for (int i = 0; i < polygons->count; i++)
        pp_polygon_clear(&polygons->list[i]);
    free(polygons->list);
    *polygons = (struct room_polygons){0};
}

static enum pp_status make_polygons(struct room_polygons *polygons,
                                    const struct pp_gbxml_shell *shell,
                                    struct pp_error *err)
{
    enum pp_status status = PP_OK;
    *polygons = (struct room_polygons){
        calloc((size_t)shell->face_count + 1, sizeof *polygons->list), 0};
    if (!polygons->list)
        return pp_fail_memory(err);
    for (int i = 0; i < shell->face_count && status == PP_OK; i++) {
        const int count = shell->faces[i].count;
        struct pp_vec3 *corners = malloc((size_t)count * sizeof *corners);
        if (!corners)
            return pp_fail_memory(err);
        for (int k = 0; k < count; k++)
            corners[k] = trim_corner(shell, i, k);
        status = pp_polygon_of(&polygons->list[i], corners, count, err);
        polygons->count += status == PP_OK;
        free(corners);
    }
    return status;
}

/* True if the point is inside the faces: an upward ray then crosses one more face that
 * points down than faces that point up. */
static bool is_within(const struct room_polygons *room, struct pp_vec3 at)
{
    int over = 0;
    for (int i = 0; i < room->count; i++) {
        const struct pp_polygon *face = &room->list[i];
        if (fabs(face->normal.z) < 1e-6)
            continue;
        bool under = false;
        for (int k = 0; k < face->count; k++) {
            struct pp_vec3 a = face->vertices[k],
                           b = face->vertices[(k + 1) % face->count];
            if ((a.y > at.y) != (b.y > at.y)
                && at.x < a.x + (b.x - a.x) * (at.y - a.y) / (b.y - a.y))
                under = !under;
        }
        double above = -pp_polygon_height(face, at) / face->normal.z;
        if (under && above > 0.0)
            over += face->normal.z < 0.0 ? 1 : -1;
    }
    return over > 0;
}

/* True if a point just inside a face of `a` is also inside `b`. Tested points: near the
 * middle of each edge, and the middle of the face. */
static bool has_place_in(const struct room_polygons *a, const struct room_polygons *b)
{
    for (int i = 0; i < a->count; i++) {
        const struct pp_polygon *face = &a->list[i];
        struct pp_vec3 middle = pp_polygon_middle(face);
        for (int k = 0; k <= face->count; k++) {
            struct pp_vec3 at = middle;
            if (k < face->count)
                at = pp_vec_along(
                    pp_vec_scale(pp_vec_add(face->vertices[k],
                                            face->vertices[(k + 1) % face->count]),
                                 0.5),
                    0.05, pp_vec_sub(middle, face->vertices[k]));
            at = pp_vec_along(at, 2.0 * trim_m, face->normal);
            if (is_within(a, at) && is_within(b, at))
                return true;
        }
    }
    return false;
}

static enum pp_status do_overlap(bool *overlap, const struct room_polygons *a,
                                 const struct room_polygons *b, struct pp_error *err)
{
    enum pp_status status = PP_OK;
    *overlap = has_place_in(a, b) || has_place_in(b, a);
    for (int i = 0; i < a->count && status == PP_OK && !*overlap; i++)
        for (int k = 0; k < b->count && status == PP_OK && !*overlap; k++)
            status = pp_polygons_cross(overlap, &a->list[i], &b->list[k], NULL, err);
    return status;
}

/* Index of the next room to leave out, the one that overlaps most others; -1: no rooms
 * overlap. */
static int worst_room(const bool *overlaps, const struct pp_bounds3 *bounds, int count)
{
    int worst = -1, most = 0;
    double least = INFINITY;
    for (int i = 0; i < count; i++) {
        int others = 0;
        for (int k = 0; k < count; k++)
            others += overlaps[i * count + k];
        struct pp_vec3 size = pp_vec_sub(bounds[i].high, bounds[i].low);
        double volume = size.x * size.y * size.z;
        if (others > most || (others == most && others > 0 && volume <= least)) {
            worst = i;
            most = others;
            least = volume;
        }
    }
    return worst;
}

static int first_other(const bool *overlaps, int count, int room)
{
    int other = 0;
    while (!overlaps[room * count + other])
        other++;
    return other;
}

enum pp_status pp_gbxml_trim_leave_out(struct pp_gbxml_room *const *rooms,
                                       struct pp_gbxml_space *const *spaces, int count,
                                       struct pp_mistakes *notes, struct pp_error *err)
{
    struct pp_bounds3 *bounds;
    struct room_polygons *polygons = calloc((size_t)count + 1, sizeof *polygons);
    bool *overlaps = calloc((size_t)count * (size_t)count + 1, sizeof *overlaps);
    enum pp_status status = list_bounds(&bounds, rooms, count, err);
    if (!polygons || !overlaps)
        status = pp_fail_memory(err);
    for (int i = 0; i < count && status == PP_OK; i++)
        status = make_polygons(&polygons[i], &rooms[i]->shell, err);
    for (int i = 0; i < count && status == PP_OK; i++)
        for (int k = 0; k < i && status == PP_OK; k++) {
            bool overlap = false;
            if (overlap_extents(&bounds[i], &bounds[k], 1e-3))
                status = do_overlap(&overlap, &polygons[i], &polygons[k], err);
            overlaps[i * count + k] = overlaps[k * count + i] = overlap;
        }
    for (int worst;
         status == PP_OK && (worst = worst_room(overlaps, bounds, count)) >= 0;) {
        int other = first_other(overlaps, count, worst);
        spaces[worst]->left_out = true;
        pp_mistakes_add(notes, spaces[worst]->line,
                        "space \"%.60s\" is ignored, with its openings (%d): it "
                        "overlaps the space \"%.60s\" by more than 20 mm",
                        spaces[worst]->id, rooms[worst]->opening_count,
                        spaces[other]->id);
        for (int k = 0; k < count; k++)
            overlaps[worst * count + k] = overlaps[k * count + worst] = false;
    }
    for (int i = 0; polygons && i < count; i++)
        clear_polygons(&polygons[i]);
    free(polygons);
    free(overlaps);
    free(bounds);
    return status;
}
