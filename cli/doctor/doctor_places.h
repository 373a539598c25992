/* doctor_places.h - where this installation has its files, and which programs it can
 * use. None of them is needed to calculate: tables are compiled in.
 */
#ifndef PP_CLI_DOCTOR_DOCTOR_PLACES_H
#define PP_CLI_DOCTOR_DOCTOR_PLACES_H

#include <stdio.h>

/* Prints a line for each: "  manual       /usr/share/doc/pepperpot/docs". */
void pp_doctor_places_print(FILE *out);

/* Prints a line for each of Radiance's programs that other commands run. */
void pp_doctor_places_print_radiance(FILE *out);

/* One line: a label, and a text that goes on in further lines. */
void pp_doctor_places_line(const char *label, const char *text, FILE *out);

#endif
