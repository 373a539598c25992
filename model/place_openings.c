/* place_openings.c - windows, rooflights and glazed polygons into the faces they are
 * cut from.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "model/nearest.h"
#include "model/resolve.h"
#include "model/sheet.h"
#include "model/tolerance.h"

/* Deeper than any wall; more is a slip of the keyboard. */
static const double reveal_most_m = 10.0;

static const char *kind_word(const struct pp_opening_part *part)
{
    return part->kind == PP_WINDOW      ? "window"
           : part->kind == PP_ROOFLIGHT ? "rooflight"
                                        : "opening";
}

/* "wall "south"", "the ceiling", ... */
static const char *face_words(char *text, size_t size, const struct pp_surface *face)
{
    static const char *const roles[] = {"floor", "wall", "ceiling"};
    char name[64];
    if (face->name)
        snprintf(text, size, "%s \"%s\"", roles[face->role],
                 pp_excerpt(name, sizeof name, face->name));
    else
        snprintf(text, size, "the %s", roles[face->role]);
    return text;
}

/* Notes what of the ring sticks out of its face; by no more than the tolerance it is
 * moved in. */
static enum pp_status fit_in_face(bool *fits, struct pp_resolver *r,
                                  const struct pp_opening_part *part,
                                  const struct pp_sheet *sheet, double (*xy)[2],
                                  int count, double tolerance, struct pp_error *err)
{
    char words[96];
    double out_m = 0.0, out_m2 = 0.0;
    struct pp_vec3 where;
    if (pp_sheet_fit(sheet, r->clipper, xy, count, tolerance, &out_m, &where, &out_m2,
                     err)
        != PP_OK)
        return PP_SYSTEM;
    face_words(words, sizeof words, sheet->face);
    if (out_m > 0.0)
        pp_mistake(r->mistakes, part->line,
                   "%s: sticks out of %s by %.4g m at (%g, %g, %g); expected all of it "
                   "within",
                   kind_word(part), words, out_m, where.x, where.y, where.z);
    else if (out_m2 > 0.0)
        pp_mistake(r->mistakes, part->line,
                   "%s: %.4g m2 of it stick out of %s; expected all of it within",
                   kind_word(part), out_m2, words);
    *fits = out_m == 0.0 && out_m2 == 0.0;
    return PP_OK;
}

/* ---- What an opening is, from its outline ---- */

/* Dirt by slope and surroundings, as in the conventions. */
static double maintenance_of(enum pp_surroundings surroundings, double slope_rad)
{
    static const double share[3][3] = {
        /* vertical, sloping, horizontal */
        [PP_RURAL] = {0.9, 0.8, 0.7},
        [PP_URBAN] = {0.8, 0.7, 0.6},
        [PP_INDUSTRIAL] = {0.7, 0.6, 0.5},
    };
    /* Vertical from 75 degrees, horizontal below 15, whatever the rounding. */
    double slope_deg = slope_rad / PP_RAD + 1e-6;
    int column = slope_deg >= 75.0 ? 0 : slope_deg >= 15.0 ? 1 : 2;
    return share[surroundings][column];
}

/* Is the outline a rectangle with its edges along the axes? */
static bool is_upright_rectangle(const double (*xy)[2], int count, const double low[2],
                                 const double high[2])
{
    if (count != 4)
        return false;
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 2; k++)
            if (fmin(fabs(xy[i][k] - low[k]), fabs(xy[i][k] - high[k])) > PP_ROUNDING_M)
                return false;
    return true;
}

static enum pp_status add_opening(struct pp_resolver *r,
                                  const struct pp_opening_part *part,
                                  const struct pp_sheet *sheet, const double (*xy)[2],
                                  int count, struct pp_error *err)
{
    struct pp_world *world = r->world;
    struct pp_opening opening = {.face = (int)(sheet->face - world->surfaces),
                                 .along = sheet->along,
                                 .up = sheet->up,
                                 .glass = part->glazing.glass,
                                 .frame_factor = part->glazing.frame_factor,
                                 .maintenance = part->glazing.maintenance,
                                 .reveal_m = part->glazing.reveal_m,
                                 .line = part->line};
    struct pp_vec3 normal = sheet->face->outline.normal;
    opening.slope_rad = atan2(hypot(normal.x, normal.y), -normal.z);
    if (isnan(opening.maintenance))
        opening.maintenance = maintenance_of(world->surroundings, opening.slope_rad);

    struct pp_vec3 *vertices = malloc(count * sizeof *vertices);
    if (!vertices)
        return pp_fail_memory(err);
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    double low_z = INFINITY, high_z = -INFINITY;
    for (int i = 0; i < count; i++) {
        vertices[i] = pp_sheet_point(sheet, xy[i][0], xy[i][1]);
        low_z = fmin(low_z, vertices[i].z);
        high_z = fmax(high_z, vertices[i].z);
        for (int k = 0; k < 2; k++) {
            low[k] = fmin(low[k], xy[i][k]);
            high[k] = fmax(high[k], xy[i][k]);
        }
    }
    opening.width_m = high[0] - low[0];
    opening.height_m = high[1] - low[1];
    opening.middle_z_m = 0.5 * (low_z + high_z);
    opening.rectangle = is_upright_rectangle(xy, count, low, high);

    enum pp_status status = pp_polygon_of(&opening.inner, vertices, count, err);
    if (status == PP_OK) {
        for (int i = 0; i < count; i++)
            vertices[i] = pp_along(vertices[i], -opening.reveal_m, normal);
        status = pp_polygon_of(&opening.outer, vertices, count, err);
    }
    free(vertices);
    /* The face's normal to the bit, not one more rounding of it. */
    opening.inner.normal = opening.outer.normal = normal;
    if (status == PP_OK)
        world->openings[world->opening_count++] = opening;
    else
        pp_polygon_clear(&opening.inner);
    return status;
}

/* ---- One opening against those before it ---- */

static enum pp_status check_overlaps(bool *free_of_others, struct pp_resolver *r,
                                     const struct pp_opening_part *part,
                                     const struct pp_sheet *sheet,
                                     const double (*xy)[2], int count,
                                     struct pp_error *err)
{
    const struct pp_world *world = r->world;
    int face = (int)(sheet->face - world->surfaces);
    *free_of_others = true;
    for (int i = 0; i < world->opening_count; i++) {
        const struct pp_opening *other = &world->openings[i];
        if (other->face != face)
            continue;
        int other_count = other->inner.count;
        double(*other_xy)[2] = malloc(other_count * sizeof *other_xy);
        if (!other_xy)
            return pp_fail_memory(err);
        pp_flatten(other->inner.vertices, other_count, sheet->origin, sheet->along,
                   sheet->up, other_xy);
        double area_m2 = 0.0;
        enum pp_status status =
            pp_rings_overlap(r->clipper, xy, count, (const double(*)[2])other_xy,
                             other_count, &area_m2, err);
        free(other_xy);
        if (status != PP_OK)
            return status;
        if (area_m2 > PP_ROUNDING_M * (other->width_m + other->height_m)) {
            *free_of_others = false;
            pp_mistake(r->mistakes, part->line,
                       "%s: overlaps the one of line %d by %.4g m2; expected openings "
                       "side by side",
                       kind_word(part), other->line, area_m2);
        }
    }
    return PP_OK;
}

/* ---- Where each kind lies ---- */

/* The window's outline in its wall; false (and a mistake) where it sticks out. */
static bool window_outline(struct pp_resolver *r, const struct pp_opening_part *part,
                           const struct pp_sheet *sheet, double xy[4][2])
{
    char words[96];
    double wide = sheet->high[0] - sheet->low[0], tall = sheet->high[1] - sheet->low[1];
    face_words(words, sizeof words, sheet->face);
    double right = part->left_m + part->width_m - wide;
    double top = part->sill_m + part->height_m - tall;
    bool fits = true;
    if (part->left_m < -PP_ROUNDING_M) {
        pp_mistake(r->mistakes, part->line,
                   "window: begins %.4g m to the left of %s, seen from outside; "
                   "expected left to be 0 or more",
                   -part->left_m, words);
        fits = false;
    }
    if (right > PP_ROUNDING_M) {
        pp_mistake(
            r->mistakes, part->line,
            "window: ends %.4g m to the right of %s, seen from outside; expected "
            "left + width to be %g m at most",
            right, words, wide);
        fits = false;
    }
    if (part->sill_m < -PP_ROUNDING_M) {
        pp_mistake(r->mistakes, part->line,
                   "window: begins %.4g m below the foot of %s; expected sill to be 0 "
                   "or more",
                   -part->sill_m, words);
        fits = false;
    }
    if (top > PP_ROUNDING_M) {
        pp_mistake(r->mistakes, part->line,
                   "window: ends %.4g m above the top of %s; expected sill + height to "
                   "be %g m at most",
                   top, words, tall);
        fits = false;
    }
    /* Left is left from outside: it is the high end of `along`. */
    double x_high = fmin(sheet->high[0], sheet->high[0] - part->left_m);
    double x_low = fmax(sheet->low[0], sheet->high[0] - part->left_m - part->width_m);
    double y_low = fmax(sheet->low[1], sheet->low[1] + part->sill_m);
    double y_high =
        fmin(sheet->high[1], sheet->low[1] + (part->sill_m + part->height_m));
    if (fabs(right) <= PP_ROUNDING_M)
        x_low = sheet->low[0];
    if (fabs(part->left_m) <= PP_ROUNDING_M)
        x_high = sheet->high[0];
    if (fabs(part->sill_m) <= PP_ROUNDING_M)
        y_low = sheet->low[1];
    if (fabs(top) <= PP_ROUNDING_M)
        y_high = sheet->high[1];
    double ring[4][2] = {
        {x_low, y_low}, {x_high, y_low}, {x_high, y_high}, {x_low, y_high}};
    memcpy(xy, ring, sizeof ring);
    return fits;
}

/* The rooflight's outline, counter-clockwise from below in a level sheet: x runs along
 * it, y against its up. */
static void rooflight_outline(const struct pp_opening_part *part,
                              const struct pp_sheet *sheet, double xy[4][2])
{
    double z = sheet->origin.z;
    struct pp_vec3 corners[4] = {{part->x, part->y + part->depth_m, z},
                                 {part->x + part->width_m, part->y + part->depth_m, z},
                                 {part->x + part->width_m, part->y, z},
                                 {part->x, part->y, z}};
    pp_flatten(corners, 4, sheet->origin, sheet->along, sheet->up, xy);
}

static bool is_level_ceiling(const struct pp_surface *face)
{
    return face->role == PP_CEILING && face->outline.normal.z < 0.0
           && hypot(face->outline.normal.x, face->outline.normal.y) < PP_LEVEL_RAD;
}

/* The flat ceiling over the rooflight's middle, or else the one nearest to it; -1 where
 * there is none. */
static int ceiling_of(const struct pp_world *world, const struct pp_opening_part *part)
{
    int nearest = -1;
    double least = INFINITY;
    for (int i = 0; i < world->face_count; i++) {
        const struct pp_surface *face = &world->surfaces[i];
        if (!is_level_ceiling(face))
            continue;
        double distance =
            pp_polygon_distance(&face->outline, pp_vec(part->x + 0.5 * part->width_m,
                                                       part->y + 0.5 * part->depth_m,
                                                       face->outline.vertices[0].z));
        if (distance < least) {
            least = distance;
            nearest = i;
        }
    }
    return nearest;
}

/* The face in whose plane all the vertices lie, the one that holds the middle of
 * several; -1 where there is none, and how far off the nearest is. */
static int face_of_outline(const struct pp_world *world,
                           const struct pp_vertices *vertices, int *nearest,
                           double *off_m)
{
    int found = -1;
    double least_to_middle = INFINITY;
    struct pp_vec3 middle = {0.0, 0.0, 0.0};
    for (int k = 0; k < vertices->count; k++)
        middle = pp_along(middle, 1.0 / vertices->count, vertices->list[k]);
    *nearest = -1;
    *off_m = INFINITY;
    for (int i = 0; i < world->face_count; i++) {
        const struct pp_polygon *outline = &world->surfaces[i].outline;
        double off_plane = 0.0, off_face = 0.0;
        for (int k = 0; k < vertices->count; k++) {
            struct pp_vec3 v = vertices->list[k];
            off_plane = fmax(off_plane, fabs(pp_polygon_height(outline, v)));
            off_face = fmax(off_face, pp_polygon_distance(outline, v));
        }
        double to_middle = pp_polygon_distance(outline, middle);
        if (off_plane <= PP_SAME_M && to_middle < least_to_middle) {
            least_to_middle = to_middle;
            found = i;
        }
        if (off_face < *off_m) {
            *off_m = off_face;
            *nearest = i;
        }
    }
    return found;
}

/* ---- The steps for one opening ---- */

static bool is_read(const struct pp_opening_part *part)
{
    if (!isfinite(part->glazing.frame_factor) || !isfinite(part->glazing.reveal_m))
        return false;
    switch (part->kind) {
    case PP_WINDOW:
        return part->wall && isfinite(part->left_m) && isfinite(part->sill_m)
               && isfinite(part->width_m) && isfinite(part->height_m);
    case PP_ROOFLIGHT:
        return isfinite(part->x) && isfinite(part->y) && isfinite(part->width_m)
               && isfinite(part->depth_m);
    case PP_OPENING:
        break;
    }
    return true;
}

static bool is_large_enough(struct pp_resolver *r, const struct pp_opening_part *part)
{
    double second = part->kind == PP_WINDOW ? part->height_m : part->depth_m;
    if (part->kind == PP_OPENING || (part->width_m >= PP_SAME_M && second >= PP_SAME_M))
        return true;
    pp_mistake(r->mistakes, part->line,
               "%s: is %g m by %g m; expected 1 mm or more each way", kind_word(part),
               part->width_m, second);
    return false;
}

/* The face that the part lies in, or -1 with the mistake noted if it is one. */
static int find_face(struct pp_resolver *r, const struct pp_opening_part *part)
{
    const struct pp_world *world = r->world;
    if (part->kind == PP_WINDOW)
        return pp_resolve_wall(r, part->wall, "window", part->line);
    if (world->face_count == 0 || r->faces_missing)
        return -1;
    if (part->kind == PP_ROOFLIGHT) {
        int ceiling = ceiling_of(world, part);
        if (ceiling < 0)
            pp_mistake(r->mistakes, part->line,
                       "rooflight: the room has no flat ceiling; expected an <opening> "
                       "in one of its faces");
        return ceiling;
    }
    int nearest;
    double off_m;
    int face = face_of_outline(world, &part->vertices, &nearest, &off_m);
    if (face < 0) {
        char words[96];
        face_words(words, sizeof words, &world->surfaces[nearest]);
        pp_mistake(
            r->mistakes, part->line,
            "opening: lies in no face of the room; the nearest is %s, from which "
            "a vertex is %.4g m away; expected all within 1 mm of its plane",
            words, off_m);
    } else if (pp_dot(pp_area_vector(part->vertices.list, part->vertices.count),
                      world->surfaces[face].outline.normal)
               < 0.0) {
        pp_mistake(r->mistakes, part->line,
                   "opening: turns clockwise seen from inside; expected "
                   "counter-clockwise");
        face = -1;
    }
    return face;
}

static enum pp_status place_in(struct pp_resolver *r,
                               const struct pp_opening_part *part,
                               const struct pp_sheet *sheet, struct pp_error *err)
{
    int count = part->kind == PP_OPENING ? part->vertices.count : 4;
    double tolerance = part->kind == PP_OPENING ? PP_SAME_M : PP_ROUNDING_M;
    double(*xy)[2] = malloc(count * sizeof *xy);
    if (!xy)
        return pp_fail_memory(err);
    bool good = true;
    if (part->kind == PP_WINDOW)
        good = window_outline(r, part, sheet, xy);
    else if (part->kind == PP_ROOFLIGHT)
        rooflight_outline(part, sheet, xy);
    else
        pp_flatten(part->vertices.list, count, sheet->origin, sheet->along, sheet->up,
                   xy);

    enum pp_status status = PP_OK;
    if (good)
        status = fit_in_face(&good, r, part, sheet, xy, count, tolerance, err);
    if (status == PP_OK && good)
        status =
            check_overlaps(&good, r, part, sheet, (const double(*)[2])xy, count, err);
    if (status == PP_OK && good)
        status = add_opening(r, part, sheet, (const double(*)[2])xy, count, err);
    free(xy);
    return status;
}

static enum pp_status place(struct pp_resolver *r, const struct pp_opening_part *part,
                            struct pp_error *err)
{
    if (!is_read(part) || !is_large_enough(r, part))
        return PP_OK;
    if (part->glazing.reveal_m > reveal_most_m)
        pp_mistake(r->mistakes, part->line,
                   "%s: its reveal is %g m deep; expected %g m at most",
                   kind_word(part), part->glazing.reveal_m, reveal_most_m);
    if (part->kind == PP_OPENING
        && !pp_resolve_good_outline(r, "opening", part->line, &part->vertices))
        return PP_OK;
    int face = find_face(r, part);
    if (face < 0)
        return PP_OK;
    struct pp_sheet sheet;
    enum pp_status status = pp_sheet_open(&sheet, &r->world->surfaces[face], err);
    if (status == PP_OK)
        status = place_in(r, part, &sheet, err);
    pp_sheet_close(&sheet);
    return status;
}

/* The sides of the opening's depth: one on each edge of its outline, facing the void
 * within. */
static enum pp_status add_reveals(struct pp_resolver *r, int index,
                                  struct pp_error *err)
{
    const struct pp_opening *opening = &r->world->openings[index];
    const struct pp_surface *wall = &r->world->surfaces[opening->face];
    struct pp_surface side = {.role = PP_REVEAL,
                              .inside = true,
                              .front = wall->front,
                              .back = wall->back,
                              .owner = index,
                              .line = opening->line};
    int count = opening->inner.count;
    for (int i = 0; i < count; i++) {
        int next = (i + 1) % count;
        struct pp_vec3 quad[4] = {
            opening->inner.vertices[i], opening->inner.vertices[next],
            opening->outer.vertices[next], opening->outer.vertices[i]};
        if (pp_resolve_add_face(r, side, quad, 4, err) != PP_OK)
            return PP_SYSTEM;
    }
    return PP_OK;
}

/* Moved out by the reveal, the glass may not stand in another part of the room. */
static void check_reveal(struct pp_resolver *r, const struct pp_opening *opening)
{
    for (int i = 0; i <= opening->outer.count; i++) {
        struct pp_vec3 point = i < opening->outer.count
                                   ? opening->outer.vertices[i]
                                   : pp_polygon_middle(&opening->outer);
        if (!pp_world_contains(r->world, point))
            continue;
        pp_mistake(
            r->mistakes, opening->line,
            "reveal: %g m deep, it puts the glass into another part of the room, "
            "at (%g, %g, %g); expected it outside",
            opening->reveal_m, point.x, point.y, point.z);
        return;
    }
}

enum pp_status pp_resolve_openings(struct pp_resolver *r, struct pp_error *err)
{
    const struct pp_room *room = r->room;
    struct pp_world *world = r->world;
    world->openings =
        calloc(room->opening_count ? room->opening_count : 1, sizeof *world->openings);
    if (!world->openings)
        return pp_fail_memory(err);
    for (int i = 0; i < room->opening_count; i++)
        if (place(r, &room->openings[i], err) != PP_OK)
            return PP_SYSTEM;
    for (int i = 0; i < world->opening_count; i++) {
        const struct pp_opening *opening = &world->openings[i];
        if (!(opening->reveal_m > 0.0))
            continue;
        if (r->closed)
            check_reveal(r, opening);
        if (add_reveals(r, i, err) != PP_OK)
            return PP_SYSTEM;
    }
    return PP_OK;
}
