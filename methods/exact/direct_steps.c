/* direct_steps.c - the steps of a patch that shows sky and ground or an obstruction.
 *
 * For a sky with a closed form, the steps give the moments of the patch, the sky
 * component without glass by these (solid_angle.h), and the mean transmittance of the
 * glass. For any other sky the steps give the value of the integral.
 */
#include "methods/exact/direct_steps.h"

#include <math.h>
#include <stdio.h>

struct sum_text {
    char text[80];
};

/* The formula of the sky component without glass: pi L(0)/Eh = 3/(3 + 2b). */
static struct sum_text closed_form(const struct pp_sky *sky)
{
    double b = sky->gradation;
    struct sum_text sum = {"100 E_0# / 3.141592653590"};
    if (b != 0.0)
        snprintf(sum.text, sizeof sum.text,
                 "300 (E_0# + %g E_1#) / (%g * 3.141592653590)", b, 3.0 + 2.0 * b);
    return sum;
}

/* Records the terms of the sky component; returns its formula, "" for an integral. */
static struct sum_text add_sky_terms(struct pp_part_steps *terms,
                                     const struct pp_patch_figures *figures,
                                     const struct pp_sky *sky)
{
    const struct pp_moments *moments = &figures->moments;
    pp_part_steps_read(terms, PP_UNIT_NUMBER, moments->omega, "omega",
                       figures->hidden ? "solid angle of the sky that is hidden, sr"
                                       : "solid angle of the sky that is seen, sr");
    if (!figures->closed_form)
        return (struct sum_text){""};
    pp_part_steps_read(terms, PP_UNIT_NUMBER, moments->cosine, "E_0",
                       "its integral of the cosine at the receiver");
    if (sky->gradation != 0.0)
        pp_part_steps_read(terms, PP_UNIT_NUMBER, moments->cosine_sine, "E_1",
                           "the same, times the sine of the altitude");
    double bare = pp_solid_angle_sky_component(moments, sky);
    struct sum_text sum = closed_form(sky);
    if (!figures->glazed || !(bare > 0.0))
        return sum;
    pp_part_steps_figure(terms, PP_UNIT_DAYLIGHT_FACTOR, bare, "s", sum.text,
                         "that sky without glass, in closed form");
    pp_part_steps_read(terms, PP_UNIT_NUMBER, figures->above / bare, "t",
                       "mean transmittance over it, by quadrature");
    return (struct sum_text){"s# t#"};
}

static void add_sky_steps(struct pp_part_steps *terms,
                          const struct pp_patch_figures *figures,
                          const struct pp_sky *sky)
{
    struct sum_text formula = add_sky_terms(terms, figures, sky);
    pp_part_steps_component(terms, false, figures->above, formula.text,
                            formula.text[0]
                                ? "sky component"
                                : "sky component, an integral, by quadrature");
    if (figures->below == 0.0)
        return;
    pp_part_steps_read(terms, PP_UNIT_DAYLIGHT_FACTOR, figures->below, "c",
                       "ground that is seen, for a reflectance of 1");
    pp_part_steps_read(terms, PP_UNIT_NUMBER, figures->factor, "rho_g",
                       "reflectance of the ground");
    pp_part_steps_component(terms, true, figures->factor * figures->below, "rho_g# c#",
                            "externally reflected component");
}

static void add_hidden_steps(struct pp_part_steps *terms,
                             const struct pp_patch_figures *figures,
                             const struct pp_sky *sky)
{
    struct sum_text formula = add_sky_terms(terms, figures, sky);
    pp_part_steps_figure(
        terms, PP_UNIT_DAYLIGHT_FACTOR, figures->above, "e", formula.text,
        formula.text[0] ? "equivalent sky component of the obstruction"
                        : "its equivalent sky component, by quadrature");
    bool below = figures->below != 0.0, own = figures->own != 0.0;
    if (below)
        pp_part_steps_read(terms, PP_UNIT_DAYLIGHT_FACTOR, figures->below, "b",
                           "hidden below the horizon, as bright as that");
    pp_part_steps_read(terms, PP_UNIT_NUMBER, figures->factor, "f",
                       "luminance factor of the obstruction");
    if (own)
        pp_part_steps_read(terms, PP_UNIT_DAYLIGHT_FACTOR, figures->own, "g",
                           "what it gives off by itself");
    pp_part_steps_component(
        terms, true, figures->factor * (figures->above + figures->below) + figures->own,
        below && own ? "f# (e# + b#) + g#"
        : below      ? "f# (e# + b#)"
        : own        ? "f# e# + g#"
                     : "f# e#",
        "externally reflected component");
}

void pp_direct_steps_add(struct pp_part_steps *terms,
                         const struct pp_patch_figures *figures,
                         const struct pp_sky *sky)
{
    bool nothing = !(figures->moments.omega > 1e-9) && figures->below == 0.0
                   && figures->own == 0.0;
    if (nothing)
        return;
    pp_part_steps_next(terms);
    if (figures->hidden)
        add_hidden_steps(terms, figures, sky);
    else
        add_sky_steps(terms, figures, sky);
}
