/* xml_words.h - what the XML parser complains of, in words for people. */
#ifndef PP_MODEL_XML_WORDS_H
#define PP_MODEL_XML_WORDS_H

#include <libxml/xmlerror.h>
#include <stddef.h>

#include "model/xml_input.h"

/* Writes one sentence on the error to text. at_the_end: it came up where the file ends.
 * open: the innermost element that had not ended there, or NULL. */
void pp_xml_sentence(char *text, size_t size, const xmlError *error, bool at_the_end,
                     const struct pp_xml_element *open);

#endif
