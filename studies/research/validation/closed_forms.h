/* closed_forms.h - cases that compare the program with closed forms and limits: open
 * skies, rectangles, glass, the integrating sphere, configuration factors. Expected
 * values are right to the digits printed here. */
#ifndef PP_STUDIES_RESEARCH_VALIDATION_CLOSED_FORMS_H
#define PP_STUDIES_RESEARCH_VALIDATION_CLOSED_FORMS_H

#include "studies/research/validation/known_case.h"
#include "studies/research/validation/known_room.h"

/* Adds the cases: by hand methods, and traced within four standard errors. */
enum pp_status pp_closed_forms(struct pp_known_cases *cases,
                               const struct pp_known_trace *how, struct pp_error *err);

#endif
