/* region_pieces.c - see region_pieces.h. */
#include "model/geometry/region_pieces.h"

#include <stdlib.h>

#include "model/base/array.h"

struct piece_plane {
    struct pp_vec3 origin, along, up;
    double least_m2;
};

static enum pp_status add_region_piece(struct pp_region_pieces *pieces,
                                       const struct piece_plane *plane,
                                       const double (*xy)[2], int count,
                                       struct pp_error *err)
{
    if (pp_region_ring_area(xy, count) < plane->least_m2)
        return PP_OK;
    struct pp_vec3 *corners = malloc((size_t)count * sizeof *corners);
    if (!corners)
        return pp_fail_memory(err);
    enum pp_status status =
        pp_array_append(&pieces->list, pieces->count, sizeof *pieces->list, err);
    if (status != PP_OK) {
        free(corners);
        return status;
    }
    for (int i = 0; i < count; i++)
        corners[i] = pp_vec_along(pp_vec_along(plane->origin, xy[i][0], plane->along),
                                  xy[i][1], plane->up);
    pieces->list[pieces->count++] = (struct pp_region_piece){count, corners};
    return PP_OK;
}

/* Adds an outer ring with its holes as triangles. */
static enum pp_status add_region_triangles(struct pp_region_pieces *pieces,
                                           const struct piece_plane *plane,
                                           const struct pp_region *part,
                                           struct pp_clipper *clipper,
                                           struct pp_error *err)
{
    double(*triangles)[3][2] = NULL;
    int count = 0;
    enum pp_status status =
        pp_clipper_triangulate(clipper, &triangles, &count, part, err);
    for (int i = 0; i < count && status == PP_OK; i++)
        status =
            add_region_piece(pieces, plane, (const double(*)[2])triangles[i], 3, err);
    free(triangles);
    return status;
}

static bool is_hole(const struct pp_ring *ring)
{
    return pp_region_ring_area((const double(*)[2])ring->xy, ring->count) < 0.0;
}

enum pp_status pp_region_pieces_cut(struct pp_region_pieces *pieces,
                                    const struct pp_region *figure,
                                    struct pp_vec3 origin, struct pp_vec3 along,
                                    struct pp_vec3 up, double least_m2,
                                    struct pp_clipper *clipper, struct pp_error *err)
{
    const struct piece_plane plane = {origin, along, up, least_m2};
    enum pp_status status = PP_OK;
    *pieces = (struct pp_region_pieces){0};
    for (int i = 0, next; i < figure->count && status == PP_OK; i = next) {
        const struct pp_ring *outer = &figure->rings[i];
        next = i + 1;
        while (next < figure->count && is_hole(&figure->rings[next]))
            next++;
        const struct pp_region part = {next - i, figure->rings + i};
        status = part.count == 1
                     ? add_region_piece(pieces, &plane, (const double(*)[2])outer->xy,
                                        outer->count, err)
                     : add_region_triangles(pieces, &plane, &part, clipper, err);
    }
    return status;
}

void pp_region_pieces_clear(struct pp_region_pieces *pieces)
{
    for (int i = 0; i < pieces->count; i++)
        free(pieces->list[i].corners);
    free(pieces->list);
    *pieces = (struct pp_region_pieces){0};
}
