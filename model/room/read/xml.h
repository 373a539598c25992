/* xml.h - an XML file as a small tree of elements with their lines. Inside model/room/
 * only.
 *
 * Only what a room file needs: elements and attributes. A DOCTYPE, namespaces, any
 * encoding but UTF-8, NUL bytes and text between the elements are mistakes; comments
 * and processing instructions are passed over. Nothing outside the bytes given is ever
 * read, and no entity is expanded but the five that XML itself has.
 *
 * The limits below make sure that a hostile file is refused in bounded time and memory.
 */
#ifndef PP_MODEL_ROOM_READ_XML_H
#define PP_MODEL_ROOM_READ_XML_H

#include <stdbool.h>
#include <stddef.h>

#include "model/base/arena.h"
#include "model/base/error.h"
#include "model/base/mistakes.h"

enum {
    PP_XML_BYTES_MOST = 8 << 20,    /* a file: 8 MiB */
    PP_XML_DEPTH_MOST = 8,          /* elements within elements */
    PP_XML_ELEMENTS_MOST = 200000,  /* in a file */
    PP_XML_ATTRIBUTES_MOST = 64,    /* of an element */
    PP_XML_TAG_BYTES_MOST = 1 << 16 /* from < to > */
};

struct pp_xml_attribute {
    const char *name, *value;
    int line; /* where its name stands */
};

struct pp_xml_element {
    const char *name;
    int line; /* where its < stands */
    bool ended;
    struct pp_xml_attribute *attributes;
    int attribute_count;
    const struct pp_xml_element *child; /* the first, or NULL */
    const struct pp_xml_element *next;  /* its parent's next child, or NULL */
};

struct pp_xml {
    const struct pp_xml_element *root; /* NULL where there is none */
    bool whole; /* read to its end; else elements that have not `ended` may lack
                 * children */
    struct pp_arena memory; /* of all of it */
};

/* PP_OK also where there are mistakes; fails when memory is out. On success the tree is
 * the caller's to destroy. */
enum pp_status pp_xml_parse(struct pp_xml *xml, const char *bytes, size_t length,
                            struct pp_mistakes *mistakes, struct pp_error *err);
void pp_xml_clear(struct pp_xml *xml);

#endif
