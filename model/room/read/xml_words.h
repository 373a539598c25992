/* xml_words.h - the XML parser's errors in words for people. Inside model/room/
 * only. */
#ifndef PP_MODEL_ROOM_READ_XML_WORDS_H
#define PP_MODEL_ROOM_READ_XML_WORDS_H

#include <expat.h>
#include <stdbool.h>
#include <stddef.h>

#include "model/room/read/xml.h"

/* Where in the file an error came up. */
struct pp_xml_place {
    const char *bytes; /* not owned; what comes before the error is well-formed */
    size_t length;
    size_t position; /* of the first byte that is wrong, or of what has no end; up to
                      * length */
    bool begun;      /* the outermost element has */
    const struct pp_xml_element *open; /* the innermost not ended there, or NULL */
};

/* Writes one sentence on the error to text. Returns the place of its cause in the
 * bytes: of a quotation, comment or tag without an end, its beginning. */
size_t pp_xml_words_sentence(char *text, size_t size, enum XML_Error error,
                             const struct pp_xml_place *place);

#endif
