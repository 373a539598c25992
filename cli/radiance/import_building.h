/* import_building.h - the command import of a gbXML file: a room file. */
#ifndef PP_CLI_RADIANCE_IMPORT_BUILDING_H
#define PP_CLI_RADIANCE_IMPORT_BUILDING_H

#include <stdbool.h>

#include "cli/exit_status.h"

/* Does the file begin as XML does? Standard input, and what cannot be read, do not. */
bool pp_import_building_is(const char *file);

/* Writes the room file to `output` (NULL, "-": standard output); what was missing or left out
 * goes to standard error, unless quiet. */
enum pp_exit pp_import_building_run(const char *file, const char *output, bool quiet);

#endif
