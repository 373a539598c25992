/* section_frame.h - the extent of a section, and the positions of points on paper. */
#ifndef PP_CHARTS_SECTION_SECTION_FRAME_H
#define PP_CHARTS_SECTION_SECTION_FRAME_H

#include "charts/section/section_cut.h"
#include "charts/sheet/style.h"
#include "model/results/report.h"

struct pp_room_section {
    const struct pp_world *world;
    const struct pp_section_cut *cut;
    const struct pp_report *report; /* report whose receivers are marked */
    double least_scale;             /* largest permitted scale, as a denominator; 0: no
                                     * limit */
    bool named;                     /* draw names and dimensions (section_words.h) */
    bool no_sights;                 /* do not draw lines of sight and obstruction
                                     * angles */
    bool no_angles;                 /* draw obstructions without lines of sight, for
                                     * exercises in which the angles are to be found */
    bool no_caption;                /* omit the caption, which is at least 90 mm wide */

    /* Scale, set by pp_room_section_fit. */
    double mm_per_m;  /* usual scales are 1:20, 1:25, 1:50, 1:75 ... */
    double height_mm; /* height of the drawing with its caption */

    /* Set by the caller, mm: x of the inside face of the near wall, y of the upper
     * edge, and widths for obstructions outside the near and the far wall. */
    double x, y, left_mm, right_mm;
    double head_mm; /* height reserved for obstructions above the room */
    double most_x;  /* right end of the caption; 0: unlimited */
};

/* Lowest and highest point of the cut faces. */
void pp_section_frame_heights(const struct pp_section_cut *cut, double *low,
                              double *high);

/* True if the section cuts the opening. */
bool pp_section_frame_is_cut(const struct pp_section_cut *cut, int opening);

/* Height (mm) by which cut glass extends above the room, such as rooflights over wells.
 * Valid after pp_room_section_fit. */
double pp_section_frame_above_mm(const struct pp_room_section *section);

/* Position on paper (mm) of a point in the section. Valid after pp_room_section_fit. */
double pp_section_frame_x(const struct pp_room_section *section, double s);
double pp_section_frame_y(const struct pp_room_section *section, double z);

#endif
