/* reader.h - the state that the readers of a room file's elements share. Inside
 * model/room/ only.
 *
 * Each reader reads one element into its place in the room, notes its mistakes, and
 * leaves it out if it has any.
 */
#ifndef PP_MODEL_ROOM_READ_READER_H
#define PP_MODEL_ROOM_READ_READER_H

#include "model/base/mistakes.h"
#include "model/base/xml.h"
#include "model/room/room_parts.h"
#include "model/room/read/room_schema.h"

enum { PP_READER_GLASSES = 64 };

struct pp_reader {
    struct pp_mistakes *mistakes;
    int bad_elements;
    bool out_of_memory;
    double per_metre;   /* of the file's lengths: 1, or 1000 for millimetres */
    const char *folder; /* that its paths are relative to; NULL: it is in memory */

    /* Glazings of the table used so far (panes > 0), so that each is integrated
     * once. */
    struct pp_glass glasses[PP_READER_GLASSES];
};

/* True after enough mistakes, or if memory is out. */
bool pp_reader_should_stop(const struct pp_reader *r);

/* Room for one item more than `count` in a list that has grown so only (its address is
 * `list`); false when memory is out. */
bool pp_reader_reserve(struct pp_reader *r, void *list, int count, size_t size);

#define PP_READER_RESERVE(r, list, count)                                              \
    pp_reader_reserve(r, &(list), count, sizeof *(list))

/* A copy that is the caller's; NULL for NULL, and when memory is out. */
char *pp_reader_copy_text(struct pp_reader *r, const char *text);

/* Fills form from the element's attributes, and checks the names and numbers of its
 * children. False on a mistake, or if the file ends within the element, about which
 * nothing more is then reported. */
bool pp_reader_fill_form(struct pp_reader *r, void *form,
                         const struct pp_element_rule *rule,
                         const struct pp_xml_element *element);

/* Appends the parent's vertices to the list; false where one has a mistake. */
bool pp_reader_add_vertices(struct pp_reader *r, struct pp_vertices *vertices,
                            const struct pp_element_rule *rule,
                            const struct pp_xml_element *parent);

#endif
