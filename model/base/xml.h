/* xml.h - an XML file as a tree of elements with their lines, read by libxml2.
 *
 * Comments and processing instructions are skipped. A DOCTYPE is a mistake, so a file
 * declares no entities and only XML's own five exist. No other file is opened.
 *
 * The limits of a format and those below bound the time and memory that a hostile file
 * can cost.
 */
#ifndef PP_MODEL_BASE_XML_H
#define PP_MODEL_BASE_XML_H

#include <stdbool.h>
#include <stddef.h>

#include "model/base/arena.h"
#include "model/base/error.h"
#include "model/base/mistakes.h"

enum {
    PP_XML_DEPTH_MOST = 64,      /* elements within elements; libxml2 refuses 256 */
    PP_XML_ATTRIBUTES_MOST = 64, /* of an element */
    /* Most bytes from < to >. The parser compares each attribute of a tag with all
     * others. */
    PP_XML_TAG_BYTES_MOST = 1 << 16
};

/* One kind of XML file. */
struct pp_xml_format {
    const char *file;     /* its name in messages: "room file" */
    const char *roots;    /* its outermost element, in messages: "a <room>" */
    size_t bytes_most;    /* below 1 GiB */
    int depth_most;       /* up to PP_XML_DEPTH_MOST */
    int elements_most;    /* in a file */
    bool attributes_only; /* no data are in text: text, namespaces and encodings other
                           * than UTF-8 are mistakes */
};

struct pp_xml_attribute {
    const char *name, *value; /* the name without its prefix */
    int line;                 /* of its name */
};

struct pp_xml_element {
    const char *name; /* without its prefix */
    const char *text; /* the first that is not white, without white space round it; NULL
                       * where there is none */
    int line;         /* of its < */
    bool ended;
    struct pp_xml_attribute *attributes; /* without xmlns and xml:... */
    int attribute_count;
    const struct pp_xml_element *child; /* the first, or NULL */
    const struct pp_xml_element *next;  /* its parent's next child, or NULL */
};

/* Zeroed at first. */
struct pp_xml {
    const struct pp_xml_element *root; /* NULL where there is none */
    bool whole; /* read to its end; else elements that have not `ended` may lack
                 * children */
    struct pp_arena memory; /* of all of it */
};

/* PP_OK also where there are mistakes; fails when memory is out. On success the caller
 * clears the tree. */
enum pp_status pp_xml_parse(struct pp_xml *xml, const char *bytes, size_t length,
                            const struct pp_xml_format *format,
                            struct pp_mistakes *mistakes, struct pp_error *err);
void pp_xml_clear(struct pp_xml *xml);

#endif
