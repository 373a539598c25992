/* section_cut.h - the line on which the receivers lie, and the vertical section of the
 * room along that line.
 *
 * Coordinates in the section: s, metres along the line from the inside face of the wall
 * at the near end, and z, height (m).
 */
#ifndef PP_CHARTS_SECTION_SECTION_CUT_H
#define PP_CHARTS_SECTION_SECTION_CUT_H

#include "model/room/world.h"

enum pp_cut_kind {
    PP_CUT_FACE,    /* a face of the envelope, less its openings */
    PP_CUT_OPENING, /* an opening, in the plane of its face */
    PP_CUT_GLASS,   /* glass at the outer end of a reveal */
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
    double origin[2], along[2]; /* x and y of the point s = 0; unit vector of increasing
                                 * s */
    double height_m;            /* height of the receivers */
    struct pp_cut *list;
    int count;
    double length_m;              /* length of the room along the line: s of the far
                                   * wall */
    int near_face, far_face;      /* indices of the walls at s = 0 and s = length_m; -1:
                                   * none */
    bool near_window, far_window; /* true if the end walls have an opening */
};

/* Cuts the world along its receivers, which must be on one straight horizontal line.
 * With a single receiver the section is perpendicular to the nearest opening.
 * PP_BAD_INPUT if there are no receivers or they are not on one line; *cut then need
 * not be cleared. */
enum pp_status pp_section_cut_init(struct pp_section_cut *cut,
                                   const struct pp_world *world,
                                   const struct pp_receiver *receivers, int count,
                                   struct pp_error *err);
void pp_section_cut_clear(struct pp_section_cut *cut);

/* Coordinate s of a point, m. */
double pp_section_cut_s(const struct pp_section_cut *cut, struct pp_vec3 point);

#endif
