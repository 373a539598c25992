/* rad_primitive.c - see rad_primitive.h. */
#include "formats/radiance/read/rad_primitive.h"

#include <math.h>

#include "formats/radiance/rad_functions.h"
#include "formats/radiance/read/rad_bsdf.h"
#include "formats/radiance/read/rad_materials.h"
#include "formats/radiance/read/rad_shapes.h"
#include "formats/radiance/read/rad_sky.h"
#include "model/base/array.h"

/* Limit on the strings, or numbers, of one primitive: enough for a polygon of 100,000
 * corners. To triangulate such a polygon takes half a minute; the time grows with the
 * square of the number of corners. */
enum { ARGUMENTS_MOST = 300000 };

/* Reads the number of strings, integers or numbers that follow. */
static enum pp_status read_count(struct pp_rad_words *words, const char *what,
                                 int *count, struct pp_error *err)
{
    struct pp_rad_word word;
    double number;
    enum pp_status status = pp_rad_words_next(words, &word, err);
    if (status != PP_OK)
        return status;
    if (!pp_rad_words_number(word, &number) || number < 0.0 || number > ARGUMENTS_MOST
        || number != (int)number)
        return pp_rad_words_fail(
            words, word.line, err,
            "found \"%.*s\"; expected the number of %s, at most %d",
            pp_rad_words_shown(word), word.text, what, ARGUMENTS_MOST);
    *count = (int)number;
    return PP_OK;
}

static enum pp_status read_strings(struct pp_rad_reader *reader,
                                   struct pp_rad_primitive *primitive,
                                   struct pp_error *err)
{
    enum pp_status status =
        read_count(primitive->words, "strings", &primitive->string_count, err);
    if (status != PP_OK)
        return status;
    status =
        pp_array_reserve(&reader->strings, &reader->string_space,
                         primitive->string_count + 1, sizeof *reader->strings, err);
    if (status != PP_OK)
        return status;
    struct pp_rad_word *strings = primitive->strings = reader->strings;
    for (int i = 0; i < primitive->string_count && status == PP_OK; i++) {
        status = pp_rad_words_next(primitive->words, &strings[i], err);
        if (status == PP_OK && strings[i].length == 0)
            status = pp_rad_words_fail(primitive->words, strings[i].line, err,
                                       "the file ends inside a primitive");
    }
    return status;
}

static enum pp_status read_rad_number(struct pp_rad_words *words, double *number,
                                      struct pp_error *err)
{
    struct pp_rad_word word;
    enum pp_status status = pp_rad_words_next(words, &word, err);
    if (status == PP_OK && word.length == 0)
        status = pp_rad_words_fail(words, word.line, err,
                                   "the file ends inside a primitive");
    int shown = pp_rad_words_shown(word);
    if (status == PP_OK && !pp_rad_words_number(word, number))
        return pp_rad_words_fail(words, word.line, err,
                                 "found \"%.*s\"; expected a number", shown, word.text);
    if (status == PP_OK && fabs(*number) > 1e30)
        return pp_rad_words_fail(words, word.line, err,
                                 "the number is %.*s; expected -1e30 to 1e30", shown,
                                 word.text);
    return status;
}

static enum pp_status read_numbers(struct pp_rad_reader *reader,
                                   struct pp_rad_primitive *primitive,
                                   struct pp_error *err)
{
    int whole = 0;
    double ignored;
    enum pp_status status = read_count(primitive->words, "whole numbers", &whole, err);
    for (int i = 0; i < whole && status == PP_OK; i++)
        status = read_rad_number(primitive->words, &ignored, err);
    if (status == PP_OK)
        status = read_count(primitive->words, "numbers", &primitive->number_count, err);
    if (status != PP_OK)
        return status;
    status =
        pp_array_reserve(&reader->numbers, &reader->number_space,
                         primitive->number_count + 1, sizeof *reader->numbers, err);
    if (status != PP_OK)
        return status;
    double *numbers = primitive->numbers = reader->numbers;
    for (int i = 0; i < primitive->number_count && status == PP_OK; i++)
        status = read_rad_number(primitive->words, &numbers[i], err);
    return status;
}

static enum pp_status say_unknown(const struct pp_rad_words *words,
                                  struct pp_rad_word word, const char *what,
                                  struct pp_error *err)
{
    return pp_rad_words_fail(words, word.line, err, "there is no %s \"%.*s\"", what,
                             pp_rad_words_shown(word), word.text);
}

/* Reads "modifier alias new old": a second name, with its own modifier. */
static enum pp_status take_alias(struct pp_rad_reader *reader,
                                 struct pp_rad_primitive *primitive,
                                 struct pp_rad_word modifier, struct pp_error *err)
{
    struct pp_rad_words *words = primitive->words;
    struct pp_rad_word old;
    struct pp_rad_meaning meaning;
    enum pp_status status = pp_rad_words_next(words, &old, err);
    if (status != PP_OK)
        return status;
    if (!pp_rad_names_find(&reader->names, old.text, old.length, &meaning))
        return say_unknown(words, old, "material or pattern", err);
    bool inherits = pp_rad_words_is(modifier, "inherit");
    if (!inherits && primitive->modifier.kind == PP_RAD_MATERIAL)
        return pp_rad_words_fail(words, primitive->line, err,
                                 "an alias of a material is modified by a material; "
                                 "expected void, inherit or a pattern");
    bool patterned = !inherits && primitive->modifier.kind == PP_RAD_PATTERN;
    if (patterned
        && (meaning.kind != PP_RAD_MATERIAL
            || reader->scene->materials[meaning.index].emits == PP_EMITS_NOTHING))
        return pp_rad_words_fail(words, primitive->line, err,
                                 "an alias applies the brightfunc of a sky to a "
                                 "material without emission; expected void or inherit");
    int pattern = patterned ? primitive->modifier.index : -1;
    if (meaning.kind == PP_RAD_MATERIAL && !inherits
        && reader->scene->materials[meaning.index].pattern != pattern) {
        struct pp_material copy = reader->scene->materials[meaning.index];
        copy.pattern = pattern;
        status = pp_scene_description_add_material(reader->scene, &copy, &meaning.index,
                                                   err);
        if (status != PP_OK)
            return status;
    }
    return pp_rad_names_define(&reader->names, primitive->name.text,
                               primitive->name.length, meaning, err);
}

/* Passes the primitive to the readers of shapes, materials and functions in turn, until
 * one of them handles its type. */
static enum pp_status take_rad_primitive(struct pp_rad_reader *reader,
                                         struct pp_rad_primitive *primitive,
                                         const struct pp_rad_context *context,
                                         struct pp_error *err)
{
    static enum pp_status (*const readers[])(
        struct pp_rad_reader *, const struct pp_rad_primitive *,
        const struct pp_rad_context *, bool *,
        struct pp_error *) = {pp_rad_shapes_read, pp_rad_functions_read,
                              pp_rad_sky_read, pp_rad_bsdf_read, pp_rad_materials_read};
    enum pp_status status = read_strings(reader, primitive, err);
    if (status == PP_OK)
        status = read_numbers(reader, primitive, err);
    bool taken = false;
    for (size_t i = 0;
         i < sizeof readers / sizeof *readers && status == PP_OK && !taken; i++)
        status = readers[i](reader, primitive, context, &taken, err);
    if (status != PP_OK || taken)
        return status;
    return pp_rad_words_fail(
        primitive->words, primitive->line, err,
        "the type \"%.*s\" is not supported; expected a shape, a material, an alias, "
        "the brightfunc of gensky or a mixfunc of two sides. Shapes are polygon, "
        "sphere, bubble, cone, cup, cylinder, tube, ring and source. Materials are "
        "plastic, metal, trans, plastic2, metal2, trans2, glass, light, glow, illum, "
        "mirror, BSDF and aBSDF",
        pp_rad_words_shown(primitive->type), primitive->type.text);
}

enum pp_status pp_rad_primitive_read(struct pp_rad_reader *reader,
                                     struct pp_rad_words *words,
                                     const struct pp_rad_context *context, bool *ended,
                                     struct pp_error *err)
{
    struct pp_rad_primitive primitive = {.words = words};
    struct pp_rad_word modifier;
    enum pp_status status = pp_rad_words_next(words, &modifier, err);
    if (status == PP_OK)
        status = pp_rad_words_next(words, &primitive.type, err);
    if (status == PP_OK)
        status = pp_rad_words_next(words, &primitive.name, err);
    if (status != PP_OK)
        return status;
    *ended = modifier.length == 0;
    if (*ended)
        return PP_OK;
    primitive.line = modifier.line;
    if (primitive.name.length == 0)
        return pp_rad_words_fail(words, modifier.line, err,
                                 "the file ends inside a primitive");
    bool alias = pp_rad_words_is(primitive.type, "alias");
    if (!(alias && pp_rad_words_is(modifier, "inherit"))
        && !pp_rad_names_find(&reader->names, modifier.text, modifier.length,
                              &primitive.modifier))
        return say_unknown(words, modifier, "material or pattern", err);
    status = alias ? take_alias(reader, &primitive, modifier, err)
                   : take_rad_primitive(reader, &primitive, context, err);
    return status == PP_OK
               ? pp_rad_materials_check_count(reader, words, primitive.line, err)
               : status;
}
