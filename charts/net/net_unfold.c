/* net_unfold.c - unfolds the floor first, then its neighbours about their common edges,
 * then the next neighbours. A panel that would overlap others or not fit begins a new
 * piece. */
#include "charts/net/net_unfold.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/array.h"
#include "model/geometry/clipper.h"

/* Sizes on paper: width of a tab and space between pieces (mm), and tolerated overlap
 * (mm2). */
static const double TAB_MM = 8.0, GAP_MM = 5.0, OVERLAP_MM2 = 0.05;

struct unfolding {
    struct pp_net *net;
    struct pp_clipper *clipper;
    double limit[2]; /* largest size of a piece without tabs */
    struct pp_error *err;
    enum pp_status status;
};

/* ---- overlaps ---- */

static double common_area(struct unfolding *unfolding, const double (*a)[2],
                          int a_count, const double (*b)[2], int b_count)
{
    struct pp_region p = {0}, q = {0}, both = {0};
    double area = 0.0;
    if (unfolding->status == PP_OK)
        unfolding->status =
            pp_clipper_of_ring(unfolding->clipper, &p, a, a_count, unfolding->err);
    if (unfolding->status == PP_OK)
        unfolding->status =
            pp_clipper_of_ring(unfolding->clipper, &q, b, b_count, unfolding->err);
    if (unfolding->status == PP_OK)
        unfolding->status =
            pp_clipper_intersection(unfolding->clipper, &both, &p, &q, unfolding->err);
    if (unfolding->status == PP_OK)
        area = pp_region_area(&both);
    pp_region_clear(&p);
    pp_region_clear(&q);
    pp_region_clear(&both);
    return area;
}

/* Corners of a panel in the coordinates of its piece; the caller frees them. If memory
 * is exhausted, returns NULL and sets unfolding->status. */
static double (*corners_of(struct unfolding *unfolding,
                           const struct pp_net_panel *panel))[2]
{
    double(*xy)[2] = malloc((size_t)panel->count * sizeof *xy);
    if (!xy)
        unfolding->status = pp_fail_memory(unfolding->err);
    for (int i = 0; xy && i < panel->count; i++)
        pp_net_panels_corner(panel, i, xy[i]);
    return xy;
}

/* True if a polygon overlaps any panel of the piece other than panel `other_than` (-1:
 * no exception). */
static bool hits_panel(struct unfolding *unfolding, int piece, const double (*xy)[2],
                       int count, int other_than)
{
    const struct pp_net_panels *panels = &unfolding->net->panels;
    bool hit = false;
    for (int i = 0; i < panels->count && !hit && unfolding->status == PP_OK; i++) {
        const struct pp_net_panel *panel = &panels->list[i];
        if (panel->piece != piece || i == other_than)
            continue;
        double(*corners)[2] = corners_of(unfolding, panel);
        hit = corners
              && common_area(unfolding, xy, count, (const double(*)[2])corners,
                             panel->count)
                     > OVERLAP_MM2;
        free(corners);
    }
    return hit;
}

/* ---- unfolding ---- */

static struct pp_bounds2 piece_extent(const struct pp_net_panels *panels, int piece)
{
    struct pp_bounds2 extent = pp_bounds2_empty();
    for (int i = 0; i < panels->count; i++)
        for (int k = 0; panels->list[i].piece == piece && k < panels->list[i].count;
             k++) {
            double xy[2];
            pp_net_panels_corner(&panels->list[i], k, xy);
            pp_bounds2_add(&extent, xy[0], xy[1]);
        }
    return extent;
}

static bool fits(const struct unfolding *unfolding, const struct pp_bounds2 *extent)
{
    return extent->high[0] - extent->low[0] <= unfolding->limit[0] + 1e-6
           && extent->high[1] - extent->low[1] <= unfolding->limit[1] + 1e-6;
}

/* Turns and shifts a panel so that its edge own_edge coincides with an edge of a placed
 * panel, in the opposite direction. */
static void lay_beside(const struct pp_net_panel *placed, int edge,
                       struct pp_net_panel *panel, int own_edge)
{
    double a[2], b[2];
    const double *c = panel->own[own_edge],
                 *d = panel->own[(own_edge + 1) % panel->count];
    pp_net_panels_corner(placed, edge, a);
    pp_net_panels_corner(placed, edge + 1, b);
    /* Maps c to b and d to a. */
    double wanted = atan2(a[1] - b[1], a[0] - b[0]),
           now = atan2(d[1] - c[1], d[0] - c[0]);
    panel->turn[0] = cos(wanted - now);
    panel->turn[1] = sin(wanted - now);
    panel->shift[0] = b[0] - panel->turn[0] * c[0] + panel->turn[1] * c[1];
    panel->shift[1] = b[1] - panel->turn[1] * c[0] - panel->turn[0] * c[1];
}

/* Connects the neighbour at an edge to the piece if it fits and does not overlap the
 * piece. Returns false if it is not connected. */
static bool hang(struct unfolding *unfolding, int index, int edge)
{
    struct pp_net_panels *panels = &unfolding->net->panels;
    struct pp_net_panel *placed = &panels->list[index];
    struct pp_net_edge *joint = &placed->edges[edge];
    if (joint->panel < 0 || panels->list[joint->panel].piece >= 0)
        return false;
    struct pp_net_panel *panel = &panels->list[joint->panel];
    if (panel->face == placed->face)
        return false; /* parts of the same face are never connected */
    int piece = placed->piece;
    lay_beside(placed, edge, panel, joint->edge);
    double(*xy)[2] = corners_of(unfolding, panel);
    bool free_there =
        xy && !hits_panel(unfolding, piece, (const double(*)[2])xy, panel->count, -1);
    free(xy);
    panel->piece = piece;
    struct pp_bounds2 extent = piece_extent(panels, piece);
    if (free_there && fits(unfolding, &extent)) {
        joint->join = panel->edges[joint->edge].join = PP_NET_FOLD;
        return true;
    }
    panel->piece = -1;
    return false;
}

/* Starts a piece with a panel, upright or, if the panel does not fit, turned by 90
 * degrees. Then connects neighbours until no more fit. */
static void grow_piece(struct unfolding *unfolding, int first)
{
    struct pp_net *net = unfolding->net;
    struct pp_net_panel *panel = &net->panels.list[first];
    unfolding->status = pp_array_append(&net->pieces, net->piece_count,
                                        sizeof *net->pieces, unfolding->err);
    if (unfolding->status != PP_OK)
        return;
    int piece = net->piece_count++;
    panel->piece = piece;
    memcpy(panel->turn, (double[2]){1.0, 0.0}, sizeof panel->turn);
    memcpy(panel->shift, (double[2]){0.0, 0.0}, sizeof panel->shift);
    struct pp_bounds2 extent = piece_extent(&net->panels, piece);
    if (!fits(unfolding, &extent))
        memcpy(panel->turn, (double[2]){0.0, 1.0}, sizeof panel->turn);
    bool grown = true;
    while (grown && unfolding->status == PP_OK) {
        grown = false;
        for (int i = 0; i < net->panels.count && !grown; i++)
            for (int k = 0; k < net->panels.list[i].count && !grown
                            && net->panels.list[i].piece == piece;
                 k++)
                grown = hang(unfolding, i, k);
    }
}

/* ---- tabs ---- */

void pp_net_unfold_tab(const struct pp_net_panel *panel, int edge,
                       double xy[PP_NET_TAB_CORNERS][2])
{
    pp_net_panels_corner(panel, edge, xy[0]);
    pp_net_panels_corner(panel, edge + 1, xy[3]);
    double along[2] = {xy[3][0] - xy[0][0], xy[3][1] - xy[0][1]};
    double length = hypot(along[0], along[1]), wide = fmin(TAB_MM, 0.3 * length);
    along[0] /= length;
    along[1] /= length;
    /* Corners run counter-clockwise, so the outside is on the right. */
    for (int i = 0; i < 2; i++) {
        double in = i ? -wide : wide;
        const double *from = xy[i ? 3 : 0];
        xy[1 + i][0] = from[0] + in * along[0] + wide * along[1];
        xy[1 + i][1] = from[1] + in * along[1] - wide * along[0];
    }
}

/* True if a tab does not overlap any panel or other tab. */
static bool tab_is_free(struct unfolding *unfolding, int index, int edge)
{
    const struct pp_net_panels *panels = &unfolding->net->panels;
    const struct pp_net_panel *panel = &panels->list[index];
    double tab[PP_NET_TAB_CORNERS][2], other[PP_NET_TAB_CORNERS][2];
    pp_net_unfold_tab(panel, edge, tab);
    bool hit = hits_panel(unfolding, panel->piece, (const double(*)[2])tab,
                          PP_NET_TAB_CORNERS, -1);
    for (int i = 0; i < panels->count && !hit; i++)
        for (int k = 0; k < panels->list[i].count && !hit; k++) {
            const struct pp_net_panel *its = &panels->list[i];
            if (its->piece != panel->piece || its->edges[k].join != PP_NET_TAB)
                continue;
            pp_net_unfold_tab(its, k, other);
            hit = common_area(unfolding, (const double(*)[2])tab, PP_NET_TAB_CORNERS,
                              (const double(*)[2])other, PP_NET_TAB_CORNERS)
                  > OVERLAP_MM2;
        }
    return !hit && unfolding->status == PP_OK;
}

/* True if an edge of another panel with the same number already has a tab. */
static bool is_served(const struct pp_net_panels *panels, int number, int other_than)
{
    for (int i = 0; i < panels->count; i++)
        for (int k = 0; k < panels->list[i].count && i != other_than; k++)
            if (panels->list[i].edges[k].number == number
                && panels->list[i].edges[k].join == PP_NET_TAB)
                return true;
    return false;
}

/* Adds a tab to one side of each edge to be glued, in the order of the panels. An edge
 * that has no space for a tab is taped. */
static void put_tabs(struct unfolding *unfolding)
{
    struct pp_net_panels *panels = &unfolding->net->panels;
    for (int i = 0; i < panels->count; i++)
        for (int k = 0; k < panels->list[i].count && unfolding->status == PP_OK; k++) {
            struct pp_net_edge *edge = &panels->list[i].edges[k];
            if (edge->join == PP_NET_FOLD || is_served(panels, edge->number, i))
                continue;
            if (tab_is_free(unfolding, i, k))
                edge->join = PP_NET_TAB;
        }
    for (int i = 0; i < panels->count; i++)
        for (int k = 0; k < panels->list[i].count; k++) {
            struct pp_net_edge *edge = &panels->list[i].edges[k];
            if (edge->join == PP_NET_PLAIN && !is_served(panels, edge->number, i))
                edge->join = PP_NET_TAPE;
        }
}

/* ---- sheets ---- */

static void measure_pieces(struct pp_net *net)
{
    for (int p = 0; p < net->piece_count; p++) {
        net->pieces[p].extent = piece_extent(&net->panels, p);
        for (int i = 0; i < net->panels.count; i++)
            for (int k = 0; k < net->panels.list[i].count; k++) {
                const struct pp_net_panel *panel = &net->panels.list[i];
                double tab[PP_NET_TAB_CORNERS][2];
                if (panel->piece != p || panel->edges[k].join != PP_NET_TAB)
                    continue;
                pp_net_unfold_tab(panel, k, tab);
                for (int c = 1; c < 3; c++)
                    pp_bounds2_add(&net->pieces[p].extent, tab[c][0], tab[c][1]);
            }
    }
}

static double height_of(const struct pp_net_piece *piece)
{
    return piece->extent.high[1] - piece->extent.low[1];
}

/* Index of the tallest piece that is not yet placed; -1: none. */
static int tallest(const struct pp_net *net)
{
    int found = -1;
    for (int i = 0; i < net->piece_count; i++)
        if (net->pieces[i].sheet < 0
            && (found < 0
                || height_of(&net->pieces[i]) > height_of(&net->pieces[found])))
            found = i;
    return found;
}

/* Places pieces in rows from the top of the area downwards, the tallest piece first. */
static void lay_on_sheets(struct pp_net *net, const double area[2])
{
    double x = 0.0, top = area[1], row = 0.0;
    int sheet = 0, index;
    for (int i = 0; i < net->piece_count; i++)
        net->pieces[i].sheet = -1;
    while ((index = tallest(net)) >= 0) {
        struct pp_net_piece *piece = &net->pieces[index];
        double wide = piece->extent.high[0] - piece->extent.low[0];
        if (x > 0.0 && x + wide > area[0] + 1e-6) {
            x = 0.0;
            top -= row + GAP_MM;
            row = 0.0;
        }
        if (row == 0.0 && height_of(piece) > top + 1e-6) {
            sheet++;
            top = area[1];
        }
        row = fmax(row, height_of(piece));
        piece->sheet = sheet;
        piece->place[0] = x;
        piece->place[1] = top - height_of(piece);
        x += wide + GAP_MM;
    }
    net->sheet_count = sheet + 1;
}

/* Index of a panel of that role that does not yet belong to a piece; -1: none. */
static int first_of(const struct pp_net_panels *panels, const struct pp_world *world,
                    enum pp_role role)
{
    for (int i = 0; i < panels->count; i++)
        if (panels->list[i].piece < 0
            && world->surfaces[panels->list[i].face].role == role)
            return i;
    return -1;
}

enum pp_status pp_net_unfold(struct pp_net *net, const struct pp_world *world,
                             double mm_per_m, const double area_mm[2],
                             struct pp_error *err)
{
    struct unfolding unfolding = {
        .net = net,
        .limit = {area_mm[0] - 2.0 * TAB_MM, area_mm[1] - 2.0 * TAB_MM},
        .err = err};
    *net = (struct pp_net){0};
    enum pp_status status = pp_clipper_create(&unfolding.clipper, err);
    if (status != PP_OK)
        return status;
    unfolding.status =
        pp_net_panels_init(&net->panels, world, mm_per_m, unfolding.limit, err);
    for (enum pp_role role = PP_FLOOR; role <= PP_CEILING; role++)
        for (int i; unfolding.status == PP_OK
                    && (i = first_of(&net->panels, world, role)) >= 0;)
            grow_piece(&unfolding, i);
    if (unfolding.status == PP_OK)
        put_tabs(&unfolding);
    pp_clipper_destroy(unfolding.clipper);
    if (unfolding.status != PP_OK) {
        pp_net_unfold_clear(net);
        return unfolding.status;
    }
    measure_pieces(net);
    lay_on_sheets(net, area_mm);
    return PP_OK;
}

void pp_net_unfold_clear(struct pp_net *net)
{
    pp_net_panels_clear(&net->panels);
    free(net->pieces);
    *net = (struct pp_net){0};
}
