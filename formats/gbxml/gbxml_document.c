/* gbxml_document.c - see gbxml_document.h. */
#include "formats/gbxml/gbxml_document.h"

#include <libxml/parser.h>
#include <libxml/parserInternals.h>
#include <string.h>

#include "model/base/text.h"

static bool has_name(xmlNodePtr node, const char *name)
{
    return node->type == XML_ELEMENT_NODE
           && strcmp((const char *)node->name, name) == 0;
}

/* What is said of a file that is no XML. */
struct fault {
    bool doctype;
    int line;
    char text[256];
};

static void on_doctype(void *context, const xmlChar *name, const xmlChar *external,
                       const xmlChar *system)
{
    (void)name, (void)external, (void)system;
    xmlParserCtxtPtr parser = context;
    ((struct fault *)parser->_private)->doctype = true;
    xmlStopParser(parser);
}

#if LIBXML_VERSION >= 21200
static void on_error(void *context, const xmlError *error)
#else
static void on_error(void *context, xmlErrorPtr error)
#endif
{
    struct fault *fault = ((xmlParserCtxtPtr)context)->_private;
    if (error->level == XML_ERR_WARNING || fault->text[0]
        || error->domain == XML_FROM_NAMESPACE)
        return;
    fault->line = error->line;
    pp_text_excerpt(fault->text, sizeof fault->text,
                    error->message ? error->message : "not well-formed");
    size_t length = strlen(fault->text);
    while (length > 0
           && (fault->text[length - 1] == '?' || fault->text[length - 1] == ' '))
        fault->text[--length] = '\0';
}

static enum pp_status refuse(struct pp_error *err, const char *file,
                             const struct fault *fault)
{
    if (fault->doctype)
        return pp_fail(err, PP_BAD_INPUT,
                       "%s: a DOCTYPE is not allowed in a gbXML file; leave it out",
                       file);
    return pp_fail(err, PP_BAD_INPUT, "%s:%d: the file is not well-formed XML: %s",
                   file, fault->line, fault->text[0] ? fault->text : "it breaks off");
}

enum pp_status pp_gbxml_document_parse(xmlDocPtr *document, const char *bytes,
                                       size_t length, const char *file,
                                       struct pp_error *err)
{
    struct fault fault = {0};
    *document = NULL;
    if (length > PP_GBXML_BYTES_MOST)
        return pp_fail(err, PP_BAD_INPUT, "%s: more than 64 MiB, the most that is read",
                       file);
    xmlParserCtxtPtr parser = xmlNewParserCtxt();
    if (!parser)
        return pp_fail_memory(err);
    parser->sax->internalSubset = on_doctype;
    parser->sax->serror = on_error;
    parser->_private = &fault;
    xmlDocPtr made =
        xmlCtxtReadMemory(parser, bytes, (int)length, NULL, NULL,
                          XML_PARSE_NONET | XML_PARSE_BIG_LINES | XML_PARSE_COMPACT);
    bool good = made && parser->wellFormed && !fault.doctype;
    xmlFreeParserCtxt(parser);
    xmlNodePtr root = good ? xmlDocGetRootElement(made) : NULL;
    if (!root || !has_name(root, "gbXML")) {
        enum pp_status status =
            root ? pp_fail(err, PP_BAD_INPUT,
                           "%s: its outermost element is \"%.40s\"; expected gbXML",
                           file, (const char *)root->name)
                 : refuse(err, file, &fault);
        xmlFreeDoc(made);
        return status;
    }
    *document = made;
    return PP_OK;
}

static xmlNodePtr find(xmlNodePtr node, const char *name)
{
    while (node && !has_name(node, name))
        node = node->next;
    return node;
}

xmlNodePtr pp_gbxml_document_child(xmlNodePtr parent, const char *name)
{
    return parent ? find(parent->children, name) : NULL;
}

xmlNodePtr pp_gbxml_document_next(xmlNodePtr before, const char *name)
{
    return find(before->next, name);
}

xmlNodePtr pp_gbxml_document_path(xmlNodePtr from, const char *path)
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

const char *pp_gbxml_document_attribute(xmlNodePtr element, const char *name)
{
    for (xmlAttrPtr at = element ? element->properties : NULL; at; at = at->next)
        if (strcmp((const char *)at->name, name) == 0)
            return at->children && at->children->content
                       ? (const char *)at->children->content
                       : "";
    return NULL;
}

const char *pp_gbxml_document_text(xmlNodePtr element)
{
    for (xmlNodePtr node = element ? element->children : NULL; node; node = node->next)
        if (node->type == XML_TEXT_NODE || node->type == XML_CDATA_SECTION_NODE) {
            const char *text = (const char *)node->content;
            return text + strspn(text, " \t\r\n");
        }
    return NULL;
}

bool pp_gbxml_document_number(xmlNodePtr element, double *value)
{
    const char *text = pp_gbxml_document_text(element);
    return text && pp_text_parse_number(text, value);
}

int pp_gbxml_document_line(xmlNodePtr element)
{
    long line = xmlGetLineNo(element);
    return line > 0 && line < 1 << 30 ? (int)line : 0;
}
