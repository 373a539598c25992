/* net_unfold.h - unfolds panels into connected flat pieces that fit the sheet, with
 * tabs at glued edges, and places the pieces on sheets. Inside charts/net/ only. */
#ifndef PP_CHARTS_NET_NET_UNFOLD_H
#define PP_CHARTS_NET_NET_UNFOLD_H

#include "charts/net/net_panels.h"

struct pp_net_piece {
    struct pp_bounds2 extent; /* tabs included, in its own coordinates */
    int sheet;                /* from 0 */
    double place[2];          /* the extent's lower left corner on the sheet's area, y
                               * up */
};

struct pp_net {
    struct pp_net_panels panels;
    int piece_count, sheet_count;
    struct pp_net_piece *pieces;
};

enum { PP_NET_TAB_CORNERS = 4 };

/* The whole net of a room on sheets of that area. */
enum pp_status pp_net_unfold(struct pp_net *net, const struct pp_world *world,
                             double mm_per_m, const double area_mm[2],
                             struct pp_error *err);
void pp_net_unfold_clear(struct pp_net *net);

/* The tab of an edge in the piece: the edge's first corner, the outer corners, its last
 * corner. */
void pp_net_unfold_tab(const struct pp_net_panel *panel, int edge,
                       double xy[PP_NET_TAB_CORNERS][2]);

#endif
