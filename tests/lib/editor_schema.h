/* editor_schema.h - validation by docs/room.rng, the schema that editors use for room
 * files. */
#ifndef PP_TESTS_LIB_EDITOR_SCHEMA_H
#define PP_TESTS_LIB_EDITOR_SCHEMA_H

#include <stdbool.h>
#include <stddef.h>

struct editor_schema;

/* Reads the schema from the source folder ($srcdir); NULL if it is invalid. */
struct editor_schema *editor_schema_create(void);
void editor_schema_destroy(struct editor_schema *schema); /* NULL is allowed */

/* True if the XML document is valid; false also if it is not XML. */
bool editor_schema_takes(const struct editor_schema *schema, const char *bytes,
                         size_t length);

#endif
