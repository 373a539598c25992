/* room_tags.h - start tags and their attributes in the text of a room file. Inside
 * model/room/ only.
 *
 * The text is well-formed XML without DOCTYPE, so that between "<" and ">" there is
 * a tag, a comment, a processing instruction or CDATA, and a ">" in a tag stands in
 * quotes or ends it.
 */
#ifndef PP_MODEL_ROOM_TEXT_ROOM_TAGS_H
#define PP_MODEL_ROOM_TEXT_ROOM_TAGS_H

#include <stdbool.h>
#include <stdio.h>

/* A part of the text; `to` is behind its last byte. */
struct pp_room_tag {
    const char *from, *to;
};

/* The next start tag at or behind `at`, from "<" to behind ">"; empty, at `end`, if there
 * is none. */
struct pp_room_tag pp_room_tags_next(const char *at, const char *end);

/* The whole element of the tag, which has no children. */
struct pp_room_tag pp_room_tags_element(struct pp_room_tag tag, const char *end);

bool pp_room_tags_is_named(struct pp_room_tag tag, const char *name);

/* The value of the tag's attribute, between its quotes; empty, at the tag's end, if it has
 * none of that name. An empty value is empty before the tag's end. */
struct pp_room_tag pp_room_tags_attribute(struct pp_room_tag tag, const char *name);

/* Writes text as an attribute's value, valid in either kind of quotes. */
void pp_room_tags_put_escaped(FILE *out, const char *text);

#endif
