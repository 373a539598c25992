/* xml.c - see xml.h. */
#include "model/room/read/xml.h"

#include <expat.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/text.h"
#include "model/room/read/xml_bytes.h"
#include "model/room/read/xml_words.h"

void pp_xml_clear(struct pp_xml *xml)
{
    pp_arena_clear(&xml->memory);
    *xml = (struct pp_xml){0};
}

/* The state that the parser's callbacks share. */
struct xml_builder {
    struct pp_xml *xml;
    XML_Parser parser;
    struct pp_mistakes *mistakes;
    const char *bytes;
    size_t length;

    struct pp_xml_element *open[PP_XML_DEPTH_MOST];       /* from the root down */
    struct pp_xml_element *newest[PP_XML_DEPTH_MOST + 1]; /* last child at each depth */
    int depth;
    int elements;

    size_t counted; /* bytes[0 .. counted) hold line - 1 line ends */
    int line;

    bool stopped; /* a limit was passed, which has been noted, or memory is out */
    bool out_of_memory;
    bool text_noted;      /* since the last tag */
    bool namespace_noted; /* in the file */
};

static void stop(struct xml_builder *b)
{
    b->stopped = true;
    XML_StopParser(b->parser, XML_FALSE);
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

/* Where what the parser tells of begins: of a tag, its <. */
static size_t position(const struct xml_builder *b)
{
    XML_Index index = XML_GetCurrentByteIndex(b->parser);
    if (index < 0)
        return 0;
    return (size_t)index < b->length ? (size_t)index : b->length;
}

/* The name of the next attribute behind p, in a well-formed tag; *next is behind its
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

/* Is it xmlns="..." or xmlns:p="..."? */
static bool is_declaration(const char *name)
{
    return strncmp(name, "xmlns", 5) == 0 && (name[5] == ':' || name[5] == '\0');
}

/* Copies the attributes, names and values by turns, each with the line of its name in the
 * tag at `start`. Namespaces have been complained of and are dropped; xml:lang and its like
 * could be no others. */
static bool take_attributes(struct xml_builder *b, struct pp_xml_element *element,
                            int count, const char **attributes, size_t start)
{
    element->attributes =
        pp_arena_take(&b->xml->memory, (size_t)count * sizeof *element->attributes);
    if (!element->attributes)
        return false;
    const char *p = b->bytes + start, *end = b->bytes + b->length;
    while (p < end && !pp_text_is_white(*p) && *p != '>')
        p++;
    for (int i = 0; i < count; i++) {
        const char *name = attributes[2 * i], *value = attributes[2 * i + 1];
        const char *at = next_attribute(p, end, &p);
        if (is_declaration(name) || strncmp(name, "xml:", 4) == 0)
            continue;
        name = pp_text_local_name(name);
        struct pp_xml_attribute *taken =
            &element->attributes[element->attribute_count++];
        taken->line = line_at(b, (size_t)(at - b->bytes));
        taken->name = pp_arena_take_text(&b->xml->memory, name, strlen(name));
        taken->value = pp_arena_take_text(&b->xml->memory, value, strlen(value));
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

static void on_start(void *context, const char *name, const char **attributes)
{
    struct xml_builder *b = context;
    if (b->stopped)
        return;
    b->text_noted = false;
    size_t start = position(b);
    int line = line_at(b, start);
    int attribute_count = 0;
    bool foreign = strchr(name, ':') != NULL;
    for (; attributes[2 * attribute_count]; attribute_count++) {
        const char *attribute = attributes[2 * attribute_count];
        foreign = foreign || is_declaration(attribute) || strchr(attribute, ':');
    }
    if (!within_limits(b, attribute_count, line)) {
        stop(b);
        return;
    }

    if (foreign && !b->namespace_noted) {
        pp_mistakes_add(b->mistakes, line,
                        "a room file has no namespaces; leave out xmlns and prefixes");
        b->namespace_noted = true;
    }

    struct pp_xml_element *element = pp_arena_take(&b->xml->memory, sizeof *element);
    name = pp_text_local_name(name);
    const char *copy = pp_arena_take_text(&b->xml->memory, name, strlen(name));
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

static void on_end(void *context, const char *name)
{
    (void)name;
    struct xml_builder *b = context;
    b->text_noted = false;
    if (!b->stopped && b->depth > 0)
        b->open[--b->depth]->ended = true;
}

/* Text between the elements: only white space may stand there. It comes in pieces. */
static void on_text(void *context, const char *text, int length)
{
    struct xml_builder *b = context;
    const char *p = text, *end = p + length;
    while (p < end && pp_text_is_white(*p))
        p++;
    if (b->stopped || b->text_noted || p == end)
        return;
    b->text_noted = true;

    size_t start = position(b) + (size_t)(p - text);
    while (pp_text_is_white(end[-1]))
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

static void on_doctype(void *context, const char *name, const char *system,
                       const char *public, int has_subset)
{
    (void)name, (void)system, (void)public, (void)has_subset;
    struct xml_builder *b = context;
    if (b->stopped)
        return;
    pp_mistakes_add(b->mistakes, line_at(b, position(b)),
                    "a DOCTYPE is not allowed in a room file; leave it out");
    stop(b);
}

/* Notes why the parser ended early. */
static void note_error(struct xml_builder *b)
{
    char sentence[512];
    struct pp_xml_place place = {b->bytes, b->length, position(b), b->xml->root != NULL,
                                 b->depth ? b->open[b->depth - 1] : NULL};
    size_t cause = pp_xml_words_sentence(sentence, sizeof sentence,
                                         XML_GetErrorCode(b->parser), &place);
    pp_mistakes_add(b->mistakes, line_at(b, cause), "%s", sentence);
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

    XML_Parser parser = XML_ParserCreate("UTF-8");
    if (!parser)
        return pp_fail_memory(err);
    struct xml_builder b = {.xml = xml,
                            .parser = parser,
                            .mistakes = mistakes,
                            .bytes = bytes,
                            .length = length,
                            .line = 1};
    XML_SetUserData(parser, &b);
    XML_SetElementHandler(parser, on_start, on_end);
    XML_SetCharacterDataHandler(parser, on_text);
    /* It stops the parser, so that a file can declare no entities of its own. */
    XML_SetStartDoctypeDeclHandler(parser, on_doctype);
    bool whole = XML_Parse(parser, bytes, (int)length, XML_TRUE) == XML_STATUS_OK;
    if (!whole && XML_GetErrorCode(parser) == XML_ERROR_NO_MEMORY)
        b.out_of_memory = true;
    else if (!whole && !b.stopped)
        note_error(&b);
    XML_ParserFree(parser);

    if (b.out_of_memory) {
        pp_xml_clear(xml);
        return pp_fail_memory(err);
    }
    xml->whole = whole;
    return PP_OK;
}
