/* net_panels.c - makes flat panels of the faces, cuts large faces by a grid of equal
 * cells, and numbers the edges: one number for each edge of the room, and one for each
 * cut. */
#include "charts/net/net_panels.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/array.h"
#include "model/geometry/clipper.h"

/* Ends closer than this distance (mm on the model) are considered equal. */
static const double SAME_MM = 1e-3;

/* Maximum number of panels if faces must be cut, since each part needs a separate
 * sheet. A larger model is considered a mistake in units or scale. */
enum { PARTS_MOST = 400 };

/* ---- from the room to a panel ---- */

void pp_net_panels_own(const struct pp_net_panels *panels,
                       const struct pp_net_panel *panel, struct pp_vec3 point,
                       double xy[2])
{
    struct pp_vec3 v = pp_vec_sub(point, panel->origin);
    xy[0] = pp_vec_dot(v, panel->along) * panels->mm_per_m;
    xy[1] = pp_vec_dot(v, panel->up) * panels->mm_per_m;
}

void pp_net_panels_place(const struct pp_net_panel *panel, const double own[2],
                         double xy[2])
{
    xy[0] = panel->turn[0] * own[0] - panel->turn[1] * own[1] + panel->shift[0];
    xy[1] = panel->turn[1] * own[0] + panel->turn[0] * own[1] + panel->shift[1];
}

void pp_net_panels_corner(const struct pp_net_panel *panel, int corner, double xy[2])
{
    pp_net_panels_place(panel, panel->own[corner % panel->count], xy);
}

void pp_net_panels_point(const struct pp_net_panels *panels,
                         const struct pp_net_panel *panel, struct pp_vec3 point,
                         double xy[2])
{
    double own[2];
    pp_net_panels_own(panels, panel, point, own);
    pp_net_panels_place(panel, own, xy);
}

/* ---- panels ---- */

/* Adds a panel of the same face as `like`, with corners in the axes of that face. */
static enum pp_status add_panel(struct pp_net_panels *panels,
                                const struct pp_net_panel *like, const double (*own)[2],
                                int count, struct pp_error *err)
{
    enum pp_status status =
        pp_array_append(&panels->list, panels->count, sizeof *panels->list, err);
    if (status != PP_OK)
        return status;
    struct pp_net_panel *panel = &panels->list[panels->count++];
    *panel = *like;
    panel->count = count;
    panel->own = malloc((size_t)count * sizeof *panel->own);
    panel->edges = calloc((size_t)count, sizeof *panel->edges);
    if (!panel->own || !panel->edges)
        return pp_fail_memory(err);
    memcpy(panel->own, own, (size_t)count * sizeof *own);
    for (int i = 0; i < count; i++)
        panel->edges[i] = (struct pp_net_edge){.number = -1, .panel = -1, .edge = -1};
    return PP_OK;
}

/* Adds the part of a face that lies in one cell. */
static enum pp_status add_cell(struct pp_net_panels *panels, struct pp_net_panel *like,
                               struct pp_clipper *clipper, const struct pp_region *face,
                               const double low[2], const double high[2],
                               struct pp_error *err)
{
    const double box[4][2] = {
        {low[0], low[1]}, {high[0], low[1]}, {high[0], high[1]}, {low[0], high[1]}};
    struct pp_region cell = {0}, part = {0};
    enum pp_status status = pp_clipper_of_ring(clipper, &cell, box, 4, err);
    if (status == PP_OK)
        status = pp_clipper_intersection(clipper, &part, face, &cell, err);
    for (int i = 0; i < part.count && status == PP_OK; i++) {
        const struct pp_ring *ring = &part.rings[i];
        if (pp_region_ring_area((const double(*)[2])ring->xy, ring->count) > 1.0) {
            status =
                add_panel(panels, like, (const double(*)[2])ring->xy, ring->count, err);
            like->part++;
        }
    }
    pp_region_clear(&cell);
    pp_region_clear(&part);
    return status;
}

/* Adds the parts of a face in a grid of cells[0] by cells[1] equal cells. */
static enum pp_status add_cells(struct pp_net_panels *panels, struct pp_net_panel *like,
                                const double (*own)[2], int count,
                                const struct pp_bounds2 *extent, const int cells[2],
                                struct pp_error *err)
{
    struct pp_clipper *clipper;
    struct pp_region face = {0};
    int first = panels->count;
    enum pp_status status = pp_clipper_create(&clipper, err);
    if (status != PP_OK)
        return status;
    status = pp_clipper_of_ring(clipper, &face, own, count, err);
    for (int i = 0; i < cells[0] * cells[1] && status == PP_OK; i++) {
        double low[2], high[2];
        for (int k = 0; k < 2; k++) {
            int at = k ? i / cells[0] : i % cells[0];
            double size = (extent->high[k] - extent->low[k]) / cells[k];
            low[k] = extent->low[k] + at * size;
            high[k] =
                at == cells[k] - 1 ? extent->high[k] : extent->low[k] + (at + 1) * size;
        }
        status = add_cell(panels, like, clipper, &face, low, high, err);
    }
    for (int i = first; i < panels->count; i++)
        panels->list[i].parts = panels->count - first;
    pp_region_clear(&face);
    pp_clipper_destroy(clipper);
    return status;
}

static enum pp_status add_net_face(struct pp_net_panels *panels,
                                   const struct pp_world *world, int face,
                                   const double limit[2], struct pp_error *err)
{
    const struct pp_polygon *outline = &world->surfaces[face].outline;
    struct pp_net_panel like = {.face = face,
                                .parts = 1,
                                .origin = outline->vertices[0],
                                .turn = {1.0, 0.0},
                                .piece = -1};
    struct pp_bounds2 extent = pp_bounds2_empty();
    double(*own)[2] = malloc((size_t)outline->count * sizeof *own), size[2];
    if (!own)
        return pp_fail_memory(err);
    pp_polygon_plane_axes(outline->normal, &like.along, &like.up);
    for (int i = 0; i < outline->count; i++) {
        pp_net_panels_own(panels, &like, outline->vertices[i], own[i]);
        pp_bounds2_add(&extent, own[i][0], own[i][1]);
    }
    int cells[2], turned[2];
    for (int k = 0; k < 2; k++) {
        size[k] = extent.high[k] - extent.low[k] - 1e-9;
        cells[k] = (int)ceil(size[k] / limit[k]);
        turned[k] = (int)ceil(size[k] / limit[1 - k]);
    }
    if ((double)turned[0] * turned[1] < (double)cells[0] * cells[1])
        memcpy(cells, turned, sizeof cells);
    if ((double)cells[0] * cells[1] + panels->count > PARTS_MOST
        && cells[0] * (double)cells[1] > 1.0) {
        free(own);
        return pp_fail(err, PP_BAD_INPUT,
                       "the net needs more than %d sheets; expected a larger --paper, "
                       "or --scale for a smaller model",
                       PARTS_MOST);
    }
    enum pp_status status =
        cells[0] * cells[1] <= 1
            ? add_panel(panels, &like, (const double(*)[2])own, outline->count, err)
            : add_cells(panels, &like, (const double(*)[2])own, outline->count, &extent,
                        cells, err);
    free(own);
    return status;
}

/* ---- edges ---- */

/* Position of a panel's corner in the room. */
static struct pp_vec3 in_room(const struct pp_net_panels *panels,
                              const struct pp_net_panel *panel, int corner)
{
    const double *own = panel->own[corner % panel->count];
    return pp_vec_along(
        pp_vec_along(panel->origin, own[0] / panels->mm_per_m, panel->along),
        own[1] / panels->mm_per_m, panel->up);
}

/* Distance of a point from the line through two others (m). */
static double off_line(struct pp_vec3 p, struct pp_vec3 a, struct pp_vec3 b)
{
    struct pp_vec3 along = pp_vec_sub(b, a);
    return pp_vec_length(pp_vec_cross(pp_vec_sub(p, a), along)) / pp_vec_length(along);
}

/* True if two edges lie on the same line and overlap. */
static bool meet(const struct pp_net_panels *panels, const struct pp_net_panel *p,
                 int i, const struct pp_net_panel *q, int k)
{
    double same = SAME_MM / panels->mm_per_m;
    struct pp_vec3 a = in_room(panels, p, i), b = in_room(panels, p, i + 1);
    struct pp_vec3 c = in_room(panels, q, k), d = in_room(panels, q, k + 1);
    struct pp_vec3 along = pp_vec_unit(pp_vec_sub(b, a));
    double length = pp_vec_length(pp_vec_sub(b, a));
    double from = pp_vec_dot(pp_vec_sub(c, a), along),
           to = pp_vec_dot(pp_vec_sub(d, a), along);
    return off_line(c, a, b) < same && off_line(d, a, b) < same
           && fmin(fmax(from, to), length) - fmax(fmin(from, to), 0.0) > same;
}

static bool same_ends(const struct pp_net_panels *panels, const struct pp_net_panel *p,
                      int i, const struct pp_net_panel *q, int k)
{
    double same = SAME_MM / panels->mm_per_m;
    return pp_vec_length(pp_vec_sub(in_room(panels, p, i), in_room(panels, q, k + 1)))
               < same
           && pp_vec_length(
                  pp_vec_sub(in_room(panels, p, i + 1), in_room(panels, q, k)))
                  < same;
}

/* Gives the same number to all edges that meet, directly or through other edges. */
static void number_edges(struct pp_net_panels *panels)
{
    for (int p = 0; p < panels->count; p++)
        for (int i = 0; i < panels->list[p].count; i++) {
            struct pp_net_edge *edge = &panels->list[p].edges[i];
            if (edge->number < 0)
                edge->number = panels->edge_numbers++;
            for (int q = 0; q < panels->count; q++)
                for (int k = 0; q != p && k < panels->list[q].count; k++) {
                    struct pp_net_edge *other = &panels->list[q].edges[k];
                    if (!meet(panels, &panels->list[p], i, &panels->list[q], k))
                        continue;
                    other->number = other->number < 0 ? edge->number : other->number;
                    if (same_ends(panels, &panels->list[p], i, &panels->list[q], k)) {
                        edge->panel = q;
                        edge->edge = k;
                    }
                }
        }
}

enum pp_status pp_net_panels_init(struct pp_net_panels *panels,
                                  const struct pp_world *world, double mm_per_m,
                                  const double limit_mm[2], struct pp_error *err)
{
    *panels = (struct pp_net_panels){.mm_per_m = mm_per_m};
    enum pp_status status = PP_OK;
    for (int i = 0; i < world->face_count && status == PP_OK; i++)
        status = add_net_face(panels, world, i, limit_mm, err);
    if (status == PP_OK)
        number_edges(panels);
    else
        pp_net_panels_clear(panels);
    return status;
}

void pp_net_panels_clear(struct pp_net_panels *panels)
{
    for (int i = 0; i < panels->count; i++) {
        free(panels->list[i].own);
        free(panels->list[i].edges);
    }
    free(panels->list);
    *panels = (struct pp_net_panels){0};
}
