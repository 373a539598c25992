/* program_place.h - paths of programs and of temporary files. */
#ifndef PP_CLI_PROGRAM_PROGRAM_PLACE_H
#define PP_CLI_PROGRAM_PROGRAM_PLACE_H

#include <stdbool.h>
#include <stddef.h>

/* Writes the folder of the running program, ending in '/'; "" if it is unknown. */
void pp_program_place_own(char *folder, size_t room);

/* Finds a program in PATH that this user can execute. Returns false and sets `path` to
 * "" if there is none. */
bool pp_program_place_on_path(const char *program, char *path, size_t room);

/* Folder for temporary files: TMPDIR if set, else /tmp. */
const char *pp_program_place_temporary(void);

#endif
