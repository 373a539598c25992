/* gbxml_openings.c - clips openings to faces by polygon overlay in the plane of the
 * face. */
#include "formats/gbxml/gbxml_openings.h"

#include <math.h>
#include <stdlib.h>

#include "model/base/array.h"
#include "model/geometry/polygon.h"
#include "model/geometry/region_pieces.h"

/* reveal_m: greatest distance of an opening from the plane of its face. parallel: least
 * cosine of the angle between their normals. */
static const double reveal_m = 0.6, parallel = 0.98;

/* Pieces of openings, and losses of area, below this (m2) are rounding errors. */
static const double least_m2 = 1e-3;

/* An opening of a surface, and the part of it that is not yet in a face. */
struct opening_left {
    struct pp_gbxml_opening *opening;
    struct pp_vec3 normal; /* unit */
    double area_m2, placed_m2;
};

static struct pp_vec3 face_corner(const struct pp_gbxml_room *room, int face, int i)
{
    return room->shell.corners[room->shell.faces[face].corners[i]];
}

/* Projects the corners onto the plane through `origin`; *figure is the region that they
 * enclose. */
static enum pp_status flatten_figure(struct pp_region *figure,
                                     const struct pp_vec3 *corners, int count,
                                     struct pp_vec3 origin, struct pp_vec3 along,
                                     struct pp_vec3 up, struct pp_clipper *clipper,
                                     struct pp_error *err)
{
    struct pp_error said = {0};
    double(*xy)[2] = malloc((size_t)count * sizeof *xy);
    *figure = (struct pp_region){0};
    if (!xy)
        return pp_fail_memory(err);
    pp_polygon_flatten(corners, count, origin, along, up, xy);
    enum pp_status status =
        pp_clipper_by_crossings(clipper, figure, (const double(*)[2])xy, count, &said);
    free(xy);
    return status == PP_SYSTEM ? pp_fail_memory(err) : PP_OK;
}

/* Axes in the plane of a face, and the face as a region in these axes. */
struct opening_plane {
    struct pp_vec3 origin, along, up;
    struct pp_region figure;
};

static enum pp_status find_plane(struct opening_plane *plane,
                                 const struct pp_gbxml_room *room, int face,
                                 struct pp_clipper *clipper, struct pp_error *err)
{
    const int count = room->shell.faces[face].count;
    struct pp_vec3 normal = pp_gbxml_shell_normal(&room->shell, face);
    struct pp_vec3 *corners = malloc((size_t)count * sizeof *corners);
    *plane = (struct opening_plane){.origin = face_corner(room, face, 0)};
    if (!corners)
        return pp_fail_memory(err);
    for (int i = 0; i < count; i++)
        corners[i] = face_corner(room, face, i);
    pp_polygon_plane_axes(pp_vec_scale(normal, 1.0 / pp_vec_length(normal)),
                          &plane->along, &plane->up);
    enum pp_status status =
        flatten_figure(&plane->figure, corners, count, plane->origin, plane->along,
                       plane->up, clipper, err);
    free(corners);
    return status;
}

/* Subtracts the openings already placed in the face from the region *figure. */
static enum pp_status take_placed(struct pp_region *figure,
                                  const struct opening_plane *plane,
                                  const struct pp_gbxml_room *room, int face,
                                  struct pp_clipper *clipper, struct pp_error *err)
{
    enum pp_status status = PP_OK;
    for (int i = 0; i < room->opening_count && status == PP_OK; i++) {
        const struct pp_gbxml_room_opening *other = &room->openings[i];
        struct pp_region taken;
        if (other->face != face)
            continue;
        status = flatten_figure(&taken, other->corners, other->count, plane->origin,
                                plane->along, plane->up, clipper, err);
        if (status == PP_OK)
            status = pp_clipper_take_away(clipper, figure, &taken, err);
        pp_region_clear(&taken);
    }
    return status;
}

/* Removes corners equal to the previous one; returns the number left. */
static int drop_repeated(struct pp_vec3 *corners, int count)
{
    int kept = 0;
    for (int i = 0; i < count; i++) {
        struct pp_vec3 before = kept > 0 ? corners[kept - 1] : corners[count - 1];
        if (pp_vec_length(pp_vec_sub(corners[i], before)) > PP_GBXML_SAME_M)
            corners[kept++] = corners[i];
    }
    return kept;
}

/* Adds the pieces of the region as openings of the face, and their area to
 * *placed_m2. */
static enum pp_status add_pieces(struct pp_gbxml_room *room, double *placed_m2,
                                 struct pp_gbxml_opening *opening, int face,
                                 const struct pp_region *figure,
                                 const struct opening_plane *plane,
                                 struct pp_clipper *clipper, struct pp_error *err)
{
    struct pp_region_pieces pieces;
    const double before_m2 = *placed_m2;
    enum pp_status status =
        pp_region_pieces_cut(&pieces, figure, plane->origin, plane->along, plane->up,
                             least_m2, clipper, err);
    for (int i = 0; i < pieces.count && status == PP_OK; i++) {
        struct pp_gbxml_room_opening made = {.opening = opening, .face = face};
        status = pp_array_append(&room->openings, room->opening_count,
                                 sizeof *room->openings, err);
        if (status != PP_OK)
            break;
        made.corners = pieces.list[i].corners;
        made.count = drop_repeated(made.corners, pieces.list[i].count);
        *placed_m2 += pp_vec_length(pp_polygon_area_vector(made.corners, made.count));
        pieces.list[i].corners = NULL;
        room->openings[room->opening_count++] = made;
    }
    pp_region_pieces_clear(&pieces);
    if (status == PP_OK && *placed_m2 > before_m2)
        room->faces[face].inner = false;
    return status;
}

/* Places an opening in a face: the part of the opening that lies in the face and is not
 * covered by openings placed earlier. */
static enum pp_status place_in_face(struct pp_gbxml_room *room,
                                    struct opening_left *left, int face,
                                    struct pp_clipper *clipper, struct pp_error *err)
{
    const struct pp_gbxml_polygon *outline = &left->opening->outline;
    struct pp_region figure = {0}, within = {0};
    struct opening_plane plane;
    double before = left->placed_m2;
    enum pp_status status = find_plane(&plane, room, face, clipper, err);
    if (status == PP_OK)
        status = flatten_figure(&figure, outline->corners, outline->count, plane.origin,
                                plane.along, plane.up, clipper, err);
    if (status == PP_OK)
        status = pp_clipper_intersection(clipper, &within, &figure, &plane.figure, err);
    if (status == PP_OK)
        status = take_placed(&within, &plane, room, face, clipper, err);
    if (status == PP_OK)
        status = add_pieces(room, &left->placed_m2, left->opening, face, &within,
                            &plane, clipper, err);
    /* A failed overlay only means that this face gets no part of the opening. */
    if (status == PP_BAD_INPUT)
        status = PP_OK, left->placed_m2 = before;
    pp_region_clear(&figure);
    pp_region_clear(&within);
    pp_region_clear(&plane.figure);
    return status;
}

/* Distance of the opening's centre from a parallel face; NAN if the face is not
 * parallel, or farther away than reveal_m. */
static double distance_to(const struct pp_gbxml_room *room, int face,
                          const struct opening_left *left)
{
    const struct pp_gbxml_polygon *outline = &left->opening->outline;
    struct pp_vec3 normal = pp_gbxml_shell_normal(&room->shell, face), sum = {0};
    double length = pp_vec_length(normal);
    if (!(length > 0.0)
        || !(fabs(pp_vec_dot(normal, left->normal)) > parallel * length))
        return NAN;
    for (int i = 0; i < outline->count; i++)
        sum = pp_vec_add(sum,
                         pp_vec_sub(outline->corners[i], face_corner(room, face, 0)));
    double away = fabs(pp_vec_dot(sum, normal)) / length / outline->count;
    return away < reveal_m ? away : NAN;
}

/* Distributes an opening over the faces, nearest first, until more than half of it is
 * placed. Faces in one plane count as equally near. */
static enum pp_status place_opening(struct pp_gbxml_room *room,
                                    struct opening_left *left,
                                    struct pp_clipper *clipper, struct pp_error *err)
{
    enum pp_status status = PP_OK;
    double reached = -1.0; /* faces up to this distance are done */
    while (status == PP_OK && left->area_m2 - left->placed_m2 > least_m2) {
        double next = INFINITY;
        for (int i = 0; i < room->shell.face_count; i++) {
            double away = distance_to(room, i, left);
            if (away > reached)
                next = fmin(next, away);
        }
        /* Once more than half of the opening is placed, faces farther away get none of
         * it. */
        if (!isfinite(next) || left->placed_m2 > 0.5 * left->area_m2)
            break;
        for (int i = 0; i < room->shell.face_count && status == PP_OK; i++) {
            double away = distance_to(room, i, left);
            if (away > reached && away <= next + 1e-2)
                status = place_in_face(room, left, i, clipper, err);
        }
        reached = next + 1e-2;
    }
    return status;
}

static void note_lost(const struct opening_left *left, struct pp_mistakes *notes)
{
    const char *name = left->opening->name ? left->opening->name : "";
    double lost = left->area_m2 - left->placed_m2;
    if (left->placed_m2 == 0.0)
        pp_mistakes_add(notes, left->opening->line,
                        "opening \"%.60s\" does not lie in a face of its space, or it "
                        "overlaps other openings; it is treated as part of the wall",
                        name);
    else if (lost > least_m2)
        pp_mistakes_add(notes, left->opening->line,
                        "opening \"%.60s\" extends beyond its wall or into another "
                        "opening; %.3g of its %.3g m2 are cut off",
                        name, lost, left->area_m2);
}

static int by_area(const void *a, const void *b)
{
    const struct opening_left *one = a, *other = b;
    if (one->area_m2 != other->area_m2)
        return one->area_m2 > other->area_m2 ? -1 : 1;
    return (one->opening->line > other->opening->line)
           - (one->opening->line < other->opening->line);
}

static enum pp_status list_opening(struct opening_left **list, int *count,
                                   struct pp_gbxml_opening *opening,
                                   struct pp_error *err)
{
    struct opening_left left = {.opening = opening};
    struct pp_vec3 area =
        pp_polygon_area_vector(opening->outline.corners, opening->outline.count);
    left.area_m2 = pp_vec_length(area);
    if (opening->left_out)
        return PP_OK;
    left.normal = left.area_m2 > 0.0 ? pp_vec_scale(area, 1.0 / left.area_m2) : area;
    enum pp_status status = pp_array_append(list, *count, sizeof **list, err);
    if (status == PP_OK)
        (*list)[(*count)++] = left;
    return status;
}

/* Lists the openings to the outside, the largest first. */
static enum pp_status list_openings(struct opening_left **list, int *count,
                                    struct pp_gbxml_model *model,
                                    const struct pp_gbxml_space *space,
                                    struct pp_error *err)
{
    enum pp_status status = PP_OK;
    for (int i = 0; i < model->surface_count && status == PP_OK; i++) {
        struct pp_gbxml_surface *surface = &model->surfaces[i];
        if (!pp_gbxml_model_bounds(surface, space) || !pp_gbxml_model_is_outer(surface))
            continue;
        for (int k = 0; k < surface->opening_count && status == PP_OK; k++)
            status = list_opening(list, count, &surface->openings[k], err);
    }
    if (*count > 0)
        qsort(*list, (size_t)*count, sizeof **list, by_area);
    return status;
}

enum pp_status pp_gbxml_openings_add(struct pp_gbxml_room *room,
                                     struct pp_gbxml_model *model,
                                     const struct pp_gbxml_space *space,
                                     struct pp_clipper *clipper,
                                     struct pp_mistakes *notes, struct pp_error *err)
{
    struct opening_left *list = NULL;
    int list_count = 0;
    enum pp_status status = list_openings(&list, &list_count, model, space, err);
    for (int i = 0; i < list_count && status == PP_OK; i++) {
        status = place_opening(room, &list[i], clipper, err);
        if (status == PP_OK)
            note_lost(&list[i], notes);
    }
    free(list);
    return status;
}
