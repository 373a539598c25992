/* nomogram_position.h - the reading of one opening on nomogram IV: the internally
 * reflected component at a point, by the formula of `irc-atlas` [ATLAS]. */
#ifndef PP_METHODS_NOMOGRAM_NOMOGRAM_POSITION_H
#define PP_METHODS_NOMOGRAM_NOMOGRAM_POSITION_H

#include "model/light/outside_light.h"
#include "model/results/nomogram_sheet.h"
#include "model/room/world.h"

/* Formulae evaluated before D and the curve are read; the list ends with NULL. */
extern const struct pp_formula *const pp_nomogram_position_formulae[];

/* Lays the straight-edge for an opening on A and B, and on C and D; then on H and the
 * curve, to read the factors for the depth and the sideways position of the receiver;
 * and finally, with the product of these factors, on E and F. Each value is rounded as
 * a user sets or reads it. tools: those of pp_method_irc_atlas for that world and
 * light. *why names a value that is off its scale, as the end of a sentence that begins
 * with "window W1"; NULL if all values are on their scales. */
enum pp_status pp_nomogram_position_read(
    struct pp_nomogram_reading *reading, const char **why,
    const struct pp_nomogram *nomogram, const struct pp_world *world,
    const struct pp_outside_light *light, const struct pp_opening *opening,
    const struct pp_receiver *receiver, const void *tools, struct pp_error *err);

/* Division of the curve at q on sheets height_mm high and width_mm wide: the smallest
 * of 0.1, 0.2, 0.5 and 1 whose marks are at least least_mm apart, between the whole
 * numbers below and above q. */
double pp_nomogram_position_division(const struct pp_nomogram *nomogram, double q,
                                     double width_mm, double height_mm,
                                     double least_mm);

#endif
