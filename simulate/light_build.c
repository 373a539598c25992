/* light_build.c - a light scene out of a description. */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model/polygon.h"
#include "simulate/ears.h"
#include "simulate/light_parts.h"
#include "simulate/round.h"
#include "simulate/triangles.h"

/* What is needed while the triangles are made. */
struct builder {
    struct pp_light_scene *scene;
    const struct pp_scene_description *from;
    float (*single)[3][3];
    int space;
    /* of the polygon at hand, with room for most_corners */
    struct pp_vec3 *corners;
    struct pp_vec3 (*pieces)[3];
    int (*triangles)[3];
    int *order;
    int most_corners;
};

static bool is_polygon(const struct pp_shape *shape)
{
    return shape->kind == PP_SHAPE_POLYGON;
}

static void stretch(struct pp_light_scene *scene, struct pp_vec3 low,
                    struct pp_vec3 high)
{
    scene->low = pp_vec(fmin(scene->low.x, low.x), fmin(scene->low.y, low.y),
                        fmin(scene->low.z, low.z));
    scene->high = pp_vec(fmax(scene->high.x, high.x), fmax(scene->high.y, high.y),
                         fmax(scene->high.z, high.z));
}

/* The box round all, and the mean of all that has a place as the centre: where most is,
 * single precision is best. */
static void measure(struct pp_light_scene *scene,
                    const struct pp_scene_description *from)
{
    struct pp_vec3 sum = {0.0, 0.0, 0.0};
    double count = 0.0;
    scene->low = pp_vec(DBL_MAX, DBL_MAX, DBL_MAX);
    scene->high = pp_vec(-DBL_MAX, -DBL_MAX, -DBL_MAX);
    for (int i = 0; i < from->shape_count; i++) {
        const struct pp_shape *shape = &from->shapes[i];
        if (shape->kind == PP_SHAPE_DISTANT)
            continue;
        struct pp_vec3 low, high;
        if (!is_polygon(shape)) {
            pp_round_box(shape, &low, &high);
            stretch(scene, low, high);
            sum = pp_add(sum, pp_scale(pp_add(low, high), 0.5));
            count++;
        }
        for (int k = 0; is_polygon(shape) && k < shape->is.polygon.count; k++) {
            struct pp_vec3 v = from->vertices[shape->is.polygon.first + k];
            stretch(scene, v, v);
            sum = pp_add(sum, v);
            count++;
        }
    }
    if (count > 0.0)
        scene->centre = pp_scale(sum, 1.0 / count);
    else
        scene->low = scene->high = pp_vec(0.0, 0.0, 0.0);
}

static enum pp_status allocate(struct builder *b, struct pp_error *err)
{
    struct pp_light_scene *scene = b->scene;
    const struct pp_scene_description *from = b->from;
    size_t parts = 0, rounds = 0, distants = 0, triangles = 0;
    for (int i = 0; i < from->shape_count; i++) {
        const struct pp_shape *shape = &from->shapes[i];
        parts += shape->kind != PP_SHAPE_DISTANT;
        rounds += !is_polygon(shape) && shape->kind != PP_SHAPE_DISTANT;
        distants += shape->kind == PP_SHAPE_DISTANT;
        if (!is_polygon(shape))
            continue;
        triangles += (size_t)shape->is.polygon.count - 2;
        if (shape->is.polygon.count > b->most_corners)
            b->most_corners = shape->is.polygon.count;
    }
    size_t corners = (size_t)b->most_corners + 1;
    scene->materials =
        calloc((size_t)from->material_count + 1, sizeof *scene->materials);
    scene->patterns = calloc((size_t)from->pattern_count + 1, sizeof *scene->patterns);
    scene->parts = calloc(parts + 1, sizeof *scene->parts);
    scene->rounds = calloc(rounds + 1, sizeof *scene->rounds);
    scene->distants = calloc(distants + 1, sizeof *scene->distants);
    scene->part_of_triangle =
        calloc(triangles + rounds + 1, sizeof *scene->part_of_triangle);
    b->single = malloc((triangles + 1) * sizeof *b->single);
    b->corners = malloc(corners * sizeof *b->corners);
    b->pieces = malloc(corners * sizeof *b->pieces);
    b->triangles = malloc(corners * sizeof *b->triangles);
    b->order = malloc(corners * sizeof *b->order);
    if (!scene->materials || !scene->patterns || !scene->parts || !scene->rounds
        || !scene->distants || !scene->part_of_triangle || !b->single || !b->corners
        || !b->pieces || !b->triangles || !b->order)
        return pp_fail_memory(err);
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

static struct pp_light_part part_of(const struct pp_light_scene *scene,
                                    const struct pp_shape *shape)
{
    bool own_back = shape->back_material >= 0;
    int back = own_back ? shape->back_material : shape->material;
    return (struct pp_light_part){
        .material = {shape->material, back},
        .tag = shape->tag,
        .round = -1,
        .window = -1,
        .emitter = {-1, -1},
        .mirror = -1,
        .space = {PP_ANYWHERE, PP_ANYWHERE},
        .back_emits = own_back || scene->materials[shape->material].emits_both_sides};
}

static bool is_convex(const struct pp_vec3 *corners, int count, struct pp_vec3 normal)
{
    for (int i = 0; i < count; i++) {
        struct pp_vec3 a = corners[i], b = corners[(i + 1) % count];
        struct pp_vec3 c = corners[(i + 2) % count];
        if (pp_dot(normal, pp_cross(pp_sub(b, a), pp_sub(c, b))) < 0.0)
            return false;
    }
    return true;
}

/* The triangles of the corners at hand, as numbers of them; how many. */
static int cut(struct builder *b, int count, struct pp_vec3 normal)
{
    if (count > 3 && !is_convex(b->corners, count, normal))
        return pp_cut_ears(b->corners, count, normal, b->triangles, b->order);
    for (int i = 0; i < count - 2; i++) {
        b->triangles[i][0] = 0;
        b->triangles[i][1] = i + 1;
        b->triangles[i][2] = i + 2;
    }
    return count - 2;
}

static enum pp_status add_polygon(struct builder *b, const struct pp_shape *shape,
                                  struct pp_error *err)
{
    struct pp_light_scene *scene = b->scene;
    int count = shape->is.polygon.count, index = scene->part_count++;
    struct pp_light_part *part = &scene->parts[index];
    *part = part_of(scene, shape);
    double offset = 0.0;
    for (int k = 0; k < count; k++)
        b->corners[k] =
            pp_sub(b->from->vertices[shape->is.polygon.first + k], scene->centre);
    struct pp_vec3 area = pp_area_vector(b->corners, count);
    part->normal = pp_unit(area);
    part->area_m2 = pp_length(area);
    for (int k = 0; k < count; k++)
        offset += pp_dot(part->normal, b->corners[k]);
    part->offset_m = offset / count;

    int triangles = cut(b, count, part->normal);
    for (int i = 0; i < triangles; i++) {
        float(*to)[3] = b->single[scene->triangle_count];
        scene->part_of_triangle[scene->triangle_count++] = index;
        for (int k = 0; k < 3; k++) {
            struct pp_vec3 v = b->pieces[i][k] = b->corners[b->triangles[i][k]];
            to[k][0] = (float)v.x;
            to[k][1] = (float)v.y;
            to[k][2] = (float)v.z;
        }
    }
    return pp_light_scene_add_emitters(scene, index, b->corners, count,
                                       (const struct pp_vec3(*)[3])b->pieces, triangles,
                                       err);
}

/* Round shapes follow the last triangle. */
static enum pp_status add_round(struct builder *b, const struct pp_shape *shape,
                                struct pp_error *err)
{
    struct pp_light_scene *scene = b->scene;
    int index = scene->part_count++, round = scene->round_count++;
    scene->rounds[round] = *shape;
    pp_round_shift(&scene->rounds[round], scene->centre);
    scene->part_of_triangle[scene->triangle_count + round] = index;
    scene->parts[index] = part_of(scene, shape);
    scene->parts[index].round = round;
    return pp_light_scene_add_emitters(scene, index, NULL, 0, NULL, 0, err);
}

static enum pp_status build(struct builder *b, struct pp_error *err)
{
    struct pp_light_scene *scene = b->scene;
    const struct pp_scene_description *from = b->from;
    enum pp_status status = allocate(b, err);
    if (status != PP_OK)
        return status;
    status = pp_light_scene_add_glosses(scene, err);
    measure(scene, from);
    for (int i = 0; status == PP_OK && i < from->shape_count; i++)
        if (is_polygon(&from->shapes[i]))
            status = add_polygon(b, &from->shapes[i], err);
    for (int i = 0; status == PP_OK && i < from->shape_count; i++)
        if (from->shapes[i].kind == PP_SHAPE_DISTANT)
            status = pp_light_scene_add_distant(scene, &from->shapes[i], err);
        else if (!is_polygon(&from->shapes[i]))
            status = add_round(b, &from->shapes[i], err);
    if (status != PP_OK)
        return status;
    pp_light_scene_settle_emitters(scene);
    status = pp_light_scene_add_mirrors(scene, err);
    if (status != PP_OK)
        return status;
    pp_light_scene_stir(scene, (const float(*)[3][3])b->single);
    return pp_rays_create_with(&scene->rays, (const float(*)[3][3])b->single,
                               scene->triangle_count, scene->rounds, scene->round_count,
                               err);
}

enum pp_status pp_light_scene_of_description(struct pp_light_scene **result,
                                             const struct pp_scene_description *from,
                                             struct pp_error *err)
{
    *result = NULL;
    struct pp_light_scene *scene = calloc(1, sizeof *scene);
    if (!scene)
        return pp_fail_memory(err);
    struct builder b = {.scene = scene, .from = from};
    enum pp_status status = build(&b, err);
    free(b.single);
    free(b.corners);
    free(b.pieces);
    free(b.triangles);
    free(b.order);
    if (status != PP_OK) {
        pp_light_scene_destroy(scene);
        return status;
    }
    *result = scene;
    return PP_OK;
}
