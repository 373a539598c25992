/* world_material.c - see world_material.h. */
#include "model/world_material.h"

#include <stdio.h>
#include <string.h>

static const char *name_of(const struct pp_surface *surface)
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
    case PP_LOOSE:
        return "surface";
    case PP_BLOCK:
        return "block";
    }
    return "surface";
}

static void name(struct pp_material *material, const char *of, bool outside)
{
    snprintf(material->name, sizeof material->name, "%s%s", of,
             outside ? " (outside)" : "");
}

struct pp_material pp_world_surface_material(const struct pp_world *world, int index,
                                             bool front)
{
    const struct pp_surface *surface = &world->surfaces[index];
    double reflectance = front ? surface->front : surface->back;
    struct pp_material material = pp_material_diffuse(pp_rgb_grey(reflectance));
    if (surface->finish && (front || !surface->inside || surface->role == PP_LOOSE))
        material = pp_material_finish(surface->finish, reflectance);
    if (surface->exitance > 0.0) {
        material.emits = PP_EMITS_EXTENDED;
        material.radiance = pp_rgb_grey(surface->exitance / PP_PI);
    }
    bool skin = index < world->face_count || surface->role == PP_REVEAL;
    name(&material, name_of(surface), !front && skin);
    return material;
}

struct pp_material pp_world_matt_material(const struct pp_world *world, int index,
                                          bool front)
{
    const struct pp_surface *surface = &world->surfaces[index];
    struct pp_material material = pp_world_surface_material(world, index, front);
    material.diffuse = pp_rgb_grey(front ? surface->front : surface->back);
    material.gloss = pp_rgb_grey(0.0);
    material.roughness[0] = material.roughness[1] = 0.0;
    material.grain = pp_vec(0.0, 0.0, 0.0);
    return material;
}

struct pp_material pp_world_pane_material(const struct pp_world *world, int index,
                                          bool inside)
{
    const struct pp_opening *opening = &world->openings[index];
    const struct pp_surface *face = &world->surfaces[opening->face];
    struct pp_material material = pp_material_glazing(
        &opening->glass, opening->frame_factor,
        opening->maintenance * opening->curtains, inside ? face->front : face->back);
    name(&material, "glazing", !inside);
    return material;
}

static bool same_rgb(struct pp_rgb a, struct pp_rgb b)
{
    return a.r == b.r && a.g == b.g && a.b == b.b;
}

static bool same_glass(const struct pp_glass *a, const struct pp_glass *b)
{
    return a->panes == b->panes && a->n == b->n && a->kl == b->kl
           && a->scale == b->scale;
}

bool pp_material_same(const struct pp_material *a, const struct pp_material *b)
{
    bool glass = true;
    for (int i = 0; i < 3; i++)
        glass = glass && same_glass(&a->glass[i], &b->glass[i]);
    return glass && a->kind == b->kind && strcmp(a->name, b->name) == 0
           && same_rgb(a->diffuse, b->diffuse) && same_rgb(a->gloss, b->gloss)
           && same_rgb(a->through_diffuse, b->through_diffuse)
           && same_rgb(a->through_gloss, b->through_gloss)
           && same_rgb(a->radiance, b->radiance) && a->roughness[0] == b->roughness[0]
           && a->roughness[1] == b->roughness[1] && a->grain.x == b->grain.x
           && a->grain.y == b->grain.y && a->grain.z == b->grain.z
           && a->clear_share == b->clear_share && a->dirt == b->dirt
           && a->emits == b->emits && a->emits_both_sides == b->emits_both_sides
           && a->unseen == b->unseen && a->pattern == b->pattern;
}
