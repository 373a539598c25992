/* rgb.h - a colour of light or a reflectance, by value: three linear channels.
 *
 * Grey is the luminance-weighted mean for Radiance's primaries [WS98]:
 *
 *     grey = 0.265 r + 0.670 g + 0.065 b
 */
#ifndef PP_MODEL_LIGHT_RGB_H
#define PP_MODEL_LIGHT_RGB_H

#include <stdbool.h>

struct pp_rgb {
    double r, g, b;
};

static inline struct pp_rgb pp_rgb(double r, double g, double b)
{
    return (struct pp_rgb){r, g, b};
}

static inline struct pp_rgb pp_rgb_grey(double value)
{
    return (struct pp_rgb){value, value, value};
}

/* Operations channel by channel. */
static inline struct pp_rgb pp_rgb_add(struct pp_rgb a, struct pp_rgb b)
{
    return pp_rgb(a.r + b.r, a.g + b.g, a.b + b.b);
}

static inline struct pp_rgb pp_rgb_sub(struct pp_rgb a, struct pp_rgb b)
{
    return pp_rgb(a.r - b.r, a.g - b.g, a.b - b.b);
}

static inline struct pp_rgb pp_rgb_times(struct pp_rgb a, struct pp_rgb b)
{
    return pp_rgb(a.r * b.r, a.g * b.g, a.b * b.b);
}

static inline struct pp_rgb pp_rgb_scale(struct pp_rgb a, double s)
{
    return pp_rgb(a.r * s, a.g * s, a.b * s);
}

/* a + s b */
static inline struct pp_rgb pp_rgb_along(struct pp_rgb a, double s, struct pp_rgb b)
{
    return pp_rgb(a.r + s * b.r, a.g + s * b.g, a.b + s * b.b);
}

/* Luminance-weighted mean; exact if all three channels are equal. */
static inline double pp_rgb_luminance(struct pp_rgb a)
{
    return a.g + 0.265 * (a.r - a.g) + 0.065 * (a.b - a.g);
}

static inline double pp_rgb_most(struct pp_rgb a)
{
    double most = a.r > a.g ? a.r : a.g;
    return most > a.b ? most : a.b;
}

static inline bool pp_rgb_is_black(struct pp_rgb a)
{
    return !(a.r > 0.0 || a.g > 0.0 || a.b > 0.0);
}

#endif
