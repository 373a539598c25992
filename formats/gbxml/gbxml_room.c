/* gbxml_room.c - faces of one space, and the test for a box. */
#include "formats/gbxml/gbxml_room.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "formats/gbxml/gbxml_envelope.h"
#include "formats/gbxml/gbxml_planes.h"
#include "model/geometry/polygon.h"

void pp_gbxml_room_clear(struct pp_gbxml_room *room)
{
    for (int i = 0; i < room->opening_count; i++)
        free(room->openings[i].corners);
    free(room->openings);
    free(room->faces);
    pp_gbxml_shell_clear(&room->shell);
    *room = (struct pp_gbxml_room){0};
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

/* Appends -2, -3 ... to a name that an earlier face already has. */
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

/* Returns the surface from which a face was made. If the faces were not made from
 * surfaces, returns the nearest parallel surface within 0.6 m. NULL: none. */
static const struct pp_gbxml_surface *surface_of(
    const struct pp_gbxml_room *room, int index,
    struct pp_gbxml_surface *const *surfaces, int count)
{
    const struct pp_gbxml_face *face = &room->shell.faces[index];
    const struct pp_gbxml_surface *nearest = NULL;
    struct pp_vec3 normal = unit_normal(room, index), middle = {0};
    double least = 0.6;
    if (room->by_surfaces)
        return face->from >= 0 ? surfaces[face->from] : NULL;
    for (int i = 0; i < face->count; i++)
        middle = pp_vec_along(middle, 1.0 / face->count,
                              room->shell.corners[face->corners[i]]);
    for (int i = 0; i < count; i++) {
        struct pp_polygon polygon = {.count = surfaces[i]->outline.count,
                                     .vertices = surfaces[i]->outline.corners};
        pp_polygon_measure(&polygon);
        if (!(fabs(pp_vec_dot(polygon.normal, normal)) > 0.98))
            continue;
        double away = pp_polygon_distance(&polygon, middle);
        if (away < least)
            least = away, nearest = surfaces[i];
    }
    return nearest;
}

static enum pp_status name_faces(struct pp_gbxml_room *room,
                                 struct pp_gbxml_surface *const *surfaces, int count,
                                 struct pp_error *err)
{
    room->faces = calloc((size_t)room->shell.face_count + 1, sizeof *room->faces);
    if (!room->faces)
        return pp_fail_memory(err);
    for (int i = 0; i < room->shell.face_count; i++) {
        struct pp_gbxml_room_face *face = &room->faces[i];
        struct pp_vec3 normal = unit_normal(room, i);
        const struct pp_gbxml_surface *surface = surface_of(room, i, surfaces, count);
        face->role = normal.z > 0.5    ? PP_GBXML_FLOOR
                     : normal.z < -0.2 ? PP_GBXML_CEILING
                                       : PP_GBXML_WALL;
        make_own(room->faces, i,
                 face->role == PP_GBXML_FLOOR     ? "floor"
                 : face->role == PP_GBXML_CEILING ? "ceiling"
                                                  : wall_name(normal));
        face->reflectance = surface ? surface->reflectance : NAN;
        face->inner = surface && !pp_gbxml_model_is_outer(surface);
    }
    return PP_OK;
}

/* ---- boxes ---- */

/* Aligns the room's axes with its longest horizontal edge, by a turn of at most 45
 * degrees. */
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
            if (length < longest + PP_GBXML_SAME_M || fabs(way.z) > PP_GBXML_SAME_M)
                continue;
            longest = length;
            double angle = atan2(way.y, way.x);
            room->rotate_rad = angle - PP_PI / 2.0 * rint(angle / (PP_PI / 2.0));
        }
    if (fabs(room->rotate_rad) < 1e-5)
        room->rotate_rad = 0.0;
}

/* Puts the origin at the lower corner; returns the upper corner in the room's own
 * axes. */
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

/* True if the face lies in a side of the box with that size. */
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
            in[2 * k] &= fabs(own[k]) < PP_GBXML_SAME_M;
            in[2 * k + 1] &= fabs(own[k] - most[k]) < PP_GBXML_SAME_M;
        }
    }
    for (int k = 0; k < 6; k++)
        if (in[k])
            return true;
    return false;
}

/* True if all faces of the same role have the same reflectance. */
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
    size = find_origin(room);
    room->width_m = size.x;
    room->depth_m = size.y;
}

/* Sets the working plane to half the height of a room too low for the default plane,
 * and widens the grid of a floor too large for the default spacing of 0.5 m. Notes
 * both. */
static void fit_plane(struct pp_gbxml_room *room, const struct pp_gbxml_model *model,
                      const struct pp_gbxml_space *space, struct pp_mistakes *notes)
{
    const double default_plane_m = 0.85, clear_m = 0.05, default_spacing_m = 0.5;
    const double points_most = fmin(4e4, 2e7 / (model->surface_count + 20.0));
    double spacing = default_spacing_m;
    room->plane_m = room->spacing_m = NAN;
    while (room->width_m * room->depth_m > points_most * spacing * spacing)
        spacing *= 2.0;
    if (spacing > default_spacing_m) {
        room->spacing_m = spacing;
        pp_mistakes_add(notes, space->line,
                        "space \"%.60s\" measures %g m by %g m and gets a grid with a "
                        "spacing of %g m",
                        space->id, room->width_m, room->depth_m, spacing);
    }
    if (room->height_m < default_plane_m + clear_m) {
        room->plane_m = 0.5 * room->height_m;
        pp_mistakes_add(
            notes, space->line,
            "space \"%.60s\" is %g m high; its working plane is at half its height",
            space->id, room->height_m);
    }
}

/* ---- the room ---- */

/* Lists the surfaces that bound the space, and their outlines as polygons. */
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
        if (pp_gbxml_model_bounds(&model->surfaces[i], space)) {
            (*surfaces)[*count] = &model->surfaces[i];
            (*polygons)[(*count)++] = model->surfaces[i].outline;
        }
    return PP_OK;
}

/* Highest corner of the openings in outer surfaces. */
static double openings_top(struct pp_gbxml_surface *const *surfaces, int count)
{
    double top = -INFINITY;
    for (int i = 0; i < count; i++)
        for (int k = 0; k < surfaces[i]->opening_count; k++) {
            const struct pp_gbxml_polygon *outline = &surfaces[i]->openings[k].outline;
            for (int j = 0; j < outline->count; j++)
                top = fmax(top, outline->corners[j].z);
        }
    return top;
}

enum pp_status pp_gbxml_room_begin(struct pp_gbxml_room *room, const char **why,
                                   struct pp_gbxml_model *model,
                                   const struct pp_gbxml_space *space,
                                   struct pp_clipper *clipper,
                                   struct pp_mistakes *notes, struct pp_error *err)
{
    struct pp_gbxml_surface **surfaces;
    struct pp_gbxml_envelope_parts parts = {.space = space};
    struct pp_gbxml_polygon *polygons;
    *room = (struct pp_gbxml_room){0};
    *why = NULL;
    enum pp_status status =
        list_surfaces(&surfaces, &polygons, &parts.count, model, space, err);
    if (status == PP_OK) {
        parts.polygons = polygons;
        parts.openings_top_m = openings_top(surfaces, parts.count);
        status = pp_gbxml_envelope_make(&room->shell, why, &room->by_surfaces, &parts,
                                        clipper, notes, err);
    }
    free(surfaces);
    free(polygons);
    return status;
}

enum pp_status pp_gbxml_room_finish(struct pp_gbxml_room *room,
                                    struct pp_gbxml_model *model,
                                    const struct pp_gbxml_space *space,
                                    struct pp_mistakes *notes, struct pp_error *err)
{
    struct pp_gbxml_surface **surfaces;
    struct pp_gbxml_polygon *polygons;
    int count, divided;
    enum pp_status status =
        list_surfaces(&surfaces, &polygons, &count, model, space, err);
    if (status == PP_OK)
        status = pp_gbxml_planes_divide(&room->shell, &divided, err);
    if (status == PP_OK && divided > 0)
        pp_mistakes_add(
            notes, space->line,
            "space \"%.60s\": %d faces are not planar and are divided into triangles",
            space->id, divided);
    if (status == PP_OK)
        status = name_faces(room, surfaces, count, err);
    if (status == PP_OK)
        find_box(room);
    if (status == PP_OK)
        fit_plane(room, model, space, notes);
    free(surfaces);
    free(polygons);
    return status;
}
