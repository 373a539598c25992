/* surface_materials.c - see surface_materials.h. */
#include "model/room/surface_materials.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/array.h"
#include "model/geometry/tolerance.h"
#include "model/light/rough/rough_finishes.h"
#include "model/light/slats/blind.h"

static const char *surface_name(const struct pp_surface *surface)
{
    switch (surface->role) {
    case PP_FLOOR:
        return "floor";
    case PP_WALL:
        return surface->name ? surface->name : "wall";
    case PP_CEILING:
        return "ceiling";
    case PP_REVEAL:
        return "reveal";
    case PP_COVER:
        return surface->name;
    case PP_FREE_SURFACE:
        return "surface";
    case PP_BLOCK:
        return "block";
    case PP_FACADE:
        return "facade";
    case PP_SKYLINE:
        return "skyline";
    case PP_ROLE_COUNT:
        break;
    }
    return "surface";
}

static void name(struct pp_material *material, const char *of, bool outside)
{
    snprintf(material->name, sizeof material->name, "%s%s", of,
             outside ? " (outside)" : "");
}

static void add_pattern(struct pp_material *material, const struct pp_world *world,
                        const struct pp_surface *surface)
{
    const struct pp_rough_finish *of =
        pp_rough_finishes_patterned(world->materials, surface->finish);
    material->surface_pattern = &of->pattern;
    material->pattern_scale = of->surface.optics.diffuse;
    material->pattern_mean = surface->pattern_mean;
    material->bumps = of->has_bumps ? &of->height : NULL;
    if (material->rough)
        material->diffuse =
            pp_rgb_scale(material->pattern_scale, surface->pattern_mean);
}

struct pp_material pp_surface_materials_of(const struct pp_world *world, int index,
                                           bool front)
{
    const struct pp_surface *surface = &world->surfaces[index];
    double reflectance = front ? surface->front : surface->back;
    struct pp_material material = pp_material_diffuse(pp_rgb_grey(reflectance));
    const struct pp_rough_surface *rough =
        pp_rough_finishes_surface(world->materials, surface->finish);
    if (!rough && world->within)
        rough = pp_rough_finishes_surface(world->within->materials, surface->finish);
    bool finished = surface->finish
                    && (front || !surface->inside || surface->role == PP_FREE_SURFACE
                        || surface->role == PP_COVER);
    bool patterned = finished && surface->pattern_mean > 0.0;
    /* A physically rough finish applies only with its own reflectance. */
    if (finished && rough && (patterned || reflectance == surface->finish->reflectance))
        material = pp_material_rough(rough);
    else if (finished && !rough)
        material = pp_material_finish(surface->finish, reflectance);
    if (patterned)
        add_pattern(&material, world, surface);
    if (surface->exitance > 0.0) {
        material.emits = PP_EMITS_EXTENDED;
        material.radiance = pp_rgb_grey(surface->exitance / PP_PI);
    }
    bool envelope = index < world->face_count || surface->role == PP_REVEAL;
    name(&material, surface_name(surface), !front && envelope);
    return material;
}

struct pp_material pp_surface_materials_matt(const struct pp_world *world, int index,
                                             bool front)
{
    const struct pp_surface *surface = &world->surfaces[index];
    struct pp_material material = pp_surface_materials_of(world, index, front);
    material.diffuse = pp_rgb_grey(front ? surface->front : surface->back);
    material.gloss = pp_rgb_grey(0.0);
    material.roughness[0] = material.roughness[1] = 0.0;
    material.grain = pp_vec(0.0, 0.0, 0.0);
    material.rough = NULL;
    if (material.bumps) /* the mean reflectance replaces both formulae */
        material.bumps = material.surface_pattern = NULL;
    material.pattern_scale = pp_rgb_grey(pp_rgb_luminance(material.pattern_scale));
    return material;
}

/* M K: share of the light transmitted by dirt and curtains. */
static double clean_share(const struct pp_opening *opening)
{
    return opening->maintenance * opening->curtains;
}

/* F: share of the opening's area that is neither frame nor the fabric of a screen. */
static double open_share(const struct pp_opening *opening)
{
    return opening->device.kind == PP_DEVICE_SCREEN
               ? opening->frame_factor * opening->device.openness
               : opening->frame_factor;
}

/* Mean reflectance of frame and fabric; the frame has the reflectance of the wall. */
static double frame_reflectance(const struct pp_opening *opening, double wall)
{
    double frame = 1.0 - opening->frame_factor,
           fabric = opening->frame_factor - open_share(opening);
    return fabric > 0.0 ? (frame * wall + fabric * opening->device.reflectance)
                              / (frame + fabric)
                        : wall;
}

double pp_surface_materials_pane_straight(const struct pp_opening *opening,
                                          double cosine)
{
    return pp_glass_transmittance(&opening->glass, cosine) * open_share(opening)
           * clean_share(opening);
}

double pp_surface_materials_pane_even(const struct pp_opening *opening)
{
    double blind = opening->blind ? opening->blind->all : 1.0;
    return opening->glass.diffuse * blind * open_share(opening) * clean_share(opening);
}

double pp_surface_materials_pane_mirrored(const struct pp_opening *opening,
                                          double cosine)
{
    return pp_glass_reflectance(&opening->glass, cosine) * open_share(opening);
}

/* Share of the light that passes the pane straight. scatter: how the pane scatters;
 * NULL: it is glass. */
static double straight_from(const struct pp_opening *opening,
                            const struct pp_pane_scatter *scatter, struct pp_vec3 u,
                            double cosine)
{
    if (!scatter)
        return pp_surface_materials_pane_straight(opening, cosine);
    struct pp_vec3 travel =
        pp_vec(-pp_vec_dot(u, opening->along), -pp_vec_dot(u, opening->up), cosine);
    return scatter->straight(scatter->data, travel) * open_share(opening)
           * clean_share(opening);
}

double pp_surface_materials_pane_from(const struct pp_opening *opening,
                                      struct pp_vec3 u, double cosine)
{
    return straight_from(opening, opening->scatter, u, cosine);
}

double pp_surface_materials_pane_sun(const struct pp_opening *opening, struct pp_vec3 u,
                                     double cosine)
{
    const struct pp_pane_scatter *scatter = opening->scatter;
    return straight_from(
        opening, scatter && scatter->for_sun ? scatter->for_sun : scatter, u, cosine);
}

/* Transmittance of one of the two faces of a crown that a ray crosses. */
static double crown_face_share(const struct pp_world *world, const struct pp_tree *tree)
{
    return sqrt(world->trees_are_bare ? tree->winter_transmittance
                                      : tree->transmittance);
}

double pp_surface_materials_past_outer_panes(const struct pp_world *world,
                                             struct pp_vec3 point, struct pp_vec3 u)
{
    double share = 1.0;
    for (int i = 0; i < world->outer_pane_count; i++) {
        const struct pp_outer_pane *pane = &world->outer_panes[i];
        double approach = pp_vec_dot(pane->outline.normal, u),
               away_m = -pp_polygon_height(&pane->outline, point) / approach;
        if (approach == 0.0 || !(away_m > 0.0)
            || pp_polygon_side(&pane->outline, pp_vec_along(point, away_m, u),
                               PP_ROUNDING_M)
                   == PP_OUTSIDE)
            continue;
        if (pane->tree >= 0) {
            share *= crown_face_share(world, &world->trees[pane->tree]);
            continue;
        }
        struct pp_opening opening = world->within->openings[pane->opening];
        opening.up = pane->up;
        opening.along = pp_vec_cross(pane->up, pane->outline.normal);
        share *= opening.glass.diffusing
                     ? 0.0
                     : pp_surface_materials_pane_from(&opening, u, fabs(approach));
    }
    return share;
}

/* Reflectance of frame and screen fabric on that side. */
static double cover_reflectance(const struct pp_world *world,
                                const struct pp_opening *opening, bool inside)
{
    const struct pp_surface *face = &world->surfaces[opening->face];
    return frame_reflectance(opening, inside ? face->front : face->back);
}

struct pp_material pp_surface_materials_glass(const struct pp_world *world,
                                              const struct pp_opening *opening,
                                              bool inside)
{
    struct pp_material material =
        pp_material_glazing(&opening->glass, open_share(opening), clean_share(opening),
                            cover_reflectance(world, opening, inside));
    name(&material, "glazing", !inside);
    return material;
}

/* The pane of an opening of that world; up: an axis of the opening. */
static struct pp_material pane_of(const struct pp_world *world,
                                  const struct pp_opening *opening, struct pp_vec3 up,
                                  bool inside)
{
    if (!opening->scatter)
        return pp_surface_materials_glass(world, opening, inside);
    struct pp_material material = pp_material_scattering(
        opening->scatter, !inside, up, open_share(opening), clean_share(opening),
        cover_reflectance(world, opening, inside));
    name(&material, "glazing", !inside);
    return material;
}

struct pp_material pp_surface_materials_pane(const struct pp_world *world, int index,
                                             bool inside)
{
    const struct pp_opening *opening = &world->openings[index];
    return pane_of(world, opening, opening->up, inside);
}

/* A face of a crown: a pane without glass. Its dirt factor is the transmittance of the
 * leaves. */
static struct pp_material crown_face(const struct pp_world *world,
                                     const struct pp_tree *tree)
{
    struct pp_glass none = pp_glass_none();
    struct pp_material material =
        pp_material_glazing(&none, 1.0, crown_face_share(world, tree), 0.0);
    name(&material, "tree", false);
    return material;
}

struct pp_material pp_surface_materials_outer_pane(const struct pp_world *world,
                                                   int index, bool inside)
{
    const struct pp_outer_pane *pane = &world->outer_panes[index];
    if (pane->tree >= 0)
        return crown_face(world, &world->trees[pane->tree]);
    return pane_of(world->within, &world->within->openings[pane->opening], pane->up,
                   inside);
}

/* Writes the number at *end and advances *end. */
static void put_material_number(double **end, double number)
{
    *(*end)++ = number + 0.0;
}

static void put_rgb(double **end, struct pp_rgb c)
{
    put_material_number(end, c.r);
    put_material_number(end, c.g);
    put_material_number(end, c.b);
}

struct pp_material_key pp_surface_materials_key(const struct pp_material *m)
{
    struct pp_material_key key = {.name = ""};
    double *end = key.numbers;
    memcpy(key.name, m->name, strlen(m->name));
    for (int i = 0; i < 3; i++) {
        put_material_number(&end, m->glass[i].panes);
        put_material_number(&end, m->glass[i].n);
        put_material_number(&end, m->glass[i].kl);
        put_material_number(&end, m->glass[i].scale);
    }
    put_rgb(&end, m->diffuse);
    put_rgb(&end, m->gloss);
    put_rgb(&end, m->through_diffuse);
    put_rgb(&end, m->through_gloss);
    put_rgb(&end, m->radiance);
    put_rgb(&end, pp_rgb(m->grain.x, m->grain.y, m->grain.z));
    put_material_number(&end, m->roughness[0]);
    put_material_number(&end, m->roughness[1]);
    put_material_number(&end, m->clear_share);
    put_material_number(&end, m->dirt);
    put_material_number(&end, m->kind);
    put_material_number(&end, m->emits);
    put_material_number(&end, m->emits_both_sides);
    put_material_number(&end, m->unseen);
    put_material_number(&end, m->pattern);
    put_material_number(&end, m->is_outside);
    put_material_number(&end, m->scatter ? (double)(m->scatter->id >> 11) : 0.0);
    return key;
}

bool pp_surface_materials_same(const struct pp_material *a, const struct pp_material *b)
{
    if (a->diffuse.r != b->diffuse.r || strcmp(a->name, b->name) != 0)
        return false; /* most cases are decided without a key */
    struct pp_material_key keys[2] = {pp_surface_materials_key(a),
                                      pp_surface_materials_key(b)};
    return memcmp(&keys[0], &keys[1], sizeof keys[0]) == 0 && a->rough == b->rough
           && a->rough_is_grey == b->rough_is_grey
           && a->surface_pattern == b->surface_pattern && a->bumps == b->bumps
           && a->pattern_mean == b->pattern_mean;
}

/* Number of previous materials that a new one is compared with. A world of a million
 * surfaces has few materials, and neighbours mostly share theirs. */
enum { LOOKED_BACK = 64 };

static enum pp_status find_material(struct pp_surface_materials *materials,
                                    const struct pp_material *material, int *index,
                                    struct pp_error *err)
{
    int last = materials->count - LOOKED_BACK;
    for (*index = materials->count - 1; *index >= 0 && *index >= last; --*index)
        if (pp_surface_materials_same(&materials->list[*index], material))
            return PP_OK;
    *index = materials->count;
    enum pp_status status = pp_array_append(&materials->list, materials->count,
                                            sizeof *materials->list, err);
    if (status == PP_OK)
        materials->list[materials->count++] = *material;
    return status;
}

static struct pp_material surface_side_material(const struct pp_world *world, int index,
                                                bool front, enum pp_surface_look look)
{
    int pane = index - world->surface_count;
    if (pane >= world->opening_count)
        return pp_surface_materials_outer_pane(world, pane - world->opening_count,
                                               front);
    if (pane >= 0)
        return pp_surface_materials_pane(world, pane, front);
    if (look == PP_LOOK_COLOURED)
        return pp_surface_materials_of(world, index, front);
    if (look == PP_LOOK_GREY && world->materials) {
        struct pp_material full = pp_surface_materials_of(world, index, front);
        if (full.rough || full.bumps)
            return pp_material_greyed(&full);
    }
    return pp_surface_materials_matt(world, index, front);
}

enum pp_status pp_surface_materials_init(struct pp_surface_materials *materials,
                                         const struct pp_world *world,
                                         enum pp_surface_look look,
                                         struct pp_error *err)
{
    int count = world->surface_count + world->opening_count + world->outer_pane_count;
    *materials = (struct pp_surface_materials){
        .sides = malloc(((size_t)count + 1) * sizeof *materials->sides)};
    enum pp_status status = materials->sides ? PP_OK : pp_fail_memory(err);
    for (int i = 0; status == PP_OK && i < 2 * count; i++) {
        struct pp_material side = surface_side_material(world, i / 2, i % 2 == 0, look);
        status = find_material(materials, &side, &materials->sides[i / 2][i % 2], err);
    }
    if (status != PP_OK)
        pp_surface_materials_clear(materials);
    return status;
}

void pp_surface_materials_clear(struct pp_surface_materials *materials)
{
    free(materials->list);
    free(materials->sides);
    *materials = (struct pp_surface_materials){.count = 0};
}
