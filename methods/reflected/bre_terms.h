/* bre_terms.h - the BRE inter-reflection formula [HLP54], [BRE310] and its terms for
 * one opening.
 *
 * The formula is defined only here: `bre` evaluates it, `bre-min` divides it,
 * `bre-table` uses its last factor, and the nomograms represent it by scales. The
 * notation is that of [GEEBELEN]. The results for several openings are added. Each
 * opening has its own W, C, R_fw and R_cw; A and R are common to all. In R_fw and R_cw,
 * openings in the other walls have a reflectance of 0.1.
 */
#ifndef PP_METHODS_REFLECTED_BRE_TERMS_H
#define PP_METHODS_REFLECTED_BRE_TERMS_H

#include "methods/allowance.h"
#include "methods/reflected/interior.h"
#include "model/light/outside_light.h"
#include "model/results/worksheet.h"
#include "model/room/world.h"

/* Per cent of Eh: light on a vertical window from ground of reflectance 0.1, which
 * fills half of the hemisphere, after reflection by ceiling and upper walls. */
#define PP_BRE_TERMS_GROUND "5 R_cw"

/* Per cent; 0.85 is the diffuse transmittance of clear single glass. */
#define PP_BRE_TERMS_AVERAGE "0.85 W / (A (1 - R)) (C R_fw + " PP_BRE_TERMS_GROUND ")"

/* Quantities of the opening: rows of a formula's list. */
#define PP_BRE_TERMS_OPENING                                                           \
    {"W", PP_UNIT_SQUARE_METRE, "net glass area: opening area times frame factor"},    \
        {"R_fw", PP_UNIT_NUMBER,                                                       \
         "mean reflectance of the floor and of the walls below the centre of the "     \
         "opening, without the window wall"},                                          \
        {"R_cw", PP_UNIT_NUMBER,                                                       \
         "mean reflectance of the ceiling and of the walls above the centre, without " \
         "the window wall"},                                                           \
        {"alpha", PP_UNIT_ANGLE, "angle of the obstruction"},                          \
    {                                                                                  \
        "C", PP_UNIT_DAYLIGHT_FACTOR,                                                  \
            "factor C for this obstruction angle, from the table"                      \
    }

extern const struct pp_formula pp_bre_terms_irc;    /* formula of `bre` */
extern const struct pp_formula pp_bre_terms_IRC_av; /* the same formula, as a quantity
                                                     * of `bre-min` */

/* Reflectance of the ground in PP_BRE_TERMS_GROUND. */
#define PP_BRE_GROUND_REFLECTANCE 0.1

struct pp_bre_terms {
    double W;               /* net glass area (m2) */
    struct pp_interior all; /* A and R */
    double R_fw, R_cw;      /* reflectances */
    double alpha_rad;       /* angle of the obstruction */
    double C;               /* fraction, not per cent */
};

/* The terms of one vertical opening. */
enum pp_status pp_bre_terms(struct pp_bre_terms *terms, const struct pp_world *world,
                            const struct pp_outside_light *light,
                            const struct pp_opening *opening, struct pp_error *err);

/* Records R_fw, R_cw, alpha and C. */
void pp_bre_terms_put_reflected(struct pp_worksheet *sheet,
                                const struct pp_bre_terms *terms,
                                const struct pp_opening *opening);

/* Records all terms, evaluates the average by one of the formulae, and returns it (a
 * fraction). */
double pp_bre_terms_work(struct pp_worksheet *sheet, const struct pp_formula *formula,
                         const struct pp_bre_terms *terms,
                         const struct pp_opening *opening);

/* The average by these terms, a fraction, without recording steps. */
double pp_bre_terms_average(const struct pp_bre_terms *terms);

#endif
