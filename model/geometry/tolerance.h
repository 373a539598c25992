/* tolerance.h - tolerances of lengths and angles.
 *
 * Room files are typed with a precision of at best 1 mm; two points nearer than that
 * are the same. Sums of typed lengths (left + width) differ only by rounding, which is
 * much smaller.
 */
#ifndef PP_MODEL_GEOMETRY_TOLERANCE_H
#define PP_MODEL_GEOMETRY_TOLERANCE_H

/* Points nearer than this (m) are the same. Also the tolerance for plane polygons and
 * for openings in a face, and the smallest size of any object. */
#define PP_SAME_M 1e-3

/* Rounding error (m) of a sum of typed lengths. A window that exceeds its wall by less
 * is moved back; an overlap of neighbours by less is ignored. */
#define PP_ROUNDING_M 1e-6

/* A receiver nearer to a surface than this (m) lies on it. */
#define PP_TOUCH_M 1e-4

/* Offset (m) of surfaces that lie in a face of the envelope, so that rays hit them in a
 * definite order. */
#define PP_SET_OFF_M 1e-4

/* A face or direction with a slope below this (rad) is horizontal. */
#define PP_LEVEL_RAD 1e-6

#endif
