/* surface_materials.h - the materials of a world's surfaces and panes. */
#ifndef PP_MODEL_ROOM_SURFACE_MATERIALS_H
#define PP_MODEL_ROOM_SURFACE_MATERIALS_H

#include <stdbool.h>

#include "model/light/material.h"
#include "model/room/world.h"

/* Material of the front (the side of the normal) or back of a surface. Its name is
 * "floor", "ceiling", "reveal", "surface", "block", "facade", "skyline", or the name of
 * a wall, door or dado; backs of the envelope and of reveals have " (outside)"
 * appended. Emission is relative to Eh. */
struct pp_material pp_surface_materials_of(const struct pp_world *world, int surface,
                                           bool front);

/* The look of surfaces in a scene. */
enum pp_surface_look {
    PP_LOOK_COLOURED, /* with the colour and gloss of finishes */
    PP_LOOK_GREY, /* grey and matt; physically rough surfaces and bumps scatter as they
                   * are, in grey */
    PP_LOOK_MATT  /* all grey and matt, without bumps */
};

/* Material without gloss and colour, as used for daylight factors. */
struct pp_material pp_surface_materials_matt(const struct pp_world *world, int surface,
                                             bool front);

/* Light through an opening's pane, with its frame, dirt and curtains:
 *
 *     straight(cosine) = tau(cosine) F M K         mirrored(cosine) = rho(cosine) F
 *
 *   F   share of the area that is open: frame factor (glass area over opening area)
 *       times openness of a screen; frame and fabric reflect diffusely
 *   M   maintenance factor: share of the light that passes the dirt
 *   K   share of the light that passes the curtains
 *
 * All simulations use these functions. The tracer, its cache, photons, pictures and the
 * Radiance export use a material named "glazing", seen from inside or outside.
 * Radiosity has no scene materials; it uses the straight and the mirrored share at a
 * cosine of incidence (0 to 1). Hand methods use methods/allowance.h.
 */
struct pp_material pp_surface_materials_pane(const struct pp_world *world, int opening,
                                             bool inside);
/* The same for an outer pane of the world; inside: the side towards the room's
 * windows. */
struct pp_material pp_surface_materials_outer_pane(const struct pp_world *world,
                                                   int index, bool inside);
/* Share of the light that passes the outer panes straight, against the unit direction
 * u, to a point inside; 1 if there are none in that direction. */
double pp_surface_materials_past_outer_panes(const struct pp_world *world,
                                             struct pp_vec3 point, struct pp_vec3 u);
/* Like pp_surface_materials_pane, but of the glass alone, without a blind or other
 * scattering. */
struct pp_material pp_surface_materials_glass(const struct pp_world *world,
                                              const struct pp_opening *opening,
                                              bool inside);
double pp_surface_materials_pane_straight(const struct pp_opening *opening,
                                          double cosine);
/* Transmittance of the pane and its device for light of equal radiance from all
 * directions, straight and scattered. Reflections between blind and glass are
 * neglected. */
double pp_surface_materials_pane_even(const struct pp_opening *opening);
double pp_surface_materials_pane_mirrored(const struct pp_opening *opening,
                                          double cosine);

/* Straight share of the light from the outward unit direction u. cosine: cosine of its
 * angle of incidence. Valid also for panes that scatter. */
double pp_surface_materials_pane_from(const struct pp_opening *opening,
                                      struct pp_vec3 u, double cosine);
/* The same for direct sunlight, through slats that are turned by the sun if they follow
 * it. */
double pp_surface_materials_pane_sun(const struct pp_opening *opening, struct pp_vec3 u,
                                     double cosine);

/* The fields of a material, including its name, but not its physically rough surface, its
 * pattern or its bumps.
 * Equal fields give keys that are equal byte for byte; -0 counts as 0. */
enum { PP_MATERIAL_KEY_NUMBERS = 41, PP_MATERIAL_KEY_OF_SCATTER = 2 /* last two */ };
struct pp_material_key {
    char name[PP_MATERIAL_NAME_SIZE];
    double numbers[PP_MATERIAL_KEY_NUMBERS];
};
struct pp_material_key pp_surface_materials_key(const struct pp_material *material);

/* True if the keys of the materials are equal and their rough surfaces, patterns and
 * bumps are the same. */
bool pp_surface_materials_same(const struct pp_material *a,
                               const struct pp_material *b);

/* All materials of a world, and their indices by surface. */
struct pp_surface_materials {
    struct pp_material *list;
    int count;
    int (*sides)[2]; /* indices of front and back; surfaces, openings,
                      * outer panes */
};

/* Makes the materials; equal materials usually share an entry. */
enum pp_status pp_surface_materials_init(struct pp_surface_materials *materials,
                                         const struct pp_world *world,
                                         enum pp_surface_look look,
                                         struct pp_error *err);
void pp_surface_materials_clear(struct pp_surface_materials *materials);

#endif
