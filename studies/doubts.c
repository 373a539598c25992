/* doubts.c - see doubts.h. */
#include "studies/doubts.h"

#include <math.h>

#include "model/geometry/bounds.h"
#include "model/light/rough/rough_finishes.h"
#include "studies/criteria/capitals.h"

/* Angular distances from the capital of a country. A position is doubted if it is more
 * than far_rad away and, with latitude and longitude swapped, less than near_rad away.
 * La Reunion is far from Paris, and 16 degrees away when swapped; it must not be
 * doubted. */
static const double far_rad = 40.0 * PP_RAD, near_rad = 12.0 * PP_RAD;

/* Extent of the envelope in x, y and z. */
static struct pp_vec3 extent_of(const struct pp_world *world)
{
    struct pp_bounds3 bounds = pp_bounds3_empty();
    for (int i = 0; i < world->face_count; i++)
        for (int k = 0; k < world->surfaces[i].outline.count; k++)
            pp_bounds3_add(&bounds, world->surfaces[i].outline.vertices[k]);
    return pp_vec_sub(bounds.high, bounds.low);
}

static void doubt_size(struct pp_mistakes *doubts, const struct pp_world *world)
{
    struct pp_vec3 extent = extent_of(world);
    double widest = fmax(extent.x, extent.y),
           narrowest = fmin(fmin(extent.x, extent.y), extent.z);
    if (widest > PP_DOUBTS_ROOM_MOST_M)
        pp_mistakes_add(doubts, world->surfaces[0].line,
                        "the room is %.6g m wide; is units=\"mm\" missing?", widest);
    else if (extent.z > PP_DOUBTS_ROOM_HEIGHT_MOST_M)
        pp_mistakes_add(doubts, world->surfaces[0].line,
                        "the room is %.6g m high; is units=\"mm\" missing?", extent.z);
    else if (narrowest < PP_DOUBTS_ROOM_LEAST_M)
        pp_mistakes_add(doubts, world->surfaces[0].line,
                        "the room measures only %.3g m; are its lengths in metres?",
                        narrowest);
}

static void doubt_openings(struct pp_mistakes *doubts, const struct pp_world *world,
                           bool alone)
{
    if (alone && world->opening_count == 0)
        pp_mistakes_add(doubts, 0, "%s%s%s has no window; no daylight enters",
                        world->name ? "room \"" : "the room",
                        world->name ? world->name : "", world->name ? "\"" : "");
    for (int i = 0; i < world->opening_count; i++) {
        const struct pp_opening *opening = &world->openings[i];
        if (world->within && !opening->is_nested)
            pp_mistakes_add(doubts, opening->line,
                            "%s has no counterpart in the coarse model; its light "
                            "comes from outside without passing that model",
                            opening->label);
        if (opening->frame_factor < PP_DOUBTS_FACTOR_LEAST)
            pp_mistakes_add(
                doubts, opening->line,
                "%s: frame-factor is the share of the opening that is glass; %.3g "
                "looks like the share of the frame (frame-factor would be %.3g)",
                opening->label, opening->frame_factor, 1.0 - opening->frame_factor);
        if (!opening->maintenance_is_auto
            && opening->maintenance < PP_DOUBTS_FACTOR_LEAST)
            pp_mistakes_add(
                doubts, opening->line,
                "%s: maintenance is the share of light that passes through the dirt; "
                "%.3g looks like the loss (maintenance would be %.3g)",
                opening->label, opening->maintenance, 1.0 - opening->maintenance);
    }
}

static void doubt_panes(struct pp_mistakes *doubts, const struct pp_world *world)
{
    for (int i = 0; i < world->opening_count; i++) {
        const struct pp_measured_pane *pane = world->openings[i].measured;
        for (int k = 0; pane && k < pane->warning_count; k++)
            pp_mistakes_add(doubts, world->openings[i].line, "%s: \"%.100s\": %s",
                            world->openings[i].label, pane->file ? pane->file : "",
                            pane->warnings[k]);
    }
}

static void doubt_materials(struct pp_mistakes *doubts, const struct pp_world *world)
{
    for (int i = 0; i < pp_rough_finishes_count(world->materials); i++) {
        const struct pp_rough_finish *material =
            pp_rough_finishes_at(world->materials, i);
        if (material->surface.lost > PP_DOUBTS_LOST_MOST)
            pp_mistakes_add(
                doubts, material->line,
                "material \"%s\": roughness divided by correlation-length is "
                "too large for the model, which loses %.0f %% of the light",
                material->finish.name, 100.0 * material->surface.lost);
    }
}

static void doubt_site(struct pp_mistakes *doubts, const struct pp_world *world)
{
    const struct pp_capital *capital =
        world->country[0] ? pp_capitals_of_country(world->country) : NULL;
    if (!capital || isnan(world->latitude_rad) || isnan(world->longitude_rad))
        return;
    if (pp_capitals_apart_rad(capital, world->latitude_rad, world->longitude_rad)
            > far_rad
        && pp_capitals_apart_rad(capital, world->longitude_rad, world->latitude_rad)
               < near_rad)
        pp_mistakes_add(doubts, 0,
                        "latitude %.6g and longitude %.6g are far from %s; are they "
                        "swapped?",
                        world->latitude_rad / PP_RAD, world->longitude_rad / PP_RAD,
                        world->country);
}

/* True if any corner of these surfaces is outside, in front of the plane of the
 * opening. */
static bool is_before(const struct pp_world *world, const struct pp_opening *opening,
                      int first, int count)
{
    const struct pp_vec3 inwards = opening->outer.normal;
    for (int i = first; i < first + count; i++) {
        const struct pp_polygon *side = &world->surfaces[i].outline;
        for (int k = 0; k < side->count; k++)
            if (pp_vec_dot(pp_vec_sub(side->vertices[k], opening->outer.vertices[0]),
                           inwards)
                < -1e-6)
                return true;
    }
    return false;
}

static bool faces_an_opening(const struct pp_world *world, const struct pp_block *block)
{
    for (int i = 0; i < world->opening_count; i++)
        if (is_before(world, &world->openings[i], block->first_side, block->side_count))
            return true;
    return false;
}

/* False if the whole block lies more than 0.5 m outside the plane of a face of the
 * room. Otherwise the block may be the room's own building. */
static bool touches_room(const struct pp_world *world, const struct pp_block *block)
{
    for (int i = 0; i < world->face_count; i++) {
        const struct pp_surface *face = &world->surfaces[i];
        bool apart = true;
        for (int s = block->first_side; s < block->first_side + block->side_count; s++)
            for (int k = 0; k < world->surfaces[s].outline.count; k++)
                apart &= pp_vec_dot(pp_vec_sub(world->surfaces[s].outline.vertices[k],
                                               face->outline.vertices[0]),
                                    face->outline.normal)
                         < -PP_DOUBTS_ROOM_LEAST_M;
        if (apart)
            return false;
    }
    return true;
}

static void doubt_outside(struct pp_mistakes *doubts, const struct pp_world *world,
                          bool alone)
{
    for (int i = 0; i < world->block_count; i++) {
        const struct pp_block *block = &world->blocks[i];
        const char *name = block->name ? block->name : "";
        if (block->height_m > PP_DOUBTS_OUTSIDE_HEIGHT_MOST_M)
            pp_mistakes_add(doubts, block->line,
                            "the block \"%s\" is %.6g m high; is units=\"mm\" missing?",
                            name, block->height_m);
        if (alone && world->opening_count > 0 && world->garden_count == 0
            && !faces_an_opening(world, block) && !touches_room(world, block))
            pp_mistakes_add(
                doubts, block->line,
                "no part of the block \"%s\" is in front of a window, so it hides "
                "no sky",
                name);
    }
    for (int i = 0; i < world->mesh_count; i++) {
        double height_m =
            world->meshes[i].bounds.high.z - world->meshes[i].bounds.low.z;
        if (height_m > PP_DOUBTS_OUTSIDE_HEIGHT_MOST_M)
            pp_mistakes_add(doubts, world->meshes[i].line,
                            "the mesh is %.6g m high; is its scale missing?", height_m);
    }
}

static void doubt_skylines(struct pp_mistakes *doubts, const struct pp_world *world)
{
    for (int i = 0; i < world->skyline_count; i++) {
        const struct pp_skyline *skyline = &world->skylines[i];
        bool has_opening = false;
        for (int k = 0; k < world->opening_count; k++)
            has_opening |= world->openings[k].face == skyline->face;
        if (!has_opening && isinf(skyline->distance_m) && world->opening_count > 0)
            pp_mistakes_add(
                doubts, skyline->line,
                "the skyline is in front of the wall \"%s\", which has no window",
                world->surfaces[skyline->face].name);
    }
}

void pp_doubts_find(struct pp_mistakes *doubts, const struct pp_world *world,
                    bool alone)
{
    doubt_size(doubts, world);
    doubt_openings(doubts, world, alone);
    doubt_panes(doubts, world);
    doubt_materials(doubts, world);
    doubt_site(doubts, world);
    doubt_outside(doubts, world, alone);
    if (alone)
        doubt_skylines(doubts, world);
    pp_mistakes_sort(doubts);
}
