/* face_frame.h - a face in its own axes, and whether a figure lies within it. */
#ifndef PP_MODEL_ROOM_FACE_FRAME_H
#define PP_MODEL_ROOM_FACE_FRAME_H

#include "model/geometry/clipper.h"
#include "model/room/world.h"

/* A face's outline in its own axes, measured from its first vertex. */
struct pp_face_frame {
    const struct pp_surface *face; /* not owned */
    struct pp_vec3 origin, along, up;
    double (*xy)[2]; /* the outline */
    int count;
    struct pp_bounds2 bounds; /* of xy */
    bool convex;
};

enum pp_status pp_face_frame_init(struct pp_face_frame *frame,
                                  const struct pp_surface *face, struct pp_error *err);
void pp_face_frame_clear(struct pp_face_frame *frame);

/* The point in space. */
struct pp_vec3 pp_face_frame_point(const struct pp_face_frame *frame, double x,
                                   double y);

/* Moves vertices of the ring that stick out by at most the tolerance (m) on to the
 * frame's edge. *out_m is then the distance by which the farthest vertex, at `where`,
 * still sticks out. *out_m2 is the area outside if no vertex is outside but the ring
 * reaches over a recess. Both 0: the ring lies within. */
enum pp_status pp_face_frame_fit(const struct pp_face_frame *frame,
                                 struct pp_clipper *clipper, double (*xy)[2], int count,
                                 double tolerance, double *out_m, struct pp_vec3 *where,
                                 double *out_m2, struct pp_error *err);

/* The area that two rings have in common (m2); 0 where they only touch. */
enum pp_status pp_face_frame_rings_overlap(struct pp_clipper *clipper,
                                           const double (*a)[2], int a_count,
                                           const double (*b)[2], int b_count,
                                           double *area_m2, struct pp_error *err);

#endif
