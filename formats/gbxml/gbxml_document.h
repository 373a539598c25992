/* gbxml_document.h - a gbXML file as a tree of elements, and these by name. Inside
 * formats/gbxml/ only.
 *
 * Namespaces are passed over. A DOCTYPE is refused, so that a file can declare no entities;
 * nothing outside of it is read.
 */
#ifndef PP_FORMATS_GBXML_GBXML_DOCUMENT_H
#define PP_FORMATS_GBXML_GBXML_DOCUMENT_H

#include <stdbool.h>
#include <stddef.h>

#include "model/base/arena.h"
#include "model/base/error.h"

enum { PP_GBXML_BYTES_MOST = 64 << 20 };

struct pp_gbxml_element {
    const char *name; /* without its prefix */
    const char
        *text; /* the first that is not white, without white space about it; NULL */
    int line;  /* where its < stands */
    int attribute_count;
    const char **attributes; /* names without prefixes, and values, by turns */
    struct pp_gbxml_element *parent, *child, *newest, *next; /* NULL: none */
};

/* Zeroed at first. */
struct pp_gbxml_document {
    const struct pp_gbxml_element *root;
    struct pp_arena memory; /* of all of it */
};

/* Parses the bytes, in UTF-8, UTF-16 or what the file says; file: what messages call it. The
 * root is a gbXML element. On success the document is the caller's to clear. */
enum pp_status pp_gbxml_document_parse(struct pp_gbxml_document *document,
                                       const char *bytes, size_t length,
                                       const char *file, struct pp_error *err);
void pp_gbxml_document_clear(struct pp_gbxml_document *document);

/* The first child element of that name, or the next one after `before`; NULL: none. */
const struct pp_gbxml_element *pp_gbxml_document_child(
    const struct pp_gbxml_element *parent, const char *name);
const struct pp_gbxml_element *pp_gbxml_document_next(
    const struct pp_gbxml_element *before, const char *name);

/* The child of the child ... by names with slashes between; NULL: none. */
const struct pp_gbxml_element *pp_gbxml_document_path(
    const struct pp_gbxml_element *from, const char *path);

/* The value of an attribute, good as long as the document; NULL where there is none. */
const char *pp_gbxml_document_attribute(const struct pp_gbxml_element *element,
                                        const char *name);

/* An element's text; NULL where there is none, and of NULL. */
const char *pp_gbxml_document_text(const struct pp_gbxml_element *element);

/* The number that an element's text is; false for anything else, and NULL. */
bool pp_gbxml_document_number(const struct pp_gbxml_element *element, double *value);

#endif
