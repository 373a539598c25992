/* rad_ground.c - see rad_ground.h. */
#include "formats/radiance/write/rad_ground.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "model/geometry/bounds.h"
#include "model/geometry/clipper.h"
#include "model/geometry/tolerance.h"
#include "model/room/ground.h"
#include "model/room/position.h"
#include "model/room/section.h"

static const double WIDE = 100.0;
/* From a hole to the inner edge of the disc, at least. */
static const double MARGIN_M = 1.0;

struct rad_ground_builder {
    struct pp_scene_description *scene;
    int material;
    struct pp_vec3 middle; /* of the ground below the room */
    double reach_m;        /* from there to what is farthest */
    struct pp_error *err;
};

static void measure_ground(struct rad_ground_builder *b, const struct pp_world *world)
{
    struct pp_bounds3 room = pp_position_bounds(world);
    double level = pp_ground_level(world) - 2.0 * PP_SET_OFF_M;
    b->middle = pp_bounds3_middle(&room);
    b->middle.z = level;
    for (int i = 0; i < world->surface_count; i++) {
        const struct pp_surface *surface = &world->surfaces[i];
        /* The wall of a skyline is as long as half the disc is wide. */
        if (surface->role == PP_SKYLINE)
            b->reach_m = fmax(b->reach_m, world->skylines[surface->owner].distance_m);
        else
            for (int k = 0; k < surface->outline.count; k++)
                b->reach_m = fmax(
                    b->reach_m,
                    pp_vec_length(pp_vec_sub(surface->outline.vertices[k], b->middle)));
    }
}

static enum pp_status add_disc(struct rad_ground_builder *b, double hole_m)
{
    const struct pp_shape disc = {
        .kind = PP_SHAPE_RING,
        .material = b->material,
        .back_material = -1,
        .is.ring = {b->middle, pp_vec(0.0, 0.0, 1.0), {hole_m, WIDE * b->reach_m}}};
    return pp_scene_description_add_shape(b->scene, &disc, NULL, b->err);
}

/* ---- round a room that reaches below the ground ---- */

static enum pp_status add_ground_triangle(struct rad_ground_builder *b, double xy[3][2])
{
    struct pp_vec3 corners[3];
    if (!(pp_region_turn(xy[0], xy[1], xy[2]) > PP_SAME_M * PP_SAME_M))
        return PP_OK;
    for (int i = 0; i < 3; i++)
        corners[i] = pp_vec(xy[i][0], xy[i][1], b->middle.z);
    return pp_scene_description_add_polygon(b->scene, corners, 3, b->material, NULL,
                                            b->err);
}

/* A square less the room, as triangles. */
static enum pp_status add_square(struct rad_ground_builder *b, double half_m,
                                 const struct pp_region *room)
{
    double x = b->middle.x, y = b->middle.y;
    const double corners[4][2] = {{x - half_m, y - half_m},
                                  {x + half_m, y - half_m},
                                  {x + half_m, y + half_m},
                                  {x - half_m, y + half_m}};
    struct pp_region square = {0}, left = {0};
    struct pp_clipper *clipper = NULL;
    double(*triangles)[3][2] = NULL;
    int count = 0;
    enum pp_status status = pp_clipper_create(&clipper, b->err);
    if (status == PP_OK)
        status = pp_clipper_of_ring(clipper, &square, corners, 4, b->err);
    if (status == PP_OK)
        status = pp_clipper_difference(clipper, &left, &square, room, b->err);
    if (status == PP_OK)
        status = pp_clipper_triangulate(clipper, &triangles, &count, &left, b->err);
    for (int i = 0; i < count && status == PP_OK; i++)
        status = add_ground_triangle(b, triangles[i]);
    free(triangles);
    pp_region_clear(&left);
    pp_region_clear(&square);
    pp_clipper_destroy(clipper);
    return status;
}

/* The disc begins at the circle within the square: where both are they are one. */
static enum pp_status add_round(struct rad_ground_builder *b,
                                const struct pp_region *room)
{
    double half_m = 0.0;
    for (int i = 0; i < room->count; i++)
        for (int k = 0; k < room->rings[i].count; k++)
            half_m = fmax(half_m, hypot(room->rings[i].xy[k][0] - b->middle.x,
                                        room->rings[i].xy[k][1] - b->middle.y));
    half_m += MARGIN_M;
    enum pp_status status = add_square(b, half_m, room);
    return status == PP_OK ? add_disc(b, half_m) : status;
}

enum pp_status pp_rad_ground_add(struct pp_scene_description *scene,
                                 const struct pp_world *world, double reflectance,
                                 struct pp_error *err)
{
    struct rad_ground_builder b = {.scene = scene, .err = err};
    struct pp_material ground = pp_material_diffuse(pp_rgb_grey(reflectance));
    snprintf(ground.name, sizeof ground.name, "ground");
    struct pp_region room = {0};
    measure_ground(&b, world);
    enum pp_status status =
        pp_scene_description_add_material(scene, &ground, &b.material, err);
    if (status == PP_OK)
        status = pp_section_at(&room, world, b.middle.z, err);
    if (status == PP_OK)
        status = room.count > 0 ? add_round(&b, &room) : add_disc(&b, 0.0);
    pp_region_clear(&room);
    return status;
}
