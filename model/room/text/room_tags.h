/* room_tags.h - start tags and their attributes in the text of a room file. Inside
 * model/room/ only.
 *
 * The text is well-formed XML without DOCTYPE. So "<" and ">" enclose a tag, a comment,
 * a processing instruction or CDATA, and a ">" in a tag is quoted or ends it.
 */
#ifndef PP_MODEL_ROOM_TEXT_ROOM_TAGS_H
#define PP_MODEL_ROOM_TEXT_ROOM_TAGS_H

#include <stdbool.h>
#include <stdio.h>

/* A range of the text; `to` is exclusive. */
struct pp_room_tag {
    const char *from, *to;
};

/* Next start tag from `at` on, including "<" and ">"; empty, at `end`, if there is
 * none. */
struct pp_room_tag pp_room_tags_next(const char *at, const char *end);

/* Extends a tag to its whole element. Children must be tags that end in "/>". */
struct pp_room_tag pp_room_tags_element(struct pp_room_tag tag, const char *end);

bool pp_room_tags_is_named(struct pp_room_tag tag, const char *name);

/* Value of the tag's attribute, between its quotes. If the tag has no such attribute,
 * the result is an empty range at the tag's end; the range of an empty value lies
 * before the end. */
struct pp_room_tag pp_room_tags_attribute(struct pp_room_tag tag, const char *name);

/* Writes text as an attribute's value, valid in either kind of quotes. */
void pp_room_tags_put_escaped(FILE *out, const char *text);

#endif
