/* protractor_read.h - one opening read with a BRS daylight protractor [BRE309],
 * rectangle by rectangle, for the method and for its worked chart. */
#ifndef PP_METHODS_PROTRACTOR_PROTRACTOR_READ_H
#define PP_METHODS_PROTRACTOR_PROTRACTOR_READ_H

#include "model/light/outside_light.h"
#include "model/results/formula.h"
#include "methods/protractor/protractor_dial.h"
#include "model/results/protractor_sheet.h"

/* Slope of an opening as protractors define it (rad): 0 level, pi/2 vertical, over pi/2
 * for an opening whose outer side faces down. */
double pp_protractor_read_slope(const struct pp_opening *opening);

/* Chooses the protractor for an opening; PP_BAD_INPUT if there is none. */
enum pp_status pp_protractor_read_choose(struct pp_protractor *protractor,
                                         const struct pp_sky *sky,
                                         const struct pp_opening *opening,
                                         struct pp_error *err);

/* Reads the scales for all visible rectangles of the opening. The caller clears the
 * readings; empty if the point sees nothing, and on failure. */
enum pp_status pp_protractor_read(struct pp_protractor_readings *readings,
                                  const struct pp_protractor_dial *dial,
                                  const struct pp_world *world,
                                  const struct pp_outside_light *light,
                                  const struct pp_opening *opening,
                                  struct pp_vec3 point, struct pp_error *err);

/* Calculates the components of readings, and their sums, by the published formulae. The
 * method itself evaluates these formulae on its worksheet instead, where a user may
 * have replaced a formula. */
void pp_protractor_read_work(struct pp_protractor_readings *readings);

/* Formulae for the readings of a rectangle [BRE309]. */
extern const struct pp_formula pp_protractor_read_initial; /* i, initial component */
extern const struct pp_formula pp_protractor_read_width;   /* K, correction factor */
extern const struct pp_formula
    pp_protractor_read_no_width; /* K, if the right jamb is to the left of the left
                                  * one */
extern const struct pp_formula pp_protractor_read_sc, pp_protractor_read_e,
    pp_protractor_read_erc;
extern const struct pp_formula
    pp_protractor_read_less; /* part of sc that an obstruction subtracts */

#endif
