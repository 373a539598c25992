/* reader.h - what the readers of a room file's elements share. Inside model/room/ only.
 *
 * Each reader takes one element to its place in the room, notes what is wrong with it,
 * and leaves out what has a mistake in it.
 */
#ifndef PP_MODEL_ROOM_READ_READER_H
#define PP_MODEL_ROOM_READ_READER_H

#include "model/base/mistakes.h"
#include "model/room/room_parts.h"
#include "model/room/read/room_schema.h"
#include "model/room/read/xml.h"

enum { PP_READER_GLASSES = 64 };

struct pp_reader {
    struct pp_mistakes *mistakes;
    int bad_elements;
    bool out_of_memory;
    void *moved; /* PP_READER_RESERVE's */

    /* The table's glazings, once met (panes > 0): each takes an integral. */
    struct pp_glass glasses[PP_READER_GLASSES];
};

/* Nothing more to be gained by reading on? */
bool pp_reader_should_stop(const struct pp_reader *r);

/* The list with room for one more behind its `count`, moved if need be; NULL when
 * memory is out. */
void *pp_reader_grow_list(struct pp_reader *r, void *list, int count, size_t size);

/* Makes sure that the list can take one more; false when memory is out. */
#define PP_READER_RESERVE(r, list, count)                                              \
    ((r)->moved = pp_reader_grow_list(r, list, count, sizeof *(list)),                 \
     (r)->moved ? ((list) = (r)->moved, true) : false)

/* A copy that is the caller's; NULL for NULL, and when memory is out. */
char *pp_reader_copy_text(struct pp_reader *r, const char *text);

/* Attributes into form, and the children's names and numbers checked. False where
 * there is a mistake, or where the file breaks off within the element: then there is
 * nothing more to be said of it. */
bool pp_reader_fill_form(struct pp_reader *r, void *form,
                         const struct pp_element_rule *rule,
                         const struct pp_xml_element *element);

/* Appends the parent's vertices to the list; false where one has a mistake. */
bool pp_reader_add_vertices(struct pp_reader *r, struct pp_vertices *vertices,
                            const struct pp_element_rule *rule,
                            const struct pp_xml_element *parent);
void pp_reader_vertices_clear(struct pp_vertices *vertices);

/* read_shape.c */
void pp_read_shape_plan(struct pp_reader *r, struct pp_room *room,
                        const struct pp_xml_element *e);
void pp_read_shape_envelope(struct pp_reader *r, struct pp_room *room,
                            const struct pp_xml_element *e);
/* Notes where the room `e` has both plan and envelope, or neither. */
void pp_read_shape_check(struct pp_reader *r, const struct pp_xml_element *e);
void pp_read_shape_clear_plan(struct pp_plan_part *plan);

/* read_opening.c */
void pp_read_opening(struct pp_reader *r, struct pp_room *room,
                     const struct pp_xml_element *e, enum pp_opening_kind kind,
                     const struct pp_element_rule *rule);

#endif
