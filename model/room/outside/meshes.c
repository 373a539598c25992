/* meshes.c - see meshes.h. */
#include "model/room/outside/meshes.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/text.h"
#include "model/geometry/tolerance.h"
#include "model/room/build/free_surfaces.h"
#include "model/room/position.h"

/* Limit on the number of comparisons between triangles within the room's bounds and the
 * room's faces, so that a large mesh is read in a short time. */
static const double near_pairs_most = 1e5;

/* Converts a corner of the file to the room's axes. */
static struct pp_vec3 mesh_corner_in_room(const struct pp_mesh_part *part,
                                          double north_rad, struct pp_vec3 q)
{
    if (part->y_is_up)
        q = pp_vec(q.x, -q.z, q.y);
    q = pp_placement_turn(pp_vec_scale(q, part->scale),
                          part->is_outline ? north_rad : part->rotate_rad);
    return pp_vec_add(part->corner, q);
}

static enum pp_status add_far(struct pp_resolver *r, const struct pp_mesh_part *part,
                              const struct pp_vec3 triangle[3], struct pp_error *err)
{
    struct pp_surface surface = {.role = PP_FREE_SURFACE,
                                 .front = part->reflectance,
                                 .back = part->reflectance,
                                 .finish = part->finish,
                                 .owner = -1,
                                 .line = part->line};
    return pp_resolve_add_face(r, surface, triangle, 3, err);
}

static enum pp_status add_near(struct pp_resolver *r, const struct pp_mesh_part *part,
                               const struct pp_vec3 triangle[3], struct pp_error *err)
{
    struct pp_vec3 corners[3] = {triangle[0], triangle[1], triangle[2]};
    int lines[3] = {part->line, part->line, part->line};
    struct pp_surface_part surface = {.vertices = {corners, lines, 3},
                                      .reflectance = part->reflectance,
                                      .finish = part->finish,
                                      .is_of_block = true,
                                      .is_of_site = part->is_of_site,
                                      .line = part->line};
    return pp_build_free_surfaces_add(r, &surface,
                                      part->is_outline ? "outline" : "mesh", err);
}

static void say(struct pp_resolver *r, const struct pp_mesh_part *part,
                const char *what)
{
    char shown[64];
    pp_mistakes_add(r->mistakes, part->line, "%s: \"%s\" %s",
                    part->is_outline ? "outline" : "mesh",
                    pp_text_excerpt(shown, sizeof shown, part->path), what);
}

/* Adds the triangles; stops at the first triangle that is in the room. */
static enum pp_status add_mesh_triangles(struct pp_resolver *r,
                                         struct pp_world_mesh *made,
                                         const struct pp_mesh_part *part,
                                         struct pp_error *err)
{
    const struct pp_mesh_triangles *mesh = &part->file->mesh;
    const struct pp_bounds3 room = pp_position_bounds(r->world);
    int before = r->mistakes->count;
    double pairs = 0.0;
    enum pp_status status = PP_OK;
    for (int i = 0; i < mesh->triangle_count && status == PP_OK; i++) {
        struct pp_vec3 triangle[3];
        for (int k = 0; k < 3; k++) {
            triangle[k] = mesh_corner_in_room(part, r->world->north_rad,
                                              mesh->corners[mesh->triangles[i][k]]);
            pp_bounds3_add(&made->bounds, triangle[k]);
        }
        /* Skips triangles below 1 mm2, which hide nothing. */
        if (!(2.0 * PP_SAME_M * PP_SAME_M
              < pp_vec_length(pp_vec_cross(pp_vec_sub(triangle[1], triangle[0]),
                                           pp_vec_sub(triangle[2], triangle[0])))))
            continue;
        bool near = pp_position_is_near(&room, triangle, 3);
        pairs += near ? r->world->face_count : 0;
        if (pairs > near_pairs_most) {
            say(r, part,
                "has too many triangles within the bounding box of the room; expected "
                "a mesh beside the room");
            return PP_OK;
        }
        status =
            near ? add_near(r, part, triangle, err) : add_far(r, part, triangle, err);
        if (r->mistakes->count > before)
            return status;
    }
    return status;
}

static bool is_far_away(const struct pp_bounds3 *bounds)
{
    double most = fmax(fabs(bounds->low.x), fabs(bounds->high.x));
    most = fmax(most, fmax(fabs(bounds->low.y), fabs(bounds->high.y)));
    return !(fmax(most, fmax(fabs(bounds->low.z), fabs(bounds->high.z))) <= 1e5);
}

static enum pp_status add_mesh(struct pp_resolver *r, const struct pp_mesh_part *part,
                               struct pp_error *err)
{
    struct pp_world *world = r->world;
    struct pp_world_mesh *made = &world->meshes[world->mesh_count];
    *made = (struct pp_world_mesh){.name = part->name ? strdup(part->name) : NULL,
                                   .bounds = pp_bounds3_empty(),
                                   .first_side = world->surface_count,
                                   .is_outline = part->is_outline,
                                   .line = part->line};
    world->mesh_count++;
    if (part->name && !made->name)
        return pp_fail_memory(err);
    enum pp_status status = add_mesh_triangles(r, made, part, err);
    made->side_count = world->surface_count - made->first_side;
    if (status == PP_OK && is_far_away(&made->bounds))
        say(r, part,
            "extends more than 100000 m from the origin; expected a \"scale\" in "
            "metres per unit, and \"x\", \"y\" and \"z\" near the room");
    return status;
}

enum pp_status pp_build_meshes(struct pp_resolver *r, struct pp_error *err)
{
    const struct pp_room *room = r->room;
    double triangles = 0.0;
    r->world->meshes = calloc((size_t)room->mesh_count + 1, sizeof *r->world->meshes);
    if (!r->world->meshes)
        return pp_fail_memory(err);
    for (int i = 0; i < room->mesh_count; i++)
        triangles += room->meshes[i].file->mesh.triangle_count;
    if (triangles > PP_MESH_MOST) {
        pp_mistakes_add(
            r->mistakes, room->line,
            "room: the external meshes have %.0f triangles; expected at most %d",
            triangles, PP_MESH_MOST);
        return PP_OK;
    }
    enum pp_status status = PP_OK;
    for (int i = 0; i < room->mesh_count && status == PP_OK && r->watertight; i++)
        if (isfinite(room->meshes[i].reflectance))
            status = add_mesh(r, &room->meshes[i], err);
    return status;
}
