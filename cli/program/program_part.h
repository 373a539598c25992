/* program_part.h - where a part of the program is that is a file of its own. */
#ifndef PP_CLI_PROGRAM_PROGRAM_PART_H
#define PP_CLI_PROGRAM_PROGRAM_PART_H

#include "cli/program/part_folders.h" /* made by make: PP_MODULE_FOLDER, PP_PROGRAM_FOLDER */

enum { PP_PROGRAM_PART_PATH = 4096 };

/* Where the program was built, in the folder `built` (ending in '/', or "") beside the one
 * that runs, if it is there; else where it is installed. */
void pp_program_part(char path[PP_PROGRAM_PART_PATH], const char *built,
                     const char *installed, const char *name);

#endif
