/* opening_outline.h - in which face an opening of the room file lies, and where in it.
 * Inside model/room/ only. */
#ifndef PP_MODEL_ROOM_BUILD_OPENING_OUTLINE_H
#define PP_MODEL_ROOM_BUILD_OPENING_OUTLINE_H

#include "model/room/build/resolve.h"
#include "model/room/face_frame.h"

/* "window", "rooflight" or "opening". */
const char *pp_opening_outline_word(const struct pp_opening_part *part);

/* Name of a face in a message: wall "south", or the ceiling. Returns text. */
const char *pp_opening_outline_face_words(char *text, size_t size,
                                          const struct pp_surface *face);

/* The surface that the opening lies in; -1 where it lies in none, which is noted, or in
 * one that could not be made. */
int pp_opening_outline_face(struct pp_resolver *r, const struct pp_opening_part *part);

/* The opening's outline in that face's own axes, counter-clockwise seen from inside: xy
 * has room for four points, or for the polygon's. False, and noted, for a window that
 * sticks out of its wall's extent. */
bool pp_opening_outline(struct pp_resolver *r, const struct pp_opening_part *part,
                        const struct pp_face_frame *frame, double (*xy)[2]);

#endif
