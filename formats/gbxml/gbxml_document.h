/* gbxml_document.h - a gbXML file as a tree of elements, with access by name. Inside
 * formats/gbxml/ only.
 *
 * Namespaces are ignored.
 */
#ifndef PP_FORMATS_GBXML_GBXML_DOCUMENT_H
#define PP_FORMATS_GBXML_GBXML_DOCUMENT_H

#include <stdbool.h>
#include <stddef.h>

#include "model/base/xml.h"

enum { PP_GBXML_BYTES_MOST = 64 << 20 };

/* Parses the bytes, in UTF-8, UTF-16 or the encoding that the file declares. `file` is
 * its name in messages. PP_BAD_INPUT if they are not well-formed XML, exceed a limit,
 * or have a root other than gbXML. On success the caller clears the document with
 * pp_xml_clear. */
enum pp_status pp_gbxml_document_parse(struct pp_xml *document, const char *bytes,
                                       size_t length, const char *file,
                                       struct pp_error *err);

/* The first child element of that name, or the next one after `before`; NULL: none. */
const struct pp_xml_element *pp_gbxml_document_child(
    const struct pp_xml_element *parent, const char *name);
const struct pp_xml_element *pp_gbxml_document_next(const struct pp_xml_element *before,
                                                    const char *name);

/* Descends by child names separated by slashes; NULL if one does not exist. */
const struct pp_xml_element *pp_gbxml_document_path(const struct pp_xml_element *from,
                                                    const char *path);

/* Value of an attribute, valid as long as the document; NULL if there is none. */
const char *pp_gbxml_document_attribute(const struct pp_xml_element *element,
                                        const char *name);

/* Text of an element; NULL if it has none or `element` is NULL. */
const char *pp_gbxml_document_text(const struct pp_xml_element *element);

/* Reads the element's text as a number; false for other text, or a NULL element. */
bool pp_gbxml_document_number(const struct pp_xml_element *element, double *value);

#endif
