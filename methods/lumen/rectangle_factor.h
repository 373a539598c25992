/* rectangle_factor.h - form factors between rectangles with edges along the axes, in
 * closed form [HSM16].
 */
#ifndef PP_METHODS_LUMEN_RECTANGLE_FACTOR_H
#define PP_METHODS_LUMEN_RECTANGLE_FACTOR_H

/* Rectangle in a plane normal to `axis` (0, 1, 2 for x, y, z). low[axis] equals
 * high[axis]; along the other two axes it extends from low to high (m). */
struct pp_aligned_rectangle {
    int axis;
    double low[3], high[3];
};

/* Area (m2). */
double pp_rectangle_factor_area(const struct pp_aligned_rectangle *rectangle);

/* Exchange area A F (m2): the area of a times the form factor from a to b, or the
 * reverse; 0 within one plane. Each rectangle must lie entirely in front of the other;
 * this is not checked. With G the integral of the kernel over both rectangles' edges
 * [HSM16]:
 *
 *     A F = sum over the four corners of each, (-1)^(i + j + k + l) G
 *     parallel, z apart, u and v between the corners:
 *       G = 1/(2 pi) [ v sqrt(u^2 + z^2) atan(v / sqrt(u^2 + z^2))
 *                    + u sqrt(v^2 + z^2) atan(u / sqrt(v^2 + z^2))
 *                    - z^2/2 ln(u^2 + v^2 + z^2) ]
 *     perpendicular, x and s from the line where the planes meet, t along that line:
 *       G = 1/(2 pi) [ t sqrt(x^2 + s^2) atan(t / sqrt(x^2 + s^2))
 *                    - (x^2 + s^2 - t^2)/4 ln(x^2 + s^2 + t^2) ]
 *
 * Errors are 1e-15 times the square of the largest distance between the rectangles.
 */
double pp_rectangle_factor_exchange_area(const struct pp_aligned_rectangle *a,
                                         const struct pp_aligned_rectangle *b);

#endif
