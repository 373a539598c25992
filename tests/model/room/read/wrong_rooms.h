/* wrong_rooms.h - rooms with one mistake each, of the text files in a folder.
 *
 * A file has the cases of one element. A case is a title, what differs from a base
 * room, and what must be said of that:
 *
 *     base study.xml
 *
 *     window wall unknown
 *          5 |  <window wall="front" left="0.9" sill="0.8" width="2.4" height="1.5"/>
 *         => line 5, sense: there is no wall "front"
 *
 *     window with child
 *          5 |  <window wall="south" left="0.9" sill="0.8" width="2.4" height="1.5">
 *          5 +    <glazing name="clear-single"/>
 *          5 +  </window>
 *         => line 6, form: window: element "glazing" is not known
 *
 *     base FILE   the room file in the same folder that the cases below change
 *     TITLE       begins the line; with - for blanks it is the room's file name
 *      N |TEXT    line N of the base room is TEXT, all of it from behind the bar
 *      N +TEXT    TEXT is a line behind line N (0: before the first)
 *      N -        line N is left out; N-M - leaves out N to M
 *     => line N, KIND: WORDS
 *                 the message is of line N of the wrong room, and has these words
 *     # ...       a comment
 *
 * Line numbers before |, + and - are those of the base room, in order. In TEXT \xNN is
 * a byte, and a \ at the end leaves out the end of the line. KIND is
 *
 *     xml    no well-formed XML of ours: the schema for editors is not asked
 *     form   the schema refuses it too
 *     sense  well formed by the schema, but no room
 */
#ifndef PP_TESTS_MODEL_ROOM_READ_WRONG_ROOMS_H
#define PP_TESTS_MODEL_ROOM_READ_WRONG_ROOMS_H

#include <stddef.h>

enum wrong_kind { WRONG_XML, WRONG_FORM, WRONG_SENSE };

struct wrong_room {
    char *file; /* the text file's name, without its folder */
    int at;     /* the title's line in that */
    char *title;
    char *bytes; /* the wrong room as a room file */
    size_t length;
    int line; /* the mistake's, in the room file */
    enum wrong_kind kind;
    char *words;
};

struct wrong_rooms {
    struct wrong_room *list;
    int count;
};

/* Reads every .txt file of the folder, in order of their names. What is not in the form
 * above, or has another's title, ends the program with its file and line. */
void wrong_rooms_read(struct wrong_rooms *rooms, const char *folder);
void wrong_rooms_clear(struct wrong_rooms *rooms);

/* The wrong room of that title, or NULL. */
const struct wrong_room *wrong_rooms_find(const struct wrong_rooms *rooms,
                                          const char *title);

#endif
