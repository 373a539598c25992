/* schema_rows.h - short forms for the tables of room_schema.h: names of values, and
 * macros for rows and rules. Inside model/room/read/ only. */
#ifndef PP_MODEL_ROOM_READ_SCHEMA_ROWS_H
#define PP_MODEL_ROOM_READ_SCHEMA_ROWS_H

#include <math.h>
#include <stddef.h>

#include "model/room/read/room_schema.h"
#include "model/room/read/room_values.h"

#define REQUIRED true, NAN
#define OR(fallback) false, fallback
#define IN(form, member) offsetof(struct pp_##form##_form, member)
#define RULE(id, element, attributes, children)                                        \
    const struct pp_element_rule pp_rule_##id = {                                      \
        element, attributes, sizeof attributes / sizeof *attributes, children,         \
        sizeof children / sizeof *children}
#define LEAF(id, element, attributes)                                                  \
    const struct pp_element_rule pp_rule_##id = {                                      \
        element, attributes, sizeof attributes / sizeof *attributes, NULL, 0}

#endif
