/* tone.h - tone mapping: from the luminances of a picture to those of a screen or
 * paper.
 *
 * Three ways: an exposure set by hand; an automatic exposure that shows the geometric
 * mean as middle grey; the curve of [LRP97]. That curve distributes contrast over the
 * luminances that occur. Contrast is limited to that of the scene, and to the contrast
 * visible to an eye adapted to the scene. Surfaces that look alike in the scene look
 * alike in the picture.
 *
 * Luminances are in cd/m2: the picture's grey (rgb.h) times `unit`.
 */
#ifndef PP_MODEL_PICTURES_TONE_H
#define PP_MODEL_PICTURES_TONE_H

#include "model/pictures/picture.h"

enum pp_tone_way { PP_TONE_BY_HAND, PP_TONE_AUTOMATIC, PP_TONE_HUMAN };

/* Luminances (cd/m2) of the display's black and white. */
#define PP_TONE_DISPLAY_LEAST 1.0
#define PP_TONE_DISPLAY_MOST 100.0

/* Luminance of middle grey divided by white; the geometric mean is shown as middle
 * grey. */
#define PP_TONE_MIDDLE 0.18

struct pp_tone_options {
    enum pp_tone_way way;
    double white; /* by hand: luminance shown as white, above 0 */
    double unit;  /* luminance (cd/m2) of a grey of 1 */
    double
        degree_pixels; /* automatic and human: pixels per degree of view; the eye adapts
                        * to fields one degree wide; at least 1 */
};

enum { PP_TONE_BINS = 100 };

struct pp_tone {
    double unit;
    double white; /* scene luminance shown as white, in proportion; 0: use the curve */
    /* Log display luminance at PP_TONE_BINS + 1 equal steps of the log scene
     * luminance. */
    double low, step, curve[PP_TONE_BINS + 1];
};

/* Analyses the whole picture. NaN pixels and black fields do not count; if there are no
 * other fields, 1 cd/m2 is shown as white. */
enum pp_status pp_tone_prepare(struct pp_tone *tone, const struct pp_picture *picture,
                               const struct pp_tone_options *options,
                               struct pp_error *err);

/* Display luminance divided by display white, for a luminance of the scene (cd/m2): 0
 * to 1, or above 1 if the picture is shown in proportion. Monotonic. The display's
 * black is not subtracted from the curve; that would increase the contrast of dark
 * parts on a display with a darker black. */
double pp_tone_shown(const struct pp_tone *tone, double luminance);

/* Converts a pixel to sRGB [IEC61966]. */
void pp_tone_apply(const struct pp_tone *tone, struct pp_rgb rgb,
                   unsigned char shown[3]);

/* Smallest visible luminance difference for an eye adapted to `luminance` (cd/m2), by
 * rods and cones: [LRP97] eq. 2, after [FERWERDA96]. */
double pp_tone_threshold(double luminance);

#endif
