/* atlas_design.h - the rooms of the atlas: writes room number i as a room file.
 *
 * Each property of room i is a coordinate of point i of an Owen-scrambled Sobol
 * sequence with a fixed seed (simulate/sampling/sobol.h). Coordinates are in groups of
 * up to six. The first n rooms are evenly spread over each group for any n, so the
 * atlas can be stopped or extended anywhere.
 *
 *     shape      floor area, width over depth, height; a flat ceiling, a single
 *                slope, a ridge
 *     finishes   reflectances of floor, walls and ceiling
 *     openings   one to four equal windows in one wall, or also in the next or the
 *                opposite one; clerestories, French windows; rooflights, and windows in
 *                slopes; all kinds of clear glass and none, frames, dirt, reveals
 *     outside    nothing, a skyline far off or near, a street, a light well, a court, a
 *                balcony, the facade alone, a block to one side; bare or snowy ground,
 *                at the level of the room or up to five storeys below it
 *     points     eight, spread over the working plane to 0.25 m from the walls
 *
 * Half of the rooms are ordinary, the other half unusual; atlas_ranges.h contains the
 * ranges of both. The frequencies of features are estimates of their frequencies in
 * practice, increased for rare features so that there are enough examples.
 */
#ifndef PP_STUDIES_RESEARCH_ATLAS_ATLAS_DESIGN_H
#define PP_STUDIES_RESEARCH_ATLAS_ATLAS_DESIGN_H

#include <stddef.h>
#include <stdint.h>

#include "simulate/sampling/sobol.h"

enum pp_atlas_sky {
    PP_ATLAS_OVERCAST,
    PP_ATLAS_ISO, /* a sky of ISO 15469 for each room, and a sun for it */
};

enum {
    PP_ATLAS_POINTS = 8,
    PP_ATLAS_MOST = 1 << 24, /* most rooms of a sweep */
    PP_ATLAS_XML = 8192,     /* most bytes of a room's text */
};

struct pp_atlas_design {
    enum pp_atlas_sky sky;
    struct pp_sobol sobol;
    struct pp_sobol_sequence sequence;
};

void pp_atlas_design_init(struct pp_atlas_design *design, enum pp_atlas_sky sky);

/* The room file of room `index`, from 0 to PP_ATLAS_MOST - 1. */
void pp_atlas_design_room(const struct pp_atlas_design *design, uint32_t index,
                          char xml[PP_ATLAS_XML]);

#endif
