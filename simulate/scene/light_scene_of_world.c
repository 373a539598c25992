/* light_scene_of_world.c - the parts of a world's surfaces and panes: the facets of the
 * tracer's scene, with materials. */
#include "simulate/scene/light_scene_of_world.h"

#include <stdlib.h>

#include "model/room/surface_materials.h"
#include "simulate/scene/light_hash.h"
#include "simulate/scene/light_scene_parts.h"

/* A new material is compared with this many of the last: a world of a million surfaces
 * has few materials, and neighbours mostly share theirs. */
enum { LOOKED_BACK = 64 };

/* The material's number among the scene's; the list is long enough for one more. */
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

static void add_to_bounds(struct pp_bounds3 *bounds, const struct pp_polygon *outline)
{
    for (int i = 0; i < outline->count; i++)
        pp_bounds3_add(bounds, outline->vertices[i]);
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
    scene->bounds = pp_bounds3_empty();
    for (int i = 0; i < world->surface_count; i++) {
        scene->parts[scene->part_count++] = part_of(scene, i);
        add_to_bounds(&scene->bounds, &world->surfaces[i].outline);
    }
    for (int i = 0; i < world->opening_count; i++)
        scene->parts[scene->part_count++] = pane_of(scene, i);
    if (world->surface_count == 0)
        scene->bounds = (struct pp_bounds3){.low = {0.0, 0.0, 0.0}};
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
