/* causes.c - the list of causes, and the conditions under which each can be
 * detected. */
#include "studies/research/compare/causes.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Smallest detectable differences in height (m) and in reflectance. */
static const double SAME_HEIGHT_M = 0.05, SAME_REFLECTANCE = 0.02;

/* ---- applicability ---- */

/* True if any glass in a room's openings or a scene's materials has `property`. */
static bool has_glass_that(const struct pp_compare_subject *subject,
                           bool (*property)(const struct pp_glass *glass))
{
    const struct pp_world *world = subject->room ? subject->room->world : NULL;
    const struct pp_scene_description *scene = subject->scene;
    for (int i = 0; world && i < world->opening_count; i++)
        if (property(&world->openings[i].glass))
            return true;
    for (int i = 0; scene && i < scene->material_count; i++)
        if (scene->materials[i].kind == PP_MATERIAL_GLASS
            && property(&scene->materials[i].glass[1]))
            return true;
    return false;
}

static bool is_there(const struct pp_glass *glass)
{
    return glass->panes > 0;
}

static bool is_clear(const struct pp_glass *glass)
{
    return glass->panes > 0 && !glass->diffusing;
}

static bool has_panes(const struct pp_glass *glass)
{
    return glass->panes > 1 && !glass->diffusing;
}

static bool has_glass(const struct pp_compare_subject *subject)
{
    return has_glass_that(subject, is_there);
}

static bool has_clear_glass(const struct pp_compare_subject *subject)
{
    return has_glass_that(subject, is_clear);
}

static bool has_several_panes(const struct pp_compare_subject *subject)
{
    return has_glass_that(subject, has_panes);
}

static bool has_frames(const struct pp_compare_subject *subject)
{
    const struct pp_world *world = subject->room ? subject->room->world : NULL;
    const struct pp_scene_description *scene = subject->scene;
    for (int i = 0; world && i < world->opening_count; i++)
        if (world->openings[i].frame_factor < 1.0)
            return true;
    for (int i = 0; scene && i < scene->material_count; i++)
        if (scene->materials[i].kind == PP_MATERIAL_GLASS
            && scene->materials[i].clear_share < 1.0)
            return true;
    return false;
}

static bool has_dirt(const struct pp_compare_subject *subject)
{
    const struct pp_world *world = subject->room ? subject->room->world : NULL;
    const struct pp_scene_description *scene = subject->scene;
    for (int i = 0; world && i < world->opening_count; i++)
        if (world->openings[i].maintenance < 1.0)
            return true;
    for (int i = 0; scene && i < scene->material_count; i++)
        if (scene->materials[i].kind == PP_MATERIAL_GLASS
            && scene->materials[i].dirt < 1.0)
            return true;
    return false;
}

static bool is_coloured(struct pp_rgb colour)
{
    return fabs(colour.r - colour.g) > SAME_REFLECTANCE
           || fabs(colour.b - colour.g) > SAME_REFLECTANCE;
}

static bool has_colours(const struct pp_compare_subject *subject)
{
    const struct pp_scene_description *scene = subject->scene;
    for (int i = 0; scene && i < scene->material_count; i++) {
        const struct pp_material *material = &scene->materials[i];
        if (material->kind != PP_MATERIAL_AIR
            && (is_coloured(material->diffuse) || is_coloured(material->gloss)
                || is_coloured(material->through_diffuse)))
            return true;
    }
    return false;
}

/* True if a horizontal plane at z_m is a possible mistake: it is at the height of no
 * point, all points face up, and z_m is below the ceiling. */
static bool is_off(const struct pp_compare_subject *subject, double z_m)
{
    bool off = !subject->room || z_m < subject->room->world->height_m;
    for (int i = 0; i < subject->count && off; i++)
        off = fabs(subject->points[i].position.z - z_m) > SAME_HEIGHT_M
              && subject->points[i].normal.z > 0.0;
    return off;
}

static bool is_off_floor(const struct pp_compare_subject *subject)
{
    return is_off(subject, 0.0);
}

static bool is_off_desk(const struct pp_compare_subject *subject)
{
    return is_off(subject, 0.85);
}

static bool is_overcast(const struct pp_compare_subject *subject)
{
    return subject->room && subject->room->light.sky.kind == PP_SKY_OVERCAST;
}

static bool is_not_uniform(const struct pp_compare_subject *subject)
{
    return subject->room && subject->room->light.sky.kind != PP_SKY_UNIFORM;
}

static bool is_room(const struct pp_compare_subject *subject)
{
    return subject->room != NULL;
}

static bool ground_is_shaded(const struct pp_compare_subject *subject)
{
    return subject->room && subject->room->light.ground_reflectance > SAME_REFLECTANCE
           && !subject->room->world->ground_is_open;
}

static bool has_outside(const struct pp_compare_subject *subject)
{
    const struct pp_world *world = subject->room ? subject->room->world : NULL;
    if (!world)
        return false;
    if (world->skyline_count > 0 || world->block_count > 0 || world->mesh_count > 0)
        return true;
    for (int i = 0; i < world->surface_count; i++)
        if (world->surfaces[i].role == PP_FREE_SURFACE && !world->surfaces[i].inside)
            return true;
    return false;
}

/* ---- the list ---- */

#define MORE_BOUNCES "allow more bounces (rtrace -ab 7 or more)"
#define CUT(number, times)                                                             \
    {                                                                                  \
        "bounces=" #number, "bounces",                                                 \
            "calculation limited to " times " between surfaces", MORE_BOUNCES, false,  \
            false, NULL                                                                \
    }
#define CUT_WITH_GROUND(number, times)                                                 \
    {                                                                                  \
        "ab=" #number, "bounces",                                                      \
            "calculation limited to " times ", including that of the ground",          \
            MORE_BOUNCES, false, false, ground_is_shaded                               \
    }

static const struct pp_cause causes[] = {
    {"ab=0", "bounces", "the program ignores light from the sky",
     "turn on the ambient calculation (rtrace -ab 7 or more)", false, true, NULL},
    CUT(0, "light without reflections"),
    CUT(1, "one reflection"),
    CUT(2, "two reflections"),
    CUT(3, "three reflections"),
    CUT(4, "four reflections"),
    CUT(5, "five reflections"),
    CUT(6, "six reflections"),
    CUT_WITH_GROUND(2, "one reflection"),
    CUT_WITH_GROUND(3, "two reflections"),
    CUT_WITH_GROUND(4, "three reflections"),
    CUT_WITH_GROUND(5, "four reflections"),
    CUT_WITH_GROUND(6, "five reflections"),
    {"glass=normal", "glass",
     "glass has its normal transmittance at all angles of incidence",
     "use a glass whose transmittance decreases with increasing angle of incidence",
     false, false, has_clear_glass},
    {"glass=transmissivity", "glass",
     "the transmittance of the glass was entered as a transmissivity",
     "convert the transmittance to a transmissivity (0.90 becomes 0.98)", false, false,
     has_clear_glass},
    {"glass=none", "glass", "openings have no glass", "add the glass", false, false,
     has_glass},
    {"panes=1", "panes", "glazing has one pane instead of two or more",
     "model all panes of the glazing", false, false, has_several_panes},
    {"frame=none", "frame", "frames do not reduce the light",
     "reduce the glass area by the area of the frames", false, false, has_frames},
    {"dirt=none", "dirt", "the glass has no dirt", "apply the maintenance factor",
     false, false, has_dirt},
    {"plane=0", "plane", "the points lie on the floor",
     "move the points to the working plane", false, false, is_off_floor},
    {"plane=0.85", "plane", "the points lie 0.85 m above the floor",
     "move the points to their correct height", false, false, is_off_desk},
    {"sky=uniform", "sky", "the sky is uniform", "use the CIE overcast sky", false,
     false, is_not_uniform},
    {"sky=gensky", "sky",
     "the sky fades into the ground at the horizon, as gensky's does",
     "use a sky function without the blend at the horizon", false, false, is_overcast},
    {"ground", "ground", "the ground has this reflectance",
     "correct the ground reflectance (gensky -g)", false, false, is_room},
    {"ground=open", "ground",
     "the whole sky lights the ground, without shadows (Radiance's ground)",
     "model the ground as a surface", false, false, ground_is_shaded},
    {"outside=none", "outside", "there are no external obstructions",
     "model the external obstructions", false, false, has_outside},
    {"colour=grey", "colour",
     ("materials are grey, with the luminous reflectance of "
      "their colours"),
     "use the colours of the materials", false, false, has_colours},
    {"colour=mean", "colour",
     "red, green and blue have equal weight instead of 0.265, 0.670 and 0.065",
     "weight the channels (179 lm/W times 0.265 R + 0.670 G + 0.065 B)", false, false,
     has_colours},
    {"colour=green", "colour", "the green channel alone is used for luminance",
     "weight the channels (179 lm/W times 0.265 R + 0.670 G + 0.065 B)", false, false,
     has_colours},
    {"factor", "factor", "all values differ by a common factor",
     "check the horizontal illuminance that daylight factors refer to (such as 10,000 "
     "lx), units, and other factors that apply to all values",
     true, false, NULL},
};
enum { CAUSE_COUNT = sizeof causes / sizeof causes[0] };

const char *pp_causes_missing_at(int index)
{
    static const char *const missing[] = {
        "reflectances of surfaces", "dimensions of room, windows and obstructions",
        "points shifted sideways", "skies other than the uniform sky and gensky's"};
    enum { MISSING_COUNT = sizeof missing / sizeof missing[0] };
    return index < MISSING_COUNT ? missing[index] : NULL;
}

bool pp_causes_is_fitted(const struct pp_cause *cause)
{
    return !cause->is_factor && !strchr(cause->word, '=');
}

enum pp_status pp_causes_set_variant(struct pp_room_variant *variant,
                                     const struct pp_cause *cause, double value,
                                     struct pp_error *err)
{
    char word[64];
    if (!pp_causes_is_fitted(cause))
        return pp_room_variant_add(variant, cause->word, err);
    snprintf(word, sizeof word, "%s=%.3f", cause->word, value);
    return pp_room_variant_add(variant, word, err);
}

const struct pp_cause *pp_causes_at(int index)
{
    return index < CAUSE_COUNT ? &causes[index] : NULL;
}

int pp_causes_of(const struct pp_cause *list[PP_CAUSES_MOST],
                 const struct pp_compare_subject *subject)
{
    int count = 0;
    for (int i = 0; i < CAUSE_COUNT; i++)
        if (!causes[i].applies || causes[i].applies(subject))
            list[count++] = &causes[i];
    return count;
}
