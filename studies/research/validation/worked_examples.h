/* worked_examples.h - compares the program with small rooms calculated by hand, and
 * with protractors whose scales are known in closed form. */
#ifndef PP_STUDIES_RESEARCH_VALIDATION_WORKED_EXAMPLES_H
#define PP_STUDIES_RESEARCH_VALIDATION_WORKED_EXAMPLES_H

#include "studies/research/validation/known_case.h"

/* Adds the cases. Each expected value is correct to its last printed digit. */
enum pp_status pp_worked_examples(struct pp_known_cases *cases, struct pp_error *err);

#endif
