/* place_openings.c - see place_openings.h. */
#include "model/room/build/place_openings.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/text.h"
#include "model/room/corrections.h"
#include "model/room/build/devices.h"
#include "model/room/build/opening_outline.h"
#include "model/room/face_frame.h"
#include "model/geometry/tolerance.h"
#include "model/light/slats/blind.h"
#include "model/room/build/outline.h"

/* Moves vertices that extend beyond the face by at most the tolerance to the edge of
 * the face; reports larger excesses. */
static enum pp_status fit_in_face(bool *fits, struct pp_resolver *r,
                                  const struct pp_opening_part *part,
                                  const struct pp_face_frame *frame, double (*xy)[2],
                                  int count, double tolerance, struct pp_error *err)
{
    char words[96];
    double out_m = 0.0, out_m2 = 0.0;
    struct pp_vec3 where;
    enum pp_status status = pp_face_frame_fit(frame, r->clipper, xy, count, tolerance,
                                              &out_m, &where, &out_m2, err);
    if (status != PP_OK)
        return status;
    pp_opening_outline_face_words(words, sizeof words, frame->face);
    /* A ring thinner than the tolerance may have no area after the move. */
    bool whole;
    status = pp_clipper_ring_is_simple(&whole, r->clipper, (const double(*)[2])xy,
                                       count, err);
    if (status != PP_OK)
        return status;
    if (out_m > 0.0)
        pp_mistakes_add(r->mistakes, part->line,
                        "%s: extends beyond %s by %.4g m at (%g, %g, %g); expected all "
                        "of it within",
                        pp_opening_outline_word(part), words, out_m, where.x, where.y,
                        where.z);
    else if (out_m2 > 0.0)
        pp_mistakes_add(r->mistakes, part->line,
                        "%s: %.4g m2 of it is outside %s; expected all of it within",
                        pp_opening_outline_word(part), out_m2, words);
    else if (!whole)
        pp_mistakes_add(r->mistakes, part->line,
                        "%s: less than 1 mm of it is within %s; expected all of it",
                        pp_opening_outline_word(part), words);
    *fits = out_m == 0.0 && out_m2 == 0.0 && whole;
    return PP_OK;
}

/* ---- properties that follow from the outline ---- */

/* Finds the maintenance factor for maintenance="auto" in the table of dirt factors that
 * the site selects, by surroundings, type of work and slope of the glass. Reports a
 * mistake if the table has no such factor. */
static void find_maintenance(struct pp_resolver *r, struct pp_opening *opening)
{
    const struct pp_world *world = r->world;
    opening->maintenance_is_auto = true;
    opening->maintenance = pp_corrections_maintenance(world->dirt, world->surroundings,
                                                      world->work, opening->slope_rad);
    if (!isnan(opening->maintenance))
        return;
    opening->maintenance = 1.0;
    pp_mistakes_add(r->mistakes, opening->line,
                    "maintenance is \"auto\", but dirt \"bs-8206\" has no figures for "
                    "industrial surroundings or dirty work; expected a number, or "
                    "dirt=\"bre-309\" for the site");
}

/* True if an opening of the room has this name. */
static bool is_opening_name(const struct pp_room *room, const char *text)
{
    for (int i = 0; i < room->opening_count; i++)
        if (room->openings[i].name && strcmp(room->openings[i].name, text) == 0)
            return true;
    return false;
}

/* Sets the label of an opening: its name, or else W (in a wall) or RL (in any other
 * face) with a number. Numbers that would give the name of another opening are
 * skipped. */
static void label_opening(struct pp_opening *opening, const struct pp_world *world,
                          const struct pp_room *room)
{
    if (room->openings[opening->part].name) {
        pp_text_excerpt(opening->label, sizeof opening->label,
                        room->openings[opening->part].name);
        return;
    }
    const char *letters = world->surfaces[opening->face].role == PP_WALL ? "W" : "RL";
    int number = 1;
    for (int i = 0; i < world->opening_count; i++) {
        const struct pp_opening *other = &world->openings[i];
        if (!other->name && strncmp(other->label, letters, strlen(letters)) == 0)
            number = (int)strtol(other->label + strlen(letters), NULL, 10) + 1;
    }
    do
        snprintf(opening->label, sizeof opening->label, "%s%d", letters, number++);
    while (is_opening_name(room, opening->label));
}

static enum pp_status add_placed_opening(struct pp_resolver *r,
                                         const struct pp_opening_part *part,
                                         const struct pp_face_frame *frame,
                                         const double (*xy)[2], int count,
                                         struct pp_error *err)
{
    struct pp_world *world = r->world;
    struct pp_opening opening = {.face = (int)(frame->face - world->surfaces),
                                 .along = frame->along,
                                 .up = frame->up,
                                 .glass = part->glazing.glass,
                                 .frame_factor = part->glazing.frame_factor,
                                 .maintenance = part->glazing.maintenance,
                                 .curtains = part->glazing.curtains,
                                 .reveal_m = part->glazing.reveal_m,
                                 .facade = -1,
                                 .part = (int)(part - r->room->openings),
                                 .line = part->line};
    struct pp_vec3 normal = frame->face->outline.normal;
    opening.slope_rad = atan2(hypot(normal.x, normal.y), -normal.z);
    if (isnan(opening.maintenance))
        find_maintenance(r, &opening);
    enum pp_status status = pp_devices_put(r, &opening, part, err);
    if (status != PP_OK)
        return status;

    struct pp_vec3 *vertices = malloc(count * sizeof *vertices);
    if (!vertices) {
        pp_blind_release(opening.blind);
        return pp_fail_memory(err);
    }
    struct pp_bounds2 bounds = pp_bounds2_empty();
    double low_z = INFINITY, high_z = -INFINITY;
    for (int i = 0; i < count; i++) {
        vertices[i] = pp_face_frame_point(frame, xy[i][0], xy[i][1]);
        low_z = fmin(low_z, vertices[i].z);
        high_z = fmax(high_z, vertices[i].z);
        pp_bounds2_add(&bounds, xy[i][0], xy[i][1]);
    }
    opening.width_m = bounds.high[0] - bounds.low[0];
    opening.height_m = bounds.high[1] - bounds.low[1];
    opening.middle_z_m = 0.5 * (low_z + high_z);
    opening.rectangle = pp_region_ring_is_upright(xy, count, &bounds);

    status = pp_polygon_of(&opening.inner, vertices, count, err);
    if (status == PP_OK) {
        for (int i = 0; i < count; i++)
            vertices[i] = pp_vec_along(vertices[i], -opening.reveal_m, normal);
        status = pp_polygon_of(&opening.outer, vertices, count, err);
    }
    free(vertices);
    /* The opening gets exactly the normal of the face, without further rounding. */
    opening.inner.normal = opening.outer.normal = normal;
    opening.name = part->name ? strdup(part->name) : NULL;
    if (status == PP_OK && part->name && !opening.name)
        status = pp_fail_memory(err);
    if (status == PP_OK) {
        label_opening(&opening, world, r->room);
        opening.measured = pp_measured_pane_hold(part->glazing.measured);
        if (opening.measured)
            opening.scatter = &opening.measured->scatter;
        world->openings[world->opening_count++] = opening;
    } else {
        pp_polygon_clear(&opening.inner);
        pp_polygon_clear(&opening.outer);
        free(opening.name);
        pp_blind_release(opening.blind);
    }
    return status;
}

/* ---- overlaps with earlier openings ---- */

static enum pp_status check_overlaps(bool *free_of_others, struct pp_resolver *r,
                                     const struct pp_opening_part *part,
                                     const struct pp_face_frame *frame,
                                     const double (*xy)[2], int count,
                                     struct pp_error *err)
{
    const struct pp_world *world = r->world;
    int face = (int)(frame->face - world->surfaces);
    *free_of_others = true;
    for (int i = 0; i < world->opening_count; i++) {
        const struct pp_opening *other = &world->openings[i];
        if (other->face != face)
            continue;
        int other_count = other->inner.count;
        double(*other_xy)[2] = malloc(other_count * sizeof *other_xy);
        if (!other_xy)
            return pp_fail_memory(err);
        pp_polygon_flatten(other->inner.vertices, other_count, frame->origin,
                           frame->along, frame->up, other_xy);
        double area_m2 = 0.0;
        enum pp_status status = pp_face_frame_rings_overlap(
            r->clipper, xy, count, (const double(*)[2])other_xy, other_count, &area_m2,
            err);
        free(other_xy);
        if (status != PP_OK)
            return status;
        if (area_m2 > PP_ROUNDING_M * (other->width_m + other->height_m)) {
            *free_of_others = false;
            pp_mistakes_add(r->mistakes, part->line,
                            "%s: overlaps the opening on line %d by %.4g m2; expected "
                            "openings side by side",
                            pp_opening_outline_word(part), other->line, area_m2);
        }
    }
    return PP_OK;
}

/* ---- steps for one opening ---- */

static bool is_read(const struct pp_opening_part *part)
{
    if (!isfinite(part->glazing.frame_factor) || !isfinite(part->glazing.curtains)
        || !isfinite(part->glazing.reveal_m))
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
    pp_mistakes_add(r->mistakes, part->line,
                    "%s: is %g m by %g m; expected at least 1 mm in each direction",
                    pp_opening_outline_word(part), part->width_m, second);
    return false;
}

static enum pp_status place_in(struct pp_resolver *r,
                               const struct pp_opening_part *part,
                               const struct pp_face_frame *frame, struct pp_error *err)
{
    int count = part->kind == PP_OPENING ? part->vertices.count : 4;
    double tolerance = part->kind == PP_OPENING ? PP_SAME_M : PP_ROUNDING_M;
    double(*xy)[2] = malloc(count * sizeof *xy);
    if (!xy)
        return pp_fail_memory(err);
    bool good = pp_opening_outline(r, part, frame, xy);
    enum pp_status status = PP_OK;
    if (good)
        status = fit_in_face(&good, r, part, frame, xy, count, tolerance, err);
    if (status == PP_OK && good)
        status =
            check_overlaps(&good, r, part, frame, (const double(*)[2])xy, count, err);
    if (status == PP_OK && good)
        status = add_placed_opening(r, part, frame, (const double(*)[2])xy, count, err);
    free(xy);
    return status;
}

static enum pp_status place_opening(struct pp_resolver *r,
                                    const struct pp_opening_part *part,
                                    struct pp_error *err)
{
    if (!is_read(part) || !is_large_enough(r, part))
        return PP_OK;
    if (part->kind == PP_OPENING
        && !pp_build_outline_is_good(r, "opening", part->line, &part->vertices))
        return PP_OK;
    int face = pp_opening_outline_face(r, part);
    if (face < 0)
        return PP_OK;
    struct pp_face_frame frame;
    enum pp_status status = pp_face_frame_init(&frame, &r->world->surfaces[face], err);
    if (status == PP_OK)
        status = place_in(r, part, &frame, err);
    pp_face_frame_clear(&frame);
    return status;
}

enum pp_status pp_build_place_openings(struct pp_resolver *r, struct pp_error *err)
{
    const struct pp_room *room = r->room;
    struct pp_world *world = r->world;
    world->openings =
        calloc(room->opening_count ? room->opening_count : 1, sizeof *world->openings);
    if (!world->openings)
        return pp_fail_memory(err);
    for (int i = 0; i < room->opening_count; i++) {
        enum pp_status status = place_opening(r, &room->openings[i], err);
        if (status != PP_OK)
            return status;
    }
    return PP_OK;
}
