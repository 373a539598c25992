/* net_unfold.h - unfolds panels into connected flat pieces that fit the sheet, with
 * tabs at glued edges, and places the pieces on sheets. For use inside charts/net/
 * only. */
#ifndef PP_CHARTS_NET_NET_UNFOLD_H
#define PP_CHARTS_NET_NET_UNFOLD_H

#include "charts/net/net_panels.h"

struct pp_net_piece {
    struct pp_bounds2 extent; /* extent including tabs, in the coordinates of the
                               * piece */
    int sheet;                /* index of the sheet, from 0 */
    double place[2];          /* position of the lower left corner of `extent` in the
                               * area of the sheet, y up */
};

struct pp_net {
    struct pp_net_panels panels;
    int piece_count, sheet_count;
    struct pp_net_piece *pieces;
};

enum { PP_NET_TAB_CORNERS = 4 };

/* Makes the whole net of a room, on sheets of that free area. */
enum pp_status pp_net_unfold(struct pp_net *net, const struct pp_world *world,
                             double mm_per_m, const double area_mm[2],
                             struct pp_error *err);
void pp_net_unfold_clear(struct pp_net *net);

/* Corners of an edge's tab in the coordinates of the piece: first corner of the edge,
 * two outer corners, last corner of the edge. */
void pp_net_unfold_tab(const struct pp_net_panel *panel, int edge,
                       double xy[PP_NET_TAB_CORNERS][2]);

#endif
