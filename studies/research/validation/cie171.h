/* cie171.h - daylight cases 5.9 to 5.14 of CIE 171 [CIE171]: roof and facade openings
 * with and without glass, a canopy, and a building opposite, under all sixteen skies.
 *
 * The glass in cases 5.10 and 5.12 of the report is 6 mm clear glass. Its transmittance
 * is a polynomial in the cosine of the angle of incidence [TS93]. The simulation uses
 * clear single glass instead, and is compared with `exact` for this glass.
 */
#ifndef PP_STUDIES_RESEARCH_VALIDATION_CIE171_H
#define PP_STUDIES_RESEARCH_VALIDATION_CIE171_H

#include "studies/research/validation/known_case.h"
#include "studies/research/validation/known_room.h"

/* Adds up to three cases for each value: `exact` against an independent integration;
 * `exact` against the printed value, if that is sound; and the simulation against
 * `exact`, within `std_errors` standard errors. how = NULL: no simulation. */
enum pp_status pp_cie171(struct pp_known_cases *cases, const struct pp_known_trace *how,
                         double std_errors, struct pp_error *err);

#endif
