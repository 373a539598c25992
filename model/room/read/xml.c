/* xml.c - see xml.h. */
#include "model/room/read/xml.h"

#include <libxml/parser.h>
#include <libxml/parserInternals.h>
#include <libxml/SAX2.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/text.h"
#include "model/room/read/xml_bytes.h"
#include "model/room/read/xml_words.h"

/* The tree's memory: blocks that are freed together. */
struct pp_xml_block {
    struct pp_xml_block *next;
    size_t used, size;
    _Alignas(max_align_t) char bytes[];
};

enum { BLOCK_BYTES = 1 << 16 };

static void *take(struct pp_xml *xml, size_t size)
{
    size = (size + sizeof(max_align_t) - 1) / sizeof(max_align_t) * sizeof(max_align_t);
    struct pp_xml_block *block = xml->blocks;
    if (!block || block->size - block->used < size) {
        size_t bytes = size > BLOCK_BYTES ? size : BLOCK_BYTES;
        block = malloc(sizeof *block + bytes);
        if (!block)
            return NULL;
        *block = (struct pp_xml_block){.next = xml->blocks, .size = bytes};
        xml->blocks = block;
    }
    void *taken = block->bytes + block->used;
    block->used += size;
    return taken;
}

static const char *take_text(struct pp_xml *xml, const xmlChar *text, size_t length)
{
    char *copy = take(xml, length + 1);
    if (copy) {
        memcpy(copy, text, length);
        copy[length] = '\0';
    }
    return copy;
}

void pp_xml_clear(struct pp_xml *xml)
{
    while (xml->blocks) {
        struct pp_xml_block *next = xml->blocks->next;
        free(xml->blocks);
        xml->blocks = next;
    }
    *xml = (struct pp_xml){0};
}

/* The state that the parser's callbacks share. */
struct xml_builder {
    struct pp_xml *xml;
    xmlParserCtxtPtr parser;
    struct pp_mistakes *mistakes;
    const char *bytes;
    size_t length;

    struct pp_xml_element *open[PP_XML_DEPTH_MOST];       /* from the root down */
    struct pp_xml_element *newest[PP_XML_DEPTH_MOST + 1]; /* last child at each depth */
    int depth;
    int elements;

    size_t counted; /* bytes[0 .. counted) hold line - 1 line ends */
    int line;

    bool stopped; /* a limit was passed or the file is broken, which has been noted */
    bool out_of_memory;
    bool text_noted;      /* since the last tag */
    bool bad_namespace;   /* of the element that comes */
    bool namespace_noted; /* in the file */
};

static void stop(struct xml_builder *b)
{
    b->stopped = true;
    xmlStopParser(b->parser);
}

/* The line of a byte. Counts on from the last one asked for, so go forward. */
static int line_at(struct xml_builder *b, size_t offset)
{
    if (offset < b->counted) {
        b->counted = 0;
        b->line = 1;
    }
    for (; b->counted < offset; b->counted++)
        b->line += b->bytes[b->counted] == '\n';
    return b->line;
}

/* Where the parser stands. */
static size_t position(const struct xml_builder *b)
{
    long consumed = xmlByteConsumed(b->parser);
    if (consumed < 0)
        return 0;
    return (size_t)consumed < b->length ? (size_t)consumed : b->length;
}

/* The < of the start tag that the parser has just read: a well-formed tag holds no
 * other. */
static size_t tag_start(const struct xml_builder *b)
{
    size_t p = position(b);
    while (p > 0 && (p == b->length || b->bytes[p] != '<'))
        p--;
    return p;
}

static bool is_white(char c)
{
    return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

/* The name of the next attribute behind p, in a well-formed tag; *next is behind its
 * value. */
static const char *next_attribute(const char *p, const char *end, const char **next)
{
    while (p < end && is_white(*p))
        p++;
    const char *open = p;
    while (open < end && *open != '"' && *open != '\'')
        open++;
    const char *close =
        open < end ? memchr(open + 1, *open, (size_t)(end - open - 1)) : NULL;
    *next = close ? close + 1 : end;
    return p;
}

/* Does xmlns="..." or xmlns:p="..." stand there? */
static bool is_declaration(const char *p, const char *end)
{
    return end - p > 5 && memcmp(p, "xmlns", 5) == 0
           && (p[5] == ':' || p[5] == '=' || is_white(p[5]));
}

/* Copies the attributes, each with the line of its name in the tag at `start`. Prefixes
 * have been complained of and are dropped; xml:lang and its like could be no others. */
static bool take_attributes(struct xml_builder *b, struct pp_xml_element *element,
                            int count, const xmlChar **attributes, size_t start)
{
    element->attributes = take(b->xml, (size_t)count * sizeof *element->attributes);
    if (!element->attributes)
        return false;
    const char *p = b->bytes + start, *end = b->bytes + b->length;
    while (p < end && !is_white(*p) && *p != '>')
        p++;
    for (int i = 0; i < count; i++) {
        const xmlChar **from = attributes + 5 * i;
        const char *name = next_attribute(p, end, &p);
        while (is_declaration(name, end))
            name = next_attribute(p, end, &p); /* the parser keeps it to itself */
        if (from[1] && xmlStrEqual(from[1], BAD_CAST "xml"))
            continue;
        struct pp_xml_attribute *taken =
            &element->attributes[element->attribute_count++];
        taken->line = line_at(b, (size_t)(name - b->bytes));
        taken->name = take_text(b->xml, from[0], strlen((const char *)from[0]));
        taken->value = take_text(b->xml, from[3], (size_t)(from[4] - from[3]));
        if (!taken->name || !taken->value)
            return false;
    }
    return true;
}

static bool within_limits(struct xml_builder *b, int attribute_count, int line)
{
    if (b->depth == PP_XML_DEPTH_MOST)
        pp_mistakes_add(b->mistakes, line,
                        "elements are nested more than %d deep, the most that is read",
                        PP_XML_DEPTH_MOST);
    else if (b->elements == PP_XML_ELEMENTS_MOST)
        pp_mistakes_add(b->mistakes, line,
                        "the file has more than %d elements, the most that are read",
                        PP_XML_ELEMENTS_MOST);
    else if (attribute_count > PP_XML_ATTRIBUTES_MOST)
        pp_mistakes_add(
            b->mistakes, line,
            "an element with more than %d attributes, the most that are read",
            PP_XML_ATTRIBUTES_MOST);
    else
        return true;
    return false;
}

/* The element under the innermost open one, and open itself. */
static void attach(struct xml_builder *b, struct pp_xml_element *element)
{
    if (b->depth == 0)
        b->xml->root = element;
    else if (!b->newest[b->depth])
        b->open[b->depth - 1]->child = element;
    else
        b->newest[b->depth]->next = element;
    b->newest[b->depth] = element;
    b->open[b->depth++] = element;
    b->newest[b->depth] = NULL;
    b->elements++;
}

static void on_start(void *context, const xmlChar *name, const xmlChar *prefix,
                     const xmlChar *uri, int namespace_count,
                     const xmlChar **namespaces, int attribute_count,
                     int defaulted_count, const xmlChar **attributes)
{
    (void)uri, (void)namespaces, (void)defaulted_count;
    struct xml_builder *b = ((xmlParserCtxtPtr)context)->_private;
    if (b->stopped)
        return;
    b->text_noted = false;
    size_t start = tag_start(b);
    int line = line_at(b, start);
    if (!within_limits(b, attribute_count, line)) {
        stop(b);
        return;
    }

    bool foreign = prefix || namespace_count > 0 || b->bad_namespace;
    for (int i = 0; i < attribute_count; i++)
        foreign = foreign || attributes[5 * i + 1];
    if (foreign && !b->namespace_noted) {
        pp_mistakes_add(b->mistakes, line,
                        "a room file has no namespaces; leave out xmlns and prefixes");
        b->namespace_noted = true;
    }

    struct pp_xml_element *element = take(b->xml, sizeof *element);
    const char *copy = take_text(b->xml, name, strlen((const char *)name));
    if (element && copy) {
        *element = (struct pp_xml_element){.name = copy, .line = line};
        if (take_attributes(b, element, attribute_count, attributes, start)) {
            attach(b, element);
            return;
        }
    }
    b->out_of_memory = true;
    stop(b);
}

static void on_end(void *context, const xmlChar *name, const xmlChar *prefix,
                   const xmlChar *uri)
{
    (void)name, (void)prefix, (void)uri;
    struct xml_builder *b = ((xmlParserCtxtPtr)context)->_private;
    b->text_noted = false;
    if (!b->stopped && b->depth > 0)
        b->open[--b->depth]->ended = true;
}

/* Text between the elements: only white space may stand there. It comes in pieces. */
static void on_text(void *context, const xmlChar *text, int length)
{
    struct xml_builder *b = ((xmlParserCtxtPtr)context)->_private;
    const char *p = (const char *)text, *end = p + length;
    while (p < end && is_white(*p))
        p++;
    if (b->stopped || b->text_noted || p == end)
        return;
    b->text_noted = true;

    /* The parser stands at or behind the end of this piece. */
    size_t start = position(b);
    while (start > 0 && b->bytes[start - 1] != '>')
        start--;
    while (start < b->length && is_white(b->bytes[start]))
        start++;

    while (is_white(end[-1]))
        end--;
    char copy[64], shown[64];
    size_t bytes =
        (size_t)(end - p) < sizeof copy ? (size_t)(end - p) : sizeof copy - 1;
    memcpy(copy, p, bytes);
    copy[bytes] = '\0';
    pp_mistakes_add(
        b->mistakes, line_at(b, start),
        "text \"%s\" between elements; everything is said in attributes here",
        pp_text_excerpt(shown, sizeof shown, copy));
    if (b->mistakes->truncated)
        stop(b);
}

static void on_doctype(void *context, const xmlChar *name, const xmlChar *external,
                       const xmlChar *system)
{
    (void)name, (void)external, (void)system;
    struct xml_builder *b = ((xmlParserCtxtPtr)context)->_private;
    if (b->stopped)
        return;
    pp_mistakes_add(b->mistakes, line_at(b, tag_start(b)),
                    "a DOCTYPE is not allowed in a room file; leave it out");
    stop(b);
}

#if LIBXML_VERSION >= 21200
static void on_error(void *context, const xmlError *error)
#else
static void on_error(void *context, xmlErrorPtr error)
#endif
{
    struct xml_builder *b = ((xmlParserCtxtPtr)context)->_private;
    if (b->stopped || error->level == XML_ERR_WARNING)
        return;
    if (error->domain == XML_FROM_NAMESPACE) {
        b->bad_namespace = true; /* said with the line of the element, which comes */
        return;
    }
    if (error->code == XML_ERR_NO_MEMORY) {
        b->out_of_memory = true;
    } else {
        char sentence[512];
        struct pp_xml_place place = {b->bytes, b->length, position(b),
                                     b->depth ? b->open[b->depth - 1] : NULL};
        size_t cause = pp_xml_words_sentence(sentence, sizeof sentence, error, &place);
        pp_mistakes_add(b->mistakes, line_at(b, cause), "%s", sentence);
    }
    stop(b);
}

enum pp_status pp_xml_parse(struct pp_xml *xml, const char *bytes, size_t length,
                            struct pp_mistakes *mistakes, struct pp_error *err)
{
    *xml = (struct pp_xml){0};
    if (length >= 3 && memcmp(bytes, "\xEF\xBB\xBF", 3) == 0) {
        bytes += 3;
        length -= 3;
    }
    if (!pp_xml_bytes_sound(bytes, length, mistakes))
        return PP_OK;

    xmlParserCtxtPtr parser = xmlNewParserCtxt();
    if (!parser)
        return pp_fail_memory(err);
    struct xml_builder b = {.xml = xml,
                            .parser = parser,
                            .mistakes = mistakes,
                            .bytes = bytes,
                            .length = length,
                            .line = 1};
    *parser->sax = (xmlSAXHandler){.initialized = XML_SAX2_MAGIC,
                                   .internalSubset = on_doctype,
                                   .startElementNs = on_start,
                                   .endElementNs = on_end,
                                   .characters = on_text,
                                   .ignorableWhitespace = on_text,
                                   .cdataBlock = on_text,
                                   .serror = on_error};
    parser->_private = &b;
    /* NOENT: else &amp; arrives as &#38;. A DOCTYPE stops the parser, so that a file
     * can declare no entities of its own. */
    xmlDocPtr none = xmlCtxtReadMemory(parser, bytes, (int)length, NULL, NULL,
                                       XML_PARSE_NONET | XML_PARSE_NOENT);
    xmlFreeDoc(none);
    bool well_formed = parser->wellFormed;
    xmlFreeParserCtxt(parser);

    if (b.out_of_memory) {
        pp_xml_clear(xml);
        return pp_fail_memory(err);
    }
    if (!b.stopped && !well_formed)
        pp_mistakes_add(mistakes, 0, "the file is not well-formed XML");
    xml->whole = !b.stopped && well_formed;
    return PP_OK;
}
