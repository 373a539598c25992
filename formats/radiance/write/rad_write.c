/* rad_write.c - chooses unique names for a scene's materials, and writes its shapes. */
#include "formats/radiance/write/rad_write.h"

#include <stdlib.h>
#include <string.h>

#include "formats/radiance/write/rad_numbers.h"
#include "formats/radiance/write/rad_write_materials.h"
#include "formats/radiance/write/rad_writer.h"

/* ---- names ---- */

/* Makes a valid Radiance name. Letters, digits, "-", "." and characters beyond ASCII
 * stay; each run of others becomes one "_", or nothing at either end. Radiance's
 * reserved words get a number. `fit` has space for two characters more than
 * PP_RAD_NAME_MOST. */
static void make_fit(char *fit, const char *name)
{
    int count = 0;
    for (; *name && count < PP_RAD_NAME_MOST; name++) {
        unsigned char c = (unsigned char)*name;
        bool good = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z')
                    || (c >= '0' && c <= '9') || c == '-' || c == '.' || c >= 0x80;
        if (good)
            fit[count++] = (char)c;
        else if (count > 0 && fit[count - 1] != '_')
            fit[count++] = '_';
    }
    while (count > 0 && fit[count - 1] == '_')
        count--;
    fit[count] = '\0';
    if (count == 0)
        strcpy(fit, "unnamed");
    if (strcmp(fit, "void") == 0 || strcmp(fit, "inherit") == 0)
        strcat(fit, "_2");
}

static bool is_taken(const struct pp_rad_writer *writer, const char *name,
                     struct pp_rad_meaning *last)
{
    return pp_rad_names_find(&writer->taken, name, strlen(name), last);
}

static enum pp_status take_name(struct pp_rad_writer *writer, const char *name,
                                int last, struct pp_error *err)
{
    struct pp_rad_meaning meaning = {PP_RAD_MATERIAL, last, -1};
    return pp_rad_names_define(&writer->taken, name, strlen(name), meaning, err);
}

/* Appends a unique name to the list; the list has space for it. */
static enum pp_status add_name(struct pp_rad_writer *writer, const char *from,
                               const char *behind, struct pp_error *err)
{
    struct pp_rad_name_text *name = &writer->names[writer->name_count++], plain;
    char fit[PP_RAD_NAME_MOST + 3];
    struct pp_rad_meaning last, ignored;
    enum pp_status status = PP_OK;
    make_fit(fit, from);
    snprintf(plain.text, sizeof plain.text, "%s%s", fit, behind);
    *name = plain;
    if (is_taken(writer, plain.text, &last)) {
        do
            snprintf(name->text, sizeof name->text, "%s%s_%d", fit, behind,
                     ++last.index);
        while (is_taken(writer, name->text, &ignored));
        status = take_name(writer, plain.text, last.index, err);
    }
    return status == PP_OK ? take_name(writer, name->text, 1, err) : status;
}

/* Finds the pairs of different front and back materials, and numbers them in order of
 * occurrence. */
static enum pp_status find_pairs(struct pp_rad_writer *writer, struct pp_error *err)
{
    const struct pp_scene_description *scene = writer->scene;
    struct pp_rad_names known = {0}; /* pairs so far, by front and back material */
    enum pp_status status = PP_OK;
    for (int i = 0; i < scene->shape_count && status == PP_OK; i++) {
        const struct pp_shape *shape = &scene->shapes[i];
        const int sides[2] = {shape->material, shape->back_material};
        struct pp_rad_meaning pair = {PP_RAD_MATERIAL, -1, -1};
        bool differ = sides[1] >= 0 && sides[1] != sides[0];
        if (differ
            && !pp_rad_names_find(&known, (const char *)sides, sizeof sides, &pair)) {
            pair.index = writer->pair_count++;
            writer->pairs[pair.index] = (struct pp_rad_pair){sides[0], sides[1], -1};
            status = pp_rad_names_define(&known, (const char *)sides, sizeof sides,
                                         pair, err);
        }
        writer->pair_of[i] = pair.index;
    }
    pp_rad_names_clear(&known);
    return status;
}

static size_t most_pairs(const struct pp_scene_description *scene)
{
    size_t most = 0;
    for (int i = 0; i < scene->shape_count; i++)
        most += scene->shapes[i].back_material >= 0;
    return most;
}

static enum pp_status name_all(struct pp_rad_writer *writer, struct pp_error *err)
{
    const struct pp_scene_description *scene = writer->scene;
    enum pp_status status = PP_OK;
    for (int i = 0; i < scene->material_count && status == PP_OK; i++) {
        status = pp_rad_write_materials_check(&scene->materials[i], err);
        if (status == PP_OK)
            status = add_name(writer, scene->materials[i].name, "", err);
    }
    for (int i = 0; i < scene->pattern_count && status == PP_OK; i++)
        status = add_name(writer, "skyfunc", "", err);
    if (status == PP_OK)
        status = find_pairs(writer, err);
    if (status == PP_OK)
        pp_rad_write_materials_classify(writer);
    for (int i = 0; i < writer->pair_count && status == PP_OK; i++) {
        struct pp_rad_pair *pair = &writer->pairs[i];
        bool mirror = pp_rad_write_materials_is_mirror(writer, pair);
        pair->name = mirror ? pair->front : writer->name_count;
        if (!mirror)
            status =
                add_name(writer, scene->materials[pair->front].name, "_sides", err);
    }
    return status;
}

enum pp_status pp_rad_write_create(struct pp_rad_writer **result,
                                   const struct pp_scene_description *scene,
                                   struct pp_error *err)
{
    *result = NULL;
    size_t pairs = most_pairs(scene);
    size_t names = (size_t)scene->material_count + (size_t)scene->pattern_count + pairs;
    struct pp_rad_writer *writer = calloc(1, sizeof *writer);
    if (!writer)
        return pp_fail_memory(err);
    writer->scene = scene;
    writer->names = calloc(names + 1, sizeof *writer->names);
    writer->pairs = calloc(pairs + 1, sizeof *writer->pairs);
    writer->pair_of = calloc((size_t)scene->shape_count + 1, sizeof *writer->pair_of);
    writer->in_pairs = calloc((size_t)scene->material_count + 1, 1);
    writer->behind = calloc((size_t)scene->material_count + 1, 1);
    writer->on_its_own = calloc((size_t)scene->material_count + 1, 1);
    bool good = writer->names && writer->pairs && writer->pair_of && writer->in_pairs
                && writer->on_its_own && writer->behind;
    enum pp_status status = good ? name_all(writer, err) : pp_fail_memory(err);
    if (status != PP_OK) {
        pp_rad_write_destroy(writer);
        return status;
    }
    *result = writer;
    return PP_OK;
}

void pp_rad_write_destroy(struct pp_rad_writer *writer)
{
    if (!writer)
        return;
    pp_rad_names_clear(&writer->taken);
    free(writer->names);
    free(writer->pairs);
    free(writer->pair_of);
    free(writer->in_pairs);
    free(writer->on_its_own);
    free(writer->behind);
    free(writer);
}

/* ---- shapes ---- */

static const char *written_material(const struct pp_rad_writer *writer, int shape)
{
    int pair = writer->pair_of[shape];
    return writer
        ->names[pair >= 0 ? writer->pairs[pair].name
                          : writer->scene->shapes[shape].material]
        .text;
}

static void write_vec(FILE *out, struct pp_vec3 v)
{
    const double xyz[3] = {v.x, v.y, v.z};
    for (int i = 0; i < 3; i++) {
        char text[32];
        pp_rad_numbers_text(xyz[i], text);
        fprintf(out, " %s", text);
    }
}

static void write_polygon(const struct pp_rad_writer *writer,
                          const struct pp_shape *shape, FILE *out)
{
    fprintf(out, "0\n0\n%d\n", 3 * shape->is.polygon.count);
    for (int i = 0; i < shape->is.polygon.count; i++) {
        write_vec(out, writer->scene->vertices[shape->is.polygon.first + i]);
        fputc('\n', out);
    }
}

/* Radiance type of a shape, from its kind and the side that is its front. */
static const char *type_of(const struct pp_shape *shape)
{
    switch (shape->kind) {
    case PP_SHAPE_POLYGON:
        return "polygon";
    case PP_SHAPE_SPHERE:
        return shape->inward ? "bubble" : "sphere";
    case PP_SHAPE_CONE:
        if (shape->is.cone.radii_m[0] == shape->is.cone.radii_m[1])
            return shape->inward ? "tube" : "cylinder";
        return shape->inward ? "cup" : "cone";
    case PP_SHAPE_RING:
        return "ring";
    case PP_SHAPE_DISTANT:
        return "source";
    }
    return "polygon";
}

static int put_vector(double *numbers, int count, struct pp_vec3 v)
{
    numbers[count] = v.x;
    numbers[count + 1] = v.y;
    numbers[count + 2] = v.z;
    return count + 3;
}

static int numbers_of(const struct pp_shape *shape, double numbers[8])
{
    int count = 0;
    switch (shape->kind) {
    case PP_SHAPE_POLYGON:
        return 0;
    case PP_SHAPE_SPHERE:
        count = put_vector(numbers, count, shape->is.sphere.centre);
        numbers[count++] = shape->is.sphere.radius_m;
        return count;
    case PP_SHAPE_CONE:
        count = put_vector(numbers, count, shape->is.cone.ends[0]);
        count = put_vector(numbers, count, shape->is.cone.ends[1]);
        numbers[count++] = shape->is.cone.radii_m[0];
        if (shape->is.cone.radii_m[0] != shape->is.cone.radii_m[1])
            numbers[count++] = shape->is.cone.radii_m[1];
        return count;
    case PP_SHAPE_RING:
        count = put_vector(numbers, count, shape->is.ring.centre);
        count = put_vector(numbers, count, shape->is.ring.axis);
        numbers[count++] = shape->is.ring.radii_m[0];
        numbers[count++] = shape->is.ring.radii_m[1];
        return count;
    case PP_SHAPE_DISTANT:
        count = put_vector(numbers, count, shape->is.distant.direction);
        numbers[count++] = 2.0 * shape->is.distant.half_angle_rad / PP_RAD;
        return count;
    }
    return 0;
}

void pp_rad_write_shapes(const struct pp_rad_writer *writer, const char *name,
                         int first, int end, FILE *out)
{
    for (int i = first; i < end; i++) {
        const struct pp_shape *shape = &writer->scene->shapes[i];
        fprintf(out, "\n%s %s %s.%d\n", written_material(writer, i), type_of(shape),
                name, i - first + 1);
        if (shape->kind == PP_SHAPE_POLYGON) {
            write_polygon(writer, shape, out);
            continue;
        }
        double numbers[8];
        int count = numbers_of(shape, numbers);
        fprintf(out, "0\n0\n");
        pp_rad_numbers_write(out, numbers, count);
    }
}
