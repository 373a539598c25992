/* dimension.h - the dimension of a quantity: length, area, angle, per cent of the sky's
 * light (daylight factor), or ratio.
 *
 * A plain number may be added to degrees or per cent, but not to metres: 1 - alpha / 90
 * is valid, A + 3 with an area A is not.
 */
#ifndef PP_MODEL_EXPRESSION_DIMENSION_H
#define PP_MODEL_EXPRESSION_DIMENSION_H

#include <stdbool.h>

/* Powers of metre, degree and per cent (of daylight factors). */
struct pp_dimension {
    double metres, degrees, per_cent;
    bool number; /* plain number: may stand for degrees or per cent */
};

/* True if the two may be added. */
bool pp_dimension_alike(struct pp_dimension a, struct pp_dimension b);

/* True if a quantity of this dimension can be a ratio, such as a reflectance; or can be
 * an angle. */
bool pp_dimension_is_ratio(struct pp_dimension d);
bool pp_dimension_is_angle(struct pp_dimension d);

/* a times b to the power `power`; d to the power `power`. */
struct pp_dimension pp_dimension_times(struct pp_dimension a, struct pp_dimension b,
                                       double power);
struct pp_dimension pp_dimension_raised(struct pp_dimension d, double power);

/* Describes a dimension: "an area (m2)", "m^3", "an angle (degrees)". */
void pp_dimension_describe(char text[96], struct pp_dimension d);

#endif
