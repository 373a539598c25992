/* xml_text.h - the bytes of an XML file as UTF-8 that is safe to parse. */
#ifndef PP_MODEL_BASE_XML_TEXT_H
#define PP_MODEL_BASE_XML_TEXT_H

#include <stddef.h>

#include "model/base/error.h"
#include "model/base/mistakes.h"
#include "model/base/xml.h"

struct pp_xml_text {
    const char *bytes; /* valid UTF-8 without NUL; NULL where there is a mistake */
    size_t length;
    const char *unended; /* the tag, comment, CDATA section or processing instruction
                          * that has no end; NULL where all have one */
    char *converted;     /* holds the bytes if they are not the file's own */
};

/* Reports the first mistake that makes parsing useless or slow: a wrong or unknown
 * encoding, a NUL byte, a tag of more than PP_XML_TAG_BYTES_MOST, an empty file. The
 * encoding is that of the byte order mark, else the declared one. UTF-8 that is
 * declared as UTF-16, as saved by some editors, is read as UTF-8. The text refers to
 * `bytes`. Fails if out of memory. */
enum pp_status pp_xml_text_read(struct pp_xml_text *text, const char *bytes,
                                size_t length, const struct pp_xml_format *format,
                                struct pp_mistakes *mistakes, struct pp_error *err);
void pp_xml_text_clear(struct pp_xml_text *text);

/* The line of a place in the text. */
int pp_xml_text_line(const struct pp_xml_text *text, const char *at);

#endif
