/* light_scene_of_world.c - a light scene out of a room's world: the tracer's scene, with
 * materials. */
#include <float.h>
#include <math.h>
#include <stdlib.h>

#include "model/room/surface_materials.h"
#include "simulate/scene/light_parts.h"

/* A new material is compared with so many of the last: a world of a million surfaces
 * has few of them, mostly neighbours. */
enum { LOOKED_BACK = 64 };

/* Its number among the scene's; the list has room. */
static int number_of(struct pp_light_scene *scene, struct pp_material material)
{
    int last = scene->material_count - LOOKED_BACK;
    for (int i = scene->material_count - 1; i >= 0 && i >= last; i--)
        if (pp_surface_materials_same(&scene->materials[i], &material))
            return i;
    scene->materials[scene->material_count] = material;
    return scene->material_count++;
}

static struct pp_material material_of(const struct pp_light_scene *scene, int index,
                                      bool front)
{
    return scene->matt ? pp_surface_materials_matt(scene->world, index, front)
                       : pp_surface_materials_of(scene->world, index, front);
}

static struct pp_light_part part_of(struct pp_light_scene *scene, int index)
{
    const struct pp_surface *surface = &scene->world->surfaces[index];
    const struct pp_facet *facet = &scene->room->facets[index];
    int space = surface->inside ? PP_INDOORS : PP_OUTDOORS;
    return (struct pp_light_part){
        .normal = facet->normal,
        .offset_m = facet->offset_m,
        .material = {number_of(scene, material_of(scene, index, true)),
                     number_of(scene, material_of(scene, index, false))},
        .tag = index,
        .round = -1,
        .window = -1,
        .emitter = {-1, -1},
        .mirror = -1,
        .space = {(unsigned char)space,
                  (unsigned char)(facet->envelope ? PP_OUTDOORS : space)},
        .envelope = facet->envelope,
        .back_emits = true};
}

static struct pp_light_part pane_of(struct pp_light_scene *scene, int window)
{
    int index = scene->world->surface_count + window;
    const struct pp_facet *facet = &scene->room->facets[index];
    struct pp_material in = pp_surface_materials_pane(scene->world, window, true);
    struct pp_material out = pp_surface_materials_pane(scene->world, window, false);
    return (struct pp_light_part){
        .normal = facet->normal,
        .offset_m = facet->offset_m,
        .material = {number_of(scene, in), number_of(scene, out)},
        .tag = index,
        .round = -1,
        .window = window,
        .emitter = {-1, -1},
        .mirror = -1,
        .space = {PP_INDOORS, PP_OUTDOORS},
        .envelope = true};
}

static void stretch(struct pp_light_scene *scene, const struct pp_polygon *outline)
{
    struct pp_vec3 *low = &scene->low, *high = &scene->high;
    for (int i = 0; i < outline->count; i++) {
        struct pp_vec3 v = outline->vertices[i];
        *low = pp_vec(fmin(low->x, v.x), fmin(low->y, v.y), fmin(low->z, v.z));
        *high = pp_vec(fmax(high->x, v.x), fmax(high->y, v.y), fmax(high->z, v.z));
    }
}

static enum pp_status build(struct pp_light_scene *scene, struct pp_error *err)
{
    const struct pp_world *world = scene->world;
    enum pp_status status = pp_ray_scene_create(&scene->room, world, err);
    if (status != PP_OK)
        return status;
    const struct pp_ray_scene *room = scene->room;
    size_t facets = (size_t)room->facet_count, triangles = (size_t)room->triangle_count;
    scene->centre = room->centre;
    scene->rays = room->rays;
    scene->parts = calloc(facets + 1, sizeof *scene->parts);
    scene->materials = calloc(2 * facets + 1, sizeof *scene->materials);
    scene->part_of_triangle = calloc(triangles + 1, sizeof *scene->part_of_triangle);
    if (!scene->parts || !scene->materials || !scene->part_of_triangle)
        return pp_fail_memory(err);
    for (size_t i = 0; i < triangles; i++)
        scene->part_of_triangle[i] = room->facet_of_triangle[i];
    scene->triangle_count = room->triangle_count;
    scene->low = pp_vec(DBL_MAX, DBL_MAX, DBL_MAX);
    scene->high = pp_vec(-DBL_MAX, -DBL_MAX, -DBL_MAX);
    for (int i = 0; i < world->surface_count; i++) {
        scene->parts[scene->part_count++] = part_of(scene, i);
        stretch(scene, &world->surfaces[i].outline);
    }
    for (int i = 0; i < world->opening_count; i++)
        scene->parts[scene->part_count++] = pane_of(scene, i);
    if (world->surface_count == 0)
        scene->low = scene->high = pp_vec(0.0, 0.0, 0.0);
    pp_light_hash_scene(scene, NULL);
    return pp_light_scene_add_glosses(scene, err);
}

static enum pp_status make(struct pp_light_scene **result, const struct pp_world *world,
                           bool matt, struct pp_error *err)
{
    *result = NULL;
    struct pp_light_scene *scene = calloc(1, sizeof *scene);
    if (!scene)
        return pp_fail_memory(err);
    scene->world = world;
    scene->matt = matt;
    enum pp_status status = build(scene, err);
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
    return make(scene, world, false, err);
}

enum pp_status pp_light_scene_of_world_matt(struct pp_light_scene **scene,
                                            const struct pp_world *world,
                                            struct pp_error *err)
{
    return make(scene, world, true, err);
}
