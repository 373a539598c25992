/* printed_tables.h - compares published tables, cell by cell, with the formulae behind
 * them: the BRS simplified table with clear glass, BRE's obstruction factors with the
 * overcast sky, the least internally reflected component with its formula, skies and
 * configuration factors. */
#ifndef PP_STUDIES_RESEARCH_VALIDATION_PRINTED_TABLES_H
#define PP_STUDIES_RESEARCH_VALIDATION_PRINTED_TABLES_H

#include "studies/research/validation/known_case.h"
#include "studies/research/validation/known_room.h"

/* Adds a case for each cell. Limits are the rounding of printed values, and the known
 * errors of the makers of the table. */
enum pp_status pp_printed_tables(struct pp_known_cases *cases,
                                 const struct pp_known_trace *how,
                                 struct pp_error *err);

#endif
