/* section_cut.h - the line on which receivers lie, and the vertical section of the room
 * along it.
 *
 * Coordinates of a place in the section: s, metres along the line from the inside face
 * of the wall from which distances are counted, and z, height.
 */
#ifndef PP_CHARTS_SECTION_SECTION_CUT_H
#define PP_CHARTS_SECTION_SECTION_CUT_H

#include "model/room/world.h"

enum pp_cut_kind {
    PP_CUT_FACE,    /* a face of the envelope, without openings */
    PP_CUT_OPENING, /* in the face's plane */
    PP_CUT_GLASS,   /* at the reveal's outer end */
    PP_CUT_COVER,   /* a door or a dado in front of a face */
    PP_CUT_INSIDE,  /* a free-standing surface in the room */
    PP_CUT_OUTSIDE, /* a block, a facade or a free-standing surface outside */
};

struct pp_cut {
    enum pp_cut_kind kind;
    int of; /* index of the surface or opening */
    double s[2], z[2];
};

struct pp_section_cut {
    double origin[2], along[2]; /* x, y of s = 0, and the unit direction of s */
    double height_m;            /* height of the receivers */
    struct pp_cut *list;
    int count;
    double length_m;              /* length of the room along the line: s of the far
                                   * wall */
    int near_face, far_face;      /* walls at s = 0 and length_m; -1: none */
    bool near_window, far_window; /* true if the end walls have an opening */
};

/* Cuts the world along its receivers, which must be on one horizontal straight line;
 * with a single receiver the cut is perpendicular to the nearest opening. PP_BAD_INPUT
 * if the receivers are not on one line or there are none; the cut then needs no
 * clearing. */
enum pp_status pp_section_cut_init(struct pp_section_cut *cut,
                                   const struct pp_world *world,
                                   const struct pp_receiver *receivers, int count,
                                   struct pp_error *err);
void pp_section_cut_clear(struct pp_section_cut *cut);

/* s of a point. */
double pp_section_cut_s(const struct pp_section_cut *cut, struct pp_vec3 point);

#endif
