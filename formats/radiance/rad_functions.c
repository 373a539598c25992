/* rad_functions.c - the text of pepperpot.cal, and the reader of primitives that use
 * its functions. */
#include "formats/radiance/rad_functions.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "formats/radiance/read/rad_reader.h"
#include "formats/radiance/read/rad_sky.h"
#include "model/light/graded_sky.h"

/* Turns the numbers of the overcast sky's gradation into text. */
#define TEXT(number) #number
#define TEXT_OF(macro) TEXT(macro)
#define OVERCAST TEXT_OF(PP_GRADED_SKY_OVERCAST)

static const char cal[] =
    "{\n"
    "\tpepperpot.cal - the skies and glazings of pepperpot\n"
    "\n"
    "\tpp_sky, for a brightfunc:\n"
    "\tA1\thorizontal irradiance of the open sky\n"
    "\tA2\t0 uniform, 1 to 15 ISO 15469, 16 CIE overcast,\n"
    "\t\t17 Perez, by the formula of ISO 15469\n"
    "\tA3\tradiance divided by irradiance where the relative radiance is 1\n"
    "\tA4-A8\ta, b, c, d, e of ISO 15469\n"
    "\tA9-A11\tdirection to the sun\n"
    "\tA12 ..\tskylines, four numbers each: direction (x, y), slope, radiance\n"
    "}\n"
    "pp_gradation = 1 + if(A4*A4, A4*exp(A5/Dz), 0);\n"
    "pp_cos_sun = bound(-1, Dx*A9 + Dy*A10 + Dz*arg(11), 1);\n"
    "pp_chi = acos(pp_cos_sun);\n"
    "pp_indicatrix = 1 + A6*(exp(A7*pp_chi) - exp(A7*PI/2)) + "
    "A8*pp_cos_sun*pp_cos_sun;\n"
    "pp_relative = if((16.5 - A2)*(A2 - 15.5), (1 + " OVERCAST "*Dz)/(1 + " OVERCAST
    "),\n"
    "\t\tif(A2 - .5, pp_gradation*pp_indicatrix, 1));\n"
    "pp_beyond(k) = if(k + 2.5 - arg(0), A1*A3*pp_relative,\n"
    "\t\tif(arg(k+2)*(arg(k)*Dx + arg(k+1)*Dy) - Dz, arg(k+3), pp_beyond(k+4)));\n"
    "pp_sky = if(Dz, pp_beyond(12), 0);\n"
    "\n"
    "{\n"
    "\tpp_through and pp_mirrored, for a BRTDfunc: clear panes, with the two\n"
    "\tpolarisations calculated separately\n"
    "\tA10\tnumber of panes\n"
    "\tA11\trefractive index\n"
    "\tA12\tabsorption coefficient times thickness of one pane\n"
    "\tA13\tfactor by which the transmittance of the panes is multiplied\n"
    "\tA14\tshare of the area that is glass, not frame\n"
    "\tA15\tshare of the light that passes through the dirt\n"
    "}\n"
    "pp_cos_i = bound(1e-6, abs(Rdot), 1);\n"
    "pp_cos_r = sqrt(1 - (1 - pp_cos_i*pp_cos_i)/(arg(11)*arg(11)));\n"
    "pp_absorb = exp(-arg(12)/pp_cos_r);\n"
    "pp_square(x) = x*x;\n"
    "pp_across = pp_square((pp_cos_i - arg(11)*pp_cos_r)/(pp_cos_i + "
    "arg(11)*pp_cos_r));\n"
    "pp_along = pp_square((arg(11)*pp_cos_i - pp_cos_r)/(arg(11)*pp_cos_i + "
    "pp_cos_r));\n"
    "pp_t1(rho) = (1-rho)*(1-rho)*pp_absorb/(1 - pp_square(rho*pp_absorb));\n"
    "pp_r1(rho) = rho*(1 + pp_absorb*pp_t1(rho));\n"
    "pp_r(k, rho) = if(k - 1.5, pp_r(k-1, rho) + pp_square(pp_t(k-1, rho))*pp_r1(rho)\n"
    "\t\t/(1 - pp_r(k-1, rho)*pp_r1(rho)), if(k - .5, pp_r1(rho), 0));\n"
    "pp_t(k, rho) = if(k - 1.5, pp_t(k-1, rho)*pp_t1(rho)\n"
    "\t\t/(1 - pp_r(k-1, rho)*pp_r1(rho)), if(k - .5, pp_t1(rho), 1));\n"
    "pp_clear = arg(13)*(pp_t(A10, pp_across) + pp_t(A10, pp_along))/2;\n"
    "pp_stack = (pp_r(A10, pp_across) + pp_r(A10, pp_along))/2;\n"
    "pp_through = arg(14)*arg(15)*pp_clear;\n"
    "pp_mirrored = arg(14)*if(pp_stack + pp_clear - 1, 1 - pp_clear, pp_stack);\n";

const char *pp_rad_functions_cal_text(void)
{
    return cal;
}

/* ---- materials with two sides ---- */

static enum pp_status rad_material_side(const struct pp_rad_reader *reader,
                                        const struct pp_rad_primitive *primitive,
                                        int which, int *material, struct pp_error *err)
{
    struct pp_rad_word word = primitive->strings[which];
    struct pp_rad_meaning meaning;
    int shown = pp_rad_words_shown(word);
    if (!pp_rad_names_find(&reader->names, word.text, word.length, &meaning))
        return pp_rad_words_fail(primitive->words, word.line, err,
                                 "there is no material \"%.*s\"", shown, word.text);
    if (meaning.kind != PP_RAD_MATERIAL)
        return pp_rad_words_fail(
            primitive->words, word.line, err,
            "a side of the mixfunc is \"%.*s\"; expected a material", shown, word.text);
    *material = which == 1 && meaning.back >= 0 ? meaning.back : meaning.index;
    /* Radiance does not sample a concentrated source in a mixfunc, and treats a glowing
     * back as dark. */
    enum pp_emitter_kind emits = reader->scene->materials[*material].emits;
    if (emits == PP_EMITS_CONCENTRATED || (which == 1 && emits != PP_EMITS_NOTHING))
        return pp_rad_words_fail(
            primitive->words, word.line, err,
            "Radiance does not treat \"%.*s\" as a light source inside a mixfunc; "
            "expected a material without emission",
            shown, word.text);
    return PP_OK;
}

/* True if the expression, without its blanks, equals PP_RAD_SIDES, which selects one
 * material per side in a mixfunc. */
static bool is_sides(struct pp_rad_word word)
{
    const char *expected = PP_RAD_SIDES;
    for (size_t i = 0; i < word.length; i++)
        if (word.text[i] != ' ' && word.text[i] != *expected++)
            return false;
    return *expected == '\0';
}

static enum pp_status take_sides(struct pp_rad_reader *reader,
                                 const struct pp_rad_primitive *primitive,
                                 struct pp_error *err)
{
    if (primitive->string_count != 4 || primitive->modifier.kind != PP_RAD_VOID
        || !is_sides(primitive->strings[2])
        || !pp_rad_words_is(primitive->strings[3], "."))
        return pp_rad_words_fail(primitive->words, primitive->line, err,
                                 "the mixfunc is not supported; expected \"void "
                                 "mixfunc\" with \"4 FRONT BACK " PP_RAD_SIDES
                                 " .\", one material per side");
    struct pp_rad_meaning meaning = {PP_RAD_MATERIAL, -1, -1};
    enum pp_status status =
        rad_material_side(reader, primitive, 0, &meaning.index, err);
    if (status == PP_OK)
        status = rad_material_side(reader, primitive, 1, &meaning.back, err);
    if (status != PP_OK)
        return status;
    return pp_rad_names_define(&reader->names, primitive->name.text,
                               primitive->name.length, meaning, err);
}

/* ---- glazings ---- */

static bool is_pane(const struct pp_rad_primitive *primitive)
{
    static const char *const expected[] = {
        "pp_mirrored", "pp_mirrored", "pp_mirrored", "pp_through", "pp_through",
        "pp_through",  "0",           "0",           "0",          PP_RAD_CAL_NAME};
    bool good = primitive->string_count == 10
                && primitive->number_count == PP_RAD_PANE_NUMBERS
                && primitive->modifier.kind == PP_RAD_VOID;
    for (int i = 0; i < 10 && good; i++)
        good = pp_rad_words_is(primitive->strings[i], expected[i]);
    for (int i = 6; i < 9 && good; i++)
        good = primitive->numbers[i] == 0.0;
    return good;
}

static bool is_share(double value)
{
    return value >= 0.0 && value <= 1.0;
}

static enum pp_status add_pane(struct pp_rad_reader *reader,
                               const struct pp_rad_primitive *primitive,
                               const struct pp_glass *glass, const double *diffuse,
                               bool back, int *index, struct pp_error *err)
{
    const double *n = primitive->numbers;
    struct pp_material pane = pp_material_glazing(glass, n[13], n[14], 0.0);
    pane.diffuse = pp_rgb(diffuse[0], diffuse[1], diffuse[2]);
    size_t length = primitive->name.length;
    snprintf(pane.name, sizeof pane.name, "%.*s%s",
             (int)(length < sizeof pane.name ? length : sizeof pane.name - 1),
             primitive->name.text, back ? " (outside)" : "");
    struct pp_error said;
    enum pp_status status =
        pp_scene_description_add_material(reader->scene, &pane, index, &said);
    return pp_rad_words_locate(primitive->words, primitive->line, status, &said, err);
}

static enum pp_status take_pane(struct pp_rad_reader *reader,
                                const struct pp_rad_primitive *primitive,
                                struct pp_error *err)
{
    const double *n = primitive->numbers;
    if (!is_pane(primitive))
        return pp_rad_words_fail(
            primitive->words, primitive->line, err,
            "the BRTDfunc is not supported; expected a glazing by " PP_RAD_CAL_NAME
            ", as written by pepperpot");
    double panes = n[9];
    bool glazed = panes >= 1.0 && panes <= 20.0 && n[10] > 1.0 && n[11] >= 0.0
                  && n[12] > 0.0 && n[12] < 10.0;
    if ((panes != 0.0 && !glazed) || panes != floor(panes) || !is_share(n[13])
        || !is_share(n[14]))
        return pp_rad_words_fail(primitive->words, primitive->line, err,
                                 "the glazing is not valid; expected 0 to 20 panes, a "
                                 "refractive index above 1, an absorption of 0 or "
                                 "more, a factor above 0, and shares from 0 to 1");
    struct pp_glass glass =
        panes == 0.0 ? pp_glass_none() : pp_glass_panes((int)panes, n[10], n[11]);
    if (panes != 0.0 && n[12] != 1.0) {
        glass.normal *= n[12];
        glass.diffuse *= n[12];
        glass.scale = n[12];
    }
    struct pp_rad_meaning meaning = {PP_RAD_MATERIAL, -1, -1};
    bool sides = n[0] != n[3] || n[1] != n[4] || n[2] != n[5];
    enum pp_status status =
        add_pane(reader, primitive, &glass, n, false, &meaning.index, err);
    if (status == PP_OK && sides)
        status = add_pane(reader, primitive, &glass, n + 3, true, &meaning.back, err);
    if (status != PP_OK)
        return status;
    return pp_rad_names_define(&reader->names, primitive->name.text,
                               primitive->name.length, meaning, err);
}

/* ---- skies ---- */

static enum pp_status sky_of(const struct pp_rad_primitive *primitive,
                             struct pp_sky *sky, struct pp_error *err)
{
    const double *n = primitive->numbers;
    struct pp_vec3 sun = pp_vec(n[8], n[9], n[10]);
    struct pp_error said = {0};
    enum pp_status status = PP_OK;
    if (n[1] == 0.0)
        *sky = pp_sky_uniform();
    else if (n[1] == PP_RAD_OVERCAST)
        *sky = pp_sky_overcast();
    else if (n[1] == PP_RAD_PEREZ && pp_vec_length(sun) > 0.5)
        *sky = pp_sky_of_parameters(n + 3, pp_vec_unit(sun));
    else if (n[1] != floor(n[1]) || n[1] < 1.0 || n[1] > 15.0
             || !(pp_vec_length(sun) > 0.5))
        status = pp_fail(&said, PP_BAD_INPUT, "the sky type is %g", n[1]);
    else
        status = pp_sky_iso(sky, (int)n[1], pp_vec_unit(sun), &said);
    const double is[] = {sky->per_horizontal, sky->a, sky->b, sky->c, sky->d, sky->e};
    for (int i = 0; i < 6 && status == PP_OK; i++)
        if (!(fabs(n[2 + i] - is[i]) <= 1e-6 * (1.0 + fabs(is[i]))))
            status = pp_fail(&said, PP_BAD_INPUT,
                             "the sky of type %g has the coefficient %g; expected %g",
                             n[1], n[2 + i], is[i]);
    return pp_rad_words_locate(primitive->words, primitive->line, status, &said, err);
}

static enum pp_status take_sky(struct pp_rad_reader *reader,
                               const struct pp_rad_primitive *primitive,
                               const struct pp_rad_context *context,
                               struct pp_error *err)
{
    const double *n = primitive->numbers;
    int count = primitive->number_count;
    int skylines = (count - PP_RAD_SKY_NUMBERS) / PP_RAD_SKYLINE_NUMBERS;
    struct pp_vec3 up =
        pp_rad_transform_direction(&context->transform, pp_vec(0.0, 0.0, 1.0));
    if (primitive->string_count != 2 || primitive->modifier.kind != PP_RAD_VOID
        || count < PP_RAD_SKY_NUMBERS
        || count != PP_RAD_SKY_NUMBERS + skylines * PP_RAD_SKYLINE_NUMBERS
        || skylines > PP_PATTERN_SKYLINES_MOST || !(n[0] >= 0.0) || up.z < 1.0 - 1e-9)
        return pp_rad_words_fail(primitive->words, primitive->line, err,
                                 "the pp_sky is not supported; expected it as written "
                                 "by pepperpot, rotated only about the vertical");
    struct pp_pattern pattern = {.kind = PP_PATTERN_SKY, .factor = n[0]};
    enum pp_status status = sky_of(primitive, &pattern.sky, err);
    if (status != PP_OK)
        return status;
    pattern.sky.sun = pp_rad_transform_direction(&context->transform, pattern.sky.sun);
    for (int i = 0; i < skylines; i++) {
        const double *of = n + PP_RAD_SKY_NUMBERS + i * PP_RAD_SKYLINE_NUMBERS;
        struct pp_vec3 outward = pp_vec(of[0], of[1], 0.0);
        if (!(fabs(pp_vec_length(outward) - 1.0) < 1e-6) || !(of[2] > 0.0)
            || !(of[3] >= 0.0))
            return pp_rad_words_fail(
                primitive->words, primitive->line, err,
                "the skyline is not valid; expected a direction of length 1, a slope "
                "above 0, and a radiance of 0 or more");
        pattern.skylines[pattern.skyline_count++] = (struct pp_pattern_skyline){
            pp_rad_transform_direction(&context->transform, outward), of[2], of[3]};
    }
    return pp_rad_sky_define(reader, primitive, &pattern, err);
}

enum pp_status pp_rad_functions_read(struct pp_rad_reader *reader,
                                     const struct pp_rad_primitive *primitive,
                                     const struct pp_rad_context *context, bool *taken,
                                     struct pp_error *err)
{
    *taken = true;
    if (pp_rad_words_is(primitive->type, "mixfunc"))
        return take_sides(reader, primitive, err);
    if (pp_rad_words_is(primitive->type, "BRTDfunc"))
        return take_pane(reader, primitive, err);
    if (pp_rad_words_is(primitive->type, "brightfunc") && primitive->string_count >= 2
        && pp_rad_words_is(primitive->strings[0], "pp_sky")
        && pp_rad_words_is(primitive->strings[1], PP_RAD_CAL_NAME))
        return take_sky(reader, primitive, context, err);
    *taken = false;
    return PP_OK;
}
