/* basis_clauses.h - the bases of one criterion in several rooms: sentences without a
 * full stop, of clauses separated by "; ". A clause "level reached: NAME" has a column
 * of its own in the tables, so the first two functions omit it. For use inside
 * reports/page/ only. */
#ifndef PP_REPORTS_PAGE_BASIS_CLAUSES_H
#define PP_REPORTS_PAGE_BASIS_CLAUSES_H

#include <stdbool.h>

enum { PP_BASIS_CLAUSES = 640 }; /* bytes, as in struct pp_finding_list */

/* Label of the clause with the level, and heading of its column. */
#define PP_BASIS_LEVEL "level reached"

/* Writes the clauses that all `count` bases contain. */
void pp_basis_clauses_common(char text[PP_BASIS_CLAUSES], const char *const *bases,
                             int count);

/* Writes the clauses of basis `index` that some other basis does not contain. */
void pp_basis_clauses_own(char text[PP_BASIS_CLAUSES], const char *const *bases,
                          int count, int index);

/* Writes the level that the basis names; false: it names none. */
bool pp_basis_clauses_level(char text[PP_BASIS_CLAUSES], const char *basis);

#endif
