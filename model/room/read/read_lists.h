/* read_lists.h - what the readers of a room file's elements share. Inside model/room/ only.
 *
 * Each reader takes one element to its place in the room, notes what is wrong with it,
 * and leaves out what has a mistake in it.
 */
#ifndef PP_MODEL_ROOM_READER_H
#define PP_MODEL_ROOM_READER_H

#include "model/base/mistakes.h"
#include "model/room/room_parts.h"
#include "model/room/read/room_schema.h"
#include "model/room/read/xml_input.h"

enum { PP_READER_GLASSES = 64 };

struct pp_room_reader {
    struct pp_mistakes *mistakes;
    int bad_elements;
    bool out_of_memory;
    void *moved; /* PP_RESERVE's */

    /* The table's glazings, once met (panes > 0): each takes an integral. */
    struct pp_glass glasses[PP_READER_GLASSES];
};

/* Nothing more to be gained by reading on? */
bool pp_reader_gives_up(const struct pp_room_reader *r);

/* The list with room for one more behind its `count`, moved if need be; NULL when
 * memory is out. */
void *pp_reader_grown(struct pp_room_reader *r, void *list, int count, size_t size);

/* Makes sure that the list can take one more; false when memory is out. */
#define PP_RESERVE(r, list, count)                                                     \
    ((r)->moved = pp_reader_grown(r, list, count, sizeof *(list)),                     \
     (r)->moved ? ((list) = (r)->moved, true) : false)

/* A copy that is the caller's; NULL for NULL, and when memory is out. */
char *pp_reader_text(struct pp_room_reader *r, const char *text);

/* Attributes into form, and the children's names and numbers checked. False where
 * there is a mistake, or where the file breaks off within the element: then there is
 * nothing more to be said of it. */
bool pp_reader_form(struct pp_room_reader *r, void *form,
                    const struct pp_element_rule *rule,
                    const struct pp_xml_element *element);

/* Appends the parent's vertices to the list; false where one has a mistake. */
bool pp_reader_vertices(struct pp_room_reader *r, struct pp_vertices *vertices,
                        const struct pp_element_rule *rule,
                        const struct pp_xml_element *parent);
void pp_vertices_clear(struct pp_vertices *vertices);

/* read_shape.c */
void pp_read_plan(struct pp_room_reader *r, struct pp_room *room,
                  const struct pp_xml_element *e);
void pp_read_envelope(struct pp_room_reader *r, struct pp_room *room,
                      const struct pp_xml_element *e);
/* Notes where the room `e` has both plan and envelope, or neither. */
void pp_check_shape(struct pp_room_reader *r, const struct pp_xml_element *e);
void pp_plan_clear(struct pp_plan_part *plan);

/* read_opening.c */
void pp_read_opening(struct pp_room_reader *r, struct pp_room *room,
                     const struct pp_xml_element *e, enum pp_opening_kind kind,
                     const struct pp_element_rule *rule);

#endif
