/* doctor_places.h - prints where this installation's files are, and which external
 * programs can be used. Calculations need none of them: the tables are compiled in. */
#ifndef PP_CLI_DOCTOR_DOCTOR_PLACES_H
#define PP_CLI_DOCTOR_DOCTOR_PLACES_H

#include <stdio.h>

/* Prints a line for each place: "  manual       /usr/share/doc/pepperpot/docs". */
void pp_doctor_places_print(FILE *out);

/* Prints a line for each Radiance program that other commands run. */
void pp_doctor_places_print_radiance(FILE *out);

/* Prints a label and a text, wrapped into further lines. */
void pp_doctor_places_line(const char *label, const char *text, FILE *out);

#endif
