/* printed_tables.h - compares published tables, cell by cell, with the formulae on
 * which they are based: the BRS simplified table for clear glass, BRE's obstruction
 * factors for the overcast sky, the table of minimum internally reflected components,
 * skies, and configuration factors. */
#ifndef PP_STUDIES_RESEARCH_VALIDATION_PRINTED_TABLES_H
#define PP_STUDIES_RESEARCH_VALIDATION_PRINTED_TABLES_H

#include "studies/research/validation/known_case.h"
#include "studies/research/validation/known_room.h"

/* Adds a case for each cell. Limits are the rounding of printed values, and the known
 * errors of the tables. */
enum pp_status pp_printed_tables(struct pp_known_cases *cases,
                                 const struct pp_known_trace *how,
                                 struct pp_error *err);

#endif
