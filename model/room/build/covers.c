/* covers.c - see covers.h. */
#include "model/room/build/covers.h"

#include <stdlib.h>
#include <string.h>

#include "model/room/build/opening_outline.h"
#include "model/room/face_frame.h"
#include "model/geometry/tolerance.h"

static const char *const words[] = {[PP_DOOR] = "door", [PP_DADO] = "dado"};

/* ---- pieces of a cover ---- */

/* Adds a piece to the wall with surface index `face`. frame->face is not used, since
 * adding surfaces invalidates it. */
static enum pp_status add_cover_piece(struct pp_resolver *r,
                                      const struct pp_cover_part *part, int face,
                                      const struct pp_face_frame *frame,
                                      const double (*xy)[2], int count,
                                      struct pp_error *err)
{
    const struct pp_polygon *wall = &r->world->surfaces[face].outline;
    double off_m = PP_SET_OFF_M + 2.0 * pp_polygon_unevenness(wall);
    struct pp_vec3 normal = wall->normal;
    struct pp_surface surface = {.role = PP_COVER,
                                 .inside = true,
                                 .name = part->name ? part->name : words[part->kind],
                                 .front = part->reflectance,
                                 .back = part->reflectance,
                                 .finish = part->finish,
                                 .owner = face,
                                 .is_door = part->kind == PP_DOOR,
                                 .line = part->line};
    struct pp_vec3 *corners = malloc((size_t)count * sizeof *corners);
    if (!corners)
        return pp_fail_memory(err);
    for (int i = 0; i < count; i++)
        corners[i] =
            pp_vec_along(pp_face_frame_point(frame, xy[i][0], xy[i][1]), off_m, normal);
    enum pp_status status = pp_resolve_add_face(r, surface, corners, count, err);
    free(corners);
    return status;
}

/* ---- other parts of a wall ---- */

/* Outline, in the frame of a wall, of opening i, or for i >= opening_count of surface i
 * - opening_count if that is a cover. NULL, and *count 0, if the opening or cover is
 * not in this wall. The caller frees the outline. */
static enum pp_status neighbour(double (**xy)[2], int *count, int *line,
                                const struct pp_world *world, int i,
                                const struct pp_face_frame *frame, struct pp_error *err)
{
    int face = (int)(frame->face - world->surfaces), k = i - world->opening_count;
    const struct pp_polygon *outline = NULL;
    if (k < 0 && world->openings[i].face == face) {
        outline = &world->openings[i].inner;
        *line = world->openings[i].line;
    } else if (k >= 0 && world->surfaces[k].role == PP_COVER
               && world->surfaces[k].owner == face) {
        outline = &world->surfaces[k].outline;
        *line = world->surfaces[k].line;
    }
    *xy = NULL;
    *count = 0;
    if (!outline)
        return PP_OK;
    *xy = malloc((size_t)outline->count * sizeof **xy);
    if (!*xy)
        return pp_fail_memory(err);
    *count = outline->count;
    pp_polygon_flatten(outline->vertices, outline->count, frame->origin, frame->along,
                       frame->up, *xy);
    return PP_OK;
}

/* ---- Doors ---- */

static enum pp_status check_door(bool *good, struct pp_resolver *r,
                                 const struct pp_cover_part *part,
                                 const struct pp_face_frame *frame, double xy[4][2],
                                 struct pp_error *err)
{
    const struct pp_world *world = r->world;
    char wall[96];
    double out_m = 0.0, out_m2 = 0.0;
    struct pp_vec3 where;
    enum pp_status status = pp_face_frame_fit(frame, r->clipper, xy, 4, PP_ROUNDING_M,
                                              &out_m, &where, &out_m2, err);
    pp_opening_outline_face_words(wall, sizeof wall, frame->face);
    *good = out_m == 0.0 && out_m2 == 0.0;
    if (status == PP_OK && out_m > 0.0)
        pp_mistakes_add(r->mistakes, part->line,
                        "door: extends beyond %s by %.4g m at (%g, %g, %g); expected "
                        "all of the door within it",
                        wall, out_m, where.x, where.y, where.z);
    else if (status == PP_OK && !*good)
        pp_mistakes_add(
            r->mistakes, part->line,
            "door: %.4g m2 of the door is outside %s; expected all of it within",
            out_m2, wall);
    int most = world->opening_count + world->surface_count;
    for (int i = 0; i < most && *good && status == PP_OK; i++) {
        double(*other)[2], area_m2 = 0.0;
        int count, line;
        status = neighbour(&other, &count, &line, world, i, frame, err);
        if (count > 0)
            status = pp_face_frame_rings_overlap(r->clipper, (const double(*)[2])xy, 4,
                                                 (const double(*)[2])other, count,
                                                 &area_m2, err);
        free(other);
        if (!(area_m2 > PP_ROUNDING_M * (part->width_m + part->height_m)))
            continue;
        *good = false;
        pp_mistakes_add(r->mistakes, part->line,
                        "door: overlaps the %s on line %d by %.4g m2; expected them "
                        "side by side",
                        i < world->opening_count ? "opening" : "door", line, area_m2);
    }
    return status;
}

static enum pp_status add_door(struct pp_resolver *r, const struct pp_cover_part *part,
                               struct pp_error *err)
{
    int face = pp_resolve_wall(r, part->wall, words[PP_DOOR], part->line);
    struct pp_face_frame frame;
    bool good = false;
    if (face < 0)
        return PP_OK;
    enum pp_status status = pp_face_frame_init(&frame, &r->world->surfaces[face], err);
    /* `left` is measured as seen from outside, from the high end of `along`. */
    double right = frame.bounds.high[0] - part->left_m, left = right - part->width_m;
    double low = frame.bounds.low[1], high = low + part->height_m;
    double xy[4][2] = {{left, low}, {right, low}, {right, high}, {left, high}};
    if (status == PP_OK)
        status = check_door(&good, r, part, &frame, xy, err);
    if (status == PP_OK && good)
        status = add_cover_piece(r, part, face, &frame, (const double(*)[2])xy, 4, err);
    pp_face_frame_clear(&frame);
    return status;
}

/* ---- Dados ---- */

/* Replaces the region by its part outside the ring, or inside it if `common`. */
static enum pp_status cut_region_by_ring(struct pp_region *region,
                                         struct pp_clipper *clipper,
                                         const double (*xy)[2], int count, bool common,
                                         struct pp_error *err)
{
    struct pp_region other = {0, NULL}, rest = {0, NULL};
    enum pp_status status = pp_clipper_of_ring(clipper, &other, xy, count, err);
    if (status == PP_OK)
        status = common ? pp_clipper_intersection(clipper, &rest, region, &other, err)
                        : pp_clipper_difference(clipper, &rest, region, &other, err);
    pp_region_clear(&other);
    if (status == PP_OK) {
        pp_region_clear(region);
        *region = rest;
    }
    return status;
}

/* Lower part of the wall, without openings and doors. */
static enum pp_status dado_region(struct pp_region *region, struct pp_resolver *r,
                                  const struct pp_cover_part *part,
                                  const struct pp_face_frame *frame,
                                  struct pp_error *err)
{
    const struct pp_world *world = r->world;
    double left = frame->bounds.low[0], right = frame->bounds.high[0];
    double low = frame->bounds.low[1];
    double high = fmin(low + part->height_m, frame->bounds.high[1]);
    const double strip[4][2] = {{left, low}, {right, low}, {right, high}, {left, high}};
    enum pp_status status = pp_clipper_of_ring(
        r->clipper, region, (const double(*)[2])frame->xy, frame->count, err);
    if (status == PP_OK)
        status = cut_region_by_ring(region, r->clipper, strip, 4, true, err);
    int most = world->opening_count + world->surface_count;
    for (int i = 0; i < most && status == PP_OK; i++) {
        double(*other)[2];
        int count, line;
        status = neighbour(&other, &count, &line, world, i, frame, err);
        if (count > 0)
            status = cut_region_by_ring(region, r->clipper, (const double(*)[2])other,
                                        count, false, err);
        free(other);
    }
    return status;
}

/* Centre of the leftmost hole along the wall; INFINITY if there is no hole. */
static double first_hole(const struct pp_region *region)
{
    double first = INFINITY;
    for (int i = 0; i < region->count; i++) {
        const struct pp_ring *ring = &region->rings[i];
        const double(*xy)[2] = (const double(*)[2])ring->xy;
        double low = INFINITY, high = -INFINITY;
        for (int k = 0; k < ring->count; k++) {
            low = fmin(low, xy[k][0]);
            high = fmax(high, xy[k][0]);
        }
        if (pp_region_ring_area(xy, ring->count) < 0.0)
            first = fmin(first, 0.5 * (low + high));
    }
    return first;
}

/* Adds each ring as a piece; the region has no holes. */
static enum pp_status add_rings(struct pp_resolver *r, const struct pp_cover_part *part,
                                int face, const struct pp_face_frame *frame,
                                const struct pp_region *region, struct pp_error *err)
{
    enum pp_status status = PP_OK;
    for (int i = 0; i < region->count && status == PP_OK; i++) {
        const struct pp_ring *ring = &region->rings[i];
        const double(*xy)[2] = (const double(*)[2])ring->xy;
        if (pp_region_ring_area(xy, ring->count) > PP_ROUNDING_M * PP_SAME_M)
            status = add_cover_piece(r, part, face, frame, xy, ring->count, err);
    }
    return status;
}

/* Adds a dado. Vertical cuts through the centre of each hole, as around a low window,
 * leave pieces without holes. */
static enum pp_status add_pieces(struct pp_resolver *r,
                                 const struct pp_cover_part *part, int face,
                                 const struct pp_face_frame *frame,
                                 struct pp_region *region, struct pp_error *err)
{
    enum pp_status status = PP_OK;
    double low = frame->bounds.low[1], high = frame->bounds.high[1];
    for (double at; status == PP_OK && isfinite(at = first_hole(region));) {
        double left = frame->bounds.low[0], right = frame->bounds.high[0];
        const double before[4][2] = {{left, low}, {at, low}, {at, high}, {left, high}};
        const double behind[4][2] = {
            {at, low}, {right, low}, {right, high}, {at, high}};
        struct pp_region piece = {0, NULL};
        status = pp_region_copy(&piece, region, err);
        if (status == PP_OK)
            status = cut_region_by_ring(&piece, r->clipper, before, 4, true, err);
        if (status == PP_OK)
            status = add_rings(r, part, face, frame, &piece, err);
        pp_region_clear(&piece);
        if (status == PP_OK)
            status = cut_region_by_ring(region, r->clipper, behind, 4, true, err);
    }
    return status == PP_OK ? add_rings(r, part, face, frame, region, err) : status;
}

static enum pp_status add_dado(struct pp_resolver *r, const struct pp_cover_part *part,
                               int face, struct pp_error *err)
{
    struct pp_face_frame frame;
    struct pp_region region = {0, NULL};
    char wall[96];
    enum pp_status status = pp_face_frame_init(&frame, &r->world->surfaces[face], err);
    double tall = frame.bounds.high[1] - frame.bounds.low[1];
    bool fits = part->height_m <= tall + PP_ROUNDING_M;
    pp_opening_outline_face_words(wall, sizeof wall, &r->world->surfaces[face]);
    if (status == PP_OK && !fits)
        pp_mistakes_add(r->mistakes, part->line,
                        "dado: is %g m high; expected at most %g m, the height of %s",
                        part->height_m, tall, wall);
    if (status == PP_OK && fits)
        status = dado_region(&region, r, part, &frame, err);
    if (status == PP_OK && fits)
        status = add_pieces(r, part, face, &frame, &region, err);
    pp_region_clear(&region);
    pp_face_frame_clear(&frame);
    return status;
}

/* Assigns dado i to a face. Reports a second dado for the same wall, or for all walls,
 * and returns false. */
static bool put_dado(struct pp_resolver *r, int *dado, int i)
{
    const struct pp_cover_part *part = &r->room->covers[i];
    const struct pp_cover_part *other = *dado < 0 ? NULL : &r->room->covers[*dado];
    *dado = i;
    if (!other || (other->wall == NULL) != (part->wall == NULL))
        return true;
    pp_mistakes_add(r->mistakes, part->line,
                    "dado: %s already has a dado, on line %d; expected only one",
                    part->wall ? "the wall" : "every wall", other->line);
    return false;
}

/* Finds the dado of each face, -1 if none: its own, or the one for all walls. */
static void find_dados(struct pp_resolver *r, int *dados)
{
    const struct pp_room *room = r->room;
    const struct pp_world *world = r->world;
    for (int i = 0; i < room->cover_count; i++) {
        bool good = room->covers[i].kind == PP_DADO && !room->covers[i].wall;
        for (int f = 0; f < world->face_count && good; f++)
            if (world->surfaces[f].role == PP_WALL)
                good = put_dado(r, &dados[f], i);
    }
    for (int i = 0; i < room->cover_count; i++) {
        const struct pp_cover_part *part = &room->covers[i];
        int face = part->kind == PP_DADO
                       ? pp_resolve_wall(r, part->wall, words[PP_DADO], part->line)
                       : -1;
        if (face >= 0)
            put_dado(r, &dados[face], i);
    }
}

static enum pp_status add_dados(struct pp_resolver *r, struct pp_error *err)
{
    int faces = r->world->face_count;
    int *dados = malloc(((size_t)faces + 1) * sizeof *dados);
    enum pp_status status = dados ? PP_OK : pp_fail_memory(err);
    for (int f = 0; f < faces && dados; f++)
        dados[f] = -1;
    if (dados)
        find_dados(r, dados);
    for (int f = 0; f < faces && status == PP_OK; f++)
        if (dados[f] >= 0)
            status = add_dado(r, &r->room->covers[dados[f]], f, err);
    free(dados);
    return status;
}

enum pp_status pp_build_covers(struct pp_resolver *r, struct pp_error *err)
{
    enum pp_status status = PP_OK;
    if (!r->watertight || r->room->cover_count == 0)
        return PP_OK;
    for (int i = 0; i < r->room->cover_count && status == PP_OK; i++)
        if (r->room->covers[i].kind == PP_DOOR)
            status = add_door(r, &r->room->covers[i], err);
    return status == PP_OK ? add_dados(r, err) : status;
}
