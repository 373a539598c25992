/* doctor_places.h - prints the folders of this installation, and the external programs
 * that can be used. Calculations do not need these files, since all tables are compiled
 * in. */
#ifndef PP_CLI_DOCTOR_DOCTOR_PLACES_H
#define PP_CLI_DOCTOR_DOCTOR_PLACES_H

#include <stdio.h>

/* Prints a line for each kind of file: " manual /usr/share/doc/pepperpot/docs". */
void pp_doctor_places_print(FILE *out);

/* Prints a line for each Radiance program that other commands can run. */
void pp_doctor_places_print_radiance(FILE *out);

/* Prints a label and a text, which is wrapped if necessary. */
void pp_doctor_places_line(const char *label, const char *text, FILE *out);

#endif
