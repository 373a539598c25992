/* protractor_disc.h - a protractor about its centre: the primary scale on the half that
 * is laid on sections, the auxiliary on the half that is laid on plans.
 *
 * Rings from the rim inwards: figures of degrees (outside the rim), degree marks, then
 * the scale's own marks and figures.
 */
#ifndef PP_CHARTS_DRAWING_BOARD_PROTRACTOR_DISC_H
#define PP_CHARTS_DRAWING_BOARD_PROTRACTOR_DISC_H

#include <stdbool.h>

#include "charts/sheet/style.h"
#include "model/results/protractor_sheet.h"

struct pp_protractor_disc {
    const struct pp_protractor_scale *scale;
    double x, y;    /* the centre; mm on paper */
    double radius;  /* radius of the rim, mm */
    double grey;    /* grey level of lines and figures: 0 black to 1 white */
    bool to_right;  /* true: the glass is on the right of the section; false: on the
                     * left */
    double plan[2]; /* direction of the normal on the plan, out of the room; unit vector
                     * on paper */
};

/* Width of the figures outside the rim, mm. */
double pp_protractor_disc_border(const struct pp_style *style);

/* Radius of the primary scale's arc and of the outermost semicircle, which is the same;
 * radius: that of the rim. In mm. */
double pp_protractor_disc_arc(const struct pp_style *style, double radius);

/* Position on paper of a point at this distance from the centre, at this angle of the
 * section or of the plan. */
void pp_protractor_disc_section(const struct pp_protractor_disc *disc, double angle_rad,
                                double distance, double xy[2]);
void pp_protractor_disc_plan(const struct pp_protractor_disc *disc, double angle_rad,
                             double distance, double xy[2]);

/* Draws the section's half, from 0 to the scale's end; `both`: a scale that ends at the
 * zenith is drawn to the left and to the right. */
void pp_protractor_disc_primary(cairo_t *cr, const struct pp_style *style,
                                const struct pp_protractor_disc *disc, bool both);

/* Draws the plan's half; `whole`: the section's half is drawn too. */
void pp_protractor_disc_auxiliary(cairo_t *cr, const struct pp_style *style,
                                  const struct pp_protractor_disc *disc, bool whole);

/* Radius of the semicircle of an average altitude. */
double pp_protractor_disc_semicircle(const struct pp_style *style,
                                     const struct pp_protractor_disc *disc,
                                     double average_rad);

#endif
