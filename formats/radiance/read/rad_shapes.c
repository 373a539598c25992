/* rad_shapes.c - see rad_shapes.h. */
#include "formats/radiance/read/rad_shapes.h"

#include <stdlib.h>

#include "model/base/array.h"

/* The pattern of a sky depends only on direction, so only an infinitely distant source
 * may have it. */
static bool has_pattern(const struct pp_rad_reader *reader, int material)
{
    return material >= 0 && reader->scene->materials[material].pattern >= 0;
}

/* Finds the material of a shape with this modifier. *material: -1 if the shape is left
 * out; *back: material of its back, -1 if it is the same. */
static enum pp_status rad_shape_material(const struct pp_rad_reader *reader,
                                         const struct pp_rad_words *words, int line,
                                         struct pp_rad_meaning modifier,
                                         const struct pp_rad_context *context,
                                         bool distant, int *material, int *back,
                                         struct pp_error *err)
{
    if (context->replaced)
        modifier = context->modifier;
    *material = modifier.kind == PP_RAD_MATERIAL ? modifier.index : -1;
    *back = modifier.kind == PP_RAD_MATERIAL ? modifier.back : -1;
    if (modifier.kind == PP_RAD_PATTERN)
        return pp_rad_words_fail(
            words, line, err,
            "the modifier of a shape is a pattern; expected a material");
    int patterned = has_pattern(reader, *material) ? *material : *back;
    if (!distant && has_pattern(reader, patterned))
        return pp_rad_words_fail(
            words, line, err,
            "the material \"%s\" of a shape has the pattern of a sky, which only a "
            "source can have; expected another material",
            reader->scene->materials[patterned].name);
    if (modifier.kind == PP_RAD_VOID)
        reader->summary->unseen++;
    return PP_OK;
}

/* Checks the limits on shapes and on corners in copies. */
static enum pp_status check_count(struct pp_rad_reader *reader,
                                  const struct pp_rad_words *words, int line,
                                  int corners, bool copied, struct pp_error *err)
{
    if (reader->scene->shape_count >= PP_RAD_SHAPES_MOST)
        return pp_rad_words_fail(words, line, err, "the scene has more than %d shapes",
                                 PP_RAD_SHAPES_MOST);
    if (!copied)
        return PP_OK;
    if (++reader->copied_shapes > PP_RAD_COPIED_SHAPES_MOST)
        return pp_rad_words_fail(
            words, line, err, "the copies made by all xforms have more than %d shapes",
            PP_RAD_COPIED_SHAPES_MOST);
    reader->copied_corners += corners;
    if (reader->copied_corners > PP_RAD_COPIED_CORNERS_MOST)
        return pp_rad_words_fail(
            words, line, err,
            "the polygons in the copies made by all xforms have more than %d corners",
            PP_RAD_COPIED_CORNERS_MOST);
    return PP_OK;
}

enum pp_status pp_rad_shapes_add_polygon(struct pp_rad_reader *reader,
                                         const struct pp_rad_words *words, int line,
                                         struct pp_rad_meaning modifier,
                                         const struct pp_vec3 *corners, int count,
                                         const struct pp_rad_context *context,
                                         struct pp_error *err)
{
    int material, back;
    enum pp_status status = rad_shape_material(reader, words, line, modifier, context,
                                               false, &material, &back, err);
    if (status == PP_OK)
        status = check_count(reader, words, line, count, context->copied, err);
    if (status != PP_OK || material < 0)
        return status;
    status = pp_array_reserve(&reader->corners, &reader->corner_space, count,
                              sizeof *reader->corners, err);
    if (status != PP_OK)
        return status;
    /* Mirroring reverses the order of corners. */
    bool backwards = context->transform.mirrored != context->inverted;
    struct pp_vec3 *moved = reader->corners, area = {0.0, 0.0, 0.0};
    double size = 0.0, turned = 0.0;
    for (int i = 0; i < count; i++) {
        moved[i] = pp_rad_transform_point(&context->transform,
                                          corners[backwards ? count - 1 - i : i]);
        struct pp_vec3 side = pp_vec_sub(moved[i], moved[0]);
        size = fmax(size, pp_vec_length(side));
        if (i < 2)
            continue;
        struct pp_vec3 part = pp_vec_cross(pp_vec_sub(moved[i - 1], moved[0]), side);
        area = pp_vec_add(area, part);
        turned += pp_vec_length(part);
    }
    if (!(pp_vec_length(area) > 1e-12 * size * size)) {
        if (turned > 1e-12 * size * size)
            return pp_rad_words_fail(words, line, err,
                                     "a polygon crosses itself, so it has no front; "
                                     "expected one that does not cross itself");
        reader->summary->flat++;
        return PP_OK;
    }
    struct pp_error said;
    int index;
    status = pp_scene_description_add_polygon(reader->scene, moved, count, material,
                                              &index, &said);
    if (status == PP_OK) {
        reader->scene->shapes[index].back_material = back;
        reader->summary->polygons++;
    }
    return pp_rad_words_locate(words, line, status, &said, err);
}

enum pp_status pp_rad_shapes_add(struct pp_rad_reader *reader,
                                 const struct pp_rad_words *words, int line,
                                 struct pp_rad_meaning modifier, struct pp_shape shape,
                                 const struct pp_rad_context *context,
                                 struct pp_error *err)
{
    const struct pp_rad_transform *t = &context->transform;
    enum pp_status status = rad_shape_material(
        reader, words, line, modifier, context, shape.kind == PP_SHAPE_DISTANT,
        &shape.material, &shape.back_material, err);
    if (status == PP_OK)
        status = check_count(reader, words, line, 0, context->copied, err);
    if (status != PP_OK || shape.material < 0)
        return status;
    shape.inward = shape.inward != context->inverted;
    switch (shape.kind) {
    case PP_SHAPE_SPHERE:
        shape.is.sphere.centre = pp_rad_transform_point(t, shape.is.sphere.centre);
        shape.is.sphere.radius_m *= t->scale;
        break;
    case PP_SHAPE_CONE:
        for (int i = 0; i < 2; i++) {
            shape.is.cone.ends[i] = pp_rad_transform_point(t, shape.is.cone.ends[i]);
            shape.is.cone.radii_m[i] *= t->scale;
        }
        break;
    case PP_SHAPE_RING:
        shape.is.ring.centre = pp_rad_transform_point(t, shape.is.ring.centre);
        shape.is.ring.axis = pp_rad_transform_direction(t, shape.is.ring.axis);
        if (context->inverted)
            shape.is.ring.axis = pp_vec_scale(shape.is.ring.axis, -1.0);
        for (int i = 0; i < 2; i++)
            shape.is.ring.radii_m[i] *= t->scale;
        break;
    case PP_SHAPE_DISTANT:
        shape.is.distant.direction =
            pp_rad_transform_direction(t, shape.is.distant.direction);
        break;
    case PP_SHAPE_POLYGON:
        break;
    }
    struct pp_error said;
    status = pp_scene_description_add_shape(reader->scene, &shape, NULL, &said);
    reader->summary->others += status == PP_OK;
    return pp_rad_words_locate(words, line, status, &said, err);
}

/* ---- types of shapes ---- */

static struct pp_vec3 vec_at(const double *numbers)
{
    return pp_vec(numbers[0], numbers[1], numbers[2]);
}

static struct pp_shape sphere(const double *n)
{
    return (struct pp_shape){.kind = PP_SHAPE_SPHERE,
                             .is.sphere = {vec_at(n), fabs(n[3])},
                             .inward = n[3] < 0.0};
}

static struct pp_shape bubble(const double *n)
{
    struct pp_shape shape = sphere(n);
    shape.inward = !shape.inward;
    return shape;
}

static struct pp_shape cone(const double *n)
{
    return (struct pp_shape){.kind = PP_SHAPE_CONE,
                             .is.cone = {{vec_at(n), vec_at(n + 3)}, {n[6], n[7]}}};
}

static struct pp_shape cup(const double *n)
{
    struct pp_shape shape = cone(n);
    shape.inward = true;
    return shape;
}

static struct pp_shape cylinder(const double *n)
{
    return (struct pp_shape){.kind = PP_SHAPE_CONE,
                             .is.cone = {{vec_at(n), vec_at(n + 3)}, {n[6], n[6]}}};
}

static struct pp_shape tube(const double *n)
{
    struct pp_shape shape = cylinder(n);
    shape.inward = true;
    return shape;
}

static struct pp_shape ring(const double *n)
{
    return (struct pp_shape){
        .kind = PP_SHAPE_RING,
        .is.ring = {vec_at(n), vec_at(n + 3), {fmin(n[6], n[7]), fmax(n[6], n[7])}}};
}

static struct pp_shape source(const double *n)
{
    return (struct pp_shape){.kind = PP_SHAPE_DISTANT,
                             .is.distant = {vec_at(n), n[3] / 2.0 * PP_RAD}};
}

static const struct {
    const char *name;
    int numbers;
    struct pp_shape (*make)(const double *numbers);
} shapes[] = {{"sphere", 4, sphere}, {"bubble", 4, bubble},     {"cone", 8, cone},
              {"cup", 8, cup},       {"cylinder", 7, cylinder}, {"tube", 7, tube},
              {"ring", 8, ring},     {"source", 4, source}};

static enum pp_status take_polygon(struct pp_rad_reader *reader,
                                   const struct pp_rad_primitive *primitive,
                                   const struct pp_rad_context *context,
                                   struct pp_error *err)
{
    int count = primitive->number_count / 3;
    if (count < 3 || primitive->number_count % 3 != 0 || primitive->string_count > 0)
        return pp_rad_words_fail(primitive->words, primitive->line, err,
                                 "a polygon has %d numbers; expected three for each of "
                                 "at least three corners",
                                 primitive->number_count);
    /* Every three numbers are the coordinates of one corner. */
    const struct pp_vec3 *corners =
        (const struct pp_vec3 *)(const void *)primitive->numbers;
    return pp_rad_shapes_add_polygon(reader, primitive->words, primitive->line,
                                     primitive->modifier, corners, count, context, err);
}

enum pp_status pp_rad_shapes_read(struct pp_rad_reader *reader,
                                  const struct pp_rad_primitive *primitive,
                                  const struct pp_rad_context *context, bool *taken,
                                  struct pp_error *err)
{
    *taken = true;
    if (pp_rad_words_is(primitive->type, "polygon"))
        return take_polygon(reader, primitive, context, err);
    for (size_t i = 0; i < sizeof shapes / sizeof *shapes; i++) {
        if (!pp_rad_words_is(primitive->type, shapes[i].name))
            continue;
        if (primitive->number_count != shapes[i].numbers || primitive->string_count > 0)
            return pp_rad_words_fail(
                primitive->words, primitive->line, err,
                "a %s has %d numbers and %d strings; expected %d numbers",
                shapes[i].name, primitive->number_count, primitive->string_count,
                shapes[i].numbers);
        return pp_rad_shapes_add(reader, primitive->words, primitive->line,
                                 primitive->modifier,
                                 shapes[i].make(primitive->numbers), context, err);
    }
    *taken = false;
    return PP_OK;
}
