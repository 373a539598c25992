/* net_panels.h - the faces of a room as flat panels for a scale model. Faces larger
 * than a sheet are cut into parts. Edges to be glued are paired. For use inside
 * charts/net/ only. */
#ifndef PP_CHARTS_NET_NET_PANELS_H
#define PP_CHARTS_NET_NET_PANELS_H

#include <stdbool.h>

#include "model/base/error.h"
#include "model/geometry/bounds.h"
#include "model/room/world.h"

enum pp_net_join {
    PP_NET_PLAIN, /* no tab: glued to another panel's tab, or free */
    PP_NET_TAB,   /* has a tab */
    PP_NET_FOLD,  /* connected to its neighbour by a fold */
    PP_NET_TAPE   /* to be taped: neither side has space for a tab */
};

struct pp_net_edge {
    int number; /* number of the edge, from 0; printed from 1. Edges that meet have the
                   same number */
    int panel, edge; /* panel and edge with the same end points; -1: none */
    enum pp_net_join join;
};

/* A panel in its own axes: millimetres on the model, y up, seen from inside the
 * room. */
struct pp_net_panel {
    int face;
    int part, parts;                  /* index of this part of the face, from 0; number
                                       * of parts */
    struct pp_vec3 origin, along, up; /* origin and unit vectors of the panel's axes in
                                       * the room */
    double turn[2], shift[2]; /* from the panel's axes to the piece: cosine and sine;
                               * mm */
    int count;
    double (*own)[2];          /* corners in the panel's own axes */
    struct pp_net_edge *edges; /* from each corner to the next */
    int piece;                 /* index of the piece that contains the panel; -1: none
                                * yet */
};

struct pp_net_panels {
    double mm_per_m;
    int count, edge_numbers;
    struct pp_net_panel *list;
};

/* Makes panels of all faces of the envelope. Each panel fits the limit, upright or
 * turned by 90 degrees. On success the caller clears *panels. PP_BAD_INPUT if faces
 * must be cut and there would be more than 400 panels. */
enum pp_status pp_net_panels_init(struct pp_net_panels *panels,
                                  const struct pp_world *world, double mm_per_m,
                                  const double limit_mm[2], struct pp_error *err);
void pp_net_panels_clear(struct pp_net_panels *panels);

/* Projects a point of the room perpendicularly on the panel; result in the panel's own
 * axes. */
void pp_net_panels_own(const struct pp_net_panels *panels,
                       const struct pp_net_panel *panel, struct pp_vec3 point,
                       double xy[2]);

/* Position in the panel's piece: of a corner of the panel, of a place given in the
 * panel's own axes, or of a point of the room in the plane of the face. */
void pp_net_panels_corner(const struct pp_net_panel *panel, int corner, double xy[2]);
void pp_net_panels_place(const struct pp_net_panel *panel, const double own[2],
                         double xy[2]);
void pp_net_panels_point(const struct pp_net_panels *panels,
                         const struct pp_net_panel *panel, struct pp_vec3 point,
                         double xy[2]);

#endif
