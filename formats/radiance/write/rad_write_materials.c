/* rad_write_materials.c - see rad_write_materials.h. */
#include "formats/radiance/write/rad_write_materials.h"

#include <math.h>
#include <string.h>

#include "formats/radiance/rad_functions.h"
#include "formats/radiance/write/rad_numbers.h"
#include "formats/radiance/write/rad_writer.h"
#include "model/room/surface_materials.h"

enum {
    MOST_NUMBERS =
        PP_RAD_SKY_NUMBERS + PP_PATTERN_SKYLINES_MOST * PP_RAD_SKYLINE_NUMBERS
};

/* A material as a Radiance primitive: type, strings, numbers. */
struct rad_primitive_text {
    const char *type;
    char strings[256]; /* preceded by their count */
    double numbers[16];
    int count;
};

/* True if two numbers are equal apart from rounding errors. */
static bool near(double a, double b)
{
    return fabs(a - b) <= 1e-12;
}

static bool is_grey(struct pp_rgb c)
{
    return near(c.r, c.g) && near(c.g, c.b);
}

static void add_material_number(struct rad_primitive_text *said, double number)
{
    said->numbers[said->count++] = number;
}

/* Adds a calculated number, rounded to the digits that are certain. */
static void add_worked(struct rad_primitive_text *said, double number)
{
    add_material_number(said, pp_rad_numbers_round(number));
}

static void add_worked_rgb(struct rad_primitive_text *said, struct pp_rgb c)
{
    add_worked(said, c.r);
    add_worked(said, c.g);
    add_worked(said, c.b);
}

static void add_rgb(struct rad_primitive_text *said, struct pp_rgb c)
{
    add_material_number(said, c.r);
    add_material_number(said, c.g);
    add_material_number(said, c.b);
}

/* Sets "4 ux uy uz .", the direction of the first roughness. */
static void say_grain(struct rad_primitive_text *said, struct pp_vec3 grain)
{
    char x[32], y[32], z[32];
    pp_rad_numbers_text(grain.x, x);
    pp_rad_numbers_text(grain.y, y);
    pp_rad_numbers_text(grain.z, z);
    snprintf(said->strings, sizeof said->strings, "4 %s %s %s .", x, y, z);
}

/* Ratio of two colours if it is the same in all channels; otherwise -1. */
static double ratio_of(struct pp_rgb part, struct pp_rgb whole)
{
    double most = pp_rgb_most(whole);
    if (!(most > 0.0))
        return pp_rgb_is_black(part) ? 0.0 : -1.0;
    double ratio = whole.r == most   ? part.r / whole.r
                   : whole.g == most ? part.g / whole.g
                                     : part.b / whole.b;
    struct pp_rgb off = pp_rgb_along(part, -ratio, whole);
    return near(off.r, 0.0) && near(off.g, 0.0) && near(off.b, 0.0) ? ratio : -1.0;
}

static bool is_mirror(const struct pp_material *m)
{
    return m->kind == PP_MATERIAL_OPAQUE && m->emits == PP_EMITS_NOTHING
           && pp_rgb_is_black(m->diffuse) && !pp_rgb_is_black(m->gloss) && !m->rough
           && m->roughness[0] == 0.0 && m->roughness[1] == 0.0;
}

/* Roughness of the gloss that represents a physically rough surface: the RMS slope of
 * its facets. The lobe of a very rough surface approaches that gloss
 * (he_torrance.h). */
static double roughness_of(const struct pp_rough_surface *rough)
{
    return fmin(2.0 * rough->optics.roughness / rough->optics.correlation, 1.0);
}

/* Describes an opaque material; false if no Radiance type can. Radiance's `mirror` is
 * black from behind, so a mirror seen from both sides is written as a plastic or
 * metal. */
static bool say_opaque(struct rad_primitive_text *said, const struct pp_material *m,
                       bool both_sides)
{
    bool twofold = m->roughness[0] != m->roughness[1];
    struct pp_rgb gloss = m->gloss;
    if (m->rough && !pp_rgb_is_black(m->diffuse)) /* the gloss of plastic is white */
        gloss = pp_rgb_grey(pp_rgb_luminance(gloss));
    if (is_mirror(m) && !both_sides) {
        said->type = "mirror";
        add_rgb(said, gloss);
        return true;
    }
    double specular = gloss.r;
    double roughness = m->rough ? roughness_of(m->rough) : m->roughness[0];
    if (is_grey(gloss) && specular < 1.0) {
        said->type = twofold ? "plastic2" : "plastic";
        struct pp_rgb colour = pp_rgb_scale(m->diffuse, 1.0 / (1.0 - specular));
        add_worked_rgb(said, m->rough ? pp_rgb(fmin(colour.r, 1.0), fmin(colour.g, 1.0),
                                               fmin(colour.b, 1.0))
                                      : colour);
    } else {
        struct pp_rgb colour = pp_rgb_add(m->diffuse, gloss);
        specular = ratio_of(gloss, colour);
        said->type = twofold ? "metal2" : "metal";
        add_worked_rgb(said, colour);
    }
    add_worked(said, specular);
    add_material_number(said, roughness);
    if (twofold) {
        add_material_number(said, m->roughness[1]);
        say_grain(said, m->grain);
    }
    return specular >= 0.0;
}

static bool say_translucent(struct rad_primitive_text *said,
                            const struct pp_material *m)
{
    bool twofold = m->roughness[0] != m->roughness[1];
    double specular = m->gloss.r;
    struct pp_rgb through = pp_rgb_add(m->through_diffuse, m->through_gloss);
    struct pp_rgb inward = pp_rgb_add(m->diffuse, through);
    double share = ratio_of(through, inward);
    double straight = ratio_of(m->through_gloss, through);
    if (!is_grey(m->gloss) || !(specular < 1.0) || share < 0.0 || straight < 0.0)
        return false;
    said->type = twofold ? "trans2" : "trans";
    add_worked_rgb(said, pp_rgb_scale(inward, 1.0 / (1.0 - specular)));
    add_worked(said, specular);
    add_material_number(said, m->roughness[0]);
    if (twofold) {
        add_material_number(said, m->roughness[1]);
        say_grain(said, m->grain);
    }
    add_worked(said, share);
    add_worked(said, straight);
    return true;
}

/* True for one clean pane without a frame, as described by Radiance's `glass`. */
static bool is_plain_pane(const struct pp_material *m)
{
    for (int i = 0; i < 3; i++)
        if (m->glass[i].panes != 1 || m->glass[i].scale != 1.0
            || m->glass[i].n != m->glass[0].n)
            return false;
    return m->clear_share == 1.0 && m->dirt == 1.0 && pp_rgb_is_black(m->diffuse);
}

static bool say_glass(struct rad_primitive_text *said, const struct pp_material *m,
                      struct pp_rgb back)
{
    const struct pp_glass *glass = m->glass;
    if (is_plain_pane(m) && pp_rgb_is_black(back)) {
        said->type = "glass";
        for (int i = 0; i < 3; i++)
            add_worked(said, exp(-glass[i].kl));
        if (glass->n != 1.52)
            add_material_number(said, glass->n);
        return true;
    }
    for (int i = 1; i < 3; i++)
        if (glass[i].panes != glass->panes || glass[i].n != glass->n
            || glass[i].kl != glass->kl || glass[i].scale != glass->scale)
            return false;
    said->type = "BRTDfunc";
    strcpy(said->strings,
           "10 pp_mirrored pp_mirrored pp_mirrored pp_through pp_through "
           "pp_through 0 0 0 " PP_RAD_CAL_NAME);
    add_rgb(said, m->diffuse);
    add_rgb(said, back);
    add_rgb(said, pp_rgb_grey(0.0));
    add_material_number(said, glass->panes);
    add_material_number(said, glass->panes > 0 ? glass->n : 1.52);
    add_material_number(said, glass->kl);
    add_material_number(said, glass->panes > 0 ? glass->scale : 1.0);
    add_material_number(said, m->clear_share);
    add_material_number(said, m->dirt);
    return true;
}

/* Describes a material that only emits light; false for others. */
static bool say_emitter(struct rad_primitive_text *said, const struct pp_material *m)
{
    bool air = m->kind == PP_MATERIAL_AIR;
    bool black = m->kind == PP_MATERIAL_OPAQUE && pp_rgb_is_black(m->diffuse)
                 && pp_rgb_is_black(m->gloss);
    bool glow = m->emits == PP_EMITS_EXTENDED;
    if (m->emits_both_sides || (black ? m->unseen : !air || glow || !m->unseen))
        return false;
    said->type = air ? "illum" : glow ? "glow" : "light";
    add_rgb(said, m->radiance);
    if (glow)
        add_material_number(said, 0.0);
    return true;
}

/* Describes a material. both_sides: the back is visible too. Returns false if no
 * Radiance type can describe it. */
static bool say(struct rad_primitive_text *said, const struct pp_material *m,
                bool both_sides)
{
    *said = (struct rad_primitive_text){.strings = "0"};
    if (m->emits != PP_EMITS_NOTHING)
        return say_emitter(said, m);
    switch (m->kind) {
    case PP_MATERIAL_OPAQUE:
        return say_opaque(said, m, both_sides);
    case PP_MATERIAL_TRANSLUCENT:
        return say_translucent(said, m);
    case PP_MATERIAL_GLASS:
        return say_glass(said, m, m->diffuse);
    case PP_MATERIAL_AIR:
        return false;
    case PP_MATERIAL_SCATTERING: /* written with its pair */
        return true;
    }
    return false;
}

enum pp_status pp_rad_write_materials_check(const struct pp_material *material,
                                            struct pp_error *err)
{
    struct rad_primitive_text said;
    return say(&said, material, false)
               ? PP_OK
               : pp_fail(err, PP_BAD_INPUT,
                         "material \"%s\": Radiance has no equivalent material",
                         material->name);
}

static void write_said(const struct rad_primitive_text *said, const char *modifier,
                       const char *name, FILE *out)
{
    fprintf(out, "\n%s %s %s\n%s\n0\n", modifier, said->type, name, said->strings);
    pp_rad_numbers_write(out, said->numbers, said->count);
}

/* ---- patterns ---- */

static void write_sky(const struct pp_pattern *pattern, const char *name, FILE *out)
{
    const struct pp_sky *sky = &pattern->sky;
    double type = sky->kind == PP_SKY_UNIFORM    ? 0
                  : sky->kind == PP_SKY_OVERCAST ? PP_RAD_OVERCAST
                  : sky->iso > 0                 ? sky->iso
                                                 : PP_RAD_PEREZ;
    double numbers[MOST_NUMBERS] = {
        pattern->factor, type,   sky->per_horizontal, sky->a,     sky->b,    sky->c,
        sky->d,          sky->e, sky->sun.x,          sky->sun.y, sky->sun.z};
    int count = PP_RAD_SKY_NUMBERS;
    for (int i = 0; i < pattern->skyline_count; i++) {
        const struct pp_pattern_skyline *skyline = &pattern->skylines[i];
        numbers[count++] = skyline->outward.x;
        numbers[count++] = skyline->outward.y;
        numbers[count++] = skyline->slope;
        numbers[count++] = skyline->radiance;
    }
    fprintf(out, "\nvoid brightfunc %s\n2 pp_sky " PP_RAD_CAL_NAME "\n0\n", name);
    pp_rad_numbers_write(out, numbers, count);
}

static void write_perez(const struct pp_pattern *pattern, const char *name, FILE *out)
{
    const double *n = pattern->perez;
    const double numbers[] = {
        pattern->zenith, pattern->ground, n[0],          n[1], n[2], n[3], n[4],
        pattern->sun.x,  pattern->sun.y,  pattern->sun.z};
    fprintf(out, "\nvoid brightfunc %s\n2 skybright perezlum.cal\n0\n", name);
    pp_rad_numbers_write(out, numbers, 10);
}

static void write_gensky(const struct pp_pattern *pattern, const char *name, FILE *out)
{
    if (pattern->type == PP_GENSKY_PEREZ) {
        write_perez(pattern, name, out);
        return;
    }
    const double numbers[] = {pattern->type, pattern->zenith, pattern->ground,
                              pattern->norm, pattern->sun.x,  pattern->sun.y,
                              pattern->sun.z};
    bool sunny =
        pattern->type == PP_GENSKY_CLEAR || pattern->type == PP_GENSKY_INTERMEDIATE;
    fprintf(out, "\nvoid brightfunc %s\n2 skybr skybright.cal\n0\n", name);
    pp_rad_numbers_write(out, numbers, sunny ? 7 : 3);
}

/* ---- materials of a scene ---- */

/* True if the two sides are clear glazing that differs only in the reflectance of the
 * frame. */
static bool is_one_glazing(const struct pp_material *front,
                           const struct pp_material *back)
{
    struct pp_material other = *back;
    other.diffuse = front->diffuse;
    memcpy(other.name, front->name, sizeof other.name);
    return front->kind == PP_MATERIAL_GLASS && pp_surface_materials_same(front, &other);
}

/* True for the two sides of one scattering pane. */
static bool is_one_pane(const struct pp_material *front, const struct pp_material *back)
{
    return front->kind == PP_MATERIAL_SCATTERING && back->kind == PP_MATERIAL_SCATTERING
           && front->scatter->id == back->scatter->id && !front->is_outside
           && back->is_outside && front->clear_share == back->clear_share
           && front->dirt == back->dirt;
}

static bool is_room_side(const struct pp_material *material)
{
    return material->kind == PP_MATERIAL_SCATTERING && !material->is_outside;
}

/* Index of the first material whose pane has the same data and losses. */
static int first_like(const struct pp_scene_description *scene, int material)
{
    const struct pp_material *own = &scene->materials[material];
    for (int i = 0; i < material; i++) {
        const struct pp_material *other = &scene->materials[i];
        if (is_room_side(other) && other->scatter->id == own->scatter->id
            && other->clear_share * other->dirt == own->clear_share * own->dirt)
            return i;
    }
    return material;
}

int pp_rad_write_materials_pane(const struct pp_scene_description *scene, int material)
{
    int number = 0;
    if (!is_room_side(&scene->materials[material]))
        return 0;
    int first = first_like(scene, material);
    for (int i = 0; i <= first; i++)
        number += is_room_side(&scene->materials[i]) && first_like(scene, i) == i;
    return number;
}

/* Writes a scattering pane as one material for both sides. Its data file contains the
 * transmission, reduced by frame and dirt. The numbers are the diffuse reflectances of
 * the room side and the outside. */
static void write_pane(const struct pp_rad_writer *writer, int front, int back,
                       const char *name, FILE *out)
{
    const struct pp_material *in = &writer->scene->materials[front];
    const struct pp_material *outside = &writer->scene->materials[back];
    double reflected[9] = {in->diffuse.r,      in->diffuse.g,      in->diffuse.b,
                           outside->diffuse.r, outside->diffuse.g, outside->diffuse.b};
    bool split = in->scatter->splits;
    fprintf(out, "\nvoid %s %s\n%s" PP_RAD_PANE_FILE, split ? "aBSDF" : "BSDF", name,
            split ? "5 " : "6 0 ", pp_rad_write_materials_pane(writer->scene, front));
    const double up[3] = {in->grain.x, in->grain.y, in->grain.z};
    for (int i = 0; i < 3; i++) {
        char text[32];
        pp_rad_numbers_text(up[i] + 0.0, text);
        fprintf(out, " %s", text);
    }
    fputs(" .\n0\n", out);
    pp_rad_numbers_write(out, reflected, 9);
}

bool pp_rad_write_materials_is_mirror(const struct pp_rad_writer *writer,
                                      const struct pp_rad_pair *pair)
{
    const struct pp_material *front = &writer->scene->materials[pair->front];
    const struct pp_material *back = &writer->scene->materials[pair->back];
    return is_mirror(front) && back->kind == PP_MATERIAL_OPAQUE
           && pp_rgb_is_black(back->diffuse) && pp_rgb_is_black(back->gloss)
           && back->emits == PP_EMITS_NOTHING && !writer->behind[pair->front];
}

/* The two sides of a glazing become one Radiance material if is_one_glazing or
 * is_one_pane is true; they are then not written separately. The back of a mirror is
 * not written either. */
void pp_rad_write_materials_classify(struct pp_rad_writer *writer)
{
    const struct pp_scene_description *scene = writer->scene;
    for (int i = 0; i < scene->shape_count; i++) {
        const struct pp_shape *shape = &scene->shapes[i];
        writer->behind[shape->back_material < 0 ? shape->material
                                                : shape->back_material] = true;
        if (writer->pair_of[i] < 0)
            writer->on_its_own[shape->material] = true;
    }
    for (int i = 0; i < writer->pair_count; i++) {
        const struct pp_rad_pair *pair = &writer->pairs[i];
        bool one = is_one_glazing(&scene->materials[pair->front],
                                  &scene->materials[pair->back])
                   || is_one_pane(&scene->materials[pair->front],
                                  &scene->materials[pair->back]);
        bool mirror = pp_rad_write_materials_is_mirror(writer, pair);
        (one ? writer->in_pairs : writer->on_its_own)[pair->front] = true;
        (one || mirror ? writer->in_pairs : writer->on_its_own)[pair->back] = true;
    }
}

static void write_pair(const struct pp_rad_writer *writer,
                       const struct pp_rad_pair *pair, FILE *out)
{
    const struct pp_material *front = &writer->scene->materials[pair->front];
    const struct pp_material *back = &writer->scene->materials[pair->back];
    const char *name = writer->names[pair->name].text;
    if (is_one_glazing(front, back)) {
        struct rad_primitive_text said = {.strings = "0"};
        say_glass(&said, front, back->diffuse);
        write_said(&said, "void", name, out);
        return;
    }
    if (is_one_pane(front, back)) {
        write_pane(writer, pair->front, pair->back, name, out);
        return;
    }
    if (pair->name == pair->front)
        return; /* a mirror, written with the materials */
    fprintf(out, "\nvoid mixfunc %s\n4 %s %s " PP_RAD_SIDES " .\n0\n0\n", name,
            writer->names[pair->front].text, writer->names[pair->back].text);
}

void pp_rad_write_materials(const struct pp_rad_writer *writer, FILE *out)
{
    const struct pp_scene_description *scene = writer->scene;
    const struct pp_rad_name_text *patterns = writer->names + scene->material_count;
    for (int i = 0; i < scene->pattern_count; i++)
        if (scene->patterns[i].kind == PP_PATTERN_SKY)
            write_sky(&scene->patterns[i], patterns[i].text, out);
        else
            write_gensky(&scene->patterns[i], patterns[i].text, out);
    for (int i = 0; i < scene->material_count; i++) {
        const struct pp_material *material = &scene->materials[i];
        struct rad_primitive_text said;
        if ((writer->in_pairs[i] && !writer->on_its_own[i])
            || !say(&said, material, writer->behind[i]))
            continue;
        if (material->rough)
            fputs("\n# A gloss in place of a physically rough surface: its spike, and "
                  "the "
                  "change with\n# angle and wavelength, are left out.",
                  out);
        write_said(&said,
                   material->pattern >= 0 ? patterns[material->pattern].text : "void",
                   writer->names[i].text, out);
    }
    for (int i = 0; i < writer->pair_count; i++)
        write_pair(writer, &writer->pairs[i], out);
}
