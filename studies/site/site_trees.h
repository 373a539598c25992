/* site_trees.h - trees on site drawings. */
#ifndef PP_STUDIES_SITE_SITE_TREES_H
#define PP_STUDIES_SITE_SITE_TREES_H

#include "model/base/error.h"
#include "model/results/sheets/site_sheet.h"
#include "model/room/world.h"

/* Adds the trees of the world and the trees that only the former world has to the
 * sheet. before: the former world; NULL: unknown. PP_SYSTEM if memory is exhausted. */
enum pp_status pp_site_trees_add(struct pp_site_sheet *sheet,
                                 const struct pp_world *world,
                                 const struct pp_world *before, struct pp_error *err);

/* Sets the crowns of an elevation, whose extent is known: those of the present trees
 * that overlap it horizontally, and stand in front of all walls that they cover.
 * The foremost tree is first. PP_SYSTEM if memory is exhausted. */
enum pp_status pp_site_trees_in_front(struct pp_site_elevation *elevation,
                                      const struct pp_site_sheet *site,
                                      struct pp_error *err);

#endif
