/* section_sight.h - the line of sight from a window to its obstruction, in a section.
 * It is only drawn: the obstruction angle of the methods is in
 * methods/reflected/obstruction.h. */
#ifndef PP_CHARTS_SECTION_SECTION_SIGHT_H
#define PP_CHARTS_SECTION_SECTION_SIGHT_H

#include "charts/section/section_cut.h"

/* Line of sight from the middle of the window, in the plane of the section. */
struct pp_section_sight {
    double angle_rad;    /* above the horizontal; 0: nothing obstructs */
    double overhang_rad; /* upper end of the visible sky, at an overhang; pi/2: none */
    double s, z;         /* the window's middle */
    double distance_m;
    int of; /* the surface at the head; -1: none */
    bool skyline;
};

/* The line of sight out of the window at the near or far end, to the head of a cut
 * obstruction or a skyline: the lower end of the highest part of the section in which
 * sky is visible. The part hidden by an overhang is above overhang_rad. If no sky is
 * visible, the line is the steepest to any visible obstruction. */
struct pp_section_sight pp_section_sight_of(const struct pp_section_cut *section,
                                            const struct pp_world *world, bool near);

#endif
