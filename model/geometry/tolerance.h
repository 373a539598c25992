/* tolerance.h - tolerances of lengths and angles, in one place.
 *
 * A room file is typed by people, to the millimetre at best; two points nearer than
 * that count as one. Sums of typed lengths (left + width) are off by rounding only, and
 * far less.
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

/* Surfaces flush with the envelope are moved off it by this, so that rays meet them in
 * a definite order. Metres. */
#define PP_SET_OFF_M 1e-4

/* A face is level, a direction horizontal, when its slope is below this (radians). */
#define PP_LEVEL_RAD 1e-6

#endif
