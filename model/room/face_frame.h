/* face_frame.h - a face in its own axes, and tests whether an outline lies within
 * it. */
#ifndef PP_MODEL_ROOM_FACE_FRAME_H
#define PP_MODEL_ROOM_FACE_FRAME_H

#include "model/geometry/clipper.h"
#include "model/room/world.h"

/* Outline of a face in its own axes. The origin is the first vertex, projected onto the
 * face's plane if the face is slightly uneven. */
struct pp_face_frame {
    const struct pp_surface *face; /* not owned */
    struct pp_vec3 origin, along, up;
    double (*xy)[2]; /* vertices of the outline */
    int count;
    struct pp_bounds2 bounds; /* bounds of xy */
    bool convex;
};

enum pp_status pp_face_frame_init(struct pp_face_frame *frame,
                                  const struct pp_surface *face, struct pp_error *err);
void pp_face_frame_clear(struct pp_face_frame *frame);

/* Converts coordinates in the face to a point in space. */
struct pp_vec3 pp_face_frame_point(const struct pp_face_frame *frame, double x,
                                   double y);

/* Moves vertices of the ring that are outside the frame by at most the tolerance (m) to
 * the frame's edge. *out_m: greatest distance of a remaining vertex, at *where, outside
 * the frame. *out_m2: area outside the frame if no vertex is outside, but the ring
 * crosses a recess of the frame. Both are 0 if the ring lies within the frame. */
enum pp_status pp_face_frame_fit(const struct pp_face_frame *frame,
                                 struct pp_clipper *clipper, double (*xy)[2], int count,
                                 double tolerance, double *out_m, struct pp_vec3 *where,
                                 double *out_m2, struct pp_error *err);

/* Common area (m2) of two rings; 0 if they only touch. */
enum pp_status pp_face_frame_rings_overlap(struct pp_clipper *clipper,
                                           const double (*a)[2], int a_count,
                                           const double (*b)[2], int b_count,
                                           double *area_m2, struct pp_error *err);

#endif
