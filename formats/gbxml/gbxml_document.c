/* gbxml_document.c - see gbxml_document.h. */
#include "formats/gbxml/gbxml_document.h"

#include <string.h>

#include "model/base/text.h"

static const struct pp_xml_format gbxml = {
    .file = "gbXML file",
    .roots = "a <gbXML>",
    .bytes_most = PP_GBXML_BYTES_MOST,
    .depth_most = PP_XML_DEPTH_MOST,
    .elements_most = 4000000,
};

/* Fails with the first of the mistakes; PP_OK if there are none. */
static enum pp_status fail_with_mistakes(const struct pp_mistakes *mistakes,
                                         const char *file, struct pp_error *err)
{
    if (mistakes->count == 0)
        return mistakes->truncated ? pp_fail_memory(err) : PP_OK;
    const struct pp_input_mistake *first = &mistakes->list[0];
    return first->line > 0
               ? pp_fail(err, PP_BAD_INPUT, "%s:%d: %s", file, first->line, first->text)
               : pp_fail(err, PP_BAD_INPUT, "%s: %s", file, first->text);
}

enum pp_status pp_gbxml_document_parse(struct pp_xml *document, const char *bytes,
                                       size_t length, const char *file,
                                       struct pp_error *err)
{
    char shown[160];
    struct pp_mistakes mistakes;
    pp_mistakes_init(&mistakes, file);
    enum pp_status status =
        pp_xml_parse(document, bytes, length, &gbxml, &mistakes, err);
    if (status == PP_OK)
        status = fail_with_mistakes(&mistakes, file, err);
    if (status == PP_OK && strcmp(document->root->name, "gbXML") != 0)
        status = pp_fail(err, PP_BAD_INPUT,
                         "%s:%d: the outermost element is <%s>; expected <gbXML>", file,
                         document->root->line,
                         pp_text_excerpt(shown, sizeof shown, document->root->name));
    pp_mistakes_clear(&mistakes);
    if (status != PP_OK)
        pp_xml_clear(document);
    return status;
}

static const struct pp_xml_element *find_gbxml_child(
    const struct pp_xml_element *element, const char *name)
{
    while (element && strcmp(element->name, name) != 0)
        element = element->next;
    return element;
}

const struct pp_xml_element *pp_gbxml_document_child(
    const struct pp_xml_element *parent, const char *name)
{
    return parent ? find_gbxml_child(parent->child, name) : NULL;
}

const struct pp_xml_element *pp_gbxml_document_next(const struct pp_xml_element *before,
                                                    const char *name)
{
    return find_gbxml_child(before->next, name);
}

const struct pp_xml_element *pp_gbxml_document_path(const struct pp_xml_element *from,
                                                    const char *path)
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

const char *pp_gbxml_document_attribute(const struct pp_xml_element *element,
                                        const char *name)
{
    for (int i = 0; element && i < element->attribute_count; i++)
        if (strcmp(element->attributes[i].name, name) == 0)
            return element->attributes[i].value;
    return NULL;
}

const char *pp_gbxml_document_text(const struct pp_xml_element *element)
{
    return element ? element->text : NULL;
}

bool pp_gbxml_document_number(const struct pp_xml_element *element, double *value)
{
    const char *text = pp_gbxml_document_text(element);
    return text && pp_text_parse_number(text, value);
}
