/* tone.h - tone mapping: from the light in a picture to the light of a screen or paper.
 *
 * There are three ways: an exposure set by hand; an automatic one, which makes the
 * geometric mean a middle grey; or the curve of [LRP97]. That curve spreads contrast
 * over the luminances that occur, but limits it to that of the scene and to that
 * visible to an eye adapted to it. Surfaces that look alike there look alike in the
 * picture.
 *
 * Luminances are cd/m2, from the picture's grey (rgb.h) times `unit`.
 */
#ifndef PP_MODEL_PICTURES_TONE_H
#define PP_MODEL_PICTURES_TONE_H

#include "model/pictures/picture.h"

enum pp_tone_way { PP_TONE_BY_HAND, PP_TONE_AUTOMATIC, PP_TONE_HUMAN };

/* Luminances of the display's black and white, cd/m2. */
#define PP_TONE_DISPLAY_LEAST 1.0
#define PP_TONE_DISPLAY_MOST 100.0

/* Middle grey, which the geometric mean becomes, over white. */
#define PP_TONE_MIDDLE 0.18

struct pp_tone_options {
    enum pp_tone_way way;
    double white; /* by hand: the luminance that is shown white, above 0 */
    double unit;  /* luminance of a grey of 1 */
    double
        degree_pixels; /* human: pixels to one degree of view, the width of the fields
                           * that the eye adapts to; at least 1 */
};

enum { PP_TONE_BINS = 100 };

struct pp_tone {
    double unit;
    double white; /* of the first two ways; 0: the curve */
    /* Logarithms of display luminance at PP_TONE_BINS + 1 equal steps of the logarithm
     * of the scene's. */
    double low, step, curve[PP_TONE_BINS + 1];
};

/* Prepares from the whole picture. Pixels that are black or NaN do not count; a picture
 * of such pixels only is shown black. */
enum pp_status pp_tone_prepare(struct pp_tone *tone, const struct pp_picture *picture,
                               const struct pp_tone_options *options,
                               struct pp_error *err);

/* The display's luminance for a luminance of the scene (cd/m2), over the display's
 * white: 0 to 1, and above in the first two ways. It grows with the luminance. The
 * display's black is not subtracted from the curve: on a display with a darker black
 * the contrast of dark parts would increase. */
double pp_tone_shown(const struct pp_tone *tone, double luminance);

/* A pixel in sRGB [IEC61966]. */
void pp_tone_apply(const struct pp_tone *tone, struct pp_rgb rgb,
                   unsigned char shown[3]);

/* The least difference of luminance that is seen by an eye adapted to `luminance`
 * (cd/m2), rods and cones together: [LRP97] eq. 2, after [FERWERDA96]. */
double pp_tone_threshold(double luminance);

#endif
