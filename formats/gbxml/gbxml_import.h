/* gbxml_import.h - a gbXML file [GBXML] as a room file.
 *
 * Spaces with openings become rooms: boxes as `plan`, all others as `envelope`
 * (gbxml_envelope.h). Windows, skylights, sliding and glazed doors and air openings to
 * the outside become openings. Shades, and the outer surfaces of spaces without a room,
 * become surfaces. The output is parsed as a room file before it is returned; rejected
 * parts are left out.
 */
#ifndef PP_FORMATS_GBXML_GBXML_IMPORT_H
#define PP_FORMATS_GBXML_GBXML_IMPORT_H

#include <stdbool.h>
#include <stddef.h>

#include "model/base/error.h"
#include "model/base/mistakes.h"

/* True if the bytes look like XML, in UTF-8 or UTF-16. */
bool pp_gbxml_import_is_xml(const char *bytes, size_t length);

/* Converts a gbXML file. *xml: the room file in UTF-8, freed by the caller. `file`:
 * name of the gbXML file in messages. notes: missing data, with the default used, and
 * skipped parts, by line. PP_BAD_INPUT if it is not a gbXML file, or gives no room. */
enum pp_status pp_gbxml_import(char **xml, size_t *length, const char *bytes,
                               size_t byte_count, const char *file,
                               struct pp_mistakes *notes, struct pp_error *err);

#endif
