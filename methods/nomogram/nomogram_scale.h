/* nomogram_scale.h - the scales of the nomograms of the internally reflected component
 * [GEEBELEN], derived from the BRE formula, and readings of them.
 *
 * Nomogram I is for the average in side-lit rooms, II for the average and the minimum,
 * III for the average in top-lit rooms; CIE overcast sky, clear single glass. Nomogram
 * IV is for a point of a side-lit room, by the formula of `irc-atlas` [ATLAS]. The
 * derivation is in nomogram_scale.c.
 *
 * Values are in the units of enum pp_nomogram_quantity: ratios, fractions, radians.
 */
#ifndef PP_METHODS_NOMOGRAM_NOMOGRAM_SCALE_H
#define PP_METHODS_NOMOGRAM_NOMOGRAM_SCALE_H

#include <stdbool.h>

#include "model/results/nomogram_sheet.h"

/* Assumption of nomograms I to III: R_cw = k R_fw. */
#define PP_NOMOGRAM_K 1.5

/* The ends of scale B. */
#define PP_NOMOGRAM_LEAST_R 0.1
#define PP_NOMOGRAM_MOST_R 0.9

/* Indices of the stems of a nomogram, which are in the order of their letters. */
enum {
    PP_STEM_A,
    PP_STEM_B,
    PP_STEM_C,
    PP_STEM_D,
    PP_STEM_E,
    PP_STEM_F,
    PP_STEM_G,
    PP_STEM_H
};

struct pp_nomogram pp_nomogram_scale_make(enum pp_nomogram_kind kind);

/* y of a value on its stem; a value outside the stem is placed at the nearer end. */
double pp_nomogram_scale_position(const struct pp_nomogram *nomogram, int stem,
                                  double value);

/* The value at y on a stem that is read: C, E or G, or F of nomogram IV. */
double pp_nomogram_scale_value(const struct pp_nomogram *nomogram, int stem, double y);

/* The y at which straight-edge `edge`, laid on y_from and y_to of its two stems,
 * crosses a stem at x. */
double pp_nomogram_scale_crossing(const struct pp_nomogram *nomogram, int edge,
                                  double y_from, double y_to, double x);

/* The ends of the curve of nomogram IV, as values of q (negative: brighter at the
 * back). */
#define PP_NOMOGRAM_LEAST_Q (-1.0)
#define PP_NOMOGRAM_MOST_Q 6.0

/* Position of q on the curve of nomogram IV. */
void pp_nomogram_scale_curve(const struct pp_nomogram *nomogram, double q, double *x,
                             double *y);

/* True if the value is on the stem, ends included. */
bool pp_nomogram_scale_contains(const struct pp_nomogram *nomogram, int stem,
                                double value);

/* Factor by which a quantity is multiplied for the numbers on its scale: 100 for per
 * cent, 180/pi for degrees, else 1. */
double pp_nomogram_scale_printed_unit(enum pp_nomogram_quantity quantity);

/* The division of a scale near `printed`, a value as numbered on the scale: the
 * smallest of 1, 2 and 5 times a power of ten whose marks are all at least least_mm
 * apart between the two nearest bold figures, on scales height_mm high. stretch: set to
 * these two bold figures. */
double pp_nomogram_scale_division(const struct pp_nomogram *nomogram, int stem,
                                  double printed, double height_mm, double least_mm,
                                  double stretch[2]);

/* The value rounded as a user sets or reads it: to a fifth of a division on a sheet of
 * A4, where the scales are PP_NOMOGRAM_A4_MM high and divisions at least
 * PP_NOMOGRAM_LEAST_MM. */
double pp_nomogram_scale_read(const struct pp_nomogram *nomogram, int stem,
                              double value);

#define PP_NOMOGRAM_A4_MM 200.0
#define PP_NOMOGRAM_LEAST_MM 0.9

#endif
