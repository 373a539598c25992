/* editor_schema.c - validates with libxml2's RELAX NG. */
#include "tests/lib/editor_schema.h"

#include <libxml/parser.h>
#include <libxml/relaxng.h>
#include <stdio.h>
#include <stdlib.h>

struct editor_schema {
    xmlRelaxNGPtr grammar;
};

struct editor_schema *editor_schema_create(void)
{
    const char *source = getenv("srcdir");
    char path[1024];
    snprintf(path, sizeof path, "%s/docs/room.rng", source ? source : ".");
    struct editor_schema *schema = malloc(sizeof *schema);
    xmlRelaxNGParserCtxtPtr parser = xmlRelaxNGNewParserCtxt(path);
    if (!schema || !parser)
        abort();
    schema->grammar = xmlRelaxNGParse(parser);
    xmlRelaxNGFreeParserCtxt(parser);
    if (!schema->grammar) {
        free(schema);
        return NULL;
    }
    return schema;
}

void editor_schema_destroy(struct editor_schema *schema)
{
    if (!schema)
        return;
    xmlRelaxNGFree(schema->grammar);
    free(schema);
}

static void say_nothing(void *context, const char *format, ...)
{
    (void)context, (void)format;
}

bool editor_schema_takes(const struct editor_schema *schema, const char *bytes,
                         size_t length)
{
    xmlDocPtr document = xmlReadMemory(bytes, (int)length, NULL, NULL, XML_PARSE_NONET);
    if (!document)
        return false;
    xmlRelaxNGValidCtxtPtr valid = xmlRelaxNGNewValidCtxt(schema->grammar);
    if (!valid)
        abort();
    xmlRelaxNGSetValidErrors(valid, say_nothing, say_nothing, NULL);
    bool takes = xmlRelaxNGValidateDoc(valid, document) == 0;
    xmlRelaxNGFreeValidCtxt(valid);
    xmlFreeDoc(document);
    return takes;
}
