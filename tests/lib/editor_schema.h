/* editor_schema.h - the verdict of docs/room.rng, by which editors check room files. */
#ifndef PP_TESTS_LIB_EDITOR_SCHEMA_H
#define PP_TESTS_LIB_EDITOR_SCHEMA_H

#include <stdbool.h>
#include <stddef.h>

struct editor_schema;

/* The schema, read from the sources' folder ($srcdir); NULL where it is no schema. */
struct editor_schema *editor_schema_create(void);
void editor_schema_destroy(struct editor_schema *schema); /* NULL is allowed */

/* Is the XML document a room by the schema? False, too, where it is no XML. */
bool editor_schema_takes(const struct editor_schema *schema, const char *bytes,
                         size_t length);

#endif
