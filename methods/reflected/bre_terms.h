/* bre_terms.h - the BRE inter-reflection formula and its terms for one opening.
 *
 *     IRC = 0.85 W / (A (1 - R)) (C R_fw + 5 R_cw)   per cent   [HLP54], [BRE310]
 *
 *   W     net glass area (m2): opening area times frame factor
 *   A     area of all inside surfaces, openings included (m2)
 *   R     their area-weighted mean reflectance, openings with 0.1
 *   R_fw  mean reflectance of floor and walls below the middle of the opening's height
 *   R_cw  the same of ceiling and walls above it; both without the opening's own wall
 *   C     factor of the outside obstruction (per cent), obstruction.h
 *
 * As given in [GEEBELEN]. 5 per cent is the ground: reflectance 0.1, seen by half the
 * hemisphere. 0.85 is the diffuse transmittance of clear single glass. Several openings
 * add up, each with its own W, C, R_fw and R_cw and the common A and R; in R_fw and
 * R_cw the openings of the other walls count with 0.1.
 */
#ifndef PP_METHODS_REFLECTED_BRE_TERMS_H
#define PP_METHODS_REFLECTED_BRE_TERMS_H

#include "methods/allowance.h"
#include "methods/reflected/interior.h"
#include "model/results/steps.h"
#include "model/room/world.h"

/* Illuminance of a vertical window from the ground, over Eh, in the formula. */
#define PP_BRE_GROUND 0.05

struct pp_bre_terms {
    double W;               /* m2 */
    struct pp_interior all; /* A and R */
    double R_fw, R_cw;      /* reflectances */
    double alpha_rad;       /* of the obstruction */
    double C;               /* a fraction */
};

/* The terms of one vertical opening. */
enum pp_status pp_bre_terms(struct pp_bre_terms *terms, const struct pp_world *world,
                            const struct pp_opening *opening, struct pp_error *err);

/* The average internally reflected component by the formula, a fraction. */
double pp_bre_terms_average(const struct pp_bre_terms *terms);

/* C R_fw + 5 R_cw as a fraction, for any factor C (a fraction): the light after its
 * first reflection, over Eh and the glass. */
double pp_bre_terms_reflected(const struct pp_bre_terms *terms, double C);

/* Records R_fw, R_cw and C. steps may be NULL. */
void pp_bre_terms_reflected_steps(struct pp_steps *steps,
                                  const struct pp_bre_terms *terms,
                                  const struct pp_opening *opening);

/* Records all terms, and the average under `symbol`. steps may be NULL. */
void pp_bre_terms_steps(struct pp_steps *steps, const struct pp_bre_terms *terms,
                        const struct pp_opening *opening, const char *symbol);

#endif
