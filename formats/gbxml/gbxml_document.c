/* gbxml_document.c - see gbxml_document.h. */
#include "formats/gbxml/gbxml_document.h"

#include <expat.h>
#include <iconv.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/array.h"
#include "model/base/text.h"

/* The state that the parser's callbacks share. */
struct gbxml_builder {
    struct pp_gbxml_document *document;
    XML_Parser parser;
    struct pp_gbxml_element *open; /* the innermost, or NULL */
    char *text;                    /* since the last tag */
    int text_length, text_room;
    bool doctype, out_of_memory;
};

static void stop_without_memory(struct gbxml_builder *b)
{
    b->out_of_memory = true;
    XML_StopParser(b->parser, XML_FALSE);
}

/* Gives the text before a tag to the open element, if it has none and it is not white. */
static bool settle_text(struct gbxml_builder *b)
{
    const char *p = b->text, *end = p + b->text_length;
    b->text_length = 0;
    while (p < end && pp_text_is_white(*p))
        p++;
    while (end > p && pp_text_is_white(end[-1]))
        end--;
    if (p == end || !b->open || b->open->text)
        return true;
    b->open->text = pp_arena_take_text(&b->document->memory, p, (size_t)(end - p));
    return b->open->text != NULL;
}

static bool take_attributes(struct pp_arena *memory, struct pp_gbxml_element *element,
                            const char **attributes)
{
    int count = 0;
    while (attributes[2 * count])
        count++;
    element->attribute_count = count;
    element->attributes =
        pp_arena_take(memory, 2 * (size_t)count * sizeof *element->attributes);
    if (!element->attributes)
        return false;
    for (int i = 0; i < 2 * count; i++) {
        const char *from =
            i % 2 == 0 ? pp_text_local_name(attributes[i]) : attributes[i];
        element->attributes[i] = pp_arena_take_text(memory, from, strlen(from));
        if (!element->attributes[i])
            return false;
    }
    return true;
}

static void on_start(void *context, const char *name, const char **attributes)
{
    struct gbxml_builder *b = context;
    struct pp_arena *memory = &b->document->memory;
    struct pp_gbxml_element *element = pp_arena_take(memory, sizeof *element);
    name = pp_text_local_name(name);
    const char *copy = pp_arena_take_text(memory, name, strlen(name));
    if (!element || !copy || !settle_text(b)) {
        stop_without_memory(b);
        return;
    }
    unsigned long line = XML_GetCurrentLineNumber(b->parser);
    *element = (struct pp_gbxml_element){
        .name = copy, .line = line < 1ul << 30 ? (int)line : 0, .parent = b->open};
    if (!take_attributes(memory, element, attributes)) {
        stop_without_memory(b);
        return;
    }
    if (!b->open)
        b->document->root = element;
    else if (!b->open->child)
        b->open->child = element;
    else
        b->open->newest->next = element;
    if (b->open)
        b->open->newest = element;
    b->open = element;
}

static void on_end(void *context, const char *name)
{
    (void)name;
    struct gbxml_builder *b = context;
    if (!settle_text(b)) {
        stop_without_memory(b);
        return;
    }
    b->open = b->open->parent;
}

static void on_text(void *context, const char *text, int length)
{
    struct gbxml_builder *b = context;
    if (pp_array_reserve(&b->text, &b->text_room, b->text_length + length, 1, NULL)
        != PP_OK) {
        stop_without_memory(b);
        return;
    }
    memcpy(b->text + b->text_length, text, (size_t)length);
    b->text_length += length;
}

static void on_doctype(void *context, const char *name, const char *system,
                       const char *public, int has_subset)
{
    (void)name, (void)system, (void)public, (void)has_subset;
    struct gbxml_builder *b = context;
    b->doctype = true;
    XML_StopParser(b->parser, XML_FALSE);
}

/* An encoding that the parser does not know, where each letter is a byte: Windows-1252 and
 * its like. */
static int on_encoding(void *context, const char *name, XML_Encoding *encoding)
{
    (void)context;
    iconv_t converter = iconv_open("UTF-32LE", name);
    if (converter == (iconv_t)-1)
        return XML_STATUS_ERROR;
    for (int i = 0; i < 256; i++) {
        char byte = (char)i, *in = &byte;
        unsigned char letter[4] = {0};
        char *out = (char *)letter;
        size_t in_left = 1, out_left = sizeof letter;
        bool known = iconv(converter, &in, &in_left, &out, &out_left) != (size_t)-1
                     && out_left == 0;
        encoding->map[i] =
            known ? letter[0] | letter[1] << 8 | letter[2] << 16 | letter[3] << 24 : -1;
        iconv(converter, NULL, NULL, NULL, NULL);
    }
    iconv_close(converter);
    return XML_STATUS_OK;
}

static enum pp_status refuse(struct pp_error *err, const char *file,
                             const struct gbxml_builder *b)
{
    if (b->doctype)
        return pp_fail(err, PP_BAD_INPUT,
                       "%s: a DOCTYPE is not allowed in a gbXML file; leave it out",
                       file);
    enum XML_Error error = XML_GetErrorCode(b->parser);
    if (b->out_of_memory || error == XML_ERROR_NO_MEMORY)
        return pp_fail_memory(err);
    return pp_fail(err, PP_BAD_INPUT, "%s:%lu: the file is not well-formed XML: %s",
                   file, (unsigned long)XML_GetCurrentLineNumber(b->parser),
                   error == XML_ERROR_NO_ELEMENTS && b->document->root
                       ? "it breaks off"
                       : XML_ErrorString(error));
}

enum pp_status pp_gbxml_document_parse(struct pp_gbxml_document *document,
                                       const char *bytes, size_t length,
                                       const char *file, struct pp_error *err)
{
    *document = (struct pp_gbxml_document){0};
    if (length > PP_GBXML_BYTES_MOST)
        return pp_fail(err, PP_BAD_INPUT, "%s: more than 64 MiB, the most that is read",
                       file);
    XML_Parser parser = XML_ParserCreate(NULL);
    if (!parser)
        return pp_fail_memory(err);
    struct gbxml_builder b = {.document = document, .parser = parser};
    XML_SetUserData(parser, &b);
    XML_SetElementHandler(parser, on_start, on_end);
    XML_SetCharacterDataHandler(parser, on_text);
    XML_SetStartDoctypeDeclHandler(parser, on_doctype);
    XML_SetUnknownEncodingHandler(parser, on_encoding, NULL);
    enum pp_status status = PP_OK;
    if (XML_Parse(parser, bytes, (int)length, XML_TRUE) != XML_STATUS_OK)
        status = refuse(err, file, &b);
    else if (strcmp(document->root->name, "gbXML") != 0)
        status = pp_fail(err, PP_BAD_INPUT,
                         "%s: its outermost element is \"%.40s\"; expected gbXML", file,
                         document->root->name);
    XML_ParserFree(parser);
    free(b.text);
    if (status != PP_OK)
        pp_gbxml_document_clear(document);
    return status;
}

void pp_gbxml_document_clear(struct pp_gbxml_document *document)
{
    pp_arena_clear(&document->memory);
    *document = (struct pp_gbxml_document){0};
}

static const struct pp_gbxml_element *find(const struct pp_gbxml_element *element,
                                           const char *name)
{
    while (element && strcmp(element->name, name) != 0)
        element = element->next;
    return element;
}

const struct pp_gbxml_element *pp_gbxml_document_child(
    const struct pp_gbxml_element *parent, const char *name)
{
    return parent ? find(parent->child, name) : NULL;
}

const struct pp_gbxml_element *pp_gbxml_document_next(
    const struct pp_gbxml_element *before, const char *name)
{
    return find(before->next, name);
}

const struct pp_gbxml_element *pp_gbxml_document_path(
    const struct pp_gbxml_element *from, const char *path)
{
    while (from && *path) {
        char name[64];
        size_t length = strcspn(path, "/");
        pp_text_append((name[0] = '\0', name), sizeof name, "%.*s", (int)length, path);
        from = pp_gbxml_document_child(from, name);
        path += length + (path[length] == '/');
    }
    return from;
}

const char *pp_gbxml_document_attribute(const struct pp_gbxml_element *element,
                                        const char *name)
{
    for (int i = 0; element && i < element->attribute_count; i++)
        if (strcmp(element->attributes[2 * i], name) == 0)
            return element->attributes[2 * i + 1];
    return NULL;
}

const char *pp_gbxml_document_text(const struct pp_gbxml_element *element)
{
    return element ? element->text : NULL;
}

bool pp_gbxml_document_number(const struct pp_gbxml_element *element, double *value)
{
    const char *text = pp_gbxml_document_text(element);
    return text && pp_text_parse_number(text, value);
}
