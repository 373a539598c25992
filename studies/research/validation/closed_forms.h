/* closed_forms.h - compares the program with closed forms and limits: open skies,
 * rectangles, glass, the integrating sphere, configuration factors. Every digit of an
 * expected value is correct. */
#ifndef PP_STUDIES_RESEARCH_VALIDATION_CLOSED_FORMS_H
#define PP_STUDIES_RESEARCH_VALIDATION_CLOSED_FORMS_H

#include "studies/research/validation/known_case.h"
#include "studies/research/validation/known_room.h"

/* Adds the cases: for hand methods, and for the simulation within four standard
 * errors. */
enum pp_status pp_closed_forms(struct pp_known_cases *cases,
                               const struct pp_known_trace *how, struct pp_error *err);

#endif
