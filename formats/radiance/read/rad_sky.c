/* rad_sky.c - see rad_sky.h. */
#include "formats/radiance/read/rad_sky.h"

#include <string.h>

#include "formats/radiance/read/rad_gendaylit.h"
#include "formats/radiance/read/rad_materials.h"
#include "formats/radiance/read/rad_shapes.h"

enum pp_status pp_rad_sky_define(struct pp_rad_reader *reader,
                                 const struct pp_rad_primitive *primitive,
                                 const struct pp_pattern *pattern, struct pp_error *err)
{
    struct pp_rad_meaning meaning = {PP_RAD_PATTERN, 0, -1};
    enum pp_status status =
        pp_scene_description_add_pattern(reader->scene, pattern, &meaning.index, err);
    if (status != PP_OK)
        return status;
    return pp_rad_names_define(&reader->names, primitive->name.text,
                               primitive->name.length, meaning, err);
}

/* ---- skies written as primitives ---- */

/* Rotation about the vertical, from the strings after the name of the function file. */
static enum pp_status pattern_turn(const struct pp_rad_primitive *primitive,
                                   const struct pp_rad_context *context,
                                   struct pp_rad_transform *turn, struct pp_error *err)
{
    int count = primitive->string_count - 2;
    struct pp_rad_transform own = pp_rad_transform_identity();
    char text[16][64], *words[16];
    bool good = count <= 16;
    for (int i = 0; i < count && good; i++) {
        struct pp_rad_word word = primitive->strings[2 + i];
        good = word.length < sizeof text[i];
        if (good) {
            memcpy(text[i], word.text, word.length);
            text[i][word.length] = '\0';
            words[i] = text[i];
        }
    }
    for (int i = 0; i < count && good;) {
        int taken = pp_rad_transform_read_option(&own, words + i, count - i);
        good = taken > 0;
        i += taken;
    }
    *turn = pp_rad_transform_compose(&context->transform, &own);
    struct pp_vec3 up = pp_rad_transform_direction(turn, pp_vec(0.0, 0.0, 1.0));
    if (good && up.z > 1.0 - 1e-9)
        return PP_OK;
    return pp_rad_words_fail(primitive->words, primitive->line, err,
                             "the sky is tilted, or its transformation is not valid; "
                             "expected at most a rotation about the vertical");
}

/* Adds a sky of perezlum.cal: factor, brightness of the ground, a to e and the sun's
 * direction. */
static enum pp_status take_perez(struct pp_rad_reader *reader,
                                 const struct pp_rad_primitive *primitive,
                                 const struct pp_rad_context *context,
                                 struct pp_error *err)
{
    const double *n = primitive->numbers;
    if (primitive->number_count != 10 || !(n[0] >= 0.0) || !(n[1] >= 0.0)
        || !(pp_vec_length(pp_vec(n[7], n[8], n[9])) > 0.5))
        return pp_rad_words_fail(
            primitive->words, primitive->line, err,
            "the sky of perezlum.cal has %d numbers, or numbers that are not valid; "
            "expected a factor and the ground's brightness, both 0 or more, five "
            "coefficients, and the sun's direction",
            primitive->number_count);
    struct pp_pattern pattern = {.kind = PP_PATTERN_GENSKY,
                                 .type = PP_GENSKY_PEREZ,
                                 .zenith = n[0],
                                 .ground = n[1],
                                 .norm = 1.0,
                                 .perez = {n[2], n[3], n[4], n[5], n[6]}};
    struct pp_rad_transform turn;
    enum pp_status status = pattern_turn(primitive, context, &turn, err);
    if (status != PP_OK)
        return status;
    pattern.sun =
        pp_rad_transform_direction(&turn, pp_vec_unit(pp_vec(n[7], n[8], n[9])));
    return pp_rad_sky_define(reader, primitive, &pattern, err);
}

static bool is_function(const struct pp_rad_primitive *primitive, const char *name,
                        const char *file)
{
    return primitive->string_count >= 2 && primitive->modifier.kind == PP_RAD_VOID
           && pp_rad_words_is(primitive->strings[0], name)
           && pp_rad_words_is(primitive->strings[1], file);
}

static enum pp_status take_sky(struct pp_rad_reader *reader,
                               const struct pp_rad_primitive *primitive,
                               const struct pp_rad_context *context,
                               struct pp_error *err)
{
    if (is_function(primitive, "skybright", "perezlum.cal"))
        return take_perez(reader, primitive, context, err);
    const struct pp_rad_words *words = primitive->words;
    const double *n = primitive->numbers;
    if (!is_function(primitive, "skybr", "skybright.cal"))
        return pp_rad_words_fail(
            words, primitive->line, err,
            "the brightfunc is not supported; expected \"void brightfunc\" with "
            "\"skybr skybright.cal\", as gensky writes it, or with \"skybright "
            "perezlum.cal\", as gendaylit does");
    bool within = primitive->number_count > 0 && n[0] >= 1.0 && n[0] <= 4.0;
    int type = within ? (int)n[0] : 0;
    bool even = type == PP_GENSKY_OVERCAST || type == PP_GENSKY_UNIFORM;
    bool sunny = type == PP_GENSKY_CLEAR || type == PP_GENSKY_INTERMEDIATE;
    if (!(even && primitive->number_count >= 3 && n[0] == type)
        && !(sunny && primitive->number_count == 7 && n[0] == type))
        return pp_rad_words_fail(
            words, primitive->line, err,
            "the sky has %d numbers; expected type (1 clear, 2 overcast, 3 uniform, 4 "
            "intermediate), zenith and ground brightness, and for 1 and 4 a factor and "
            "the sun's direction",
            primitive->number_count);
    struct pp_pattern pattern = {.kind = PP_PATTERN_GENSKY,
                                 .type = (enum pp_gensky_kind)type,
                                 .zenith = n[1],
                                 .ground = n[2],
                                 .norm = 1.0,
                                 .sun = {0.0, 0.0, 1.0}};
    struct pp_rad_transform turn;
    enum pp_status status = pattern_turn(primitive, context, &turn, err);
    if (status != PP_OK)
        return status;
    if (!(n[1] >= 0.0) || !(n[2] >= 0.0))
        return pp_rad_words_fail(
            words, primitive->line, err,
            "the zenith and ground brightness are %g and %g; expected 0 or more", n[1],
            n[2]);
    if (sunny) {
        struct pp_vec3 sun = pp_vec(n[4], n[5], n[6]);
        if (!(n[3] > 0.0) || !(pp_vec_length(sun) > 0.5))
            return pp_rad_words_fail(
                words, primitive->line, err,
                "the sunny sky has no sun; expected a factor above 0 and a direction");
        pattern.norm = n[3];
        pattern.sun = pp_rad_transform_direction(&turn, pp_vec_unit(sun));
    }
    return pp_rad_sky_define(reader, primitive, &pattern, err);
}

enum pp_status pp_rad_sky_read(struct pp_rad_reader *reader,
                               const struct pp_rad_primitive *primitive,
                               const struct pp_rad_context *context, bool *taken,
                               struct pp_error *err)
{
    *taken = pp_rad_words_is(primitive->type, "brightfunc");
    return *taken ? take_sky(reader, primitive, context, err) : PP_OK;
}

/* ---- skies from the commands gensky and gendaylit ---- */

static enum pp_status define(struct pp_rad_reader *reader, const char *name,
                             enum pp_rad_kind kind, int index, struct pp_error *err)
{
    return pp_rad_names_define(&reader->names, name, strlen(name),
                               (struct pp_rad_meaning){kind, index, -1}, err);
}

enum pp_status pp_rad_sky_generate(struct pp_rad_reader *reader,
                                   const struct pp_rad_pipe *pipe,
                                   const struct pp_rad_command *command,
                                   const struct pp_rad_context *context,
                                   struct pp_error *err)
{
    struct pp_gensky sky;
    char wrong[200];
    bool is_perez = strcmp(command->words[0], "gendaylit") == 0;
    if (!(is_perez ? pp_rad_gendaylit_evaluate : pp_rad_gensky_evaluate)(
            &sky, command->words, command->count, wrong, sizeof wrong))
        return pp_rad_pipe_fail(pipe, err, "", wrong);
    struct pp_vec3 up =
        pp_rad_transform_direction(&context->transform, pp_vec(0.0, 0.0, 1.0));
    if (!(up.z > 1.0 - 1e-9))
        return pp_rad_pipe_fail(
            pipe, err,
            "the sky is tilted; expected at most a rotation about the vertical", "");
    struct pp_vec3 sun = sky.pattern.sun;
    sky.pattern.sun = pp_rad_transform_direction(&context->transform, sun);
    int index;
    enum pp_status status =
        pp_rad_materials_check_count(reader, pipe->words, pipe->line, err);
    if (status == PP_OK)
        status =
            pp_scene_description_add_pattern(reader->scene, &sky.pattern, &index, err);
    if (status == PP_OK)
        status = define(reader, "skyfunc", PP_RAD_PATTERN, index, err);
    if (status != PP_OK || !sky.has_sun)
        return status;
    struct pp_material solar = pp_material_light(pp_rgb_grey(sky.sun_radiance));
    strcpy(solar.name, "solar");
    status = pp_scene_description_add_material(reader->scene, &solar, &index, err);
    if (status == PP_OK)
        status = define(reader, "solar", PP_RAD_MATERIAL, index, err);
    if (status != PP_OK)
        return status;
    const struct pp_shape disc = {.kind = PP_SHAPE_DISTANT,
                                  .is.distant = {sun, sky.sun_half_rad}};
    return pp_rad_shapes_add(reader, pipe->words, pipe->line,
                             (struct pp_rad_meaning){PP_RAD_MATERIAL, index, -1}, disc,
                             context, err);
}
