/* direct_steps.c - see direct_steps.h.
 *
 * Where the sky has a closed form, its light without glass is worked out of the moments
 * of what is seen of it (solid_angle.h); the glass is then its mean transmittance over
 * that. Elsewhere what is found is the value of an integral, which has no shorter sum.
 */
#include "methods/exact/direct_steps.h"

#include <math.h>

/* Sets down a figure of this part that was read. */
static void read(const struct pp_part_steps *terms, enum pp_step_unit unit,
                 double value, const char *name, const char *what)
{
    pp_steps_add_named(terms->steps, unit, value,
                       pp_part_steps_symbol(terms, name).text, "%s", what);
}

/* The formula of the sky's light without glass. */
static const char *closed_form(const struct pp_sky *sky)
{
    return sky->kind == PP_SKY_UNIFORM ? "100 E_0# / 3.141592653590"
                                       : "300 (E_0# + 2 E_1#) / (7 * 3.141592653590)";
}

/* Sets down what leads to the sky's light; returns the formula that it is then worked
 * out by, "" where it is an integral. */
static const char *lead(struct pp_part_steps *terms,
                        const struct pp_patch_figures *figures,
                        const struct pp_sky *sky)
{
    const struct pp_moments *moments = &figures->moments;
    read(terms, PP_UNIT_NUMBER, moments->omega, "omega",
         figures->hidden ? "solid angle of the sky that is hidden, sr"
                         : "solid angle of the sky that is seen, sr");
    if (!figures->closed_form)
        return "";
    read(terms, PP_UNIT_NUMBER, moments->cosine, "E_0",
         "its integral of the cosine at the receiver");
    if (sky->kind != PP_SKY_UNIFORM)
        read(terms, PP_UNIT_NUMBER, moments->cosine_sine, "E_1",
             "the same, times the sine of the altitude");
    double bare = pp_solid_angle_sky_component(moments, sky);
    if (!figures->glazed || !(bare > 0.0))
        return closed_form(sky);
    pp_part_steps_figure(terms, PP_UNIT_SHARE, bare, "s", closed_form(sky),
                         "that sky without glass, in closed form");
    read(terms, PP_UNIT_NUMBER, figures->above / bare, "t",
         "mean transmittance over it, by quadrature");
    return "s# t#";
}

static void set_down_sky(struct pp_part_steps *terms,
                         const struct pp_patch_figures *figures,
                         const struct pp_sky *sky)
{
    const char *formula = lead(terms, figures, sky);
    pp_part_steps_component(terms, false, figures->above, formula,
                            formula[0] ? "sky component"
                                       : "sky component, an integral, by quadrature");
    if (figures->below == 0.0)
        return;
    read(terms, PP_UNIT_SHARE, figures->below, "c",
         "ground that is seen, for a reflectance of 1");
    read(terms, PP_UNIT_NUMBER, figures->factor, "rho_g", "reflectance of the ground");
    pp_part_steps_component(terms, true, figures->factor * figures->below, "rho_g# c#",
                            "externally reflected component");
}

static void set_down_hidden(struct pp_part_steps *terms,
                            const struct pp_patch_figures *figures,
                            const struct pp_sky *sky)
{
    const char *formula = lead(terms, figures, sky);
    pp_part_steps_figure(terms, PP_UNIT_SHARE, figures->above, "e", formula,
                         formula[0] ? "equivalent sky component of the obstruction"
                                    : "its equivalent sky component, by quadrature");
    bool below = figures->below != 0.0, own = figures->own != 0.0;
    if (below)
        read(terms, PP_UNIT_SHARE, figures->below, "b",
             "hidden below the horizon, as bright as that");
    read(terms, PP_UNIT_NUMBER, figures->factor, "f",
         "luminance factor of the obstruction");
    if (own)
        read(terms, PP_UNIT_SHARE, figures->own, "g", "what it gives off by itself");
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
        set_down_hidden(terms, figures, sky);
    else
        set_down_sky(terms, figures, sky);
}
