/* xml_bytes.h - checks of an XML file before it is parsed. Inside model/room/ only. */
#ifndef PP_MODEL_ROOM_READ_XML_BYTES_H
#define PP_MODEL_ROOM_READ_XML_BYTES_H

#include <stdbool.h>
#include <stddef.h>

#include "model/base/mistakes.h"

/* Notes the first fault that makes parsing the bytes useless or unsafe: another
 * encoding than UTF-8, a NUL byte, bytes that are not UTF-8, a tag of more than
 * PP_XML_TAG_BYTES_MOST (the parser's time for a tag grows with the square of its
 * attributes), nothing at all. True where there is no fault. */
bool pp_xml_bytes_sound(const char *bytes, size_t length, struct pp_mistakes *mistakes);

/* Behind the comment, CDATA section, processing instruction or tag that starts at p; `end`
 * where it has no end. */
const char *pp_xml_bytes_markup_end(const char *p, const char *end, bool *is_tag);

#endif
