/* facet_pieces.c - divides the plane of a facet into cells by lines through its
 * corners, and intersects each cell with the facet. */
#include "simulate/research/radiosity/facet_pieces.h"

#include <math.h>
#include <stdlib.h>

#include "model/base/array.h"
#include "model/geometry/convex_parts.h"
#include "model/room/face_less_openings.h"
#include "simulate/research/radiosity/form_factor.h"

/* Lines nearer to each other than this are merged (m). */
static const double SAME_LINE_M = 1e-6;
/* A cell counts as empty if less than this fraction is filled, and as full if more than
 * 1 - this fraction is filled. */
static const double NOTHING = 1e-9;

enum { MOST_LINES = 32 };

struct cutting {
    struct pp_facets *facets;
    struct pp_clipper *clipper;
    const struct pp_polygon *outline;
    struct pp_face_axes axes;
    int facet, face; /* face: the face whose openings are cut out; -1: none */
};

static enum pp_status append_facet_piece(struct pp_facets *facets, int facet,
                                         const struct pp_vec3 *corners, int count,
                                         struct pp_error *err)
{
    enum pp_status status = pp_array_append(&facets->pieces, facets->piece_count,
                                            sizeof *facets->pieces, err);
    if (status == PP_OK)
        status = pp_array_reserve(&facets->corners, &facets->corner_room,
                                  facets->corner_count + count, sizeof *facets->corners,
                                  err);
    if (status != PP_OK)
        return status;
    facets->pieces[facets->piece_count++] =
        (struct pp_piece){facet, facets->corner_count, count};
    for (int i = 0; i < count; i++)
        facets->corners[facets->corner_count++] = corners[i];
    facets->list[facet].piece_count++;
    return PP_OK;
}

/* Appends a piece given by coordinates in the facet's plane. */
static enum pp_status append_flat(const struct cutting *work, const double (*xy)[2],
                                  int count, struct pp_error *err)
{
    const struct pp_world *world = work->facets->world;
    struct pp_vec3 corners[4];
    for (int i = 0; i < count; i++)
        corners[i] = pp_face_less_openings_corner(&work->axes, xy[i], work->outline,
                                                  world, work->face);
    return append_facet_piece(work->facets, work->facet, corners, count, err);
}

static enum pp_status append_triangles(const struct cutting *work,
                                       const struct pp_region *region,
                                       struct pp_error *err)
{
    double(*pieces)[3][2] = NULL;
    int count = 0;
    enum pp_status status =
        pp_clipper_triangulate(work->clipper, &pieces, &count, region, err);
    for (int i = 0; status == PP_OK && i < count; i++)
        status = append_flat(work, (const double(*)[2])pieces[i], 3, err);
    free(pieces);
    return status;
}

/* ---- lines ---- */

struct cut_lines {
    double at[MOST_LINES];
    int count;
    bool too_many;
};

static int by_place(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Lines through the corners of all rings, perpendicular to one axis. */
static struct cut_lines lines_of(const struct pp_region *region, int axis)
{
    struct cut_lines lines = {.count = 0};
    for (int r = 0; r < region->count; r++)
        for (int i = 0; i < region->rings[r].count; i++) {
            double place = region->rings[r].xy[i][axis];
            bool known = false;
            for (int k = 0; !known && k < lines.count; k++)
                known = fabs(lines.at[k] - place) < SAME_LINE_M;
            if (!known && lines.count == MOST_LINES)
                lines.too_many = true;
            else if (!known)
                lines.at[lines.count++] = place;
        }
    qsort(lines.at, (size_t)lines.count, sizeof *lines.at, by_place);
    return lines;
}

/* Adds the pieces of the facet within one cell. */
static enum pp_status cut_cell(const struct cutting *work,
                               const struct pp_region *region, double left,
                               double right, double low, double high,
                               struct pp_error *err)
{
    double xy[4][2] = {{left, low}, {right, low}, {right, high}, {left, high}};
    struct pp_ring ring = {4, xy};
    struct pp_region cell = {1, &ring}, filled = {0, NULL};
    double area = (right - left) * (high - low);
    enum pp_status status =
        pp_clipper_intersection(work->clipper, &filled, region, &cell, err);
    if (status == PP_OK && pp_region_area(&filled) > (1.0 - NOTHING) * area)
        status = append_flat(work, (const double(*)[2])xy, 4, err);
    else if (status == PP_OK && pp_region_area(&filled) > NOTHING * area)
        status = append_triangles(work, &filled, err);
    pp_region_clear(&filled);
    return status;
}

static enum pp_status cut_facet_region(const struct cutting *work,
                                       const struct pp_region *region,
                                       struct pp_error *err)
{
    struct cut_lines x = lines_of(region, 0), y = lines_of(region, 1);
    enum pp_status status = PP_OK;
    if (x.too_many || y.too_many)
        return append_triangles(work, region, err);
    for (int i = 0; i + 1 < x.count; i++)
        for (int k = 0; status == PP_OK && k + 1 < y.count; k++)
            status =
                cut_cell(work, region, x.at[i], x.at[i + 1], y.at[k], y.at[k + 1], err);
    return status;
}

static bool is_cover_of(const struct pp_world *world, int surface, int wall)
{
    return world->surfaces[surface].role == PP_COVER
           && world->surfaces[surface].owner == wall;
}

/* Subtracts the doors and dados (covers) of the wall from its region. */
static enum pp_status less_covers(const struct cutting *work, struct pp_region *region,
                                  struct pp_error *err)
{
    const struct pp_world *world = work->facets->world;
    enum pp_status status = PP_OK;
    if (work->face < 0)
        return PP_OK; /* only walls have covers */
    for (int i = world->face_count; status == PP_OK && i < world->surface_count; i++) {
        struct pp_region cover = {0, NULL};
        if (!is_cover_of(world, i, work->facet))
            continue;
        status = pp_face_less_openings(&cover, work->clipper, &work->axes,
                                       &world->surfaces[i].outline, NULL, -1, err);
        if (status == PP_OK)
            status = pp_clipper_take_away(work->clipper, region, &cover, err);
        pp_region_clear(&cover);
    }
    return status;
}

/* True if the facet occupies the whole outline of its surface. */
static bool is_whole(const struct pp_world *world, int index)
{
    if (index >= world->face_count)
        return index >= world->surface_count || world->surfaces[index].role != PP_COVER;
    bool whole = true;
    for (int i = 0; whole && i < world->opening_count; i++)
        whole = world->openings[i].face != index;
    for (int i = world->face_count; whole && i < world->surface_count; i++)
        whole = !is_cover_of(world, i, index);
    return whole;
}

enum pp_status pp_facet_pieces_add(struct pp_facets *facets, int index,
                                   struct pp_clipper *clipper, struct pp_error *err)
{
    const struct pp_world *world = facets->world;
    struct pp_facet *facet = &facets->list[index];
    const struct pp_polygon *outline = facet->outline;
    struct cutting work = {facets,  clipper,
                           outline, {facet->origin, facet->a, facet->b},
                           index,   index < world->face_count ? index : -1};
    facet->first_piece = facets->piece_count;
    enum pp_status status = pp_face_less_openings(&facet->region, clipper, &work.axes,
                                                  outline, world, work.face, err);
    if (status == PP_OK)
        status = less_covers(&work, &facet->region, err);
    if (status != PP_OK)
        return status;
    if (is_whole(world, index) && pp_convex_parts_is_convex(outline)
        && outline->count <= PP_FORM_FACTOR_MOST / 2)
        return append_facet_piece(facets, index, outline->vertices, outline->count,
                                  err);
    return cut_facet_region(&work, &facet->region, err);
}
