/* tolerance.h - how near is the same, in one place.
 *
 * A room file is typed by people, to the millimetre at best; two points nearer than
 * that are meant to be one. Sums of typed lengths (left + width) are off by rounding
 * only, and far less.
 */
#ifndef PP_MODEL_GEOMETRY_TOLERANCE_H
#define PP_MODEL_GEOMETRY_TOLERANCE_H

/* Points nearer than this are one; a polygon is plane, an opening lies in a face, to
 * within it; nothing may be smaller. Metres. */
#define PP_SAME_M 1e-3

/* Rounding error of a sum of typed lengths: a window that sticks out of its wall or into
 * its neighbour by less is moved back. Metres. */
#define PP_ROUNDING_M 1e-6

/* A receiver nearer to a surface than this lies on it. Metres. */
#define PP_TOUCH_M 1e-4

/* Surfaces that lie flush against the envelope are set off by this, so that it is
 * plain to a ray which of the two it meets. Metres. */
#define PP_SET_OFF_M 1e-4

/* A face is level, a direction horizontal, when its slope is below this (radians). */
#define PP_LEVEL_RAD 1e-6

#endif
