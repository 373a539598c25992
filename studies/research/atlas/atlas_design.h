/* atlas_design.h - the rooms of the atlas: room i of a designed sweep, as a room file.
 *
 * Each of a room's numbers is a coordinate of point i of an Owen-scrambled Sobol sequence
 * of fixed seed (simulate/sampling/sobol.h), in groups of up to six: every prefix of the
 * sweep is spread evenly over each group, so that it can be stopped or extended anywhere.
 *
 *     shape      area, width over depth, height; a flat ceiling, a single slope, a ridge
 *     finishes   of floor, walls, ceiling
 *     openings   one to four equal windows in one wall, or also in the next or the
 *                opposite one; clerestories, French windows; rooflights, and windows in
 *                slopes; all kinds of clear glass and none, frames, dirt, reveals
 *     outside    nothing, a skyline far off or near, a street, a light well, a court, a
 *                balcony, the facade alone, a block to one side; the ground, snow on it;
 *                up to five storeys above it
 *     points     eight, spread over the working plane to 0.25 m from the walls
 *
 * One half of the rooms are ordinary, the other half unusual: atlas_ranges.h has the ranges
 * of both.
 *
 * Frequencies are a designer's guess of what is met, with enough of what is rare.
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
    PP_ATLAS_MOST = 1 << 24, /* rooms of a sweep */
    PP_ATLAS_XML = 8192,     /* bytes that a room's text needs at most */
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
