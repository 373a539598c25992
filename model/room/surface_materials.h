/* surface_materials.h - what the surfaces and panes of a world do with light. */
#ifndef PP_MODEL_ROOM_SURFACE_MATERIALS_H
#define PP_MODEL_ROOM_SURFACE_MATERIALS_H

#include <stdbool.h>

#include "model/light/material.h"
#include "model/room/world.h"

/* Of the side that the surface's normal points to, or of the other one. Named after the
 * surface: "floor", "ceiling", a wall's name, "reveal", "surface", "block"; backs of a
 * room's own skin with " (outside)" behind. What it gives off is over Eh. */
struct pp_material pp_surface_materials_of(const struct pp_world *world, int surface,
                                           bool front);

/* The same matt and grey, as hand methods and daylight factors have it. */
struct pp_material pp_surface_materials_matt(const struct pp_world *world, int surface,
                                             bool front);

/* Of an opening's pane, "glazing", from inside or outside: glass, frame, dirt,
 * curtains. */
struct pp_material pp_surface_materials_pane(const struct pp_world *world, int opening,
                                             bool inside);

/* All that a material is, name and all: keys that are the same to the byte are of
 * materials that are the same. -0 counts as 0. */
enum { PP_MATERIAL_KEY_NUMBERS = 39 };
struct pp_material_key {
    char name[PP_MATERIAL_NAME_SIZE];
    double numbers[PP_MATERIAL_KEY_NUMBERS];
};
struct pp_material_key pp_surface_materials_key(const struct pp_material *material);

/* Are they the same, name and all? */
bool pp_surface_materials_same(const struct pp_material *a,
                               const struct pp_material *b);

#endif
