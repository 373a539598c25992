/* wrong_rooms.h - rooms with one mistake each, from the text files in a folder.
 *
 * A file has the cases of one element. A case is a title, the changes to a base room,
 * and the expected message:
 *
 *    base study.xml
 *
 *    window wall unknown
 *         5 |  <window wall="front" left="0.9" sill="0.8" width="2.4" height="1.5"/>
 *        => line 5, sense: there is no wall "front"
 *
 *    window with child
 *         5 |  <window wall="south" left="0.9" sill="0.8" width="2.4" height="1.5">
 *         5 +    <glazing name="clear-single"/>
 *         5 +  </window>
 *        => line 6, form: window: element "glazing" is not known
 *
 *    base FILE   the room file in the same folder that the following cases change
 *    TITLE       begins the line; with - for blanks it is the name of the room's file
 *     N |TEXT    replaces line N of the base room by TEXT, which begins after the bar
 *     N +TEXT    inserts TEXT after line N (0: before the first)
 *     N -        omits line N; N-M - omits lines N to M
 *    => line N, KIND: WORDS
 *                the message is for line N of the wrong room and contains these words
 *    # ...       a comment
 *
 * Line numbers before |, + and - are those of the base room, in ascending order. In
 * TEXT \xNN is a byte, and a \ at the end removes the end of the line. KIND is
 *
 *    xml    not well-formed XML; the schema for editors is not tested
 *    form   the schema also rejects it
 *    sense  valid by the schema, but not a possible room
 */
#ifndef PP_TESTS_MODEL_ROOM_READ_WRONG_ROOMS_H
#define PP_TESTS_MODEL_ROOM_READ_WRONG_ROOMS_H

#include <stddef.h>

enum wrong_kind { WRONG_XML, WRONG_FORM, WRONG_SENSE };

struct wrong_room {
    char *file; /* name of the text file, without its folder */
    int at;     /* line of the title in this file */
    char *title;
    char *bytes; /* the wrong room as a room file */
    size_t length;
    int line; /* line of the mistake in the room file */
    enum wrong_kind kind;
    char *words;
};

struct wrong_rooms {
    struct wrong_room *list;
    int count;
};

/* Reads every .txt file of the folder, in the order of their names. A line in another
 * form, or a repeated title, ends the program with its file and line. */
void wrong_rooms_read(struct wrong_rooms *rooms, const char *folder);
void wrong_rooms_clear(struct wrong_rooms *rooms);

/* The wrong room of that title, or NULL. */
const struct wrong_room *wrong_rooms_find(const struct wrong_rooms *rooms,
                                          const char *title);

#endif
