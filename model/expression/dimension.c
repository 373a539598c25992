/* dimension.c - compares and multiplies powers of metre, degree and per cent. */
#include "model/expression/dimension.h"

#include <math.h>

#include "model/base/text.h"

static bool same(double a, double b)
{
    return fabs(a - b) < 1e-9;
}

bool pp_dimension_alike(struct pp_dimension a, struct pp_dimension b)
{
    return same(a.metres, b.metres)
           && (a.number || b.number
               || (same(a.degrees, b.degrees) && same(a.per_cent, b.per_cent)));
}

bool pp_dimension_is_ratio(struct pp_dimension d)
{
    return same(d.metres, 0.0)
           && (d.number || (same(d.degrees, 0.0) && same(d.per_cent, 0.0)));
}

bool pp_dimension_is_angle(struct pp_dimension d)
{
    return same(d.metres, 0.0)
           && (d.number || (same(d.degrees, 1.0) && same(d.per_cent, 0.0)));
}

struct pp_dimension pp_dimension_times(struct pp_dimension a, struct pp_dimension b,
                                       double power)
{
    return (struct pp_dimension){a.metres + power * b.metres,
                                 a.degrees + power * b.degrees,
                                 a.per_cent + power * b.per_cent, a.number || b.number};
}

struct pp_dimension pp_dimension_raised(struct pp_dimension d, double power)
{
    return (struct pp_dimension){power * d.metres, power * d.degrees,
                                 power * d.per_cent, d.number};
}

void pp_dimension_describe(char text[96], struct pp_dimension d)
{
    text[0] = '\0';
    if (same(d.metres, 1.0))
        pp_text_append(text, 96, "a length (m)");
    else if (same(d.metres, 2.0))
        pp_text_append(text, 96, "an area (m2)");
    else if (!same(d.metres, 0.0))
        pp_text_append(text, 96, "m^%g", d.metres);
    if (!d.number && !same(d.degrees, 0.0))
        pp_text_append(text, 96, "%san angle%s", text[0] ? " times " : "",
                       same(d.degrees, 1.0) ? " (degrees)" : " to a power");
    if (!d.number && !same(d.per_cent, 0.0))
        pp_text_append(text, 96, "%sa percentage of the sky's light%s",
                       text[0] ? " times " : "",
                       same(d.per_cent, 1.0) ? "" : " to a power");
    if (!text[0])
        pp_text_append(text, 96, d.number ? "a number" : "a ratio");
}
