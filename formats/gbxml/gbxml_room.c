/* gbxml_room.c - faces and openings of one space. */
#include "formats/gbxml/gbxml_room.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "formats/gbxml/gbxml_prism.h"
#include "model/base/array.h"
#include "model/base/text.h"

/* Greatest distance of an opening from the plane of its face. */
static const double reveal_m = 0.6;

/* Tolerance (m) within which two lengths are equal. */
static const double same_m = 2e-3;

void pp_gbxml_room_clear(struct pp_gbxml_room *room)
{
    for (int i = 0; i < room->opening_count; i++)
        free(room->openings[i].corners);
    free(room->openings);
    free(room->faces);
    pp_gbxml_shell_clear(&room->shell);
    *room = (struct pp_gbxml_room){0};
}

bool pp_gbxml_room_has(const struct pp_gbxml_surface *surface,
                       const struct pp_gbxml_space *space)
{
    if (strcmp(surface->type, "Shade") == 0 || strstr(surface->type, "Column"))
        return false;
    for (int i = 0; i < PP_GBXML_NEIGHBOURS; i++)
        if (surface->spaces[i] && strcmp(surface->spaces[i], space->id) == 0)
            return true;
    return false;
}

bool pp_gbxml_room_is_outer(const struct pp_gbxml_surface *surface)
{
    bool one =
        !surface->spaces[1]
        || (surface->spaces[0] && strcmp(surface->spaces[0], surface->spaces[1]) == 0);
    return one && !strstr(surface->type, "Interior");
}

struct pp_vec3 pp_gbxml_room_own(const struct pp_gbxml_room *room, struct pp_vec3 at)
{
    struct pp_vec3 from = pp_vec_sub(at, room->origin);
    double c = cos(room->rotate_rad), s = sin(room->rotate_rad);
    return (struct pp_vec3){c * from.x + s * from.y, c * from.y - s * from.x, from.z};
}

/* ---- faces ---- */

static struct pp_vec3 unit_normal(const struct pp_gbxml_room *room, int face)
{
    struct pp_vec3 normal = pp_gbxml_shell_normal(&room->shell, face);
    double length = pp_vec_length(normal);
    return length > 0.0 ? pp_vec_scale(normal, 1.0 / length)
                        : (struct pp_vec3){0.0, 0.0, 1.0};
}

/* Name of a wall by its outward direction in the building's axes: "south-east". */
static const char *wall_name(struct pp_vec3 inward)
{
    static const char *const names[] = {"north", "north-east", "east", "south-east",
                                        "south", "south-west", "west", "north-west"};
    double bearing = atan2(-inward.x, -inward.y) / PP_RAD;
    return names[((int)floor(bearing / 45.0 + 0.5) + 8) % 8];
}

/* Puts -2, -3 ... behind a name that the faces before have already. */
static void make_own(struct pp_gbxml_room_face *faces, int index, const char *name)
{
    int number = 1;
    snprintf(faces[index].name, sizeof faces->name, "%s", name);
    for (int i = 0; i < index;) {
        if (strcmp(faces[i].name, faces[index].name) != 0) {
            i++;
            continue;
        }
        snprintf(faces[index].name, sizeof faces->name, "%s-%d", name, ++number);
        i = 0;
    }
}

static enum pp_status name_faces(struct pp_gbxml_room *room,
                                 struct pp_gbxml_surface *const *surfaces,
                                 struct pp_error *err)
{
    room->faces = calloc((size_t)room->shell.face_count + 1, sizeof *room->faces);
    if (!room->faces)
        return pp_fail_memory(err);
    for (int i = 0; i < room->shell.face_count; i++) {
        struct pp_gbxml_room_face *face = &room->faces[i];
        struct pp_vec3 normal = unit_normal(room, i);
        const int from = room->shell.faces[i].from;
        face->role = normal.z > 0.5    ? PP_GBXML_FLOOR
                     : normal.z < -0.2 ? PP_GBXML_CEILING
                                       : PP_GBXML_WALL;
        make_own(room->faces, i,
                 face->role == PP_GBXML_FLOOR     ? "floor"
                 : face->role == PP_GBXML_CEILING ? "ceiling"
                                                  : wall_name(normal));
        face->reflectance = surfaces && from >= 0 ? surfaces[from]->reflectance : NAN;
        face->inner = surfaces && from >= 0 && !pp_gbxml_room_is_outer(surfaces[from]);
    }
    return PP_OK;
}

/* ---- openings ---- */

/* The distance of a point from the face's plane, inwards. */
static double height_over(const struct pp_gbxml_room *room, int face, struct pp_vec3 at)
{
    int corner = room->shell.faces[face].corners[0];
    return pp_vec_dot(pp_vec_sub(at, room->shell.corners[corner]),
                      unit_normal(room, face));
}

static struct pp_vec3 gbxml_polygon_middle(const struct pp_gbxml_polygon *polygon)
{
    struct pp_vec3 sum = {0.0, 0.0, 0.0};
    for (int i = 0; i < polygon->count; i++)
        sum = pp_vec_add(sum, polygon->corners[i]);
    return pp_vec_scale(sum, 1.0 / polygon->count);
}

/* Is a point over the face, seen along its normal? By crossings. */
static bool is_over(const struct pp_gbxml_room *room, int index, struct pp_vec3 at)
{
    const struct pp_gbxml_face *face = &room->shell.faces[index];
    struct pp_vec3 normal = unit_normal(room, index);
    struct pp_vec3 u = fabs(normal.z) < 0.9
                           ? pp_vec_cross((struct pp_vec3){0.0, 0.0, 1.0}, normal)
                           : (struct pp_vec3){1.0, 0.0, 0.0};
    struct pp_vec3 v = pp_vec_cross(normal, u);
    bool inside = false;
    for (int i = 0; i < face->count; i++) {
        struct pp_vec3 a = pp_vec_sub(room->shell.corners[face->corners[i]], at);
        struct pp_vec3 b =
            pp_vec_sub(room->shell.corners[face->corners[(i + 1) % face->count]], at);
        double au = pp_vec_dot(a, u), av = pp_vec_dot(a, v);
        double bu = pp_vec_dot(b, u), bv = pp_vec_dot(b, v);
        if ((av > 0.0) != (bv > 0.0) && au + (bu - au) * av / (av - bv) > 0.0)
            inside = !inside;
    }
    return inside;
}

/* The face nearest to the opening that looks as it does; -1: none. */
static int face_for(const struct pp_gbxml_room *room,
                    const struct pp_gbxml_opening *opening)
{
    struct pp_vec3 middle = gbxml_polygon_middle(&opening->outline);
    int nearest = -1;
    double least = reveal_m;
    for (int i = 0; i < room->shell.face_count; i++) {
        double away = fabs(height_over(room, i, middle));
        if (!(away < least) || !is_over(room, i, middle))
            continue;
        double spread = 0.0;
        for (int k = 0; k < opening->outline.count; k++)
            spread = fmax(
                spread,
                fabs(fabs(height_over(room, i, opening->outline.corners[k])) - away));
        if (spread > 0.02)
            continue;
        least = away;
        nearest = i;
    }
    return nearest;
}

/* Corners in the face's plane, in the room's sense of turning. */
static enum pp_status add_room_opening(struct pp_gbxml_room *room,
                                       struct pp_gbxml_opening *opening, int face,
                                       struct pp_error *err)
{
    const struct pp_gbxml_polygon *outline = &opening->outline;
    struct pp_vec3 normal = unit_normal(room, face), sum = {0.0, 0.0, 0.0};
    struct pp_gbxml_room_opening made = {.opening = opening, .face = face};
    made.corners = calloc((size_t)outline->count, sizeof *made.corners);
    enum pp_status status = made.corners
                                ? pp_array_append(&room->openings, room->opening_count,
                                                  sizeof *room->openings, err)
                                : pp_fail_memory(err);
    if (status != PP_OK) {
        free(made.corners);
        return status;
    }
    for (int i = 0; i < outline->count; i++) {
        struct pp_vec3 at = outline->corners[i];
        at = pp_vec_sub(at, pp_vec_scale(normal, height_over(room, face, at)));
        if (made.count == 0
            || pp_vec_length(pp_vec_sub(at, made.corners[made.count - 1])) > same_m)
            made.corners[made.count++] = at;
    }
    while (made.count > 1
           && pp_vec_length(pp_vec_sub(made.corners[0], made.corners[made.count - 1]))
                  <= same_m)
        made.count--;
    for (int i = 1; i + 1 < made.count; i++)
        sum = pp_vec_add(
            sum, pp_vec_cross(pp_vec_sub(made.corners[i], made.corners[0]),
                              pp_vec_sub(made.corners[i + 1], made.corners[0])));
    for (int i = 0, k = made.count - 1; i < k && pp_vec_dot(sum, normal) < 0.0;
         i++, k--) {
        struct pp_vec3 kept = made.corners[i];
        made.corners[i] = made.corners[k];
        made.corners[k] = kept;
    }
    room->openings[room->opening_count++] = made;
    return PP_OK;
}

/* Adds the openings of surfaces to the outside. */
static enum pp_status add_openings(struct pp_gbxml_room *room,
                                   struct pp_gbxml_surface *const *surfaces, int count,
                                   struct pp_mistakes *notes, struct pp_error *err)
{
    enum pp_status status = PP_OK;
    for (int i = 0; i < count && status == PP_OK; i++)
        for (int k = 0; k < surfaces[i]->opening_count && status == PP_OK
                        && pp_gbxml_room_is_outer(surfaces[i]);
             k++) {
            struct pp_gbxml_opening *opening = &surfaces[i]->openings[k];
            if (opening->left_out)
                continue;
            int face = face_for(room, opening);
            if (face < 0)
                pp_mistakes_add(notes, opening->line,
                                "opening \"%.60s\" lies in no face of its space; taken "
                                "as wall",
                                opening->name ? opening->name : "");
            else
                status = add_room_opening(room, opening, face, err);
        }
    return status;
}

/* ---- boxes ---- */

/* Turns the room's axes along its longest level edge, by less than an eighth of a circle
 * either way. */
static void find_axes(struct pp_gbxml_room *room)
{
    const struct pp_gbxml_shell *shell = &room->shell;
    double longest = 0.0;
    for (int i = 0; i < shell->face_count; i++)
        for (int k = 0; k < shell->faces[i].count; k++) {
            const struct pp_gbxml_face *face = &shell->faces[i];
            struct pp_vec3 way =
                pp_vec_sub(shell->corners[face->corners[(k + 1) % face->count]],
                           shell->corners[face->corners[k]]);
            double length = pp_vec_length(way);
            if (length < longest + same_m || fabs(way.z) > same_m)
                continue;
            longest = length;
            double angle = atan2(way.y, way.x);
            room->rotate_rad = angle - PP_PI / 2.0 * rint(angle / (PP_PI / 2.0));
        }
    if (fabs(room->rotate_rad) < 1e-5)
        room->rotate_rad = 0.0;
}

/* Puts the origin at the lower corner; returns the upper one in own axes. */
static struct pp_vec3 find_origin(struct pp_gbxml_room *room)
{
    const struct pp_gbxml_shell *shell = &room->shell;
    struct pp_vec3 low = {INFINITY, INFINITY, INFINITY},
                   high = {-INFINITY, -INFINITY, -INFINITY};
    room->origin = (struct pp_vec3){0.0, 0.0, 0.0};
    for (int i = 0; i < shell->corner_count; i++) {
        struct pp_vec3 at = pp_gbxml_room_own(room, shell->corners[i]);
        low = (struct pp_vec3){fmin(low.x, at.x), fmin(low.y, at.y), fmin(low.z, at.z)};
        high = (struct pp_vec3){fmax(high.x, at.x), fmax(high.y, at.y),
                                fmax(high.z, at.z)};
    }
    double c = cos(room->rotate_rad), s = sin(room->rotate_rad);
    room->origin =
        (struct pp_vec3){c * low.x - s * low.y, s * low.x + c * low.y, low.z};
    return pp_vec_sub(high, low);
}

/* True if the face lies in a side of the box of that size. */
static bool is_in_side(const struct pp_gbxml_room *room, int index, struct pp_vec3 size)
{
    const struct pp_gbxml_face *face = &room->shell.faces[index];
    const double most[3] = {size.x, size.y, size.z};
    bool in[6] = {true, true, true, true, true, true};
    for (int i = 0; i < face->count; i++) {
        struct pp_vec3 at =
            pp_gbxml_room_own(room, room->shell.corners[face->corners[i]]);
        const double own[3] = {at.x, at.y, at.z};
        for (int k = 0; k < 3; k++) {
            in[2 * k] &= fabs(own[k]) < same_m;
            in[2 * k + 1] &= fabs(own[k] - most[k]) < same_m;
        }
    }
    for (int k = 0; k < 6; k++)
        if (in[k])
            return true;
    return false;
}

/* True unless a face of the same role or side has another reflectance than the
 * first. */
static bool is_of_one_finish(const struct pp_gbxml_room *room)
{
    for (int i = 0; i < room->shell.face_count; i++)
        for (int k = 0; k < i; k++) {
            double a = room->faces[i].reflectance, b = room->faces[k].reflectance;
            if (room->faces[i].role == room->faces[k].role && a != b
                && !(isnan(a) && isnan(b)))
                return false;
        }
    return true;
}

static void find_box(struct pp_gbxml_room *room)
{
    find_axes(room);
    struct pp_vec3 size = find_origin(room);
    room->is_box = is_of_one_finish(room);
    for (int i = 0; i < room->shell.face_count && room->is_box; i++)
        room->is_box = is_in_side(room, i, size);
    room->width_m = size.x;
    room->depth_m = size.y;
    room->height_m = size.z;
    if (room->is_box)
        return;
    room->rotate_rad = 0.0;
    find_origin(room);
}

/* ---- the room ---- */

/* The surfaces of the space and, as polygons, theirs. */
static enum pp_status list_surfaces(struct pp_gbxml_surface ***surfaces,
                                    struct pp_gbxml_polygon **polygons, int *count,
                                    struct pp_gbxml_model *model,
                                    const struct pp_gbxml_space *space,
                                    struct pp_error *err)
{
    size_t most = (size_t)model->surface_count + 1;
    *count = 0;
    *surfaces = calloc(most, sizeof **surfaces);
    *polygons = calloc(most, sizeof **polygons);
    if (!*surfaces || !*polygons)
        return pp_fail_memory(err);
    for (int i = 0; i < model->surface_count; i++)
        if (pp_gbxml_room_has(&model->surfaces[i], space)) {
            (*surfaces)[*count] = &model->surfaces[i];
            (*polygons)[(*count)++] = model->surfaces[i].outline;
        }
    return PP_OK;
}

/* Replaces the room's shell by another one if that is better, and notes its kind. */
static bool take_shell(struct pp_gbxml_room *room, struct pp_gbxml_shell *other,
                       bool better, const struct pp_gbxml_space *space,
                       struct pp_mistakes *notes, const char *what)
{
    if (!better) {
        pp_gbxml_shell_clear(other);
        return false;
    }
    pp_gbxml_shell_clear(&room->shell);
    room->shell = *other;
    pp_mistakes_add(
        notes, space->line,
        "space \"%.60s\": its surfaces do not close; %s is taken, without what "
        "they say of reflectances",
        space->id, what);
    return true;
}

/* Makes the shell from the surfaces, the ShellGeometry, or the floor: the first that
 * closes. */
static enum pp_status make_shell(struct pp_gbxml_room *room, const char **why,
                                 bool *by_surfaces, const struct pp_gbxml_space *space,
                                 const struct pp_gbxml_polygon *polygons, int count,
                                 struct pp_mistakes *notes, struct pp_error *err)
{
    struct pp_gbxml_shell other;
    const char *other_why;
    enum pp_status status =
        pp_gbxml_shell_make(&room->shell, why, polygons, count, err);
    if (status == PP_OK && (*why || room->shell.lacking > 0)
        && space->shell_count > 0) {
        status = pp_gbxml_shell_make(&other, &other_why, space->shell,
                                     space->shell_count, err);
        bool better = status == PP_OK && !other_why && (*why || other.lacking == 0);
        if (take_shell(room, &other, better, space, notes, "its ShellGeometry"))
            *why = NULL, *by_surfaces = false;
    }
    if (status == PP_OK && *why) {
        status = pp_gbxml_prism_make(&other, &other_why, space, polygons, count, err);
        if (take_shell(room, &other, status == PP_OK && !other_why, space, notes,
                       "the upright prism over its floor, as high as it is"))
            *why = NULL, *by_surfaces = false;
    }
    if (status == PP_OK && !*why && room->shell.lacking > 0)
        pp_mistakes_add(notes, space->line,
                        "space \"%.60s\" is open; it is closed by %d plane %s",
                        space->id, room->shell.lacking,
                        room->shell.lacking == 1 ? "face" : "faces");
    return status;
}

enum pp_status pp_gbxml_room_make(struct pp_gbxml_room *room, const char **why,
                                  struct pp_gbxml_model *model,
                                  const struct pp_gbxml_space *space,
                                  struct pp_mistakes *notes, struct pp_error *err)
{
    struct pp_gbxml_surface **surfaces;
    struct pp_gbxml_polygon *polygons;
    int count;
    bool by_surfaces = true;
    *room = (struct pp_gbxml_room){0};
    *why = NULL;
    enum pp_status status =
        list_surfaces(&surfaces, &polygons, &count, model, space, err);
    if (status == PP_OK)
        status =
            make_shell(room, why, &by_surfaces, space, polygons, count, notes, err);
    if (status == PP_OK && !*why)
        status = name_faces(room, by_surfaces ? surfaces : NULL, err);
    if (status == PP_OK && !*why)
        find_box(room);
    if (status == PP_OK && !*why)
        status = add_openings(room, surfaces, count, notes, err);
    free(surfaces);
    free(polygons);
    return status;
}
