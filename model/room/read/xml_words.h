/* xml_words.h - what the XML parser complains of, in words for people. */
#ifndef PP_MODEL_ROOM_READ_XML_WORDS_H
#define PP_MODEL_ROOM_READ_XML_WORDS_H

#include <libxml/xmlerror.h>
#include <stddef.h>

#include "model/room/read/xml.h"

/* Where in the file an error came up. */
struct pp_xml_place {
    const char *bytes; /* not owned */
    size_t length;
    size_t position;                   /* of the parser, up to length */
    const struct pp_xml_element *open; /* the innermost not ended there, or NULL */
};

/* Writes one sentence on the error to text. Returns where in the bytes its cause is to
 * be looked for: what has no end is named by its beginning. */
size_t pp_xml_words_sentence(char *text, size_t size, const xmlError *error,
                             const struct pp_xml_place *place);

#endif
