/* xml.h - an XML file as a tree of elements with their lines, read by libxml2.
 *
 * Comments and processing instructions are skipped. A DOCTYPE is a mistake, so a file
 * cannot declare entities; only the five of XML exist. No other file is opened.
 *
 * The limits of a format and those below restrict the time and memory that a hostile
 * file can take.
 */
#ifndef PP_MODEL_BASE_XML_H
#define PP_MODEL_BASE_XML_H

#include <stdbool.h>
#include <stddef.h>

#include "model/base/arena.h"
#include "model/base/error.h"
#include "model/base/mistakes.h"

enum {
    PP_XML_DEPTH_MOST = 64,      /* nesting depth; libxml2 rejects 256 */
    PP_XML_ATTRIBUTES_MOST = 64, /* attributes per element */
    /* Limit on the bytes of a tag, since the parser compares each attribute of a tag
     * with all others. */
    PP_XML_TAG_BYTES_MOST = 1 << 16
};

/* One kind of XML file. */
struct pp_xml_format {
    const char *file;     /* file type in messages: "room file" */
    const char *roots;    /* root element in messages: "a <room>" */
    size_t bytes_most;    /* below 1 GiB */
    int depth_most;       /* up to PP_XML_DEPTH_MOST */
    int elements_most;    /* total in a file */
    bool attributes_only; /* data are in attributes only: text, namespaces and
                           * encodings other than UTF-8 are mistakes */
};

struct pp_xml_attribute {
    const char *name, *value; /* name: without prefix */
    int line;                 /* line of the name */
};

struct pp_xml_element {
    const char *name; /* without prefix */
    const char *text; /* first text that is not white, without surrounding white
                       * space; NULL: none */
    int line;         /* line of its < */
    bool ended;
    struct pp_xml_attribute *attributes; /* without xmlns and xml:... */
    int attribute_count;
    const struct pp_xml_element *child; /* first child; NULL: none */
    const struct pp_xml_element *next;  /* next child of the parent; NULL: none */
};

/* Initialise with zeros. */
struct pp_xml {
    const struct pp_xml_element *root; /* NULL: none */
    bool whole; /* read to its end; else elements that are not `ended` may lack
                 * children */
    struct pp_arena memory; /* owns the whole tree */
};

/* Parses the bytes. Returns PP_OK even if there are mistakes; fails only if memory runs
 * out. On success the caller clears the tree. */
enum pp_status pp_xml_parse(struct pp_xml *xml, const char *bytes, size_t length,
                            const struct pp_xml_format *format,
                            struct pp_mistakes *mistakes, struct pp_error *err);
void pp_xml_clear(struct pp_xml *xml);

#endif
