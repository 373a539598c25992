/* tone.c - see tone.h. The curve is the histogram adjustment of [LRP97]:
 *
 *     log Ld = log Ld_min + (log Ld_max - log Ld_min) P(log Lw)
 *
 * P is the cumulative histogram of the scene's luminances Lw, trimmed until the slope
 * of the curve does not exceed its ceiling.
 */
#include "model/pictures/tone.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

/* Trimming ends when it removes less than this share of the remaining histogram.
 * [LRP97] use this share of the whole histogram, which may be half of a small
 * remainder. */
static const double tolerance = 0.025;

/* Share of the histogram that is spread evenly over its bins; chosen by trial. */
static const double spread = 0.01;

double pp_tone_threshold(double luminance)
{
    double a = log10(luminance), t;
    if (a < -3.94)
        t = -2.86;
    else if (a < -1.44)
        t = pow(0.405 * a + 1.6, 2.18) - 2.86;
    else if (a < -0.0184)
        t = a - 0.395;
    else if (a < 1.9)
        t = pow(0.249 * a + 0.65, 2.7) - 0.72;
    else
        t = a - 1.255;
    return pow(10.0, t);
}

/* ---- adaptation ---- */

/* Natural logarithms of the mean luminances of squares of one degree; black squares are
 * left out. */
struct adaptation_fields {
    double *logs;
    int count;
};

static enum pp_status average_fields(struct adaptation_fields *fields,
                                     const struct pp_picture *picture,
                                     const struct pp_tone_options *options,
                                     struct pp_error *err)
{
    int side = (int)fmin(fmax(options->degree_pixels, 1.0), 4096.0);
    int across = (picture->width + side - 1) / side;
    int down = (picture->height + side - 1) / side;
    *fields = (struct adaptation_fields){
        .logs = malloc((size_t)across * (size_t)down * sizeof(double))};
    if (!fields->logs)
        return pp_fail_memory(err);
    for (int j = 0; j < down; j++)
        for (int i = 0; i < across; i++) {
            double sum = 0.0;
            int count = 0;
            for (int y = j * side; y < (j + 1) * side && y < picture->height; y++)
                for (int x = i * side; x < (i + 1) * side && x < picture->width; x++) {
                    double grey = pp_rgb_luminance(pp_picture_rgb(picture, x, y));
                    if (!isfinite(grey))
                        continue;
                    sum += grey;
                    count++;
                }
            double luminance = count ? sum / count * options->unit : 0.0;
            if (luminance > 0.0 && isfinite(luminance))
                fields->logs[fields->count++] = log(luminance);
        }
    return PP_OK;
}

/* ---- the curve ---- */

static const double display_range = 4.605170185988092; /* log(most / least) */

/* Logarithm of the display luminance of a field; `below` of `all` fields are darker. */
static double display_log(double below, double all)
{
    return log(PP_TONE_DISPLAY_LEAST) + display_range * below / all;
}

/* Trims the histogram so that the curve shows at most the contrast of the scene, and at
 * most the contrast visible in the scene: the lower of the two ceilings of [LRP97]. The
 * ceiling for visibility alone would give dark parts of the display, where the eye
 * distinguishes less, more contrast than the scene. Returns the amount removed; *total
 * is the remainder. */
static double trim(double bins[PP_TONE_BINS], const struct pp_tone *tone, double *total)
{
    double below = 0.0, cut = 0.0, all = *total;
    for (int i = 0; i < PP_TONE_BINS; i++) {
        double scene = exp(tone->low + (i + 0.5) * tone->step);
        double shown = exp(display_log(below + bins[i] / 2.0, all));
        double by_eye =
            pp_tone_threshold(shown) / shown / (pp_tone_threshold(scene) / scene);
        double most = fmin(1.0, by_eye) * all * tone->step / display_range;
        below += bins[i];
        if (bins[i] > most) {
            cut += bins[i] - most;
            bins[i] = most;
        }
    }
    *total = all - cut;
    return cut;
}

/* Shows a scene whose contrast fits the display linearly, with its brightest luminance
 * as white. */
static void show_linearly(struct pp_tone *tone, double brightest)
{
    tone->white = brightest;
}

static void make_curve(struct pp_tone *tone, const struct adaptation_fields *fields)
{
    double low = INFINITY, high = -INFINITY;
    for (int i = 0; i < fields->count; i++) {
        low = fmin(low, fields->logs[i]);
        high = fmax(high, fields->logs[i]);
    }
    /* Fields below 1e-4 cd/m2 are left out of the histogram. */
    low = fmax(low, log(1e-4));
    if (!(high > low + 1e-6)) {
        show_linearly(tone, exp(high) / PP_TONE_MIDDLE);
        return;
    }
    if (high - low <= display_range) {
        show_linearly(tone, exp(high));
        return;
    }
    tone->low = low;
    tone->step = (high - low) / PP_TONE_BINS;
    double bins[PP_TONE_BINS] = {0.0}, total = 0.0;
    for (int i = 0; i < fields->count; i++) {
        if (fields->logs[i] < low)
            continue;
        int bin = (int)((fields->logs[i] - low) / tone->step);
        bins[bin < PP_TONE_BINS ? bin : PP_TONE_BINS - 1] += 1.0;
        total += 1.0;
    }
    /* Spreads a hundredth evenly over the bins. Trimmed contrast can then move to the
     * gap between the luminances of a room and its window, where it is not visible. */
    double all = total + spread * total;
    for (int i = 0; i < PP_TONE_BINS; i++)
        bins[i] += spread * total / PP_TONE_BINS;
    total = all;
    for (double cut = INFINITY; cut > tolerance * total;) {
        cut = trim(bins, tone, &total);
        if (!(total > 1e-6 * all)) {
            show_linearly(tone, exp(high));
            return;
        }
    }
    double below = 0.0;
    tone->curve[0] = display_log(0.0, total);
    for (int i = 0; i < PP_TONE_BINS; i++) {
        below += bins[i];
        tone->curve[i + 1] = display_log(below, total);
    }
}

enum pp_status pp_tone_prepare(struct pp_tone *tone, const struct pp_picture *picture,
                               const struct pp_tone_options *options,
                               struct pp_error *err)
{
    *tone = (struct pp_tone){.unit = options->unit, .white = options->white};
    if (options->way == PP_TONE_BY_HAND)
        return PP_OK;
    struct adaptation_fields fields;
    enum pp_status status = average_fields(&fields, picture, options, err);
    if (status != PP_OK)
        return status;
    tone->white = 1.0;
    if (fields.count > 0 && options->way == PP_TONE_AUTOMATIC) {
        double sum = 0.0;
        for (int i = 0; i < fields.count; i++)
            sum += fields.logs[i];
        tone->white = exp(sum / fields.count) / PP_TONE_MIDDLE;
    } else if (fields.count > 0) {
        tone->white = 0.0;
        make_curve(tone, &fields);
    }
    free(fields.logs);
    return PP_OK;
}

/* ---- pixels ---- */

double pp_tone_shown(const struct pp_tone *tone, double luminance)
{
    if (!(luminance > 0.0))
        return 0.0;
    if (tone->white > 0.0)
        return luminance / tone->white;
    double at = (log(luminance) - tone->low) / tone->step, shown;
    if (at <= 0.0) /* darker than all fields: proportional */
        shown = tone->curve[0] + at * tone->step;
    else if (at >= PP_TONE_BINS)
        shown = tone->curve[PP_TONE_BINS];
    else
        shown = tone->curve[(int)at]
                + (at - (int)at) * (tone->curve[(int)at + 1] - tone->curve[(int)at]);
    return exp(shown) / PP_TONE_DISPLAY_MOST;
}

/* sRGB transfer function, 0 to 255. */
static unsigned char encode(double linear)
{
    double value =
        linear <= 0.0031308 ? 12.92 * linear : 1.055 * pow(linear, 1.0 / 2.4) - 0.055;
    return (unsigned char)lrint(255.0 * fmin(fmax(value, 0.0), 1.0));
}

void pp_tone_apply(const struct pp_tone *tone, struct pp_rgb rgb,
                   unsigned char shown[3])
{
    double grey = pp_rgb_luminance(rgb);
    memset(shown, 0, 3);
    if (!(grey > 0.0) || !isfinite(grey))
        return;
    double scale = pp_tone_shown(tone, grey * tone->unit) / grey;
    shown[0] = encode(scale * rgb.r);
    shown[1] = encode(scale * rgb.g);
    shown[2] = encode(scale * rgb.b);
}
