/* import_building.h - the command import for a gbXML file, which it converts to a room
 * file. */
#ifndef PP_CLI_RADIANCE_IMPORT_BUILDING_H
#define PP_CLI_RADIANCE_IMPORT_BUILDING_H

#include <stdbool.h>

#include "cli/exit_status.h"

/* True if the file begins like XML. False for standard input and for unreadable
 * files. */
bool pp_import_building_is(const char *file);

/* Writes the room file to `output` (NULL, "-": standard output). Missing and skipped
 * parts are reported on standard error, unless quiet. */
enum pp_exit pp_import_building_run(const char *file, const char *output, bool quiet);

#endif
