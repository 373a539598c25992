/* world_material.h - what the surfaces and panes of a world do with light. */
#ifndef PP_MODEL_WORLD_MATERIAL_H
#define PP_MODEL_WORLD_MATERIAL_H

#include <stdbool.h>

#include "model/material.h"
#include "model/world.h"

/* Of the side that the surface's normal points to, or of the other one. Named after the
 * surface: "floor", "ceiling", a wall's name, "reveal", "surface", "block"; backs of a
 * room's own skin with " (outside)" behind. What it gives off is over Eh. */
struct pp_material pp_world_surface_material(const struct pp_world *world, int surface,
                                             bool front);

/* The same matt and grey, as hand methods and daylight factors have it. */
struct pp_material pp_world_matt_material(const struct pp_world *world, int surface,
                                          bool front);

/* Of an opening's pane, "glazing", from inside or outside: glass, frame, dirt,
 * curtains. */
struct pp_material pp_world_pane_material(const struct pp_world *world, int opening,
                                          bool inside);

/* Are they the same, name and all? */
bool pp_material_same(const struct pp_material *a, const struct pp_material *b);

#endif
