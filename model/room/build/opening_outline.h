/* opening_outline.h - finds the face of the room that contains an opening, and the
 * outline of the opening in that face. Inside model/room/ only. */
#ifndef PP_MODEL_ROOM_BUILD_OPENING_OUTLINE_H
#define PP_MODEL_ROOM_BUILD_OPENING_OUTLINE_H

#include "model/room/build/resolve.h"
#include "model/room/face_frame.h"

/* Returns "window", "rooflight" or "opening". */
const char *pp_opening_outline_word(const struct pp_opening_part *part);

/* Name of a face in a message: wall "south", or the ceiling. Returns text. */
const char *pp_opening_outline_face_words(char *text, size_t size,
                                          const struct pp_surface *face);

/* Index of the face that contains the opening. -1, with a report, if there is no such
 * face, or if the vertices of an <opening> are clockwise seen from inside; -1 also if
 * the face itself is invalid. */
int pp_opening_outline_face(struct pp_resolver *r, const struct pp_opening_part *part);

/* Outline of the opening in the axes of that face, counter-clockwise seen from inside.
 * xy has space for four points, or for the vertices of an <opening>. Returns false,
 * with a report, if a window extends beyond its wall. */
bool pp_opening_outline(struct pp_resolver *r, const struct pp_opening_part *part,
                        const struct pp_face_frame *frame, double (*xy)[2]);

#endif
