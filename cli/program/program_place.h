/* program_place.h - paths of programs and of temporary files. */
#ifndef PP_CLI_PROGRAM_PROGRAM_PLACE_H
#define PP_CLI_PROGRAM_PROGRAM_PLACE_H

#include <stdbool.h>
#include <stddef.h>

/* The folder of the running program, ending in '/'; empty if unknown. */
void pp_program_place_own(char *folder, size_t room);

/* Finds a program that is in PATH and executable by this user. False: there is none,
 * and path is "". */
bool pp_program_place_on_path(const char *program, char *path, size_t room);

/* Folder for temporary files: TMPDIR, else /tmp. */
const char *pp_program_place_temporary(void);

#endif
