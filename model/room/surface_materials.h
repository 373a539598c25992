/* surface_materials.h - the materials of a world's surfaces and panes. */
#ifndef PP_MODEL_ROOM_SURFACE_MATERIALS_H
#define PP_MODEL_ROOM_SURFACE_MATERIALS_H

#include <stdbool.h>

#include "model/light/material.h"
#include "model/room/world.h"

/* The material of the side that the surface's normal points to, or of the other one. It
 * is named after the surface: "floor", "ceiling", a wall's name, "reveal", "surface",
 * "block", "facade"; backs of the envelope and of reveals have " (outside)" behind. Its emission
 * is over Eh. */
struct pp_material pp_surface_materials_of(const struct pp_world *world, int surface,
                                           bool front);

/* Material of a surface without gloss and colour, as used by hand methods and daylight
 * factors. */
struct pp_material pp_surface_materials_matt(const struct pp_world *world, int surface,
                                             bool front);

/* Light through an opening's pane, with its frame, dirt and curtains:
 *
 *     straight(cosine) = tau(cosine) F M K         mirrored(cosine) = rho(cosine) F
 *
 *   F   share of the opening's area that is glass
 *   M   maintenance: the share of the light that dirt leaves
 *   K   the share that curtains leave
 *
 * All simulations use these functions. The tracer, its cache, photons, pictures and the
 * Radiance export use a material, seen from inside or outside and named "glazing".
 * Radiosity, which has no scene materials, uses the two shares of the light at a cosine
 * of incidence. Hand methods use methods/allowance.h. */
struct pp_material pp_surface_materials_pane(const struct pp_world *world, int opening,
                                             bool inside);
double pp_surface_materials_pane_straight(const struct pp_opening *opening,
                                          double cosine);
double pp_surface_materials_pane_mirrored(const struct pp_opening *opening,
                                          double cosine);

/* All fields of a material, its name included: materials are the same where their keys
 * are the same to the byte. -0 counts as 0. */
enum { PP_MATERIAL_KEY_NUMBERS = 39 };
struct pp_material_key {
    char name[PP_MATERIAL_NAME_SIZE];
    double numbers[PP_MATERIAL_KEY_NUMBERS];
};
struct pp_material_key pp_surface_materials_key(const struct pp_material *material);

/* True if they are the same, name included. */
bool pp_surface_materials_same(const struct pp_material *a,
                               const struct pp_material *b);

/* All materials of a world, and the index of each surface's. */
struct pp_surface_materials {
    struct pp_material *list;
    int count;
    int (*sides)[2]; /* front and back, by surface, then by opening's pane */
};

/* Makes the materials; equal ones are as a rule one entry. With `matt` those of
 * surfaces are without gloss and grey. */
enum pp_status pp_surface_materials_init(struct pp_surface_materials *materials,
                                         const struct pp_world *world, bool matt,
                                         struct pp_error *err);
void pp_surface_materials_clear(struct pp_surface_materials *materials);

#endif
