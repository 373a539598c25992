/* cie171.h - the daylight cases of CIE 171, 5.9 to 5.14: unglazed and glazed roof and
 * facade openings, a canopy, a building opposite, under all sixteen skies [CIE171].
 *
 * The glass of 5.10 and 5.12 is the 6 mm clear glass of the report, a polynomial in the
 * cosine [TS93]; traced it is clear single glass, and compared with `exact` through that.
 */
#ifndef PP_STUDIES_RESEARCH_VALIDATION_CIE171_H
#define PP_STUDIES_RESEARCH_VALIDATION_CIE171_H

#include "studies/research/validation/known_case.h"
#include "studies/research/validation/known_room.h"

/* Adds up to three cases per value: `exact` against the independent integration; if the
 * printed figure is sound, `exact` against that; and the simulation against `exact`,
 * within `std_errors` of its standard errors. how NULL: nothing is simulated. */
enum pp_status pp_cie171(struct pp_known_cases *cases, const struct pp_known_trace *how,
                         double std_errors, struct pp_error *err);

#endif
