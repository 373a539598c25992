/* net_panels.h - the faces of a room as flat panels for a scale model, cut into parts
 * if they are larger than a sheet; and the pairs of edges to be glued. Inside
 * charts/net/ only. */
#ifndef PP_CHARTS_NET_NET_PANELS_H
#define PP_CHARTS_NET_NET_PANELS_H

#include <stdbool.h>

#include "model/base/error.h"
#include "model/geometry/bounds.h"
#include "model/room/world.h"

enum pp_net_join {
    PP_NET_PLAIN, /* glued to a tab of another panel, or to nothing */
    PP_NET_TAB,   /* has the tab */
    PP_NET_FOLD,  /* the panels are connected here */
    PP_NET_TAPE   /* no space for a tab on either side */
};

struct pp_net_edge {
    int number;      /* shared with the edges it meets */
    int panel, edge; /* panel and edge with the same ends; -1: none */
    enum pp_net_join join;
};

/* Coordinates are millimetres on the model, y up, seen from inside the room. */
struct pp_net_panel {
    int face;
    int part, parts;                  /* index of the part of the face, from 0; number
                                       * of parts */
    struct pp_vec3 origin, along, up; /* axes in the face's plane */
    double turn[2], shift[2]; /* from these axes to the piece: cosine and sine; mm */
    int count;
    double (*own)[2];          /* corners in the panel's own axes */
    struct pp_net_edge *edges; /* from each corner to the next */
    int piece;                 /* the piece it belongs to; -1: none yet */
};

struct pp_net_panels {
    double mm_per_m;
    int count, edge_numbers;
    struct pp_net_panel *list;
};

/* Panels of all faces of the envelope, none larger than the limit, either upright or
 * turned by a quarter. On success the caller clears *panels. PP_BAD_INPUT for a model of
 * more than 400 sheets. */
enum pp_status pp_net_panels_init(struct pp_net_panels *panels,
                                  const struct pp_world *world, double mm_per_m,
                                  const double limit_mm[2], struct pp_error *err);
void pp_net_panels_clear(struct pp_net_panels *panels);

/* Perpendicular projection of a point of the room on a panel, in the panel's own
 * axes. */
void pp_net_panels_own(const struct pp_net_panels *panels,
                       const struct pp_net_panel *panel, struct pp_vec3 point,
                       double xy[2]);

/* Position in its piece of a panel's corner, of a place in its own axes, or of a point
 * of the room in its face's plane. */
void pp_net_panels_corner(const struct pp_net_panel *panel, int corner, double xy[2]);
void pp_net_panels_place(const struct pp_net_panel *panel, const double own[2],
                         double xy[2]);
void pp_net_panels_point(const struct pp_net_panels *panels,
                         const struct pp_net_panel *panel, struct pp_vec3 point,
                         double xy[2]);

#endif
