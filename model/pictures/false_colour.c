/* false_colour.c - see false_colour.h. */
#include "model/pictures/false_colour.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model/geometry/vec.h"

/* Share of pixels at each end that the scale leaves out; chosen, not measured. */
static const double left_out = 0.005;

enum { DECADES_MOST = 4 };

/* ---- round numbers ---- */

static const double rounds[] = {1.0, 2.0, 5.0};

/* Number `index` of ..., 0.1, 0.2, 0.5, 1 (index 0), 2, 5, 10, ... */
static double round_number(int index)
{
    int decade = (int)floor(index / 3.0);
    double ten = pow(10.0, abs(decade));
    double mantissa = rounds[index - 3 * decade];
    return decade < 0 ? mantissa / ten : mantissa * ten;
}

/* Index of the largest round number that does not exceed the value, up to rounding. */
static int round_below(double value)
{
    int index = 3 * (int)floor(log10(value));
    while (round_number(index) > value * (1.0 + 1e-9))
        index--;
    while (round_number(index + 1) <= value * (1.0 + 1e-9))
        index++;
    return index;
}

static int round_above(double value)
{
    int index = round_below(value);
    return round_number(index) < value * (1.0 - 1e-9) ? index + 1 : index;
}

/* ---- the scale ---- */

static int ascending(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static void settle_colour_scale(struct pp_false_colour_scale *scale, double low,
                                double high, bool logarithmic)
{
    int top = round_above(high), bottom = round_below(low);
    if (bottom < top - 3 * DECADES_MOST)
        bottom = top - 3 * DECADES_MOST;
    if (bottom == top)
        bottom--;
    *scale = (struct pp_false_colour_scale){logarithmic ? round_number(bottom) : 0.0,
                                            round_number(top), logarithmic};
}

enum pp_status pp_false_colour_scale_fit(struct pp_false_colour_scale *scale,
                                         const struct pp_picture *picture, double unit,
                                         bool logarithmic, struct pp_error *err)
{
    size_t pixels = (size_t)picture->width * (size_t)picture->height, count = 0;
    double *values = malloc(pixels * sizeof *values);
    if (!values)
        return pp_fail_memory(err);
    for (int y = 0; y < picture->height; y++)
        for (int x = 0; x < picture->width; x++) {
            double value = unit * pp_rgb_luminance(pp_picture_rgb(picture, x, y));
            if (value > 1e-30 && value < 1e30)
                values[count++] = value;
        }
    *scale = (struct pp_false_colour_scale){0.1, 1.0, logarithmic};
    if (count > 0) {
        qsort(values, count, sizeof *values, ascending);
        size_t out = (size_t)(left_out * (double)count);
        settle_colour_scale(scale, values[out], values[count - 1 - out], logarithmic);
    }
    free(values);
    return PP_OK;
}

int pp_false_colour_scale_levels(const struct pp_false_colour_scale *scale,
                                 double levels[PP_FALSE_COLOUR_LEVELS_MOST])
{
    int count = 0;
    if (scale->logarithmic) {
        for (int i = round_above(scale->low); count < PP_FALSE_COLOUR_LEVELS_MOST;
             i++) {
            if (round_number(i) > scale->high * (1.0 + 1e-9))
                break;
            levels[count++] = round_number(i);
        }
        return count;
    }
    /* Uses about ten equal steps. */
    double step = round_number(round_above((scale->high - scale->low) / 12.0));
    for (double i = ceil(scale->low / step - 1e-9); count < PP_FALSE_COLOUR_LEVELS_MOST;
         i++) {
        if (i * step > scale->high * (1.0 + 1e-9))
            break;
        levels[count++] = i * step;
    }
    return count;
}

double pp_false_colour_scale_at(const struct pp_false_colour_scale *scale, double value)
{
    double at;
    if (!scale->logarithmic)
        at = (value - scale->low) / (scale->high - scale->low);
    else if (value > 0.0)
        at = log(value / scale->low) / log(scale->high / scale->low);
    else
        at = 0.0;
    return fmin(fmax(at, 0.0), 1.0);
}

/* ---- colours ---- */

/* [GREEN11] eq. 2, with start 0.5, -1.5 rotations, hue 1 and gamma 1. */
void pp_false_colour(double at, unsigned char rgb[3])
{
    static const double weights[3][2] = {
        {-0.14861, 1.78277}, {-0.29227, -0.90649}, {1.97294, 0.0}};
    double lambda = 0.1 + 0.8 * at;
    double phi = 2.0 * PP_PI * (0.5 / 3.0 + 1.0 - 1.5 * lambda);
    double a = lambda * (1.0 - lambda) / 2.0;
    for (int i = 0; i < 3; i++) {
        double value =
            lambda + a * (weights[i][0] * cos(phi) + weights[i][1] * sin(phi));
        rgb[i] = (unsigned char)lrint(255.0 * fmin(fmax(value, 0.0), 1.0));
    }
}

enum pp_status pp_false_colour_raster(struct pp_raster *raster,
                                      const struct pp_picture *picture, double unit,
                                      const struct pp_false_colour_scale *scale,
                                      struct pp_error *err)
{
    enum pp_status status =
        pp_raster_init(raster, picture->width, picture->height, err);
    for (int y = 0; status == PP_OK && y < picture->height; y++)
        for (int x = 0; x < picture->width; x++) {
            double value = unit * pp_rgb_luminance(pp_picture_rgb(picture, x, y));
            unsigned char *rgb = pp_raster_at(raster, x, y);
            if (isfinite(value))
                pp_false_colour(pp_false_colour_scale_at(scale, value), rgb);
            else
                memset(rgb, 255, 3);
        }
    return status;
}
