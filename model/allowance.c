/* allowance.c - see allowance.h. */
#include "model/allowance.h"

/* Diffuse transmittance of clear single glass in the reflected-component formulae. */
static const double printed_diffuse = 0.85;

/* G: diffuse transmittance over that of clear single glass. */
static double glass_type(const struct pp_glass *glass)
{
    return glass->diffuse / pp_glass_clear_single().diffuse;
}

double pp_allowance_reflected_glass(const struct pp_opening *opening)
{
    if (opening->glass.panes == 0)
        return 1.0;
    return printed_diffuse * glass_type(&opening->glass);
}

double pp_allowance_factor(unsigned allowances, const struct pp_opening *opening)
{
    double factor = 1.0;
    bool bare = opening->glass.panes == 0 && allowances & PP_ALLOWS_NO_GLASS;
    if (!(allowances & PP_ALLOWS_OWN_GLASS))
        factor *= pp_allowance_reflected_glass(opening);
    if (allowances & PP_ALLOWS_CLEAR_GLASS && !bare)
        factor /= printed_diffuse;
    if (!(allowances & PP_ALLOWS_FRAME))
        factor *= opening->frame_factor;
    if (!(allowances & PP_ALLOWS_DIRT))
        factor *= opening->maintenance;
    return factor;
}
