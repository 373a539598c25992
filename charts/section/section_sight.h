/* section_sight.h - the line of sight from a window to its obstruction, in a section.
 * The line is used only for drawings. The obstruction angle for calculations is in
 * methods/reflected/obstruction.h. */
#ifndef PP_CHARTS_SECTION_SECTION_SIGHT_H
#define PP_CHARTS_SECTION_SECTION_SIGHT_H

#include "charts/section/section_cut.h"

/* Line of sight from the middle of the window, in the plane of the section. */
struct pp_section_sight {
    double angle_rad;    /* angle above the horizontal; 0: no obstruction */
    double overhang_rad; /* angle of an overhang, the upper limit of the visible sky;
                          * pi/2: none */
    double s, z;         /* position of the middle of the window */
    double distance_m;
    int of; /* index of the surface at the head of the obstruction; -1: none */
    bool skyline;
};

/* Finds the line of sight from the window at the near or far end to the head of a cut
 * obstruction or skyline. angle_rad is the lower limit, and overhang_rad the upper
 * limit, of the highest range of angles in which sky is visible. If no sky is visible,
 * the line is the steepest to any obstruction. */
struct pp_section_sight pp_section_sight_of(const struct pp_section_cut *section,
                                            const struct pp_world *world, bool near);

#endif
