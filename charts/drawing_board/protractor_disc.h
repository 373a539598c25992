/* protractor_disc.h - draws a protractor around its centre: the primary scale on the
 * half for sections, the auxiliary scale on the half for plans.
 *
 * From outside to inside: degree figures (outside the rim), degree marks, then the
 * marks and figures of the scale.
 */
#ifndef PP_CHARTS_DRAWING_BOARD_PROTRACTOR_DISC_H
#define PP_CHARTS_DRAWING_BOARD_PROTRACTOR_DISC_H

#include <stdbool.h>

#include "charts/sheet/style.h"
#include "model/results/protractor_sheet.h"

struct pp_protractor_disc {
    const struct pp_protractor_scale *scale;
    double x, y;    /* position of the centre on paper, mm */
    double radius;  /* radius of the rim, mm */
    double grey;    /* grey level of lines and figures: 0 black to 1 white */
    bool to_right;  /* true: the glass is on the right of the section; false: on the
                     * left */
    double plan[2]; /* unit vector on paper: direction on the plan of the outward normal
                     * of the opening */
};

/* Width of the ring of degree figures outside the rim, mm. */
double pp_protractor_disc_border(const struct pp_style *style);

/* Radius (mm) of the arc of the primary scale, which is also the radius of the
 * outermost semicircle. radius: radius of the rim (mm). */
double pp_protractor_disc_arc(const struct pp_style *style, double radius);

/* Position on paper (mm) of a point given by its distance from the centre (mm) and its
 * angle: in the section from the base line, in the plan from the normal, positive to
 * the right as seen from inside. */
void pp_protractor_disc_section(const struct pp_protractor_disc *disc, double angle_rad,
                                double distance, double xy[2]);
void pp_protractor_disc_plan(const struct pp_protractor_disc *disc, double angle_rad,
                             double distance, double xy[2]);

/* Draws the half for sections, from 0 to the end of the scale. `both`: a scale that
 * ends at the zenith is drawn to the left and to the right. */
void pp_protractor_disc_primary(cairo_t *cr, const struct pp_style *style,
                                const struct pp_protractor_disc *disc, bool both);

/* Draws the half for plans. `whole`: the half for sections is drawn as well. */
void pp_protractor_disc_auxiliary(cairo_t *cr, const struct pp_style *style,
                                  const struct pp_protractor_disc *disc, bool whole);

/* Radius (mm) of the semicircle for an average altitude. */
double pp_protractor_disc_semicircle(const struct pp_style *style,
                                     const struct pp_protractor_disc *disc,
                                     double average_rad);

#endif
