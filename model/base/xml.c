/* xml.c - see xml.h.
 *
 * The parser reads the text in pieces through on_read. After a mistake, on_read returns
 * nothing, so that parsing ends soon.
 */
#include "model/base/xml.h"

#include <libxml/globals.h>
#include <libxml/parser.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/array.h"
#include "model/base/text.h"
#include "model/base/xml_sentence.h"
#include "model/base/xml_text.h"

void pp_xml_clear(struct pp_xml *xml)
{
    pp_arena_clear(&xml->memory);
    *xml = (struct pp_xml){0};
}

/* State shared by the parser's callbacks. */
struct xml_builder {
    struct pp_xml *xml;
    const struct pp_xml_format *format;
    struct pp_mistakes *mistakes;
    struct pp_xml_text text;
    size_t given; /* bytes given to the parser so far */
    xmlParserCtxtPtr parser;

    struct pp_xml_element *open[PP_XML_DEPTH_MOST]; /* open elements, from the root */
    struct pp_xml_element *newest[PP_XML_DEPTH_MOST + 1]; /* last child at each depth */
    int depth;
    int elements;

    /* Text since the last tag, without leading white space. */
    char *letters;
    int letter_count, letter_room;
    int letter_line;

    bool stopped; /* a mistake or lack of memory has ended the parsing */
    bool out_of_memory;
    bool namespace_noted;
};

static void stop_without_memory(struct xml_builder *b)
{
    b->stopped = b->out_of_memory = true;
}

static int on_read(void *context, char *buffer, int size)
{
    struct xml_builder *b = context;
    size_t left = b->stopped ? 0 : b->text.length - b->given;
    size_t count = left < (size_t)size ? left : (size_t)size;
    memcpy(buffer, b->text.bytes + b->given, count);
    b->given += count;
    return (int)count;
}

/* ---- positions in the text ---- */

/* First byte not yet parsed. */
static const char *here(const struct xml_builder *b)
{
    long read = xmlByteConsumed(b->parser);
    size_t offset = read < 0 ? 0 : (size_t)read;
    return b->text.bytes + (offset < b->text.length ? offset : b->text.length);
}

/* Last byte before here() that is one of `bytes`; the start of the text if there is
 * none. */
static const char *last(const struct xml_builder *b, const char *bytes)
{
    const char *p = here(b);
    do {
        if (p == b->text.bytes)
            return p;
        p--;
    } while (!strchr(bytes, *p));
    return p;
}

/* Line of a position before here(). */
static int line_at(const struct xml_builder *b, const char *at)
{
    int line = b->parser->input->line;
    for (const char *end = here(b); at < end; at++)
        line -= *at == '\n';
    return line;
}

/* ---- the tree ---- */

/* Ends the text before a tag. The first text of an element is stored; if the format has
 * attributes only, any text is a mistake. */
static void settle_text(struct xml_builder *b)
{
    char shown[64];
    while (b->letter_count > 0 && pp_text_is_white(b->letters[b->letter_count - 1]))
        b->letter_count--;
    if (b->letter_count == 0 || b->depth == 0)
        return;
    struct pp_xml_element *open = b->open[b->depth - 1];
    if (b->format->attributes_only) {
        b->letters[b->letter_count] = '\0';
        pp_mistakes_add(b->mistakes, b->letter_line,
                        "there is text \"%s\" between elements; expected only elements "
                        "and attributes",
                        pp_text_excerpt(shown, sizeof shown, b->letters));
        b->stopped = b->stopped || b->mistakes->truncated;
    } else if (!open->text) {
        open->text =
            pp_arena_take_text(&b->xml->memory, b->letters, (size_t)b->letter_count);
        if (!open->text)
            stop_without_memory(b);
    }
    b->letter_count = 0;
}

/* Receives text between tags, in pieces. */
static void on_text(void *context, const xmlChar *piece, int length)
{
    struct xml_builder *b = context;
    const char *text = (const char *)piece, *end = text + length;
    if (b->stopped)
        return;
    while (b->letter_count == 0 && text < end && pp_text_is_white(*text))
        text++;
    if (text == end)
        return;
    if (b->letter_count == 0) {
        b->letter_line = b->parser->input->line;
        for (const char *p = text; p < end; p++)
            b->letter_line -= *p == '\n';
    }
    int count = (int)(end - text);
    if (pp_array_reserve(&b->letters, &b->letter_room, b->letter_count + count + 1, 1,
                         NULL)
        != PP_OK) {
        stop_without_memory(b);
        return;
    }
    memcpy(b->letters + b->letter_count, text, (size_t)count);
    b->letter_count += count;
}

static bool within_limits(struct xml_builder *b, int attribute_count, int line)
{
    if (b->depth == b->format->depth_most)
        pp_mistakes_add(b->mistakes, line,
                        "elements are nested more than %d levels deep; expected fewer "
                        "levels",
                        b->format->depth_most);
    else if (b->elements == b->format->elements_most)
        pp_mistakes_add(b->mistakes, line,
                        "the file has more than %d elements; expected fewer",
                        b->format->elements_most);
    else if (attribute_count > PP_XML_ATTRIBUTES_MOST)
        pp_mistakes_add(b->mistakes, line,
                        "an element has more than %d attributes; expected fewer",
                        PP_XML_ATTRIBUTES_MOST);
    else
        return true;
    return false;
}

/* Name of the next attribute after p, in a well-formed tag; *next is after its
 * value. */
static const char *next_attribute(const char *p, const char *end, const char **next)
{
    while (p < end && pp_text_is_white(*p))
        p++;
    const char *open = p;
    while (open < end && *open != '"' && *open != '\'')
        open++;
    const char *close =
        open < end ? memchr(open + 1, *open, (size_t)(end - open - 1)) : NULL;
    *next = close ? close + 1 : end;
    return p;
}

/* True for xmlns="..." or xmlns:p="...", which libxml2 does not treat as attributes. */
static bool is_declaration(const char *p, const char *end)
{
    return end - p > 5 && memcmp(p, "xmlns", 5) == 0
           && (p[5] == ':' || p[5] == '=' || pp_text_is_white(p[5]));
}

/* Fields of an attribute in libxml2; VALUE and VALUE_END are pointers. */
enum { NAME, PREFIX, NAMESPACE, VALUE, VALUE_END, FIELDS };

/* Copies an attribute's value. libxml2 replaces each & by &#38; (unless XML_PARSE_NOENT
 * is set, which would expand entities). NULL if memory runs out. */
static const char *take_value(struct pp_arena *memory, const char *from, size_t length)
{
    static const char written[] = "&#38;";
    char *copy = pp_arena_take_text(memory, from, length);
    char *end = copy;
    for (const char *p = copy; p && *p; p++) {
        *end++ = *p;
        if (strncmp(p, written, sizeof written - 1) == 0)
            p += sizeof written - 2;
    }
    if (end)
        *end = '\0';
    return copy;
}

/* Copies the attributes of the tag at p, each with the line of its name. */
static bool take_attributes(struct xml_builder *b, struct pp_xml_element *element,
                            const char *p, int count, const xmlChar **attributes)
{
    struct pp_arena *memory = &b->xml->memory;
    element->attributes =
        pp_arena_take(memory, (size_t)count * sizeof *element->attributes);
    if (!element->attributes)
        return false;
    const char *end = here(b), *counted = p, *at;
    int line = element->line;
    while (p < end && !pp_text_is_white(*p))
        p++;
    for (int i = 0; i < count; i++) {
        do
            at = next_attribute(p, end, &p);
        while (is_declaration(at, end));
        for (; counted < at; counted++)
            line += *counted == '\n';
        const char *const *field = (const char *const *)(attributes + FIELDS * i);
        if (field[PREFIX] && strcmp(field[PREFIX], "xml") == 0)
            continue;
        struct pp_xml_attribute *taken =
            &element->attributes[element->attribute_count++];
        taken->line = line;
        taken->name = pp_arena_take_text(memory, field[NAME], strlen(field[NAME]));
        taken->value =
            take_value(memory, field[VALUE], (size_t)(field[VALUE_END] - field[VALUE]));
        if (!taken->name || !taken->value)
            return false;
    }
    return true;
}

/* Appends the element to the innermost open one, and opens it. */
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
                     const xmlChar **namespaces, int count, int defaulted,
                     const xmlChar **attributes)
{
    (void)uri, (void)namespaces, (void)defaulted;
    struct xml_builder *b = context;
    if (!b->stopped)
        settle_text(b);
    if (b->stopped)
        return;
    const char *tag = last(b, "<"); /* values contain no < in well-formed text */
    int line = line_at(b, tag);
    if (!within_limits(b, count + namespace_count, line)) {
        b->stopped = true;
        return;
    }

    bool is_foreign = prefix || namespace_count > 0;
    for (int i = 0; i < count; i++)
        is_foreign = is_foreign || attributes[FIELDS * i + PREFIX];
    if (is_foreign && b->format->attributes_only && !b->namespace_noted) {
        pp_mistakes_add(b->mistakes, line,
                        "a %s has no namespaces; leave out xmlns and prefixes",
                        b->format->file);
        b->namespace_noted = true;
    }

    struct pp_xml_element *element = pp_arena_take(&b->xml->memory, sizeof *element);
    const char *copy = pp_arena_take_text(&b->xml->memory, (const char *)name,
                                          strlen((const char *)name));
    if (element && copy) {
        *element = (struct pp_xml_element){.name = copy, .line = line};
        if (take_attributes(b, element, tag, count, attributes)) {
            attach(b, element);
            return;
        }
    }
    stop_without_memory(b);
}

static void on_end(void *context, const xmlChar *name, const xmlChar *prefix,
                   const xmlChar *uri)
{
    (void)name, (void)prefix, (void)uri;
    struct xml_builder *b = context;
    if (b->stopped)
        return;
    settle_text(b);
    b->open[--b->depth]->ended = true;
}

/* ---- mistakes ---- */

static void on_doctype(void *context, const xmlChar *name, const xmlChar *external,
                       const xmlChar *system)
{
    (void)name, (void)external, (void)system;
    struct xml_builder *b = context;
    if (b->stopped)
        return;
    pp_mistakes_add(b->mistakes, line_at(b, last(b, "<")),
                    "a DOCTYPE is not allowed in a %s; leave it out", b->format->file);
    b->stopped = true;
    xmlStopParser(b->parser); /* before the parser reads declarations */
}

/* Reports that the text ends too early: inside an element, a tag, a comment or another
 * construct. */
static void note_end(struct xml_builder *b)
{
    const char *p = b->text.unended, *end = b->text.bytes + b->text.length;
    if (p) {
        pp_mistakes_add(b->mistakes, pp_xml_text_line(&b->text, p), "%s",
                        pp_xml_sentence_of_unended(p, end));
        return;
    }
    char name[160];
    struct pp_xml_element *open = b->depth > 0 ? b->open[b->depth - 1] : NULL;
    pp_text_excerpt(name, sizeof name, open ? open->name : "");
    if (open)
        pp_mistakes_add(b->mistakes, pp_xml_text_line(&b->text, end),
                        "the file ends inside the <%s> that begins on line %d; "
                        "expected </%s>",
                        name, open->line, name);
    else
        pp_mistakes_add(b->mistakes, pp_xml_text_line(&b->text, end),
                        "the file ends inside a tag");
}

static void note_sentence(struct xml_builder *b, const xmlError *error)
{
    const char *at = here(b);
    struct pp_xml_sentence sentence =
        pp_xml_sentence_of_error(error->code, at, b->text.bytes);
    if (!sentence.text) {
        const char *message = error->message ? error->message : "";
        pp_mistakes_add(b->mistakes, line_at(b, at),
                        "the file is not well-formed XML: %.*s",
                        (int)strcspn(message, "\r\n"), message);
        return;
    }
    if (sentence.cause != PP_XML_HERE)
        at = last(b, sentence.cause == PP_XML_TAG ? "<" : "\"'");
    pp_mistakes_add(b->mistakes, line_at(b, at), "%s", sentence.text);
}

/* Reports only the first error, since later ones may follow from it. */
static void on_error(void *context, const xmlError *error)
{
    struct xml_builder *b = context;
    if (b->stopped || error->level != XML_ERR_FATAL)
        return;
    b->stopped = true;
    struct pp_xml_element *open = b->depth > 0 ? b->open[b->depth - 1] : NULL;
    const char *name = error->str2 ? error->str2 : error->str1 ? error->str1 : "";
    char one[160], other[160];
    pp_text_excerpt(one, sizeof one, name);
    pp_text_excerpt(other, sizeof other, open ? open->name : "");
    int line = line_at(b, here(b));
    if (error->code == XML_ERR_NO_MEMORY)
        b->out_of_memory = true;
    else if (error->code == XML_ERR_TAG_NAME_MISMATCH && open)
        pp_mistakes_add(b->mistakes, line,
                        "there is </%s>; expected </%s> to close the element on "
                        "line %d",
                        one, other, open->line);
    else if (error->code == XML_ERR_ATTRIBUTE_REDEFINED)
        pp_mistakes_add(b->mistakes, line_at(b, last(b, "<")),
                        "the attribute \"%s\" is given twice", one);
    else if (error->code == XML_ERR_UNDECLARED_ENTITY)
        pp_mistakes_add(
            b->mistakes, line,
            "the entity &%s; is unknown; XML has &amp; &lt; &gt; &quot; and &apos;",
            one);
    else if (error->code == XML_ERR_DOCUMENT_END && b->xml->root && b->depth == 0)
        pp_mistakes_add(
            b->mistakes, line,
            "there is more content after </%s>; expected the end of the file",
            pp_text_excerpt(one, sizeof one, b->xml->root->name));
    else if (!b->xml->root && error->code == XML_ERR_DOCUMENT_EMPTY)
        pp_mistakes_add(b->mistakes, line, "this is not XML; expected %s",
                        b->format->roots);
    else if (here(b) == b->text.bytes + b->text.length)
        note_end(b);
    else
        note_sentence(b, error);
}

/* ---- the parser ---- */

static void build_xml_element(struct xml_builder *b)
{
    xmlSAXHandler handler = {.initialized = XML_SAX2_MAGIC,
                             .startElementNs = on_start,
                             .endElementNs = on_end,
                             .characters = on_text,
                             .ignorableWhitespace = on_text,
                             .internalSubset = on_doctype};
    handler.serror = (xmlStructuredErrorFunc)on_error;
    b->parser =
        xmlCreateIOParserCtxt(&handler, b, on_read, NULL, b, XML_CHAR_ENCODING_NONE);
    if (!b->parser) {
        stop_without_memory(b);
        return;
    }
    /* The text was converted to UTF-8, whatever encoding it declares. */
    xmlCtxtUseOptions(b->parser, XML_PARSE_NONET | XML_PARSE_IGNORE_ENC);
    bool is_good = xmlParseDocument(b->parser) == 0;
    if (!is_good && !b->stopped)
        pp_mistakes_add(b->mistakes, 0, "the file is not well-formed XML");
    b->xml->whole = is_good && !b->stopped;
    xmlFreeParserCtxt(b->parser);
}

static void say_nothing(void *context, const xmlError *error)
{
    (void)context, (void)error;
}

enum pp_status pp_xml_parse(struct pp_xml *xml, const char *bytes, size_t length,
                            const struct pp_xml_format *format,
                            struct pp_mistakes *mistakes, struct pp_error *err)
{
    *xml = (struct pp_xml){0};
    struct xml_builder b = {.xml = xml, .format = format, .mistakes = mistakes};
    xmlInitParser();
    /* Encoding and memory errors have no parser context and go to the handler of this
     * thread, which would print them. */
    xmlStructuredErrorFunc before = xmlStructuredError;
    void *before_context = xmlStructuredErrorContext;
    xmlSetStructuredErrorFunc(NULL, (xmlStructuredErrorFunc)say_nothing);
    enum pp_status status =
        pp_xml_text_read(&b.text, bytes, length, format, mistakes, err);
    if (status == PP_OK && b.text.bytes)
        build_xml_element(&b);
    pp_xml_text_clear(&b.text);
    xmlSetStructuredErrorFunc(before_context, before);
    free(b.letters);
    if (b.out_of_memory) {
        pp_xml_clear(xml);
        return pp_fail_memory(err);
    }
    return status;
}
