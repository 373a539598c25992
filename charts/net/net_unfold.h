/* net_unfold.h - panels hung together as far as they stay flat and on the sheet, tabs where
 * they are glued, and the pieces laid on sheets. Inside charts/net/ only. */
#ifndef PP_CHARTS_NET_NET_UNFOLD_H
#define PP_CHARTS_NET_NET_UNFOLD_H

#include "charts/net/net_panels.h"

struct pp_net_piece {
    struct pp_bounds2 extent; /* tabs included, in its own coordinates */
    int sheet;                /* from 0 */
    double place[2];          /* of the extent's low corner on the sheet's area, y up */
};

struct pp_net {
    struct pp_net_panels panels;
    int piece_count, sheet_count;
    struct pp_net_piece *pieces;
};

enum { PP_NET_TAB_CORNERS = 4 };

/* The whole net of a room on sheets that have that area. */
enum pp_status pp_net_unfold(struct pp_net *net, const struct pp_world *world,
                             double mm_per_m, const double area_mm[2],
                             struct pp_error *err);
void pp_net_unfold_clear(struct pp_net *net);

/* The tab of an edge, from its first corner over the outer ones to its last, in the
 * piece. */
void pp_net_unfold_tab(const struct pp_net_panel *panel, int edge,
                       double xy[PP_NET_TAB_CORNERS][2]);

#endif
