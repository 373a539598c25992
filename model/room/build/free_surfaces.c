/* free_surfaces.c - see free_surfaces.h.
 *
 * A surface may touch the room's faces, or lie in one, like a picture on a wall; it is
 * then offset into the room. Faces of the building's other rooms, and pieces of their
 * facades, are added here too. They are outside the room; a face that lies in a face of
 * this room is offset outwards.
 */
#include "model/room/build/free_surfaces.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/text.h"
#include "model/geometry/polygons_cross.h"
#include "model/geometry/tolerance.h"
#include "model/room/position.h"
#include "model/room/build/outline.h"

/* Sides of the envelope on which points of a surface lie, and one such point per
 * side. */
struct sides_seen {
    bool inside, outside;
    struct pp_vec3 inside_at, outside_at;
};

static bool is_on_envelope(const struct pp_world *world, struct pp_vec3 point)
{
    for (int i = 0; i < world->face_count; i++)
        if (pp_polygon_distance(&world->surfaces[i].outline, point) <= PP_SAME_M)
            return true;
    return false;
}

static void note_side_of_point(struct sides_seen *seen, const struct pp_world *world,
                               struct pp_vec3 point)
{
    if (is_on_envelope(world, point))
        return;
    if (pp_position_in_room(world, point)) {
        seen->inside = true;
        seen->inside_at = point;
    } else {
        seen->outside = true;
        seen->outside_at = point;
    }
}

/* Finds the sides of the envelope on which the vertices, the midpoints of edges, and
 * the centroids of the polygon's triangles lie. */
static enum pp_status look_over(struct sides_seen *seen, struct pp_resolver *r,
                                const struct pp_polygon *polygon, struct pp_error *err)
{
    int count = polygon->count;
    double(*xy)[2] = malloc(count * sizeof *xy), (*triangles)[3][2] = NULL;
    int triangle_count = 0;
    if (!xy)
        return pp_fail_memory(err);
    struct pp_vec3 along, up, origin = polygon->vertices[0];
    pp_polygon_plane_axes(polygon->normal, &along, &up);
    pp_polygon_flatten(polygon->vertices, count, origin, along, up, xy);
    struct pp_region region = {0};
    enum pp_status status =
        pp_clipper_of_ring(r->clipper, &region, (const double(*)[2])xy, count, err);
    if (status == PP_OK)
        status = pp_clipper_triangulate(r->clipper, &triangles, &triangle_count,
                                        &region, err);

    for (int i = 0; i < count; i++) {
        struct pp_vec3 p = polygon->vertices[i];
        struct pp_vec3 edge = pp_vec_sub(polygon->vertices[(i + 1) % count], p);
        note_side_of_point(seen, r->world, p);
        note_side_of_point(seen, r->world, pp_vec_along(p, 0.5, edge));
    }
    for (int i = 0; i < triangle_count; i++) {
        double x = 0.0, y = 0.0;
        for (int k = 0; k < 3; k++) {
            x += triangles[i][k][0] / 3.0;
            y += triangles[i][k][1] / 3.0;
        }
        note_side_of_point(seen, r->world,
                           pp_vec_along(pp_vec_along(origin, x, along), y, up));
    }
    pp_region_clear(&region);
    free(triangles);
    free(xy);
    return status;
}

static const char *role_word(enum pp_role role)
{
    return role == PP_FLOOR ? "floor" : role == PP_WALL ? "wall" : "ceiling";
}

/* True if a mistake that begins with this text has been reported for that line. */
static bool has_been_said(const struct pp_mistakes *mistakes, int line,
                          const char *beginning)
{
    for (int i = 0; i < mistakes->count; i++)
        if (mistakes->list[i].line == line
            && strncmp(mistakes->list[i].text, beginning, strlen(beginning)) == 0)
            return true;
    return false;
}

/* Reports a face of another room inside this one, once per pair of rooms. */
static void say_rooms_overlap(struct pp_resolver *r, const struct pp_surface_part *part,
                              struct pp_vec3 where)
{
    char other[64], own[64];
    char said[256], there[256];
    const char *name = r->world->name;
    pp_text_excerpt(own, sizeof own, name ? name : "");
    pp_text_excerpt(other, sizeof other, part->name ? part->name : "");
    snprintf(said, sizeof said, "room: \"%s\" and the room \"%s\" on line %d overlap, ",
             own, other, part->line);
    snprintf(there, sizeof there,
             "room: \"%s\" and the room \"%s\" on line %d overlap, ", other, own,
             r->room->line);
    if (has_been_said(r->mistakes, r->room->line, said)
        || has_been_said(r->mistakes, part->line, there))
        return;
    pp_mistakes_add(
        r->mistakes, r->room->line,
        "%sat (%g, %g, %g) in the axes of the first; expected rooms that at most "
        "touch",
        said, where.x, where.y, where.z);
}

/* Name of the room to whose axes the coordinates in a message refer; empty for a room's
 * own surfaces. */
static const char *room_words(char words[96], const struct pp_resolver *r,
                              const struct pp_surface_part *part)
{
    char name[64];
    words[0] = '\0';
    if (part->is_of_site)
        snprintf(
            words, 96, " \"%s\"",
            pp_text_excerpt(name, sizeof name, r->world->name ? r->world->name : ""));
    return words;
}

/* Reports a surface that crosses the envelope, or lies on a side of it where it must
 * not be; else *clear is true. */
static enum pp_status check_clear(bool *clear, struct pp_resolver *r,
                                  const struct pp_surface_part *part, const char *what,
                                  const struct pp_polygon *polygon,
                                  const struct sides_seen *seen, struct pp_error *err)
{
    const struct pp_world *world = r->world;
    struct pp_vec3 where;
    char words[96];
    bool cross = false;
    for (int i = 0; i < world->face_count && !cross; i++) {
        const struct pp_surface *face = &world->surfaces[i];
        if (pp_polygons_cross(&cross, polygon, &face->outline, &where, err) != PP_OK)
            return PP_SYSTEM;
        /* Both rooms find the overlap, but only one reports it. */
        if (cross && part->is_room_outside && part->line > r->room->line)
            say_rooms_overlap(r, part, where);
        else if (cross && !part->is_room_outside)
            pp_mistakes_add(
                r->mistakes, part->line,
                "%s: intersects a %s of the room%s at (%g, %g, %g); expected all of it "
                "%s",
                what, role_word(face->role), room_words(words, r, part), where.x,
                where.y, where.z,
                part->is_of_block || part->is_of_site ? "outside"
                : part->is_of_room                    ? "inside"
                                                      : "inside or all outside");
    }
    if (!cross && seen->inside && part->is_room_outside) {
        cross = true;
        say_rooms_overlap(r, part, seen->inside_at);
    }
    if (!cross && seen->inside && (part->is_of_site || part->is_of_block)) {
        cross = true;
        where = seen->inside_at;
        pp_mistakes_add(r->mistakes, part->line,
                        "%s: is inside the room%s at (%g, %g, %g); expected outside",
                        what, room_words(words, r, part), where.x, where.y, where.z);
    }
    if (!cross && seen->inside && seen->outside) {
        cross = true;
        struct pp_vec3 in = seen->inside_at, out = seen->outside_at;
        pp_mistakes_add(r->mistakes, part->line,
                        "%s: is in the room at (%g, %g, %g) and outside at (%g, %g, "
                        "%g); expected all of it inside or all outside",
                        what, in.x, in.y, in.z, out.x, out.y, out.z);
    }
    if (!cross && part->is_of_room && seen->outside) {
        cross = true;
        where = seen->outside_at;
        pp_mistakes_add(r->mistakes, part->line,
                        "%s: is outside the room at (%g, %g, %g); expected inside",
                        what, where.x, where.y, where.z);
    }
    *clear = !cross;
    return PP_OK;
}

/* True if the polygon crosses the centre of the opening, within the depth of its reveal
 * or immediately in front of it. */
static bool closes(const struct pp_polygon *polygon, const struct pp_opening *opening)
{
    struct pp_vec3 from = pp_polygon_middle(&opening->inner),
                   to = pp_polygon_middle(&opening->outer);
    double before = pp_polygon_height(polygon, from),
           behind = pp_polygon_height(polygon, to);
    if (pp_polygon_distance(polygon, from) <= PP_SET_OFF_M
        || pp_polygon_distance(polygon, to) <= PP_SET_OFF_M)
        return true;
    if (before * behind >= 0.0)
        return false;
    struct pp_vec3 across =
        pp_vec_along(from, before / (before - behind), pp_vec_sub(to, from));
    return pp_polygon_side(polygon, across, PP_SET_OFF_M) != PP_OUTSIDE;
}

/* Reports openings that are blocked by the face of another room. */
static void check_openings(struct pp_resolver *r, const struct pp_surface_part *part,
                           const struct pp_polygon *polygon)
{
    for (int i = 0; i < r->world->opening_count; i++) {
        const struct pp_opening *opening = &r->world->openings[i];
        char name[64];
        if (!closes(polygon, opening))
            continue;
        pp_mistakes_add(
            r->mistakes, opening->line,
            "the opening is blocked by the %s \"%s\" on line %d in front of it; "
            "expected open air",
            part->is_front ? "facade of the room" : "room",
            pp_text_excerpt(name, sizeof name, part->name ? part->name : ""),
            part->line);
    }
}

/* Projects the vertices onto the polygon's plane. */
static void flatten_to_plane(struct pp_polygon *polygon)
{
    struct pp_vec3 middle = pp_polygon_middle(polygon), n = polygon->normal;
    for (int k = 0; k < polygon->count; k++) {
        struct pp_vec3 *v = &polygon->vertices[k];
        *v = pp_vec_along(*v, -pp_vec_dot(n, pp_vec_sub(*v, middle)), n);
    }
}

/* Offsets a surface that lies in a face of the envelope: inwards if `inside`, else
 * outwards. is_of_room: the surface is a face or a facade of another room, and its
 * normal points into that room. Such a surface is offset only if the two rooms are on
 * opposite sides of it; two fronts in one plane stay as they are. */
static void set_off(const struct pp_world *world, struct pp_polygon *polygon,
                    bool inside, bool is_of_room)
{
    for (int i = 0; i < world->face_count; i++) {
        const struct pp_polygon *face = &world->surfaces[i].outline;
        double nearest = INFINITY, farthest = 0.0;
        for (int k = 0; k < polygon->count; k++) {
            double height = pp_polygon_height(face, polygon->vertices[k]);
            nearest = fmin(nearest, fabs(height));
            farthest = fmax(farthest, fabs(height));
        }
        if (farthest >= PP_SET_OFF_M
            || (is_of_room && pp_vec_dot(polygon->normal, face->normal) > 0.0))
            continue;
        double shift = inside ? PP_SET_OFF_M + nearest : -PP_SET_OFF_M - nearest;
        for (int k = 0; k < polygon->count; k++)
            polygon->vertices[k] =
                pp_vec_along(polygon->vertices[k], shift, face->normal);
        return;
    }
}

static bool is_near(const struct pp_world *world, const struct pp_polygon *polygon)
{
    const struct pp_bounds3 room = pp_position_bounds(world);
    return pp_position_is_near(&room, polygon->vertices, polygon->count);
}

/* Finds the side of the envelope on which the surface lies, and whether it crosses the
 * envelope. */
static enum pp_status place_free_surface(struct sides_seen *seen, bool *clear,
                                         struct pp_resolver *r,
                                         const struct pp_surface_part *part,
                                         const char *what,
                                         const struct pp_polygon *polygon,
                                         struct pp_error *err)
{
    *seen = (struct sides_seen){0};
    enum pp_status status = look_over(seen, r, polygon, err);
    return status == PP_OK ? check_clear(clear, r, part, what, polygon, seen, err)
                           : status;
}

enum pp_status pp_build_free_surfaces_add(struct pp_resolver *r,
                                          const struct pp_surface_part *part,
                                          const char *what, struct pp_error *err)
{
    struct pp_surface surface = {.role = PP_FREE_SURFACE,
                                 .front = part->reflectance,
                                 .back = part->reflectance,
                                 .exitance = part->exitance,
                                 .finish = part->finish,
                                 .name = part->name,
                                 .owner = -1,
                                 .is_shade = part->is_shade,
                                 .is_of_fitting = part->is_of_room,
                                 .line = part->line};
    if (pp_polygon_of(&surface.outline, part->vertices.list, part->vertices.count, err)
        != PP_OK)
        return PP_SYSTEM;
    struct sides_seen seen = {.outside = true};
    bool clear = true;
    enum pp_status status = PP_OK;
    /* A surface that belongs inside is checked even if it is far away. */
    if (part->is_of_room || is_near(r->world, &surface.outline))
        status =
            place_free_surface(&seen, &clear, r, part, what, &surface.outline, err);
    if (status == PP_OK && clear && (part->is_room_outside || part->is_front))
        check_openings(r, part, &surface.outline);
    if (status != PP_OK || !clear) {
        pp_polygon_clear(&surface.outline);
        return status;
    }
    /* A surface that lies entirely in the envelope counts as inside. */
    surface.inside = (seen.inside || !seen.outside) && !part->is_room_outside
                     && !part->is_of_site && !part->is_of_block;
    flatten_to_plane(&surface.outline);
    if (!r->keeps_places)
        set_off(r->world, &surface.outline, surface.inside,
                part->is_room_outside || part->is_front);
    return pp_resolve_add_surface(r, &surface, err);
}

enum pp_status pp_build_free_surfaces(struct pp_resolver *r, struct pp_error *err)
{
    const struct pp_room *room = r->room;
    for (int i = 0; i < room->surface_count; i++) {
        const struct pp_surface_part *part = &room->surfaces[i];
        if (!pp_build_outline_is_good(r, "surface", part->line, &part->vertices)
            || !r->watertight || !isfinite(part->reflectance)
            || !isfinite(part->exitance))
            continue;
        enum pp_status status =
            pp_build_free_surfaces_add(r, part,
                                       part->what          ? part->what
                                       : part->is_of_block ? "block"
                                                           : "surface",
                                       err);
        if (status != PP_OK)
            return status;
    }
    return PP_OK;
}
