/* side_lit_box.h - dimensions of a box-shaped room with windows in one wall. */
#ifndef PP_STUDIES_SIDE_LIT_BOX_H
#define PP_STUDIES_SIDE_LIT_BOX_H

#include "model/room/world.h"

struct pp_side_lit_box {
    struct pp_vec3 into; /* unit normal of the window wall, pointing into the room */
    double front;        /* coordinate of the window wall in the direction `into`, m */
    double depth_m;      /* from the window wall to the wall opposite */
    double width_m;      /* along the window wall */
    double floor_z;
    double head_z; /* z of the head of the highest window */
};

/* Finds the dimensions. Returns false, with the reason in *why, if the room is not a
 * box with windows in one wall. A box has one horizontal floor, one horizontal ceiling
 * and four other faces, all at right angles within 1e-3. */
bool pp_side_lit_box_of(struct pp_side_lit_box *box, const struct pp_world *world,
                        const char **why);

#endif
