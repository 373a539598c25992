/* gbxml_loop.c - see gbxml_loop.h. */
#include "formats/gbxml/gbxml_loop.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/array.h"
#include "model/geometry/polygon.h"

enum { CORNERS_MOST = 1000 };

/* farthest_m: largest coordinate, as in a room file. moved_from_m: a model farther from
 * the origin than this is moved to the origin. near_m: corners within this distance of
 * the first corner belong to the building. */
static const double farthest_m = 1e5, moved_from_m = 1e4, near_m = 5e4;

/* Coordinates of a point in metres; false if one is missing. */
static bool read_point(const struct pp_gbxml_loop_reader *r,
                       const struct pp_xml_element *point, struct pp_vec3 *at)
{
    double xyz[3];
    const struct pp_xml_element *coordinate =
        pp_gbxml_document_child(point, "Coordinate");
    for (int i = 0; i < 3; i++) {
        if (!coordinate || !pp_gbxml_document_number(coordinate, &xyz[i])
            || !isfinite(xyz[i]))
            return false;
        xyz[i] *= r->metre;
        coordinate = pp_gbxml_document_next(coordinate, "Coordinate");
    }
    *at = (struct pp_vec3){xyz[0], xyz[1], xyz[2]};
    return true;
}

void pp_gbxml_loop_find_origin(struct pp_gbxml_loop_reader *r,
                               const struct pp_xml_element *campus)
{
    bool begun = false;
    struct pp_vec3 first = {0.0, 0.0, 0.0}, low = first, at;
    r->origin = first;
    for (const struct pp_xml_element *surface =
             pp_gbxml_document_child(campus, "Surface");
         surface; surface = pp_gbxml_document_next(surface, "Surface")) {
        const struct pp_xml_element *loop =
            pp_gbxml_document_path(surface, "PlanarGeometry/PolyLoop");
        for (const struct pp_xml_element *point =
                 pp_gbxml_document_child(loop, "CartesianPoint");
             point; point = pp_gbxml_document_next(point, "CartesianPoint")) {
            if (!read_point(r, point, &at))
                continue;
            if (!begun)
                begun = true, first = low = at;
            if (!(hypot(at.x - first.x, at.y - first.y) <= near_m))
                continue;
            low = pp_vec(fmin(low.x, at.x), fmin(low.y, at.y), fmin(low.z, at.z));
        }
    }
    if (!begun || !(hypot(low.x, low.y) > moved_from_m && hypot(low.x, low.y) < 1e9)
        || !(fabs(low.z) < farthest_m))
        return;
    r->origin = pp_vec(floor(low.x), floor(low.y), floor(low.z));
    pp_mistakes_add(r->notes, 0,
                    "the model is far from the origin, so its origin was moved to the "
                    "point (%.0f, %.0f, %.0f) m of the file",
                    r->origin.x, r->origin.y, r->origin.z);
}

/* Replaces the corners by the outer ring of the largest piece of the region. */
static enum pp_status take_rim(struct pp_gbxml_polygon *polygon,
                               const struct pp_region *figure, struct pp_vec3 origin,
                               struct pp_vec3 along, struct pp_vec3 up,
                               struct pp_error *err)
{
    const struct pp_ring *rim = NULL;
    double most = 0.0;
    for (int i = 0; i < figure->count; i++) {
        const struct pp_ring *ring = &figure->rings[i];
        double area = pp_region_ring_area((const double(*)[2])ring->xy, ring->count);
        if (area > most)
            most = area, rim = ring;
    }
    if (!rim)
        return PP_OK;
    struct pp_vec3 *corners = calloc((size_t)rim->count, sizeof *corners);
    if (!corners)
        return pp_fail_memory(err);
    for (int i = 0; i < rim->count; i++) {
        corners[i] =
            pp_vec_along(pp_vec_along(origin, rim->xy[i][0], along), rim->xy[i][1], up);
        /* Keeps an original corner exactly, even if it is off the plane. */
        int nearest = 0;
        for (int k = 1; k < polygon->count; k++)
            if (pp_vec_length(pp_vec_sub(polygon->corners[k], corners[i]))
                < pp_vec_length(pp_vec_sub(polygon->corners[nearest], corners[i])))
                nearest = k;
        if (pp_vec_length(pp_vec_sub(polygon->corners[nearest], corners[i])) < 5e-3)
            corners[i] = polygon->corners[nearest];
    }
    free(polygon->corners);
    *polygon = (struct pp_gbxml_polygon){corners, rim->count};
    return PP_OK;
}

/* Replaces an outline that crosses itself; a simple outline stays as it is. */
static enum pp_status make_simple(struct pp_gbxml_polygon *polygon,
                                  struct pp_gbxml_loop_reader *r)
{
    struct pp_vec3 area = pp_polygon_area_vector(polygon->corners, polygon->count);
    double length = pp_vec_length(area);
    double(*xy)[2] = malloc((size_t)polygon->count * sizeof *xy);
    if (!xy)
        return pp_fail_memory(r->err);
    struct pp_vec3 along, up, origin = polygon->corners[0];
    struct pp_region figure = {0};
    struct pp_error said = {0};
    bool simple = !(length > 1e-6);
    enum pp_status status = PP_OK;
    if (!simple) {
        pp_polygon_plane_axes(pp_vec_scale(area, 1.0 / length), &along, &up);
        pp_polygon_flatten(polygon->corners, polygon->count, origin, along, up, xy);
        status = pp_clipper_ring_is_simple(&simple, r->clipper, (const double(*)[2])xy,
                                           polygon->count, r->err);
    }
    if (status == PP_OK && !simple) {
        /* If no region is found, the outline stays; the checks of the room file report
         * it. */
        status = pp_clipper_by_crossings(r->clipper, &figure, (const double(*)[2])xy,
                                         polygon->count, &said);
        if (status == PP_OK)
            status = take_rim(polygon, &figure, origin, along, up, r->err);
        else
            status = status == PP_SYSTEM ? pp_fail_memory(r->err) : PP_OK;
    }
    pp_region_clear(&figure);
    free(xy);
    return status;
}

enum pp_status pp_gbxml_loop_read(struct pp_gbxml_polygon *polygon,
                                  struct pp_gbxml_loop_reader *r,
                                  const struct pp_xml_element *loop)
{
    bool good = true;
    enum pp_status status = PP_OK;
    *polygon = (struct pp_gbxml_polygon){0};
    for (const struct pp_xml_element *point =
             pp_gbxml_document_child(loop, "CartesianPoint");
         point && good && status == PP_OK;
         point = pp_gbxml_document_next(point, "CartesianPoint")) {
        struct pp_vec3 at;
        good = polygon->count < CORNERS_MOST && read_point(r, point, &at);
        if (!good)
            break;
        at = pp_vec_sub(at, r->origin);
        good = fabs(at.x) <= farthest_m && fabs(at.y) <= farthest_m
               && fabs(at.z) <= farthest_m;
        status = pp_array_append(&polygon->corners, polygon->count,
                                 sizeof *polygon->corners, r->err);
        if (status == PP_OK)
            polygon->corners[polygon->count++] = at;
    }
    if (status == PP_OK && (!good || polygon->count < 3)) {
        good = false;
        pp_mistakes_add(r->notes, loop->line,
                        "not a polygon of 3 to %d corners with three coordinates each, "
                        "within 100 km of the model's origin; ignored",
                        CORNERS_MOST);
    }
    if (status == PP_OK && good)
        status = make_simple(polygon, r);
    if (status == PP_OK && good)
        return PP_OK;
    free(polygon->corners);
    *polygon = (struct pp_gbxml_polygon){0};
    return status;
}
