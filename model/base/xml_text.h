/* xml_text.h - converts the bytes of an XML file to UTF-8 that is safe to parse. */
#ifndef PP_MODEL_BASE_XML_TEXT_H
#define PP_MODEL_BASE_XML_TEXT_H

#include <stddef.h>

#include "model/base/error.h"
#include "model/base/mistakes.h"
#include "model/base/xml.h"

struct pp_xml_text {
    const char *bytes; /* valid UTF-8 without NUL; NULL after a mistake */
    size_t length;
    const char *unended; /* first tag, comment, CDATA section or processing
                          * instruction without an end; NULL: none */
    char *converted;     /* owned bytes, if converted; else NULL */
};

/* Checks and converts the bytes. Reports the first mistake that makes parsing useless
 * or slow: too many bytes, a wrong or unknown encoding, a NUL byte, a tag of more than
 * PP_XML_TAG_BYTES_MOST, an empty file. The encoding is given by the byte order mark,
 * or else by the declaration. UTF-8 that declares itself as UTF-16, as saved by some
 * editors, is read as UTF-8. The text refers to `bytes`. Fails only if memory runs
 * out. */
enum pp_status pp_xml_text_read(struct pp_xml_text *text, const char *bytes,
                                size_t length, const struct pp_xml_format *format,
                                struct pp_mistakes *mistakes, struct pp_error *err);
void pp_xml_text_clear(struct pp_xml_text *text);

/* Line of a position in the text. */
int pp_xml_text_line(const struct pp_xml_text *text, const char *at);

#endif
