/* room_words.c - see room_words.h. Lengths of room and openings are given to the
 * centimetre, lengths outside to four digits, fractions to two or three digits. */
#include "charts/room/room_words.h"

#include <math.h>

#include "charts/sheet/page.h"
#include "model/base/text.h"
#include "model/geometry/bounds.h"

void pp_room_words_size(char *text, size_t room, const struct pp_world *world)
{
    struct pp_bounds2 extent = pp_bounds2_empty();
    for (int i = 0; i < world->face_count; i++) {
        const struct pp_polygon *outline = &world->surfaces[i].outline;
        for (int k = 0; k < outline->count; k++)
            pp_bounds2_add(&extent, outline->vertices[k].x, outline->vertices[k].y);
    }
    pp_page_say(text, room,
                "%.2f \u00d7 %.2f\u00a0m, %.2f\u00a0m high; floor %.1f\u00a0m\u00b2; "
                "working plane at %.2f\u00a0m.",
                extent.high[0] - extent.low[0], extent.high[1] - extent.low[1],
                world->height_m, pp_world_floor_m2(world), world->working_plane_m);
}

static void say_glass(char *text, size_t room, const struct pp_opening *opening)
{
    const struct pp_glass *glass = &opening->glass;
    if (glass->diffusing)
        pp_text_append(text, room, "; diffusing pane, transmittance %.2f",
                       glass->diffuse);
    else if (glass->panes == 0)
        pp_text_append(text, room, "; without glass");
    else
        pp_text_append(text, room, "; transmittance %.2f normal, %.2f diffuse",
                       glass->normal, glass->diffuse);
}

void pp_room_words_opening(char *text, size_t room, const struct pp_world *world,
                           int index)
{
    const struct pp_opening *opening = &world->openings[index];
    const char *wall = world->surfaces[opening->face].name;
    double sill = INFINITY;
    for (int i = 0; i < opening->inner.count; i++)
        sill = fmin(sill, opening->inner.vertices[i].z);
    pp_page_say(text, room,
                "%s%.40s%s%.2f \u00d7 %.2f\u00a0m, lower edge at %.2f\u00a0m",
                wall ? "in wall " : "", wall ? wall : "", wall ? ", " : "",
                opening->width_m, opening->height_m, sill);
    if (opening->reveal_m > 0.0)
        pp_text_append(text, room, ", reveal %.2f\u00a0m", opening->reveal_m);
    say_glass(text, room, opening);
    pp_text_append(text, room, "; frame %.3g, dirt %.3g", opening->frame_factor,
                   opening->maintenance);
    pp_window_device_say(&opening->device, text, room, "\u00b0");
    pp_text_append(text, room, ".");
}

void pp_room_words_outside(char *text, size_t room, const struct pp_world *world)
{
    enum { TOLD = 6 };
    for (int i = 0; i < world->skyline_count; i++) {
        const struct pp_skyline *skyline = &world->skylines[i];
        const char *wall = world->surfaces[skyline->face].name;
        pp_page_say(text, room, "Endless skyline in front of wall %s: %.4g\u00b0",
                    wall ? wall : "", skyline->angle_rad / PP_RAD);
        if (isfinite(skyline->distance_m))
            pp_page_say(text, room,
                        "above the centre of its windows, %.4g\u00a0m away,",
                        skyline->distance_m);
        pp_page_say(text, room, "reflectance %.3g.", skyline->reflectance);
    }
    for (int i = 0; i < world->block_count && i < TOLD; i++) {
        const struct pp_block *block = &world->blocks[i];
        pp_page_say(text, room,
                    "Block %.4g by %.4g\u00a0m, %.4g\u00a0m high, from x\u00a0%.4g, "
                    "y\u00a0%.4g, z\u00a0%.4g, reflectance %.3g",
                    block->width_m, block->depth_m, block->height_m, block->corner.x,
                    block->corner.y, block->corner.z, block->reflectance);
        if (block->rotate_rad != 0.0)
            pp_text_append(text, room, ", rotated by %.4g\u00b0",
                           block->rotate_rad / PP_RAD);
        pp_text_append(text, room, ".");
    }
    if (world->block_count > TOLD)
        pp_page_say(text, room, "%d more blocks are not listed.",
                    world->block_count - TOLD);
    for (int i = 0; i < world->tree_count && i < TOLD; i++) {
        const struct pp_tree *tree = &world->trees[i];
        pp_page_say(text, room,
                    "Tree at x\u00a0%.4g, y\u00a0%.4g, %.4g\u00a0m high, crown from "
                    "%.4g\u00a0m, %.4g\u00a0m wide, transmittance %.3g",
                    tree->foot.x, tree->foot.y, tree->height_m, tree->crown_base_m,
                    tree->crown_width_m, tree->transmittance);
        if (tree->winter_transmittance != tree->transmittance)
            pp_page_say(text, room, "(%.3g without leaves)",
                        tree->winter_transmittance);
        pp_text_append(text, room, ".");
    }
    if (world->tree_count > TOLD)
        pp_page_say(text, room, "%d more trees are not listed.",
                    world->tree_count - TOLD);
}
