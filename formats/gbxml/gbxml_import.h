/* gbxml_import.h - a gbXML file [GBXML] as a room file.
 *
 * Spaces with openings become rooms: boxes as `plan`, all others as `envelope`, by the surfaces
 * about them or, where those do not close, by their ShellGeometry. Windows, skylights and
 * sliding doors to the outside become openings with the visible transmittance of their type;
 * shades, and the outside of spaces without a room, become surfaces. What is written has been
 * read as a room file before; what that refuses is left out.
 */
#ifndef PP_FORMATS_GBXML_GBXML_IMPORT_H
#define PP_FORMATS_GBXML_GBXML_IMPORT_H

#include <stdbool.h>
#include <stddef.h>

#include "model/base/error.h"
#include "model/base/mistakes.h"

/* Do the bytes look like XML, in UTF-8 or UTF-16? */
bool pp_gbxml_import_is_xml(const char *bytes, size_t length);

/* *xml: the room file, UTF-8, the caller's to free. file: what messages call the gbXML file.
 * notes: what was missing, with the default taken, and what was left out, by line. PP_BAD_INPUT
 * where it is no gbXML file, or no room comes of it. */
enum pp_status pp_gbxml_import(char **xml, size_t *length, const char *bytes,
                               size_t byte_count, const char *file,
                               struct pp_mistakes *notes, struct pp_error *err);

#endif
