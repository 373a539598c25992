/* envelope.c - see envelope.h. */
#include "model/room/build/envelope.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/text.h"
#include "model/geometry/tolerance.h"
#include "model/room/build/outline.h"

/* Reflectance of the outer sides of the envelope; assumed. */
static const double outer_reflectance = 0.2;

static enum pp_status name_wall(struct pp_resolver *r, const char *name, int face,
                                struct pp_error *err)
{
    r->walls[r->wall_count] = strdup(name);
    if (!r->walls[r->wall_count])
        return pp_fail_memory(err);
    r->wall_faces[r->wall_count++] = face;
    return PP_OK;
}

static enum pp_status make_wall_list(struct pp_resolver *r, int most,
                                     struct pp_error *err)
{
    r->walls = calloc(most > 0 ? most : 1, sizeof *r->walls);
    r->wall_faces = calloc(most > 0 ? most : 1, sizeof *r->wall_faces);
    return r->walls && r->wall_faces ? PP_OK : pp_fail_memory(err);
}

/* A reflectance, and its finish; finish is NULL if the file gives a number. */
struct face_finish {
    double reflectance;
    const struct pp_finish *finish;
};

/* Finish of a wall: its own if the file gives one, else the finish of all walls. */
static struct face_finish finish_of_wall(const struct pp_room *room, const char *name)
{
    for (int i = 0; i < room->finish_count; i++)
        if (room->finishes[i].wall && name && strcmp(room->finishes[i].wall, name) == 0)
            return (struct face_finish){room->finishes[i].reflectance,
                                        room->finishes[i].finish};
    return (struct face_finish){room->walls, room->walls_finish};
}

/* Finish of a face with that role. */
static struct face_finish finish_of_role(const struct pp_room *room, enum pp_role role,
                                         const char *name)
{
    if (role == PP_WALL)
        return finish_of_wall(room, name);
    if (role == PP_FLOOR)
        return (struct face_finish){room->floor, room->floor_finish};
    return (struct face_finish){room->ceiling, room->ceiling_finish};
}

static struct face_finish finish_of_face(const struct pp_room *room,
                                         const struct pp_face_part *face)
{
    if (!isnan(face->reflectance))
        return (struct face_finish){face->reflectance, face->finish};
    return finish_of_role(room, face->role, face->name);
}

/* Returns true, with a report, if the wall has the name of an earlier wall. */
static bool is_second_wall(struct pp_resolver *r, const struct pp_face_part *wall)
{
    for (const struct pp_face_part *face = r->room->plan.faces; face < wall; face++)
        if (face->role == PP_WALL && face->name
            && strcmp(face->name, wall->name) == 0) {
            char name[64];
            pp_mistakes_add(r->mistakes, wall->line,
                            "face: has the same wall name \"%s\" as line %d; expected "
                            "a different name for every wall",
                            pp_text_excerpt(name, sizeof name, wall->name), face->line);
            return true;
        }
    return false;
}

static enum pp_status add_envelope_face(struct pp_resolver *r, enum pp_role role,
                                        const char *name, struct face_finish finish,
                                        int line, const struct pp_vec3 *vertices,
                                        int count, struct pp_error *err)
{
    struct pp_surface face = {.role = role,
                              .inside = true,
                              .name = name,
                              .front = finish.reflectance,
                              .back = outer_reflectance,
                              .finish = finish.finish,
                              .owner = -1,
                              .line = line};
    return pp_resolve_add_face(r, face, vertices, count, err);
}

/* Makes floor, ceiling, and a wall on each edge of the counter-clockwise ring. Walls
 * are numbered by the edges of the file. If the ring is reversed (turned), edge i of
 * the ring is edge count - 2 - i (modulo count) of the file. */
static enum pp_status raise_plan(struct pp_resolver *r, const struct pp_vec3 *ring,
                                 int count, bool turned, struct pp_error *err)
{
    const struct pp_room *room = r->room;
    double height_m = room->plan.height_m;
    int line = room->plan.line;
    struct pp_vec3 *level = malloc(count * sizeof *level);
    if (!level)
        return pp_fail_memory(err);

    enum pp_status status =
        add_envelope_face(r, PP_FLOOR, NULL, finish_of_role(room, PP_FLOOR, NULL), line,
                          ring, count, err);
    for (int i = 0; i < count; i++) {
        struct pp_vec3 corner = ring[count - 1 - i];
        level[i] = pp_vec(corner.x, corner.y, height_m);
    }
    if (status == PP_OK)
        status = add_envelope_face(r, PP_CEILING, NULL,
                                   finish_of_role(room, PP_CEILING, NULL), line, level,
                                   count, err);
    free(level);

    for (int i = 0; i < count && status == PP_OK; i++) {
        /* Seen from inside, the edge runs from right to left. */
        struct pp_vec3 right = ring[i], left = ring[(i + 1) % count];
        struct pp_vec3 wall[4] = {left, right, pp_vec(right.x, right.y, height_m),
                                  pp_vec(left.x, left.y, height_m)};
        int named = turned ? (2 * count - 2 - i) % count : i;
        status = add_envelope_face(r, PP_WALL, r->walls[named],
                                   finish_of_wall(room, r->walls[named]), line, wall, 4,
                                   err);
        r->wall_faces[named] = r->world->surface_count - 1;
    }
    return status;
}

static enum pp_status resolve_rectangle(struct pp_resolver *r, struct pp_error *err)
{
    static const char *const names[] = {"south", "east", "north", "west"};
    const struct pp_plan_part *plan = &r->room->plan;
    if (make_wall_list(r, 4, err) != PP_OK)
        return PP_SYSTEM;
    for (int i = 0; i < 4; i++)
        if (name_wall(r, names[i], -1, err) != PP_OK)
            return PP_SYSTEM;
    if (!isfinite(plan->width_m) || !isfinite(plan->depth_m)
        || !isfinite(plan->height_m))
        return PP_OK;
    if (plan->width_m < PP_SAME_M || plan->depth_m < PP_SAME_M
        || plan->height_m < PP_SAME_M) {
        pp_mistakes_add(r->mistakes, plan->line,
                        "plan: is %g m wide, %g m deep and %g m high; expected at "
                        "least 1 mm in each direction",
                        plan->width_m, plan->depth_m, plan->height_m);
        return PP_OK;
    }
    struct pp_vec3 ring[4] = {{0.0, 0.0, 0.0},
                              {plan->width_m, 0.0, 0.0},
                              {plan->width_m, plan->depth_m, 0.0},
                              {0.0, plan->depth_m, 0.0}};
    return raise_plan(r, ring, 4, false, err);
}

static enum pp_status resolve_plan(struct pp_resolver *r, struct pp_error *err)
{
    const struct pp_plan_part *plan = &r->room->plan;
    int count = plan->vertices.count;
    if (make_wall_list(r, count, err) != PP_OK)
        return PP_SYSTEM;
    for (int i = 0; i < count; i++) {
        char name[16];
        snprintf(name, sizeof name, "%d", i + 1);
        if (name_wall(r, name, -1, err) != PP_OK)
            return PP_SYSTEM;
    }
    bool good = pp_build_outline_is_good(r, "plan", plan->line, &plan->vertices);
    if (isfinite(plan->height_m) && plan->height_m < PP_SAME_M) {
        pp_mistakes_add(r->mistakes, plan->line,
                        "plan: is %g m high; expected 1 mm or more", plan->height_m);
        good = false;
    }
    if (!good || !isfinite(plan->height_m))
        return PP_OK;
    const struct pp_vec3 *ring = plan->vertices.list;
    if (pp_polygon_area_vector(ring, count).z > 0.0)
        return raise_plan(r, ring, count, false, err);

    /* Continues with the reversed plan, to find further mistakes. */
    pp_mistakes_add(r->mistakes, plan->line,
                    "plan: its vertices are clockwise seen from above; expected "
                    "counter-clockwise");
    struct pp_vec3 *turned = malloc(count * sizeof *turned);
    if (!turned)
        return pp_fail_memory(err);
    for (int i = 0; i < count; i++)
        turned[i] = ring[count - 1 - i];
    enum pp_status status = raise_plan(r, turned, count, true, err);
    free(turned);
    return status;
}

/* Adds the faces of an envelope as given in the file. */
static enum pp_status resolve_faces(struct pp_resolver *r, struct pp_error *err)
{
    const struct pp_plan_part *plan = &r->room->plan;
    if (make_wall_list(r, plan->face_count, err) != PP_OK)
        return PP_SYSTEM;
    for (int i = 0; i < plan->face_count; i++) {
        const struct pp_face_part *part = &plan->faces[i];
        char what[96], name[64];
        snprintf(what, sizeof what, "face \"%s\"",
                 pp_text_excerpt(name, sizeof name, part->name ? part->name : ""));
        bool good = pp_build_outline_is_good(r, part->name ? what : "face", part->line,
                                             &part->vertices);
        r->faces_missing |= !good;
        if (good) {
            if (add_envelope_face(r, part->role, part->name,
                                  finish_of_face(r->room, part), part->line,
                                  part->vertices.list, part->vertices.count, err)
                != PP_OK)
                return PP_SYSTEM;
        }
        if (part->role != PP_WALL || !part->name)
            continue;
        if (!is_second_wall(r, part)
            && name_wall(r, part->name, good ? r->world->surface_count - 1 : -1, err)
                   != PP_OK)
            return PP_SYSTEM;
    }
    return PP_OK;
}

/* Checks that each finish names an existing wall, and that no wall has two. */
static enum pp_status check_finishes(struct pp_resolver *r, struct pp_error *err)
{
    const struct pp_room *room = r->room;
    int *lines = calloc(r->wall_count + 1, sizeof *lines); /* by wall: line of finish */
    if (!lines)
        return pp_fail_memory(err);
    for (int i = 0; i < room->plan.face_count; i++) {
        const struct pp_face_part *face = &room->plan.faces[i];
        if (face->role != PP_WALL || !face->name || isnan(face->reflectance))
            continue;
        int wall = pp_resolve_wall_index(r, face->name, "face", face->line);
        if (wall >= 0)
            lines[wall] = face->line;
    }
    for (int i = 0; i < room->finish_count; i++) {
        const struct pp_finish_part *finish = &room->finishes[i];
        int wall = pp_resolve_wall_index(r, finish->wall, "finish", finish->line);
        if (wall >= 0 && lines[wall] > 0)
            pp_mistakes_add(r->mistakes, finish->line,
                            "finish: the wall already has a finish, on line %d; "
                            "expected at most one",
                            lines[wall]);
        else if (wall >= 0)
            lines[wall] = finish->line;
    }
    free(lines);
    return PP_OK;
}

enum pp_status pp_build_envelope(struct pp_resolver *r, struct pp_error *err)
{
    const struct pp_plan_part *plan = &r->room->plan;
    enum pp_status status = PP_OK;
    if (plan->envelope)
        status = resolve_faces(r, err);
    else if (plan->line != 0)
        status = plan->rectangle ? resolve_rectangle(r, err) : resolve_plan(r, err);
    if (status != PP_OK)
        return status;

    if (check_finishes(r, err) != PP_OK)
        return PP_SYSTEM;
    struct pp_world *world = r->world;
    world->face_count = world->surface_count;
    for (int i = 0; i < world->face_count; i++)
        for (int k = 0; k < world->surfaces[i].outline.count; k++)
            world->height_m =
                fmax(world->height_m, world->surfaces[i].outline.vertices[k].z);
    return PP_OK;
}
