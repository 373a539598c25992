/* nomogram_position.c - sets the figures of `irc-atlas` on the scales of nomogram
 * IV. */
#include "methods/nomogram/nomogram_position.h"

#include <math.h>
#include <stddef.h>

#include "methods/fitted/fitted_light.h"
#include "methods/fitted/fitted_position.h"
#include "methods/fitted/irc_atlas.h"
#include "methods/method.h"
#include "methods/nomogram/nomogram_reading.h"
#include "methods/nomogram/nomogram_scale.h"
#include "model/results/worksheet.h"

const struct pp_formula *const pp_nomogram_position_formulae[] = {
    PP_FITTED_LIGHT_FORMULAE, &pp_irc_atlas_light,     &pp_fitted_position_l,
    &pp_fitted_position_q_d,  &pp_fitted_position_q_s, NULL,
};

/* Width of the scales on A4. */
static const double width_mm = 240.0;

double pp_nomogram_position_division(const struct pp_nomogram *nomogram, double q,
                                     double width, double height, double least_mm)
{
    static const double steps[] = {0.1, 0.2, 0.5};
    double from = fmin(floor(q + 1e-9), PP_NOMOGRAM_MOST_Q - 1.0);
    for (int i = 0; i < 3; i++) {
        /* The larger q is, the closer together are the marks. */
        double x0, y0, x1, y1, to = from + 1.0;
        pp_nomogram_scale_curve(nomogram, to - steps[i], &x0, &y0);
        pp_nomogram_scale_curve(nomogram, to, &x1, &y1);
        if (hypot(width * (x1 - x0), height * (y1 - y0)) >= least_mm)
            return steps[i];
    }
    return 1.0;
}

/* Reads the factor at the point where the straight-edge, laid from the place through q,
 * crosses F. */
static struct pp_nomogram_place read_place(const struct pp_nomogram *nomogram, double q,
                                           double share)
{
    struct pp_nomogram_place place;
    double fifth = pp_nomogram_position_division(
                       nomogram, q, width_mm, PP_NOMOGRAM_A4_MM, PP_NOMOGRAM_LEAST_MM)
                   / 5.0;
    double x_share = nomogram->stems[PP_STEM_H].x, x_f = nomogram->stems[PP_STEM_F].x;
    place.q = fifth * rint(q / fifth);
    place.share = pp_nomogram_scale_read(nomogram, PP_STEM_H, share);
    pp_nomogram_scale_curve(nomogram, place.q, &place.x, &place.y);
    place.share_y = pp_nomogram_scale_position(nomogram, PP_STEM_H, place.share);
    double y = place.share_y
               + (place.y - place.share_y) * (x_f - x_share) / (place.x - x_share);
    place.factor = pp_nomogram_scale_read(
        nomogram, PP_STEM_F, pp_nomogram_scale_value(nomogram, PP_STEM_F, y));
    place.factor_y = pp_nomogram_scale_position(nomogram, PP_STEM_F, place.factor);
    return place;
}

static double factor_of(double q, double share)
{
    return fabs(q) < 1e-9 ? 1.0 : q * exp(-q * share) / -expm1(-q);
}

/* Returns the reason if a value is off its scale, else NULL. */
static const char *find_off_scale(const struct pp_nomogram *nomogram, double light,
                                  const double q[2], const double share[2])
{
    static const char off_factors[] =
        "gives a factor outside scale F (0.03 to 4) at this point";
    double product = 1.0;
    if (!pp_nomogram_scale_contains(nomogram, PP_STEM_D, light))
        return "receives an illuminance outside scale D (0.1 to 50 %)";
    for (int i = 0; i < 2; i++) {
        if (!(q[i] >= PP_NOMOGRAM_LEAST_Q && q[i] <= PP_NOMOGRAM_MOST_Q))
            return "is in a room whose depth or width, in decay lengths, is outside "
                   "the range of the curve (-1 to 6)";
        if (!pp_nomogram_scale_contains(nomogram, PP_STEM_H, share[i]))
            return "is too far from the point, measured along the wall, for scale H";
        double factor = factor_of(q[i], share[i]);
        product *= factor;
        if (!pp_nomogram_scale_contains(nomogram, PP_STEM_F, factor))
            return off_factors;
    }
    return pp_nomogram_scale_contains(nomogram, PP_STEM_F, product) ? NULL
                                                                    : off_factors;
}

enum pp_status pp_nomogram_position_read(
    struct pp_nomogram_reading *reading, const char **why,
    const struct pp_nomogram *nomogram, const struct pp_world *world,
    const struct pp_outside_light *light, const struct pp_opening *opening,
    const struct pp_receiver *receiver, const void *tools, struct pp_error *err)
{
    struct pp_part part = {0};
    const struct pp_worksheet *sheet = &part.sheet;
    enum pp_status status = pp_method_irc_atlas.evaluate(world, light, opening,
                                                         receiver, tools, &part, err);
    if (status != PP_OK)
        return status;
    const double L = pp_worksheet_printed(sheet, pp_irc_atlas_light.symbol) / 100.0;
    const double q[2] = {pp_worksheet_printed(sheet, "q_d"),
                         pp_worksheet_printed(sheet, "q_s")};
    const double share[2] = {
        pp_worksheet_printed(sheet, "x") / pp_worksheet_printed(sheet, "d_r"),
        2.0 * pp_worksheet_printed(sheet, "y") / pp_worksheet_printed(sheet, "w_r")};
    *reading =
        (struct pp_nomogram_reading){.glass_m2 = pp_worksheet_printed(sheet, "tau")
                                                 * pp_worksheet_printed(sheet, "Ag"),
                                     .inside_m2 = pp_worksheet_printed(sheet, "A")};
    for (int i = 0; i < PP_NOMOGRAM_STEMS; i++)
        reading->value[i] = NAN;
    *why = find_off_scale(nomogram, L, q, share);
    if (*why)
        return PP_OK;
    double *value = reading->value;
    reading->ratio = reading->glass_m2 / reading->inside_m2;
    const double R = pp_worksheet_printed(sheet, "R");
    pp_nomogram_reading_set_room(reading, nomogram, R);
    const double mean = value[PP_STEM_A] / (1.0 - R) * L;
    const double factors = factor_of(q[0], share[0]) * factor_of(q[1], share[1]);
    if (!pp_nomogram_scale_contains(nomogram, PP_STEM_E, mean)
        || !pp_nomogram_scale_contains(nomogram, PP_STEM_G, mean * factors)) {
        *why = "gives a component outside scales E and G (0.005 to 50 %)";
        return PP_OK;
    }
    pp_nomogram_reading_lay(reading, nomogram, 0);
    value[PP_STEM_D] = pp_nomogram_scale_read(nomogram, PP_STEM_D, L);
    pp_nomogram_reading_lay(reading, nomogram, 1);
    for (int i = 0; i < 2; i++)
        reading->places[i] = read_place(nomogram, q[i], share[i]);
    value[PP_STEM_F] = pp_nomogram_scale_read(
        nomogram, PP_STEM_F, reading->places[0].factor * reading->places[1].factor);
    pp_nomogram_reading_lay(reading, nomogram, 2);
    reading->component = pow(10.0, -reading->tens) * value[PP_STEM_E];
    reading->further = pow(10.0, -reading->tens) * value[PP_STEM_G];
    return PP_OK;
}
