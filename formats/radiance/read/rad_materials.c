/* rad_materials.c - see rad_materials.h. */
#include "formats/radiance/read/rad_materials.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static struct pp_rgb rgb_at(const double *n)
{
    return pp_rgb(n[0], n[1], n[2]);
}

static struct pp_material plastic(const double *n, int count)
{
    (void)count;
    return pp_material_plastic(rgb_at(n), n[3], n[4], n[4]);
}

static struct pp_material metal(const double *n, int count)
{
    (void)count;
    return pp_material_metal(rgb_at(n), n[3], n[4], n[4]);
}

static struct pp_material trans(const double *n, int count)
{
    (void)count;
    return pp_material_trans(rgb_at(n), n[3], n[4], n[5], n[6]);
}

static struct pp_material plastic2(const double *n, int count)
{
    (void)count;
    return pp_material_plastic(rgb_at(n), n[3], n[4], n[5]);
}

static struct pp_material metal2(const double *n, int count)
{
    (void)count;
    return pp_material_metal(rgb_at(n), n[3], n[4], n[5]);
}

static struct pp_material trans2(const double *n, int count)
{
    (void)count;
    struct pp_material material = pp_material_trans(rgb_at(n), n[3], n[4], n[6], n[7]);
    material.roughness[1] = n[5];
    return material;
}

static struct pp_material glass(const double *n, int count)
{
    return pp_material_pane(rgb_at(n), count > 3 ? n[3] : 1.52);
}

static struct pp_material light(const double *n, int count)
{
    (void)count;
    return pp_material_light(rgb_at(n));
}

/* A glow with a negative radius is visible in Radiance but illuminates nothing; here it
 * is black. */
static struct pp_material glow(const double *n, int count)
{
    (void)count;
    return pp_material_glow(n[3] < 0.0 ? pp_rgb_grey(0.0) : rgb_at(n));
}

/* An illum lights surfaces; take_other adds the material that is visible instead of
 * it. */
static struct pp_material illum(const double *n, int count)
{
    (void)count;
    struct pp_material material = pp_material_air();
    material.emits = PP_EMITS_CONCENTRATED;
    material.unseen = true;
    material.radiance = rgb_at(n);
    return material;
}

static struct pp_material mirror(const double *n, int count)
{
    (void)count;
    return pp_material_mirror(rgb_at(n));
}

/* Material types, and the functions that convert their numbers. */
static const struct {
    const char *name;
    int least, most; /* allowed number of arguments */
    bool grain;      /* four strings give the direction of the first roughness */
    struct pp_material (*make)(const double *numbers, int count);
} materials[] = {
    {"plastic", 5, 5, false, plastic}, {"metal", 5, 5, false, metal},
    {"trans", 7, 7, false, trans},     {"plastic2", 6, 6, true, plastic2},
    {"metal2", 6, 6, true, metal2},    {"trans2", 8, 8, true, trans2},
    {"glass", 3, 4, false, glass},     {"light", 3, 3, false, light},
    {"glow", 4, 4, false, glow},       {"illum", 3, 3, false, illum},
    {"mirror", 3, 3, false, mirror},
};

/* Reads "ux uy uz .", the direction of the first roughness; it must be constant. */
static enum pp_status take_grain(const struct pp_rad_primitive *primitive,
                                 const struct pp_rad_context *context,
                                 struct pp_vec3 *grain, struct pp_error *err)
{
    double u[3];
    bool good =
        primitive->string_count == 4 && pp_rad_words_is(primitive->strings[3], ".");
    for (int i = 0; i < 3 && good; i++)
        good = pp_rad_words_number(primitive->strings[i], &u[i]);
    *grain =
        good ? pp_rad_transform_direction(&context->transform, pp_vec(u[0], u[1], u[2]))
             : pp_vec(0.0, 0.0, 0.0);
    if (good && pp_vec_length(*grain) > 0.0)
        return PP_OK;
    return pp_rad_words_fail(
        primitive->words, primitive->line, err,
        "the direction is a function; expected the direction of the first roughness as "
        "three constants and a dot, such as \"4 1 0 0 .\"");
}

/* Reads the alternate material of an illum, if it has one, and the material of its
 * back. */
static enum pp_status take_other(const struct pp_rad_reader *reader,
                                 const struct pp_rad_primitive *primitive,
                                 struct pp_material *illum, int *back,
                                 struct pp_error *err)
{
    struct pp_rad_meaning meaning;
    if (primitive->string_count == 0)
        return PP_OK;
    struct pp_rad_word other = primitive->strings[0];
    int shown = pp_rad_words_shown(other);
    if (!pp_rad_names_find(&reader->names, other.text, other.length, &meaning))
        return pp_rad_words_fail(primitive->words, other.line, err,
                                 "there is no material \"%.*s\"", shown, other.text);
    if (meaning.kind == PP_RAD_VOID)
        return PP_OK;
    struct pp_material seen = {.emits = PP_EMITS_NOTHING};
    if (meaning.kind == PP_RAD_MATERIAL)
        seen = reader->scene->materials[meaning.index];
    if (meaning.kind != PP_RAD_MATERIAL || seen.emits != PP_EMITS_NOTHING)
        return pp_rad_words_fail(primitive->words, other.line, err,
                                 "the alternate material of an illum is \"%.*s\"; "
                                 "expected a material that emits no light",
                                 shown, other.text);
    seen.emits = illum->emits;
    seen.unseen = true;
    seen.radiance = illum->radiance;
    *illum = seen;
    *back = meaning.back;
    return PP_OK;
}

/* Adds the black material of a mirror's back. */
static enum pp_status add_black(struct pp_rad_reader *reader, int *index,
                                struct pp_error *err)
{
    struct pp_material black = pp_material_diffuse(pp_rgb_grey(0.0));
    strcpy(black.name, "black");
    return pp_scene_description_add_material(reader->scene, &black, index, err);
}

static enum pp_status take_material(struct pp_rad_reader *reader,
                                    const struct pp_rad_primitive *primitive,
                                    const struct pp_rad_context *context, size_t which,
                                    struct pp_error *err)
{
    const struct pp_rad_words *words = primitive->words;
    const char *name = materials[which].name;
    if (primitive->number_count < materials[which].least
        || primitive->number_count > materials[which].most)
        return pp_rad_words_fail(
            words, primitive->line, err, "%s has %d numbers; expected %d%s", name,
            primitive->number_count, materials[which].least,
            materials[which].most > materials[which].least ? " or 4" : "");
    bool is_illum = strcmp(name, "illum") == 0;
    if (strcmp(name, "mirror") == 0 && primitive->string_count == 1)
        return pp_rad_words_fail(
            words, primitive->line, err,
            "a mirror with the alternate material \"%.*s\" is not supported; expected "
            "that material instead of the mirror, or a mirror without strings",
            pp_rad_words_shown(primitive->strings[0]), primitive->strings[0].text);
    if (!materials[which].grain && primitive->string_count > is_illum)
        return pp_rad_words_fail(
            words, primitive->line, err, "%s has %d strings; expected none%s", name,
            primitive->string_count, is_illum ? ", or the visible material" : "");
    for (int i = 0; i < 3; i++)
        if (!(primitive->numbers[i] >= 0.0)
            || (strcmp(name, "glass") == 0 && primitive->numbers[i] > 1.0))
            return pp_rad_words_fail(
                words, primitive->line, err, "%s has the value %g; expected %s", name,
                primitive->numbers[i],
                strcmp(name, "glass") == 0 ? "transmissivities from 0 to 1"
                                           : "0 or more");
    struct pp_material material =
        materials[which].make(primitive->numbers, primitive->number_count);
    struct pp_rad_meaning meaning = {PP_RAD_MATERIAL, 0, -1};
    enum pp_status status = PP_OK;
    if (materials[which].grain)
        status = take_grain(primitive, context, &material.grain, err);
    if (is_illum)
        status = take_other(reader, primitive, &material, &meaning.back, err);
    if (status != PP_OK)
        return status;
    if (primitive->modifier.kind == PP_RAD_MATERIAL)
        return pp_rad_words_fail(words, primitive->line, err,
                                 "a material modifies another material; expected void "
                                 "or the brightfunc of a sky");
    if (primitive->modifier.kind == PP_RAD_PATTERN) {
        if (material.emits == PP_EMITS_NOTHING)
            return pp_rad_words_fail(
                words, primitive->line, err,
                "the brightfunc of a sky modifies %s; expected light or glow", name);
        material.pattern = primitive->modifier.index;
    }
    snprintf(material.name, sizeof material.name, "%.*s",
             (int)(primitive->name.length < sizeof material.name
                       ? primitive->name.length
                       : sizeof material.name - 1),
             primitive->name.text);
    struct pp_error said;
    status = pp_scene_description_add_material(reader->scene, &material, &meaning.index,
                                               &said);
    if (status == PP_OK && strcmp(name, "mirror") == 0)
        status = add_black(reader, &meaning.back, &said);
    status = pp_rad_words_locate(words, primitive->line, status, &said, err);
    if (status != PP_OK)
        return status;
    return pp_rad_names_define(&reader->names, primitive->name.text,
                               primitive->name.length, meaning, err);
}

enum pp_status pp_rad_materials_check_count(const struct pp_rad_reader *reader,
                                            const struct pp_rad_words *words, int line,
                                            struct pp_error *err)
{
    const struct pp_scene_description *scene = reader->scene;
    return scene->material_count <= PP_RAD_MATERIALS_MOST - scene->pattern_count
               ? PP_OK
               : pp_rad_words_fail(words, line, err,
                                   "the scene has more than %d materials and patterns",
                                   PP_RAD_MATERIALS_MOST);
}

enum pp_status pp_rad_materials_read(struct pp_rad_reader *reader,
                                     const struct pp_rad_primitive *primitive,
                                     const struct pp_rad_context *context, bool *taken,
                                     struct pp_error *err)
{
    *taken = true;
    for (size_t i = 0; i < sizeof materials / sizeof *materials; i++)
        if (pp_rad_words_is(primitive->type, materials[i].name))
            return take_material(reader, primitive, context, i, err);
    *taken = false;
    return PP_OK;
}
