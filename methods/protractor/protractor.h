/* protractor.h - what the protractor's readings of one opening are: for the method and
 * for its worked chart. */
#ifndef PP_METHODS_PROTRACTOR_PROTRACTOR_H
#define PP_METHODS_PROTRACTOR_PROTRACTOR_H

#include "methods/protractor/protractor_dial.h"
#include "model/results/protractor_sheet.h"

/* The slope as protractors have it: 0 level and pi/2 upright; over pi/2 for an opening
 * that leans out over who looks through it from inside. */
double pp_protractor_read_slope(const struct pp_opening *opening);

/* Which protractor an opening is read with; PP_BAD_INPUT where there is none. */
enum pp_status pp_protractor_read_choose(struct pp_protractor *protractor,
                                         const struct pp_sky *sky,
                                         const struct pp_opening *opening,
                                         struct pp_error *err);

/* Reads all that the point sees of the opening; none where it sees nothing. To be
 * cleared by the caller; empty on failure. */
enum pp_status pp_protractor_read(struct pp_protractor_readings *readings,
                                  const struct pp_protractor_dial *dial,
                                  const struct pp_world *world,
                                  const struct pp_opening *opening,
                                  struct pp_vec3 point, struct pp_error *err);

#endif
