/* light_scene_of_world.c - the parts of a world's surfaces and panes, with their
 * materials and triangles. */
#include "simulate/scene/light_scene_of_world.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "model/base/array.h"
#include "model/room/ground.h"
#include "model/room/surface_materials.h"
#include "simulate/sampling/lobe.h"
#include "simulate/sampling/triangle.h"
#include "simulate/scene/emitters.h"
#include "simulate/scene/light_scene_parts.h"

/* Sets the box around all surfaces, and the scene's centre and size. Centre and size
 * are those of the room's box or, without a room, of the box around all surfaces. */
static void measure_world_scene(struct pp_light_scene *scene)
{
    const struct pp_world *world = scene->world;
    if (world->surface_count == 0)
        return;
    scene->bounds = pp_bounds3_empty();
    for (int i = 0; i < world->surface_count; i++)
        for (int k = 0; k < world->surfaces[i].outline.count; k++)
            pp_bounds3_add(&scene->bounds, world->surfaces[i].outline.vertices[k]);
    struct pp_bounds3 room = pp_light_scene_bounds(scene, true);
    scene->centre = pp_bounds3_middle(&room);
    struct pp_vec3 half = pp_vec_scale(pp_vec_sub(room.high, room.low), 0.5);
    scene->size_m = fmax(half.x, fmax(half.y, half.z));
}

static struct pp_light_part part_of_outline(const struct pp_light_scene *scene,
                                            int index, const struct pp_polygon *outline,
                                            const int material[2])
{
    struct pp_light_part part = pp_light_scene_parts_of(index, material);
    part.normal = outline->normal;
    part.area_m2 = outline->area_m2;
    part.offset_m =
        pp_vec_dot(outline->normal, pp_vec_sub(outline->vertices[0], scene->centre));
    pp_lobe_frame(part.normal, &part.a, &part.b);
    return part;
}

static void make_parts(struct pp_light_scene *scene, const int (*sides)[2])
{
    const struct pp_world *world = scene->world;
    for (int i = 0; i < world->surface_count; i++) {
        const struct pp_surface *surface = &world->surfaces[i];
        unsigned char space = surface->inside ? PP_INDOORS : PP_OUTDOORS;
        struct pp_light_part part =
            part_of_outline(scene, i, &surface->outline, sides[i]);
        part.envelope = i < world->face_count || surface->role == PP_REVEAL;
        part.space[0] = space;
        part.space[1] = part.envelope ? PP_OUTDOORS : space;
        part.back_emits = true;
        scene->parts[scene->part_count++] = part;
        scene->most_exitance = fmax(scene->most_exitance, surface->exitance);
        scene->reflects |=
            surface->front > 0.0 || (!part.envelope && surface->back > 0.0);
    }
    for (int i = 0; i < world->opening_count; i++) {
        const struct pp_opening *opening = &world->openings[i];
        int index = scene->part_count++;
        struct pp_light_part part =
            part_of_outline(scene, index, &opening->outer, sides[index]);
        part.window = i;
        part.space[0] = PP_INDOORS;
        part.space[1] = PP_OUTDOORS;
        part.envelope = true;
        scene->parts[index] = part;
        scene->reflects |=
            opening->glass.panes > 0 || world->surfaces[opening->face].front > 0.0;
    }
    for (int i = 0; i < world->outer_pane_count; i++) {
        int index = scene->part_count++;
        struct pp_light_part part =
            part_of_outline(scene, index, &world->outer_panes[i].outline, sides[index]);
        part.space[0] = part.space[1] = PP_OUTDOORS;
        scene->parts[index] = part;
    }
}

static enum pp_status add_world_triangles(struct pp_light_scene *scene,
                                          struct pp_triangles *list,
                                          struct pp_error *err)
{
    const struct pp_world *world = scene->world;
    struct pp_clipper *clipper = NULL;
    enum pp_status status = pp_clipper_create(&clipper, err);
    for (int i = 0; status == PP_OK && i < world->surface_count; i++)
        status = pp_triangles_of_surface(list, clipper, world, i, scene->centre, err);
    for (int i = 0; status == PP_OK && i < world->outer_pane_count; i++)
        status = pp_triangles_of_polygon(
            list, clipper, &world->outer_panes[i].outline,
            world->surface_count + world->opening_count + i, scene->centre, err);
    int first_pane = list->count;
    for (int i = 0; status == PP_OK && i < world->opening_count; i++)
        status = pp_triangles_of_polygon(list, clipper, &world->openings[i].outer,
                                         world->surface_count + i, scene->centre, err);
    if (status == PP_OK)
        status = pp_triangles_of_plane(&scene->plane, &scene->plane_count, clipper,
                                       world, scene->centre, err);
    pp_clipper_destroy(clipper);
    for (int i = 0; i < scene->plane_count; i++)
        scene->plane_area_m2 += pp_triangle_area(scene->plane[i]);
    if (status == PP_OK)
        status = pp_openings_find(scene, list, first_pane, err);
    if (status == PP_OK)
        status = pp_coarse_openings_find(&scene->coarse, world, scene->centre, err);
    if (status == PP_OK)
        pp_convex_room_find_niches(scene);
    if (status == PP_OK)
        status = pp_reflectors_find(scene, err);
    if (status == PP_OK)
        status = pp_window_images_find(scene, err);
    if (status == PP_OK)
        status = pp_convex_room_create(&scene->convex, scene, err);
    return status == PP_OK ? pp_light_scene_add_rays(scene, list, err) : status;
}

/* Adds the sun as a disc of half a degree that produces the sun's illuminance. */
static enum pp_status add_sun_disc(struct pp_light_scene *scene,
                                   const struct pp_outside_sun *sun,
                                   struct pp_error *err)
{
    static const double HALF_RAD = 0.2665 * PP_RAD;
    double half = sin(HALF_RAD / 2.0), solid = 4.0 * PP_PI * half * half;
    enum pp_status status = pp_array_append(&scene->materials, scene->material_count,
                                            sizeof *scene->materials, err);
    if (status != PP_OK)
        return status;
    scene->distants = calloc(1, sizeof *scene->distants);
    if (!scene->distants)
        return pp_fail_memory(err);
    struct pp_material *material = &scene->materials[scene->material_count];
    *material = pp_material_light(pp_rgb_grey(sun->per_sky / solid));
    snprintf(material->name, sizeof material->name, "sun");
    const struct pp_shape disc = {.kind = PP_SHAPE_DISTANT,
                                  .material = scene->material_count++,
                                  .back_material = -1,
                                  .tag = -1,
                                  .is.distant = {sun->to, HALF_RAD}};
    return pp_emitters_add_distant(scene, &disc, err);
}

static enum pp_status build_world_scene(struct pp_light_scene *scene,
                                        enum pp_surface_look look,
                                        const struct pp_outside_sun *sun,
                                        struct pp_error *err)
{
    const struct pp_world *world = scene->world;
    struct pp_surface_materials materials;
    struct pp_triangles list = {.facet_of = NULL};
    scene->has_room = world->face_count > 0;
    scene->decorations = world->decorations;
    measure_world_scene(scene);
    scene->parts = calloc((size_t)world->surface_count + (size_t)world->opening_count
                              + (size_t)world->outer_pane_count + 1,
                          sizeof *scene->parts);
    if (!scene->parts)
        return pp_fail_memory(err);
    enum pp_status status = pp_surface_materials_init(&materials, world, look, err);
    if (status == PP_OK) {
        make_parts(scene, (const int(*)[2])materials.sides);
        scene->materials = materials.list;
        scene->material_count = materials.count;
        free(materials.sides);
        if (sun && sun->per_sky > 0.0)
            status = add_sun_disc(scene, sun, err);
    }
    if (status == PP_OK) {
        status = pp_light_scene_add_laws(scene, err);
    }
    if (status == PP_OK)
        status = pp_scene_skylines_init(&scene->skylines, world, err);
    scene->ground = (struct pp_scene_ground){!world->ground_is_open,
                                             pp_ground_level(world) - scene->centre.z};
    if (status == PP_OK)
        status = add_world_triangles(scene, &list, err);
    if (status == PP_OK && look != PP_LOOK_COLOURED)
        status = pp_glass_images_find(scene, err);
    pp_triangles_clear(&list);
    return status;
}

static enum pp_status make_light_scene(struct pp_light_scene **result,
                                       const struct pp_world *world,
                                       enum pp_surface_look look,
                                       const struct pp_outside_sun *sun,
                                       struct pp_error *err)
{
    *result = NULL;
    struct pp_light_scene *scene = calloc(1, sizeof *scene);
    if (!scene)
        return pp_fail_memory(err);
    scene->world = world;
    enum pp_status status = build_world_scene(scene, look, sun, err);
    if (status != PP_OK) {
        pp_light_scene_destroy(scene);
        return status;
    }
    *result = scene;
    return PP_OK;
}

enum pp_status pp_light_scene_of_world(struct pp_light_scene **scene,
                                       const struct pp_world *world,
                                       struct pp_error *err)
{
    return make_light_scene(scene, world, PP_LOOK_COLOURED, NULL, err);
}

enum pp_status pp_light_scene_of_world_sunlit(struct pp_light_scene **scene,
                                              const struct pp_world *world,
                                              const struct pp_outside_sun *sun,
                                              struct pp_error *err)
{
    return make_light_scene(scene, world, PP_LOOK_COLOURED, sun, err);
}

enum pp_status pp_light_scene_of_world_matt(struct pp_light_scene **scene,
                                            const struct pp_world *world,
                                            struct pp_error *err)
{
    return make_light_scene(scene, world, PP_LOOK_MATT, NULL, err);
}

enum pp_status pp_light_scene_of_world_grey(struct pp_light_scene **scene,
                                            const struct pp_world *world,
                                            struct pp_error *err)
{
    return make_light_scene(scene, world, PP_LOOK_GREY, NULL, err);
}

struct pp_vec3 pp_light_scene_of_world_plane_point(const struct pp_light_scene *scene,
                                                   double u, double v)
{
    return pp_triangle_point_of((const struct pp_vec3(*)[3])scene->plane,
                                scene->plane_count, scene->plane_area_m2, u, v);
}
