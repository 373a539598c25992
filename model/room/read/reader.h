/* reader.h - state shared by the readers of a room file's elements. Inside model/room/
 * only.
 *
 * Each reader reads one element into the room, reports its mistakes, and leaves the
 * element out if it has any.
 */
#ifndef PP_MODEL_ROOM_READ_READER_H
#define PP_MODEL_ROOM_READ_READER_H

#include "model/base/mistakes.h"
#include "model/base/xml.h"
#include "model/light/rough/rough_finishes.h"
#include "model/room/room_parts.h"
#include "model/room/read/room_schema.h"

enum { PP_READER_GLASSES = 64 };

struct pp_reader {
    struct pp_mistakes *mistakes;
    int bad_elements;
    bool out_of_memory;
    double per_metre;   /* units of the file per metre: 1, or 1000 for millimetres */
    const char *folder; /* folder for relative paths; NULL: read from memory */
    struct pp_rough_finishes *materials; /* materials of the file; NULL: none */

    /* Glazings of the table that were used so far (panes > 0), so that the integral of
     * each is calculated once. */
    struct pp_glass glasses[PP_READER_GLASSES];
};

/* True after too many mistakes, or if memory has run out. */
bool pp_reader_should_stop(const struct pp_reader *r);

/* Makes space for one more item in a list of `count` that grows only by this function;
 * `list` is the address of its pointer. False if memory runs out. */
bool pp_reader_reserve(struct pp_reader *r, void *list, int count, size_t size);

#define PP_READER_RESERVE(r, list, count)                                              \
    pp_reader_reserve(r, &(list), count, sizeof *(list))

/* Copies a text for the caller; NULL for NULL, or if memory runs out. */
char *pp_reader_copy_text(struct pp_reader *r, const char *text);

/* Path of a file that the room names, relative to the working directory. Freed by the
 * caller; NULL if memory runs out. */
char *pp_reader_path(struct pp_reader *r, const char *file);

/* Fills form from the element's attributes, and checks the names and numbers of its
 * children. False after a mistake, or if the file is truncated within the element;
 * truncation itself is reported elsewhere. */
bool pp_reader_fill_form(struct pp_reader *r, void *form,
                         const struct pp_element_rule *rule,
                         const struct pp_xml_element *element);

/* Appends the parent's vertices to the list; false if one has a mistake. */
bool pp_reader_add_vertices(struct pp_reader *r, struct pp_vertices *vertices,
                            const struct pp_element_rule *rule,
                            const struct pp_xml_element *parent);

#endif
