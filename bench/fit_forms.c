/* fit_forms.c - the forms of methods/fitted/, and names of sources, shapes and terms
 * for the output. */
#include "bench/fit_forms.h"

const struct pp_fit_form pp_fit_forms_shipped[] = {
    {.name = "irc-atlas",
     .model = {.source = PP_FIT_SPHERE_NOW,
               .shape = PP_FIT_INSIDE,
               .power = 0.5,
               .side = PP_FIT_BESIDE_OPENING,
               .shade = PP_FIT_HALF_SHADE,
               .count = 2,
               .terms = {PP_FIT_PARTS, PP_FIT_REVEAL},
               .value = {1.6, 0.4, 1.4, 0.5}},
     .printed = PP_FIT_SPHERE,
     .constants = {"PP_FITTED_PARTS", "PP_FITTED_REVEAL"}},
    {.name = "bre-atlas",
     .model = {.source = PP_FIT_BRE_DOWN,
               .shade = PP_FIT_HALF_SHADE,
               .count = 3,
               .terms = {PP_FIT_UPPER, PP_FIT_PARTS, PP_FIT_SHALLOW}},
     .printed = PP_FIT_BRE,
     .constants = {"PP_FITTED_BRE_UPPER", "PP_FITTED_BRE_PARTS",
                   "PP_FITTED_BRE_SHALLOW"}},
    {.name = "split-flux-atlas",
     .model = {.source = PP_FIT_FLUX_ALL,
               .shade = PP_FIT_HALF_SHADE,
               .count = 1,
               .terms = {PP_FIT_LOW_LOST}},
     .printed = PP_FIT_FLUX,
     .constants = {"PP_FITTED_FLUX_LOW"}},
    {.name = "average-df-atlas",
     .model = {.source = PP_FIT_DF_NOW,
               .shade = PP_FIT_HALF_SHADE,
               .of_df = true,
               .count = 4,
               .terms = {PP_FIT_ONE, PP_FIT_REVEAL_ALWAYS, PP_FIT_FLOOR_AREA,
                         PP_FIT_GROUND}},
     .printed = PP_FIT_DF,
     .constants = {"PP_FITTED_DF", "PP_FITTED_DF_REVEAL", "PP_FITTED_DF_FLOOR",
                   "PP_FITTED_DF_UPWARD"}},
};
const int pp_fit_forms_count =
    sizeof pp_fit_forms_shipped / sizeof pp_fit_forms_shipped[0];

const char *const pp_fit_forms_sources[PP_FIT_SOURCES] = {
    [PP_FIT_BRE] = "bre",
    [PP_FIT_FLUX] = "split-flux",
    [PP_FIT_SPHERE] = "sphere",
    [PP_FIT_DF] = "average-df",
    [PP_FIT_SPHERE_NOW] = "sphere's balance with the light outside",
    [PP_FIT_BRE_NOW] = "bre with the light outside",
    [PP_FIT_FLUX_NOW] = "split-flux with the light outside",
    [PP_FIT_DF_NOW] = "average-df with the light outside",
    [PP_FIT_BRE_DOWN] = "bre with the light outside, as it comes down",
    [PP_FIT_FLUX_ALL] = "split-flux with the light outside, by 1 - R^2",
};

const char *const pp_fit_forms_shapes[PP_FIT_SHAPES] = {
    [PP_FIT_EVEN] = "even",
    [PP_FIT_EXPONENTIAL] = "exp",
    [PP_FIT_COSH] = "cosh",
    [PP_FIT_INSIDE] = "exp from inside",
};

const char *const pp_fit_forms_sides[PP_FIT_SIDES] = {
    [PP_FIT_ALIKE] = "alike from side to side",
    [PP_FIT_WALL] = "sideways by w_r",
    [PP_FIT_BESIDE_OPENING] = "sideways by w_r - w",
};

const char *const pp_fit_forms_shades[PP_FIT_SHADES] = {
    [PP_FIT_OWN_SHADE] = "two shades",
    [PP_FIT_ONE_SHADE] = "one shade",
    [PP_FIT_HALF_SHADE] = "the ground in half of it",
};

const char *const pp_fit_forms_ranges[PP_FIT_RANGES] = {
    [PP_FIT_SECTION] = "2 w h/(w + h)",
    [PP_FIT_ROOT] = "sqrt(w h)",
    [PP_FIT_HEIGHT] = "h",
};

const char *const pp_fit_forms_terms[PP_FIT_TERMS] = {
    [PP_FIT_ONE] = "constant",
    [PP_FIT_UPPER] = "rho_u",
    [PP_FIT_LOWER] = "rho_l",
    [PP_FIT_SKY] = "V/V0",
    [PP_FIT_ANGLE] = "1-alpha/90",
    [PP_FIT_PARTS] = "(A_l/A_u)^(1-R)",
    [PP_FIT_PARTS_ALWAYS] = "A_l/A_u",
    [PP_FIT_REVEAL] = "(1-R)reveal",
    [PP_FIT_REVEAL_ALWAYS] = "reveal",
    [PP_FIT_LOW] = "low",
    [PP_FIT_LOW_LOST] = "(1-R)low",
    [PP_FIT_FLOOR_AREA] = "A/A_f",
    [PP_FIT_GROUND] = "ground's-share",
    [PP_FIT_CEILING] = "ceiling",
    [PP_FIT_WALLS] = "walls",
    [PP_FIT_FLOOR] = "floor",
    [PP_FIT_MEAN] = "R",
    [PP_FIT_LOSS] = "exp(1-R)",
    [PP_FIT_DEEP] = "d_r/h_r",
    [PP_FIT_SHALLOW] = "(1+h_r/d_r)^(1-R)",
    [PP_FIT_BROAD] = "w_r/h_r",
    [PP_FIT_GLASS] = "Ag/A",
    [PP_FIT_SILL] = "sill/h_r",
    [PP_FIT_HEAD] = "head/h_r",
    [PP_FIT_PLACE] = "x/d_r",
    [PP_FIT_PLACE_LOST] = "(1-R)(x/d_r-1/2)",
    [PP_FIT_SQUARE] = "(x/d_r)^2",
    [PP_FIT_NEAR] = "1+(x/h_r)^2",
    [PP_FIT_ASIDE] = "y/w_r",
    [PP_FIT_BESIDE] = "beside/l",
};
