/* corners.h - the step that makes corners of the envelope one that are meant to be
 * one. Inside model/room/ only. */
#ifndef PP_MODEL_ROOM_BUILD_CORNERS_H
#define PP_MODEL_ROOM_BUILD_CORNERS_H

#include "model/room/build/resolve.h"

/* Points nearer than PP_SAME_M, by more than PP_ROUNDING_M, become equal to the bit, so
 * that later steps can follow edges from face to face; fills r->corners with their
 * numbers. A smaller gap in an envelope is closed so, one of a millimetre stays open. */
enum pp_status pp_build_corners(struct pp_resolver *r, struct pp_error *err);

#endif
