/* gbxml_document.h - a gbXML file as libxml2's tree, and its elements by name. Inside
 * formats/gbxml/ only (the files there that know libxml2).
 *
 * Namespaces are passed over. A DOCTYPE is refused, so that a file can declare no entities;
 * nothing outside of it is read.
 */
#ifndef PP_FORMATS_GBXML_GBXML_DOCUMENT_H
#define PP_FORMATS_GBXML_GBXML_DOCUMENT_H

#include <libxml/tree.h>
#include <stdbool.h>
#include <stddef.h>

#include "model/base/error.h"

enum { PP_GBXML_BYTES_MOST = 64 << 20 };

/* Parses the bytes, in UTF-8, UTF-16 or what the file says; file: what messages call it. The
 * root is a gbXML element. */
enum pp_status pp_gbxml_document_parse(xmlDocPtr *document, const char *bytes,
                                       size_t length, const char *file,
                                       struct pp_error *err);

/* The first child element of that name, or the next one after `before`; NULL: none. */
xmlNodePtr pp_gbxml_document_child(xmlNodePtr parent, const char *name);
xmlNodePtr pp_gbxml_document_next(xmlNodePtr before, const char *name);

/* The child of the child ... by names with slashes between; NULL: none. */
xmlNodePtr pp_gbxml_document_path(xmlNodePtr from, const char *path);

/* The value of an attribute, the text of an element (without white space about it), good as
 * long as the document; NULL where there is none. */
const char *pp_gbxml_document_attribute(xmlNodePtr element, const char *name);
const char *pp_gbxml_document_text(xmlNodePtr element);

/* The number that an element's text is; false for anything else, and NULL. */
bool pp_gbxml_document_number(xmlNodePtr element, double *value);

/* From 1; 0: not known. */
int pp_gbxml_document_line(xmlNodePtr element);

#endif
