/* room_section.h - vertical section of the room, drawn to scale: floor, walls,
 * openings, working plane with its receivers, obstructions outside. */
#ifndef PP_CHARTS_SECTION_ROOM_SECTION_H
#define PP_CHARTS_SECTION_ROOM_SECTION_H

#include "charts/section/section_cut.h"
#include "charts/sheet/style.h"
#include "model/results/report.h"

struct pp_room_section {
    const struct pp_world *world;
    const struct pp_section_cut *cut;
    const struct pp_report *report; /* report whose receivers are marked */
    double least_scale;             /* scale is 1 to this or smaller; 0: any */
    bool named;                     /* with names and dimensions (section_words.h) */
    bool no_sights;                 /* leave out the obstructions' angles */
    bool no_angles;                 /* obstructions without lines of sight: their angles
                                     * are to be found */
    bool no_caption;                /* leave out the caption, which is at least 90 mm
                                     * wide */

    /* Scale, set by pp_room_section_fit. */
    double mm_per_m;  /* a usual scale: 1:20, 1:25, 1:50, 1:75 ... */
    double height_mm; /* height of the drawing with its caption */

    /* Set by the caller: x of the near wall's inside face, y of the top, and widths for
     * obstructions outside the near and the far wall. */
    double x, y, left_mm, right_mm;
    double head_mm; /* height for obstructions above the room */
    double most_x;  /* right end of the caption; 0: unlimited */
};

/* True if the window at the near or far end is obstructed. */
bool pp_room_section_has_outside(const struct pp_room_section *section, bool near);

/* Sets the largest round scale at which the room fits into that length and height. */
void pp_room_section_fit(struct pp_room_section *section, const struct pp_style *style,
                         double length_mm, double height_mm);

/* Lowest and highest point of the cut faces. */
void pp_room_section_heights(const struct pp_section_cut *cut, double *low,
                             double *high);

/* True if the section passes through the opening. */
bool pp_room_section_is_cut(const struct pp_section_cut *cut, int opening);

/* Position on paper of a place in the section; valid after pp_room_section_fit. */
double pp_room_section_x(const struct pp_room_section *section, double s);
double pp_room_section_y(const struct pp_room_section *section, double z);

/* Height above the room of the glass that is cut, such as that of rooflights over
 * wells, mm; valid after pp_room_section_fit. */
double pp_room_section_above_mm(const struct pp_room_section *section);

void pp_room_section_draw(cairo_t *cr, const struct pp_style *style,
                          const struct pp_room_section *section);

#endif
