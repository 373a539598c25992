/* element_form.h - reads and checks elements by the tables of room_schema.h. Inside
 * model/room/ only. */
#ifndef PP_MODEL_ROOM_READ_ELEMENT_FORM_H
#define PP_MODEL_ROOM_READ_ELEMENT_FORM_H

#include "model/light/rough/rough_finishes.h"
#include "model/room/read/room_schema.h"

/* Fills the element's form from its attributes, with defaults for missing ones, and
 * reports mistakes. Returns false if there are any. per_metre: 1, or 1000 for a file in
 * millimetres; forms are in metres. materials: those of the file; NULL: none. */
bool pp_element_form_fill(void *form, const struct pp_element_rule *rule,
                          const struct pp_xml_element *element, double per_metre,
                          const struct pp_rough_finishes *materials,
                          struct pp_mistakes *mistakes);

/* Reports children that the element cannot have, and kinds of which it has too many or
 * too few. Returns false after a report. */
bool pp_element_form_check_children(const struct pp_element_rule *rule,
                                    const struct pp_xml_element *element,
                                    struct pp_mistakes *mistakes);

/* True if the rule has the name of the element. */
bool pp_element_form_matches(const struct pp_xml_element *element,
                             const struct pp_element_rule *rule);

#endif
