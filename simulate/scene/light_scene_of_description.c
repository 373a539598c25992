/* light_scene_of_description.c - the parts, triangles and emitters of a description's
 * shapes. */
#include "simulate/scene/light_scene_of_description.h"

#include <stdlib.h>
#include <string.h>

#include "model/geometry/polygon.h"
#include "simulate/sampling/lobe.h"
#include "simulate/scene/light_scene_parts.h"
#include "simulate/scene/round.h"
#include "simulate/scene/triangles.h"
#include "simulate/scene/unsampled.h"

/* A scene that is being made. */
struct light_scene_builder {
    struct pp_light_scene *scene;
    const struct pp_scene_description *from;
    struct pp_clipper *clipper;
    struct pp_triangles triangles; /* triangles of all polygons */
    struct pp_vec3 *corners;       /* corners of one polygon, relative to the centre */
};

static bool is_polygon(const struct pp_shape *shape)
{
    return shape->kind == PP_SHAPE_POLYGON;
}

/* Sets the box around all shapes, and the scene's centre, which is the mean of their
 * points. Most points are then near the centre, where single precision is best. */
static void measure_described_scene(struct pp_light_scene *scene,
                                    const struct pp_scene_description *from)
{
    struct pp_vec3 sum = {0.0, 0.0, 0.0};
    double count = 0.0;
    scene->bounds = pp_bounds3_empty();
    for (int i = 0; i < from->shape_count; i++) {
        const struct pp_shape *shape = &from->shapes[i];
        if (shape->kind == PP_SHAPE_DISTANT)
            continue;
        if (!is_polygon(shape)) {
            struct pp_bounds3 box = pp_round_bounds(shape);
            pp_bounds3_add(&scene->bounds, box.low);
            pp_bounds3_add(&scene->bounds, box.high);
            sum = pp_vec_add(sum, pp_bounds3_middle(&box));
            count++;
        }
        for (int k = 0; is_polygon(shape) && k < shape->is.polygon.count; k++) {
            struct pp_vec3 v = from->vertices[shape->is.polygon.first + k];
            pp_bounds3_add(&scene->bounds, v);
            sum = pp_vec_add(sum, v);
            count++;
        }
    }
    if (count > 0.0)
        scene->centre = pp_vec_scale(sum, 1.0 / count);
    else
        scene->bounds = (struct pp_bounds3){.low = {0.0, 0.0, 0.0}};
}

static enum pp_status allocate(struct light_scene_builder *b, struct pp_error *err)
{
    struct pp_light_scene *scene = b->scene;
    const struct pp_scene_description *from = b->from;
    size_t parts = 0, rounds = 0, distants = 0;
    int most_corners = 0;
    for (int i = 0; i < from->shape_count; i++) {
        const struct pp_shape *shape = &from->shapes[i];
        parts += shape->kind != PP_SHAPE_DISTANT;
        rounds += !is_polygon(shape) && shape->kind != PP_SHAPE_DISTANT;
        distants += shape->kind == PP_SHAPE_DISTANT;
        if (is_polygon(shape) && shape->is.polygon.count > most_corners)
            most_corners = shape->is.polygon.count;
    }
    scene->materials =
        calloc((size_t)from->material_count + 1, sizeof *scene->materials);
    scene->measured = calloc((size_t)from->pane_count + 1, sizeof *scene->measured);
    scene->patterns = calloc((size_t)from->pattern_count + 1, sizeof *scene->patterns);
    scene->parts = calloc(parts + 1, sizeof *scene->parts);
    scene->rounds = calloc(rounds + 1, sizeof *scene->rounds);
    scene->distants = calloc(distants + 1, sizeof *scene->distants);
    b->corners = malloc(((size_t)most_corners + 1) * sizeof *b->corners);
    if (!scene->materials || !scene->measured || !scene->patterns || !scene->parts
        || !scene->rounds || !scene->distants || !b->corners)
        return pp_fail_memory(err);
    for (int i = 0; i < from->pane_count; i++)
        scene->measured[i] = pp_measured_pane_hold(from->panes[i]);
    scene->measured_count = from->pane_count;
    scene->material_count = from->material_count;
    scene->pattern_count = from->pattern_count;
    if (from->material_count > 0)
        memcpy(scene->materials, from->materials,
               (size_t)from->material_count * sizeof *from->materials);
    if (from->pattern_count > 0)
        memcpy(scene->patterns, from->patterns,
               (size_t)from->pattern_count * sizeof *from->patterns);
    return PP_OK;
}

static struct pp_light_part part_of_shape(const struct pp_light_scene *scene,
                                          const struct pp_shape *shape)
{
    bool own_back = shape->back_material >= 0;
    const int sides[2] = {shape->material,
                          own_back ? shape->back_material : shape->material};
    struct pp_light_part part = pp_light_scene_parts_of(shape->tag, sides);
    part.space[0] = part.space[1] = PP_ANYWHERE;
    part.back_emits = own_back || scene->materials[sides[0]].emits_both_sides;
    return part;
}

static enum pp_status add_polygon(struct light_scene_builder *b,
                                  const struct pp_shape *shape, struct pp_error *err)
{
    struct pp_light_scene *scene = b->scene;
    int count = shape->is.polygon.count, index = scene->part_count++;
    struct pp_light_part *part = &scene->parts[index];
    *part = part_of_shape(scene, shape);
    double offset = 0.0;
    for (int k = 0; k < count; k++)
        b->corners[k] =
            pp_vec_sub(b->from->vertices[shape->is.polygon.first + k], scene->centre);
    struct pp_vec3 area = pp_polygon_area_vector(b->corners, count);
    part->normal = pp_vec_unit(area);
    pp_lobe_frame(part->normal, &part->a, &part->b);
    part->area_m2 = pp_vec_length(area);
    for (int k = 0; k < count; k++)
        offset += pp_vec_dot(part->normal, b->corners[k]);
    part->offset_m = offset / count;

    struct pp_polygon polygon = {count, b->corners, part->normal, 0.0};
    int first = b->triangles.count;
    enum pp_status status = pp_triangles_of_polygon(&b->triangles, b->clipper, &polygon,
                                                    index, pp_vec(0.0, 0.0, 0.0), err);
    int cut = b->triangles.count - first;
    if (status != PP_OK || cut == 0)
        return status;
    return pp_emitters_add_part(
        scene, index, b->corners, count,
        (const struct pp_vec3(*)[3])b->triangles.corners + first, cut, err);
}

static enum pp_status add_round(struct light_scene_builder *b,
                                const struct pp_shape *shape, struct pp_error *err)
{
    struct pp_light_scene *scene = b->scene;
    int index = scene->part_count++, round = scene->round_count++;
    scene->rounds[round] = *shape;
    pp_round_shift(&scene->rounds[round], scene->centre);
    scene->parts[index] = part_of_shape(scene, shape);
    scene->parts[index].round = round;
    scene->parts[index].area_m2 = pp_round_area(&scene->rounds[round]);
    return pp_emitters_add_part(scene, index, NULL, 0, NULL, 0, err);
}

static enum pp_status build_described_scene(struct light_scene_builder *b,
                                            struct pp_error *err)
{
    struct pp_light_scene *scene = b->scene;
    const struct pp_scene_description *from = b->from;
    enum pp_status status = allocate(b, err);
    if (status != PP_OK)
        return status;
    status = pp_clipper_create(&b->clipper, err);
    measure_described_scene(scene, from);
    for (int i = 0; status == PP_OK && i < from->shape_count; i++)
        if (is_polygon(&from->shapes[i]))
            status = add_polygon(b, &from->shapes[i], err);
        else if (from->shapes[i].kind == PP_SHAPE_DISTANT)
            status = pp_emitters_add_distant(scene, &from->shapes[i], err);
        else
            status = add_round(b, &from->shapes[i], err);
    if (status == PP_OK)
        status = pp_light_scene_add_laws(scene, err);
    if (status != PP_OK)
        return status;
    pp_emitters_link_triangles(scene);
    pp_unsampled_find_glow(scene);
    status = pp_mirrors_find(scene, err);
    if (status == PP_OK)
        status = pp_reflectors_find(scene, err);
    return status == PP_OK ? pp_light_scene_add_rays(scene, &b->triangles, err)
                           : status;
}

enum pp_status pp_light_scene_of_description(struct pp_light_scene **result,
                                             const struct pp_scene_description *from,
                                             struct pp_error *err)
{
    *result = NULL;
    struct pp_light_scene *scene = calloc(1, sizeof *scene);
    if (!scene)
        return pp_fail_memory(err);
    scene->decorations = 1.0;
    struct light_scene_builder b = {.scene = scene, .from = from};
    enum pp_status status = build_described_scene(&b, err);
    pp_triangles_clear(&b.triangles);
    pp_clipper_destroy(b.clipper);
    free(b.corners);
    if (status != PP_OK) {
        pp_light_scene_destroy(scene);
        return status;
    }
    *result = scene;
    return PP_OK;
}
