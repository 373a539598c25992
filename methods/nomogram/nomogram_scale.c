/* nomogram_scale.c - the derivation of the nomograms' scales [GEEBELEN], and the
 * scales.
 *
 * THE FORMULA. For vertical glass, the BRE formula (bre_terms.h) is, in per cent,
 *
 *     IRC = q W / (A (1 - R)) (C R_fw + g R_cw)                               (1)
 *
 * with its constants q for clear glass and g for the ground; for top light, C is
 * replaced by C(beta), the light of the sky on glass of slope beta, and g by g (1 - cos
 * beta). For horizontal glass these are 100 and 0. The formula has three reflectances,
 * but a scale can have only one. A rule must therefore relate R_fw and R_cw to R:
 *
 *     R_cw = k R_fw,   R = (R_fw + R_cw)/2  =>  R_fw = 2 R/(1 + k)            (2)
 *
 * The second relation holds because the parts of the room above and below the middle of
 * the window are about equal. With (2) the formula is a product of functions of one
 * quantity each,
 *
 *     IRC = K . W/A . R/(1 - R) . F,   K = q . 2/(1 + k) . (C0 + g k)         (3)
 *
 *     side-lit  C0 = C(0)  F = (C(alpha) + g k)/(C(0) + g k)
 *     top-lit   C0 = 100   F = (C(beta) + g k (1 - cos beta))/100
 *               (without "+ g k" in K; F is then 1 for horizontal glass)
 *
 *     minimum = IRC / f, with the published f for the walls' reflectance [BRE310]
 *
 * The logarithm of IRC is therefore a sum, which a straight-edge adds on parallel
 * scales.
 *
 * THE RULE. k is 1.5: to a tenth, the k for which (3) is right on average (geometric
 * mean of (3)/(1) nearest to 1, no obstruction) over rooms of floor 0.2, walls 0.5,
 * ceiling 0.7, 3 to 8 m wide and deep, 2.5 to 3.5 m high, with windows of 10 to 30 % of
 * the floor in one wall. R_cw/R_fw itself is 1.7 there, but R contains the dark
 * windows, which R_fw and R_cw leave out: R_fw + R_cw is 5 % above 2 R. The smaller k
 * compensates for that. So R_fw = 0.8 R, R_cw = 1.2 R. For top light, the same rule
 * holds: floor and all walls receive the light, and their mean reflectance is 0.8 R to
 * 0.9 R with such finishes.
 *
 * THE SCALES. Let the stem at x_1 have y_1 = m_1 u, the stem at x_2 have y_2 = m_2 v.
 * A straight line through both crosses the stem at x_3 between them at
 *
 *     y_3 = (1 - t) m_1 u + t m_2 v,   t = (x_3 - x_1)/(x_2 - x_1)
 *
 * which is m_3 (u + v) if (1 - t) m_1 = t m_2 = m_3, that is
 *
 *     t = m_1/(m_1 + m_2),   m_3 = m_1 m_2/(m_1 + m_2)                        (4)
 *
 * with u, v logarithms to base ten and m the length of a decade. If the first stem does
 * not begin at 0 but y_1 = y_01 + m_1 u, y_3 increases by (1 - t) y_01; an offset y_02
 * of the second stem increases y_3 by t y_02.
 *
 *   A, B fill the whole height; m_A, m_B follow from their ranges. C lies at (4).
 *   E is to be at x_E between C and D: by (4) m_D = m_C (1 - t)/t.
 *   G is to be at x_G between E and F: likewise m_F.
 *   D and F are shorter than the height and stand in its middle.
 *
 * NOMOGRAM IV uses the formula of `irc-atlas`, in per cent,
 *
 *     IRC_m = T W/(A (1 - R)) L,   IRC = IRC_m f_d f_s                         (5)
 *
 * with L the effective light on the glass, calculated below the scales: C is a = T W/(A
 * (1 - R)), D is L, E is IRC_m, F is a factor for the position, and G is the product of
 * E and F. Both factors are
 *
 *     f = q exp(-q u)/(1 - exp(-q)),   log f = h(q) - q u log e
 *
 * of the position u: u = x/d_r with q_d for the depth, and u = 2 y/w_r with q_s
 * sideways. Let the stem H, the scale of u, stand at x_H with y = y_0 + m_H u, and the
 * stem F at x_F with y = y_1 + m_F log f. For one q, all lines that join a u to its f
 * meet in one point: at the fraction t of the way from H to F,
 *
 *     y = (1 - t)(y_0 + m_H u) + t (y_1 + m_F (h - q u log e))
 *
 * does not depend on u if t = m_H/(m_H + m_F q log e). The points of all q form a curve
 * between H and F. The curve crosses F at q = 0, where f = 1. Rooms that are brighter
 * at their back have a negative q, on the part of the curve beyond F.
 *
 * On the lines A-B, C-D and E-F, the scale that is read lies between the two scales
 * that are set. Errors of setting are therefore averaged and not magnified.
 */
#include "methods/nomogram/nomogram_scale.h"

#include <math.h>
#include <stddef.h>

#include "methods/reflected/bre_terms.h"
#include "methods/reflected/irc_minimum.h"
#include "methods/reflected/obstruction.h"
#include "model/geometry/vec.h"
#include "model/light/graded_sky.h"

/* Ranges of the scales that a user sets. */
static const double least_glass = 0.005, most_glass = 0.2;
static const double most_obstruction_rad = 80.0 * PP_RAD;
static const double darkest_walls = 0.2, lightest_walls = 0.8;
static const double least_light = 0.001, most_light = 0.5;
static const double least_component = 5e-5, most_component = 0.5;
static const double least_factor = 0.03, most_factor = 4.0;

/* Foot of H (which no other stem determines), height of one unit on it, and its upper
 * end: a point at the far end of a wall that has its opening at the near end. */
static const double places_foot = 0.04, places_unit = 0.46, most_place = 2.0;

/* Formula (1) for W = A and R = 0. */
static double by_formula(double C, double R_fw, double R_cw)
{
    const struct pp_bre_terms terms = {
        .W = 1.0, .all = {1.0, 0.0}, .R_fw = R_fw, .R_cw = R_cw, .C = C};
    return pp_bre_terms_average(&terms);
}

/* F for glass at slope beta under the overcast sky. */
static double slope_factor(double beta)
{
    double C = pp_graded_sky_on_plane(PP_GRADED_SKY_OVERCAST, beta);
    return by_formula(C, 1.0, PP_NOMOGRAM_K * (1.0 - cos(beta)))
           / by_formula(1.0, 1.0, 0.0);
}

/* F for a window that faces an obstruction at altitude alpha. */
static double obstruction_factor(double alpha)
{
    return by_formula(pp_obstruction_factor(alpha), 1.0, PP_NOMOGRAM_K)
           / by_formula(pp_obstruction_factor(0.0), 1.0, PP_NOMOGRAM_K);
}

/* Value of the factor of (3) that depends on the quantity. */
static double function_of(enum pp_nomogram_quantity quantity, double value)
{
    switch (quantity) {
    case PP_NOMOGRAM_GLASS:
    case PP_NOMOGRAM_COMPONENT:
    case PP_NOMOGRAM_GAIN:
    case PP_NOMOGRAM_LIGHT:
    case PP_NOMOGRAM_FACTOR:
        break;
    case PP_NOMOGRAM_LOSS:
        return 1.0 / (1.0 - value);
    case PP_NOMOGRAM_PLACE: /* linear scale */
        return pow(10.0, value);
    case PP_NOMOGRAM_REFLECTANCE:
        return value / (1.0 - value);
    case PP_NOMOGRAM_OBSTRUCTION:
        return obstruction_factor(value);
    case PP_NOMOGRAM_SLOPE:
        return slope_factor(value);
    case PP_NOMOGRAM_WALLS:
        return 1.0 / pp_irc_minimum_average_ratio(value);
    }
    return value;
}

/* A stem over the full height. */
static struct pp_nomogram_stem whole_stem(enum pp_nomogram_quantity quantity, double x,
                                          double low, double high)
{
    double bottom = log10(function_of(quantity, low));
    double decade = 1.0 / (log10(function_of(quantity, high)) - bottom);
    return (struct pp_nomogram_stem){.quantity = quantity,
                                     .x = x,
                                     .foot = -decade * bottom,
                                     .decade = decade,
                                     .low = low,
                                     .high = high};
}

/* A stem centred in the height, with its values ascending. */
static struct pp_nomogram_stem middle_stem(enum pp_nomogram_quantity quantity, double x,
                                           double decade, double low, double high)
{
    double sum = log10(function_of(quantity, low)) + log10(function_of(quantity, high));
    return (struct pp_nomogram_stem){.quantity = quantity,
                                     .x = x,
                                     .foot = 0.5 - decade * sum / 2.0,
                                     .decade = decade,
                                     .low = low,
                                     .high = high};
}

/* The y of a stem's lower or upper end. */
static double end_y(const struct pp_nomogram_stem *stem, bool upper)
{
    double a =
        stem->foot + stem->decade * log10(function_of(stem->quantity, stem->low));
    double b =
        stem->foot + stem->decade * log10(function_of(stem->quantity, stem->high));
    return upper ? fmax(a, b) : fmin(a, b);
}

/* The stem read between two others, at the x of (4). constant: factor of the product
 * that neither of the two stems contains. */
static struct pp_nomogram_stem stem_between(const struct pp_nomogram_stem *from,
                                            const struct pp_nomogram_stem *to,
                                            double constant)
{
    double t = from->decade / (from->decade + to->decade);
    struct pp_nomogram_stem stem = {.quantity = PP_NOMOGRAM_COMPONENT,
                                    .x = from->x + t * (to->x - from->x),
                                    .decade = t * to->decade};
    stem.foot = (1.0 - t) * from->foot + t * to->foot - stem.decade * log10(constant);
    for (int end = 0; end < 2; end++) {
        double y = (1.0 - t) * end_y(from, end) + t * end_y(to, end);
        *(end ? &stem.high : &stem.low) = pow(10.0, (y - stem.foot) / stem.decade);
    }
    return stem;
}

/* Length of a decade on the stem at x_to. With this length, the stem read between
 * `from` and the stem at x_to lies at x_read. */
static double decade_for(const struct pp_nomogram_stem *from, double x_read,
                         double x_to)
{
    double t = (x_read - from->x) / (x_to - from->x);
    return from->decade * (1.0 - t) / t;
}

static void name_stems(struct pp_nomogram *nomogram)
{
    for (int i = 0; i < nomogram->stem_count; i++)
        nomogram->stems[i].letter = (char)('A' + i);
}

static struct pp_nomogram make_position(void)
{
    struct pp_nomogram nomogram = {
        .kind = PP_NOMOGRAM_POSITION,
        .stem_count = 8,
        .edge_count = 3,
        .edges = {{PP_STEM_A, PP_STEM_B, PP_STEM_C},
                  {PP_STEM_C, PP_STEM_D, PP_STEM_E},
                  {PP_STEM_E, PP_STEM_F, PP_STEM_G}},
    };
    struct pp_nomogram_stem *stem = nomogram.stems;
    stem[PP_STEM_A] = whole_stem(PP_NOMOGRAM_GLASS, 0.0, least_glass, most_glass);
    stem[PP_STEM_B] =
        whole_stem(PP_NOMOGRAM_LOSS, 0.24, PP_NOMOGRAM_LEAST_R, PP_NOMOGRAM_MOST_R);
    stem[PP_STEM_C] = stem_between(&stem[PP_STEM_A], &stem[PP_STEM_B], 1.0);
    stem[PP_STEM_C].quantity = PP_NOMOGRAM_GAIN;
    stem[PP_STEM_D] =
        middle_stem(PP_NOMOGRAM_LIGHT, 0.55, decade_for(&stem[PP_STEM_C], 0.33, 0.55),
                    least_light, most_light);
    stem[PP_STEM_E] = stem_between(&stem[PP_STEM_C], &stem[PP_STEM_D], 1.0);
    stem[PP_STEM_F] =
        middle_stem(PP_NOMOGRAM_FACTOR, 0.78, decade_for(&stem[PP_STEM_E], 0.465, 0.78),
                    least_factor, most_factor);
    stem[PP_STEM_G] = stem_between(&stem[PP_STEM_E], &stem[PP_STEM_F], 1.0);
    for (int i = PP_STEM_E; i <= PP_STEM_G; i += PP_STEM_G - PP_STEM_E) {
        stem[i].low = least_component;
        stem[i].high = most_component;
    }
    stem[PP_STEM_H] = (struct pp_nomogram_stem){.quantity = PP_NOMOGRAM_PLACE,
                                                .x = 1.0,
                                                .foot = places_foot,
                                                .decade = places_unit,
                                                .low = 0.0,
                                                .high = most_place};
    name_stems(&nomogram);
    return nomogram;
}

struct pp_nomogram pp_nomogram_scale_make(enum pp_nomogram_kind kind)
{
    if (kind == PP_NOMOGRAM_POSITION)
        return make_position();
    /* x of the stems B, E, D and, for the minimum, G, F, chosen by trial for even
     * spacing. */
    static const double places[PP_NOMOGRAM_POSITION][5] = {
        [PP_NOMOGRAM_AVERAGE] = {0.78, 0.61, 1.0},
        [PP_NOMOGRAM_MINIMUM] = {0.74, 0.52, 0.87, 0.63, 1.0},
        [PP_NOMOGRAM_ROOFLIGHT] = {0.78, 0.56, 1.0},
    };
    const double *x = places[kind];
    bool top = kind == PP_NOMOGRAM_ROOFLIGHT, minimum = kind == PP_NOMOGRAM_MINIMUM;
    struct pp_nomogram nomogram = {
        .kind = kind,
        .k = PP_NOMOGRAM_K,
        .R_fw_R = 2.0 / (1.0 + PP_NOMOGRAM_K),
        .stem_count = minimum ? 7 : 5,
        .edge_count = minimum ? 3 : 2,
        .edges = {{PP_STEM_A, PP_STEM_B, PP_STEM_C},
                  {PP_STEM_C, PP_STEM_D, PP_STEM_E},
                  {PP_STEM_E, PP_STEM_F, PP_STEM_G}},
    };
    double R_fw = nomogram.R_fw_R, R_cw = PP_NOMOGRAM_K * nomogram.R_fw_R;
    double K = top ? by_formula(1.0, R_fw, 0.0)
                   : by_formula(pp_obstruction_factor(0.0), R_fw, R_cw);

    struct pp_nomogram_stem *stem = nomogram.stems;
    stem[PP_STEM_A] = whole_stem(PP_NOMOGRAM_GLASS, 0.0, least_glass, most_glass);
    stem[PP_STEM_B] = whole_stem(PP_NOMOGRAM_REFLECTANCE, x[0], PP_NOMOGRAM_LEAST_R,
                                 PP_NOMOGRAM_MOST_R);
    stem[PP_STEM_C] = stem_between(&stem[PP_STEM_A], &stem[PP_STEM_B], K);
    stem[PP_STEM_D] = middle_stem(top ? PP_NOMOGRAM_SLOPE : PP_NOMOGRAM_OBSTRUCTION,
                                  x[2], decade_for(&stem[PP_STEM_C], x[1], x[2]), 0.0,
                                  top ? PP_PI / 2.0 : most_obstruction_rad);
    stem[PP_STEM_E] = stem_between(&stem[PP_STEM_C], &stem[PP_STEM_D], 1.0);
    if (minimum) {
        stem[PP_STEM_F] = middle_stem(PP_NOMOGRAM_WALLS, x[4],
                                      decade_for(&stem[PP_STEM_E], x[3], x[4]),
                                      darkest_walls, lightest_walls);
        stem[PP_STEM_G] = stem_between(&stem[PP_STEM_E], &stem[PP_STEM_F], 1.0);
    }
    name_stems(&nomogram);
    return nomogram;
}

/* log10(q/(1 - exp(-q))). */
static double log_mean(double q)
{
    return fabs(q) < 1e-9 ? 0.0 : log10(q / -expm1(-q));
}

void pp_nomogram_scale_curve(const struct pp_nomogram *nomogram, double q, double *x,
                             double *y)
{
    const struct pp_nomogram_stem *places = &nomogram->stems[PP_STEM_H],
                                  *factors = &nomogram->stems[PP_STEM_F];
    double t =
        places->decade / (places->decade + factors->decade * q * log10(exp(1.0)));
    *x = places->x + t * (factors->x - places->x);
    *y = (1.0 - t) * places->foot + t * (factors->foot + factors->decade * log_mean(q));
}

double pp_nomogram_scale_position(const struct pp_nomogram *nomogram, int index,
                                  double value)
{
    const struct pp_nomogram_stem *stem = &nomogram->stems[index];
    double within = fmin(fmax(value, stem->low), stem->high);
    return stem->foot + stem->decade * log10(function_of(stem->quantity, within));
}

double pp_nomogram_scale_value(const struct pp_nomogram *nomogram, int index, double y)
{
    const struct pp_nomogram_stem *stem = &nomogram->stems[index];
    return pow(10.0, (y - stem->foot) / stem->decade);
}

double pp_nomogram_scale_crossing(const struct pp_nomogram *nomogram, int index,
                                  double y_from, double y_to, double x)
{
    const struct pp_nomogram_edge *edge = &nomogram->edges[index];
    double x_from = nomogram->stems[edge->from].x, x_to = nomogram->stems[edge->to].x;
    return y_from + (x - x_from) / (x_to - x_from) * (y_to - y_from);
}

bool pp_nomogram_scale_contains(const struct pp_nomogram *nomogram, int index,
                                double value)
{
    const struct pp_nomogram_stem *stem = &nomogram->stems[index];
    return value >= stem->low && value <= stem->high;
}

double pp_nomogram_scale_printed_unit(enum pp_nomogram_quantity quantity)
{
    switch (quantity) {
    case PP_NOMOGRAM_COMPONENT:
    case PP_NOMOGRAM_LIGHT:
        return 100.0;
    case PP_NOMOGRAM_OBSTRUCTION:
    case PP_NOMOGRAM_SLOPE:
        return 1.0 / PP_RAD;
    default:
        return 1.0;
    }
}

/* Finds the interval between bold figures that contains a value. Bold figures are 1, 2,
 * 5, 10 ... on a logarithmic scale, tenths of a reflectance (fifths for the walls, as
 * published), and tens of degrees. */
static void find_stretch(enum pp_nomogram_quantity quantity, double printed,
                         double stretch[2])
{
    double even = 0.0;
    switch (quantity) {
    default:
        break;
    case PP_NOMOGRAM_REFLECTANCE:
    case PP_NOMOGRAM_LOSS:
    case PP_NOMOGRAM_PLACE:
        even = 0.1;
        break;
    case PP_NOMOGRAM_WALLS:
        even = 0.2;
        break;
    case PP_NOMOGRAM_OBSTRUCTION:
    case PP_NOMOGRAM_SLOPE:
        even = 10.0;
        break;
    }
    if (even > 0.0) {
        stretch[0] = even * floor(printed / even + 1e-9);
        stretch[1] = stretch[0] + even;
        return;
    }
    static const double bold[] = {1.0, 2.0, 5.0, 10.0};
    double power = pow(10.0, floor(log10(printed) + 1e-9));
    int i = 0;
    while (i < 2 && printed / power > bold[i + 1] * (1.0 - 1e-9))
        i++;
    stretch[0] = bold[i] * power;
    stretch[1] = bold[i + 1] * power;
}

double pp_nomogram_scale_division(const struct pp_nomogram *nomogram, int index,
                                  double printed, double height_mm, double least_mm,
                                  double stretch[2])
{
    static const double usual[] = {1.0, 2.0, 5.0};
    const struct pp_nomogram_stem *stem = &nomogram->stems[index];
    double unit = pp_nomogram_scale_printed_unit(stem->quantity);
    bool angle = stem->quantity == PP_NOMOGRAM_OBSTRUCTION
                 || stem->quantity == PP_NOMOGRAM_SLOPE;
    find_stretch(stem->quantity, printed, stretch);
    double width = stretch[1] - stretch[0];
    /* The scale's own end may cut the stretch short. */
    double low = fmax(stretch[0], unit * stem->low);
    double high = fmin(stretch[1], unit * stem->high);
    double power = angle ? 1.0 : pow(10.0, floor(log10(width) + 1e-9) - 3.0);
    for (int i = 0;; i++) {
        double step = usual[i % 3] * power;
        if (i % 3 == 2)
            power *= 10.0;
        if (step > 0.999 * width)
            return width;
        if (fabs(width / step - rint(width / step)) > 1e-6)
            continue;
        /* Mark spacing is monotone along a stretch, so its ends are enough to test. */
        double ends[2] = {low, high - step};
        double apart = INFINITY;
        for (int end = 0; end < 2; end++) {
            double y0 = pp_nomogram_scale_position(nomogram, index, ends[end] / unit);
            double y1 =
                pp_nomogram_scale_position(nomogram, index, (ends[end] + step) / unit);
            apart = fmin(apart, height_mm * fabs(y1 - y0));
        }
        if (apart >= least_mm)
            return step;
    }
}

double pp_nomogram_scale_read(const struct pp_nomogram *nomogram, int index,
                              double value)
{
    const struct pp_nomogram_stem *stem = &nomogram->stems[index];
    double unit = pp_nomogram_scale_printed_unit(stem->quantity);
    double within = fmin(fmax(value, stem->low), stem->high), stretch[2];
    double fifth =
        pp_nomogram_scale_division(nomogram, index, unit * within, PP_NOMOGRAM_A4_MM,
                                   PP_NOMOGRAM_LEAST_MM, stretch)
        / 5.0;
    double read = fifth * rint(unit * within / fifth) / unit;
    return fmin(fmax(read, stem->low), stem->high);
}
