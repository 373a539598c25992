/* rad_read.c - see rad_read.h: the loop over primitives. */
#include "formats/radiance/rad_read.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/read_file.h"
#include "formats/radiance/rad_reader.h"

/* What one primitive has of strings or numbers: a polygon of 100,000 corners, which
 * takes half a minute to be cut into triangles, in time that goes by their square. */
enum { ARGUMENTS_MOST = 300000 };

/* A list with room for count things of that size; NULL, and the old one stays, where
 * memory is out. */
static void *with_room(void *list, int *space, int count, size_t size)
{
    if (count <= *space)
        return list;
    int wanted = count > 1000 ? count : 1000;
    void *grown = realloc(list, (size_t)wanted * size);
    if (grown)
        *space = wanted;
    return grown;
}

/* How many strings, whole numbers or numbers follow. */
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
            "\"%.*s\" where the number of %s was expected, %d at most",
            (int)(word.length < 60 ? word.length : 60), word.text, what,
            ARGUMENTS_MOST);
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
    struct pp_rad_word *strings =
        with_room(reader->strings, &reader->string_space, primitive->string_count + 1,
                  sizeof *strings);
    if (!strings)
        return pp_fail_memory(err);
    primitive->strings = reader->strings = strings;
    for (int i = 0; i < primitive->string_count && status == PP_OK; i++) {
        status = pp_rad_words_next(primitive->words, &strings[i], err);
        if (status == PP_OK && strings[i].length == 0)
            status = pp_rad_words_fail(primitive->words, strings[i].line, err,
                                       "the file ends in the middle of a primitive");
    }
    return status;
}

static enum pp_status read_number(struct pp_rad_words *words, double *number,
                                  struct pp_error *err)
{
    struct pp_rad_word word;
    enum pp_status status = pp_rad_words_next(words, &word, err);
    if (status == PP_OK && word.length == 0)
        status = pp_rad_words_fail(words, word.line, err,
                                   "the file ends in the middle of a primitive");
    int shown = (int)(word.length < 60 ? word.length : 60);
    if (status == PP_OK && !pp_rad_words_number(word, number))
        return pp_rad_words_fail(words, word.line, err,
                                 "\"%.*s\" where a number was expected", shown,
                                 word.text);
    if (status == PP_OK && fabs(*number) > 1e30)
        return pp_rad_words_fail(words, word.line, err,
                                 "the number %.*s; expected -1e30 to 1e30", shown,
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
        status = read_number(primitive->words, &ignored, err);
    if (status == PP_OK)
        status = read_count(primitive->words, "numbers", &primitive->number_count, err);
    if (status != PP_OK)
        return status;
    double *numbers = with_room(reader->numbers, &reader->number_space,
                                primitive->number_count + 1, sizeof *numbers);
    if (!numbers)
        return pp_fail_memory(err);
    primitive->numbers = reader->numbers = numbers;
    for (int i = 0; i < primitive->number_count && status == PP_OK; i++)
        status = read_number(primitive->words, &numbers[i], err);
    return status;
}

static enum pp_status say_unknown(const struct pp_rad_words *words,
                                  struct pp_rad_word word, const char *what,
                                  struct pp_error *err)
{
    return pp_rad_words_fail(words, word.line, err, "there is no %s \"%.*s\"", what,
                             (int)(word.length < 60 ? word.length : 60), word.text);
}

/* "modifier alias new old": another name, with another modifier. */
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
                                 "an alias of a material by a material; expected void, "
                                 "inherit or a pattern");
    bool patterned = !inherits && primitive->modifier.kind == PP_RAD_PATTERN;
    if (patterned
        && (meaning.kind != PP_RAD_MATERIAL
            || reader->scene->materials[meaning.index].emits == PP_EMITS_NOTHING))
        return pp_rad_words_fail(
            words, primitive->line, err,
            "an alias that puts a sky's brightfunc on what gives off no "
            "light; expected void or inherit");
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
                               primitive->name.length, meaning)
               ? PP_OK
               : pp_fail_memory(err);
}

static enum pp_status take(struct pp_rad_reader *reader,
                           struct pp_rad_primitive *primitive,
                           const struct pp_rad_context *way, struct pp_error *err)
{
    enum pp_status status = read_strings(reader, primitive, err);
    if (status == PP_OK)
        status = read_numbers(reader, primitive, err);
    bool taken = false;
    if (status == PP_OK)
        status = pp_rad_shapes_read(reader, primitive, way, &taken, err);
    if (status == PP_OK && !taken)
        status = pp_rad_functions_read(reader, primitive, way, &taken, err);
    if (status == PP_OK && !taken)
        status = pp_rad_materials_read(reader, primitive, way, &taken, err);
    if (status == PP_OK && !taken)
        status = pp_rad_words_fail(
            primitive->words, primitive->line, err,
            "the type \"%.*s\" is not understood; expected a shape (polygon, sphere, "
            "bubble, cone, cup, cylinder, tube, ring, source), a material (plastic, "
            "metal, trans, plastic2, metal2, trans2, glass, light, glow, illum, "
            "mirror), alias, the brightfunc of gensky, a mixfunc of two sides",
            (int)(primitive->type.length < 60 ? primitive->type.length : 60),
            primitive->type.text);
    return status;
}

/* Whatever stands next in the file; *ended at its end. */
static enum pp_status read_next(struct pp_rad_reader *reader,
                                struct pp_rad_words *words,
                                const struct pp_rad_context *way, bool *ended,
                                struct pp_error *err)
{
    char *command;
    int line;
    enum pp_status status = pp_rad_words_next_command(words, &command, &line, err);
    if (status != PP_OK || command) {
        if (command)
            status = pp_rad_command_run(reader, words, command, line, way, err);
        free(command);
        return status;
    }
    struct pp_rad_primitive primitive = {.words = words};
    struct pp_rad_word modifier;
    status = pp_rad_words_next(words, &modifier, err);
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
                                 "the file ends in the middle of a primitive");
    bool alias = pp_rad_words_is(primitive.type, "alias");
    if (!(alias && pp_rad_words_is(modifier, "inherit"))
        && !pp_rad_names_find(&reader->names, modifier.text, modifier.length,
                              &primitive.modifier))
        return say_unknown(words, modifier, "material or pattern", err);
    status = alias ? take_alias(reader, &primitive, modifier, err)
                   : take(reader, &primitive, way, err);
    return status == PP_OK
               ? pp_rad_materials_check_count(reader, words, primitive.line, err)
               : status;
}

static enum pp_status read_words(struct pp_rad_reader *reader,
                                 struct pp_rad_words *words,
                                 const struct pp_rad_context *way, struct pp_error *err)
{
    enum pp_status status = PP_OK;
    for (bool ended = false; !ended && status == PP_OK;)
        status = read_next(reader, words, way, &ended, err);
    return status;
}

enum pp_status pp_rad_read_file(struct pp_rad_reader *reader, const char *path,
                                const struct pp_rad_context *way, struct pp_error *err)
{
    char *bytes;
    size_t length;
    enum pp_status status = pp_read_file(&bytes, &length, path, PP_RAD_BYTES_MOST, err);
    if (status != PP_OK)
        return status;
    struct pp_rad_words words = {pp_read_file_title(path), bytes, length, 0, 1};
    reader->bytes += length;
    status = length > PP_RAD_BYTES_MOST
                 ? pp_fail(err, PP_BAD_INPUT, "%s: larger than 4 GiB", words.file)
                 : read_words(reader, &words, way, err);
    free(bytes);
    return status;
}

static enum pp_status finish(struct pp_rad_reader *reader, enum pp_status status)
{
    pp_rad_names_clear(&reader->names);
    free(reader->strings);
    free(reader->numbers);
    free(reader->corners);
    if (status != PP_OK)
        pp_scene_description_clear(reader->scene);
    return status;
}

static const struct pp_rad_context straight = {
    .transform = {.rows = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}},
                  .scale = 1.0}};

enum pp_status pp_rad_read(struct pp_scene_description *scene,
                           struct pp_rad_summary *summary, const char *const *paths,
                           int count, struct pp_error *err)
{
    struct pp_rad_reader reader = {.scene = scene, .summary = summary};
    pp_scene_description_init(scene);
    *summary = (struct pp_rad_summary){0};
    enum pp_status status = PP_OK;
    for (int i = 0; i < count && status == PP_OK; i++)
        status = pp_rad_read_file(&reader, paths[i], &straight, err);
    return finish(&reader, status);
}

enum pp_status pp_rad_read_bytes(struct pp_scene_description *scene,
                                 struct pp_rad_summary *summary, const char *bytes,
                                 size_t length, const char *file, struct pp_error *err)
{
    struct pp_rad_reader reader = {.scene = scene, .summary = summary};
    struct pp_rad_words words = {file, bytes, length, 0, 1};
    pp_scene_description_init(scene);
    *summary = (struct pp_rad_summary){0};
    return finish(&reader, read_words(&reader, &words, &straight, err));
}
