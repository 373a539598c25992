/* import_building.h - the command import for a gbXML file: converts the file to a room
 * file. */
#ifndef PP_CLI_RADIANCE_IMPORT_BUILDING_H
#define PP_CLI_RADIANCE_IMPORT_BUILDING_H

#include <stdbool.h>

#include "cli/exit_status.h"

/* True if the content of the file is XML. False for standard input and for unreadable
 * files. */
bool pp_import_building_is(const char *file);

/* Writes the room file to `output` (NULL or "-": standard output). Missing and omitted
 * parts are reported on standard error, unless `quiet` is set. */
enum pp_exit pp_import_building_run(const char *file, const char *output, bool quiet);

#endif
