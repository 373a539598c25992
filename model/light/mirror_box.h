/* mirror_box.h - luminance of a mirror-box artificial sky, and its deviation from the
 * CIE overcast sky.
 *
 * A luminous ceiling over a square of vertical mirrors, H high and W wide, is reflected
 * infinitely often; each reflection has a factor rho. A line of sight at altitude a
 * travels H cot(a) horizontally before it reaches the ceiling. Across one pair of
 * mirrors, at azimuth psi from their normal, this is x = (H/W) cot(a) |cos psi| widths,
 * hence m or m + 1 reflections for m <= x < m + 1. The average over all positions in
 * the model is
 *
 *     g(x) = rho^m (1 - (x - m) (1 - rho))                              (1)
 *
 *     L(a) = L0 mean over psi of g(k cot a |cos psi|) g(k cot a |sin psi|), k = H/W (2)
 *
 * for a ceiling of luminance L0 in all directions. Light reflected back by floor and
 * model is neglected. L/L0 depends only on rho and k. It rises from 0 at the horizon to
 * L0 at the zenith; the overcast sky rises from a third.
 */
#ifndef PP_MODEL_LIGHT_MIRROR_BOX_H
#define PP_MODEL_LIGHT_MIRROR_BOX_H

struct pp_mirror_box {
    double rho;    /* reflectance of the mirrors, 0 to 1 */
    double height; /* height divided by width of the mirrors: k, 0 or more */
};

/* L(a)/L0 from (2); altitude 0 to pi/2. */
double pp_mirror_box_luminance(const struct pp_mirror_box *box, double altitude_rad);

/* Illuminance of a horizontal plane divided by L0: pi for perfect mirrors. */
double pp_mirror_box_horizontal(const struct pp_mirror_box *box);

/* Correction factor of a sky component measured in the box, for an opening that shows
 * the sky at that altitude: luminance of the overcast sky divided by the luminance of
 * the box, each relative to its own horizontal illuminance. INFINITY where the box is
 * dark. */
double pp_mirror_box_correction(const struct pp_mirror_box *box, double altitude_rad);

#endif
