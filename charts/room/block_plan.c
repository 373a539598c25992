/* block_plan.c - see block_plan.h. */
#include "charts/room/block_plan.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "charts/sheet/canvas.h"
#include "charts/sheet/labels.h"
#include "model/base/text.h"

/* Blocks are drawn up to this distance (m) from the room. */
static const double farthest_m = 100.0;

/* Corners of a block's base in the plan. */
static void base_of(const struct pp_block *block, double xy[4][2])
{
    static const int way[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    for (int i = 0; i < 4; i++) {
        xy[i][0] =
            block->corner.x + way[i][0] * block->along.x + way[i][1] * block->across.x;
        xy[i][1] =
            block->corner.y + way[i][0] * block->along.y + way[i][1] * block->across.y;
    }
}

/* Frame of the plan of the room and the blocks, fitted into the box above the
 * caption. */
static struct pp_room_plan frame_of_blocks(const struct pp_style *style,
                                           const struct pp_world *world,
                                           struct pp_box box)
{
    struct pp_room_plan frame = {.world = world};
    pp_room_plan_fit(&frame, world, style, box.width, box.height);
    struct pp_bounds2 room = frame.extent;
    for (int i = 0; i < world->block_count; i++) {
        double xy[4][2];
        base_of(&world->blocks[i], xy);
        for (int k = 0; k < 4; k++)
            pp_bounds2_add(&frame.extent,
                           fmin(fmax(xy[k][0], room.low[0] - farthest_m),
                                room.high[0] + farthest_m),
                           fmin(fmax(xy[k][1], room.low[1] - farthest_m),
                                room.high[1] + farthest_m));
    }
    double border = 3.0 * style->scale, size[2];
    for (int k = 0; k < 2; k++)
        size[k] = frame.extent.high[k] - frame.extent.low[k];
    frame.scale = pp_room_plan_usual_scale(
        1000.0
        * fmax(size[0] / fmax(box.width - 2.0 * border, 5.0),
               size[1] / fmax(box.height - 2.0 * border, 5.0)));
    frame.mm_per_m = 1000.0 / frame.scale;
    frame.x = box.x + 0.5 * (box.width - size[0] * frame.mm_per_m);
    frame.y = box.y + border + size[1] * frame.mm_per_m;
    return frame;
}

/* Writes name, coordinates and height of a block at its middle, or at a free place
 * nearby. */
static void say_block(cairo_t *cr, const struct pp_style *style,
                      const struct pp_room_plan *frame, const struct pp_block *block,
                      struct pp_labels *labels)
{
    char words[192] = "";
    double xy[4][2], x = 0.0, y = 0.0;
    base_of(block, xy);
    for (int k = 0; k < 4; k++) {
        x += 0.25 * pp_plan_frame_x(frame, xy[k][0]);
        y += 0.25 * pp_plan_frame_y(frame, xy[k][1]);
    }
    if (block->name)
        pp_text_append(words, sizeof words, "%.30s\n", block->name);
    if (block->rotate_rad == 0.0)
        pp_text_append(words, sizeof words, "x %.4g to %.4g, y %.4g to %.4g\n",
                       block->corner.x, block->corner.x + block->width_m,
                       block->corner.y, block->corner.y + block->depth_m);
    else
        pp_text_append(words, sizeof words,
                       "%.4g \u00d7 %.4g\u00a0m, turned %.4g\u00b0\n", block->width_m,
                       block->depth_m, block->rotate_rad / PP_RAD);
    double eaves = block->corner.z + block->height_m, ridge = eaves;
    /* A block with a roof has further surfaces with the block's name. */
    for (int i = 0; i < frame->world->surface_count && block->name; i++) {
        const struct pp_surface *roof = &frame->world->surfaces[i];
        if (roof->name && strcmp(roof->name, block->name) == 0)
            for (int k = 0; k < roof->outline.count; k++)
                ridge = fmax(ridge, roof->outline.vertices[k].z);
    }
    if (ridge > eaves + 0.005)
        pp_text_append(words, sizeof words,
                       "eaves %.4g, ridge %.4g\u00a0m above the floor", eaves, ridge);
    else
        pp_text_append(words, sizeof words, "top %.4g\u00a0m above the floor", eaves);
    const struct pp_lettering set = {.size = PP_TEXT_SMALL};
    struct pp_box size = pp_lettering_measure(cr, style, &set, 0.0, 0.0, words);
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    for (int k = 0; k < 4; k++) {
        low[0] = fmin(low[0], pp_plan_frame_x(frame, xy[k][0]));
        low[1] = fmin(low[1], pp_plan_frame_y(frame, xy[k][1]));
        high[0] = fmax(high[0], pp_plan_frame_x(frame, xy[k][0]));
        high[1] = fmax(high[1], pp_plan_frame_y(frame, xy[k][1]));
    }
    bool inside = size.width < high[0] - low[0] && size.height < high[1] - low[1];
    double gap = 1.0 * style->scale;
    const double places[5][2] = {{x - 0.5 * size.width, y - 0.5 * size.height},
                                 {high[0] + gap, y - 0.5 * size.height},
                                 {low[0] - gap - size.width, y - 0.5 * size.height},
                                 {x - 0.5 * size.width, high[1] + gap},
                                 {x - 0.5 * size.width, low[1] - gap - size.height}};
    for (int i = inside ? 0 : 1; i < 5; i++) {
        struct pp_box at = {places[i][0], places[i][1], size.width, size.height};
        if (!pp_labels_is_free(labels, at))
            continue;
        pp_lettering_draw_on_white(cr, style, &set, at.x, at.y, words);
        pp_labels_note_box(labels, at);
        return;
    }
}

void pp_block_plan_axes(cairo_t *cr, const struct pp_style *style,
                        const struct pp_room_plan *plan)
{
    double at[2] = {0.0, 0.0}, length = 7.0 * style->scale;
    bool outside = false;
    for (int k = 0; k < 2; k++)
        outside |= plan->extent.low[k] > 0.0 || plan->extent.high[k] < 0.0;
    for (int k = 0; k < 2 && outside; k++)
        at[k] = plan->extent.low[k];
    double x = pp_plan_frame_x(plan, at[0]), y = pp_plan_frame_y(plan, at[1]);
    const double from[2] = {x, y}, ends[2][2] = {{x + length, y}, {x, y - length}};
    for (int k = 0; k < 2; k++)
        pp_style_arrow(cr, style, from, ends[k], 1.2 * style->scale,
                       0.48 * style->scale);
    const struct pp_lettering set = {
        .size = PP_TEXT_SMALL, .italic = true, .across = 0.5, .down = 0.5};
    double off = 1.6 * style->scale;
    char words[48];
    snprintf(words, sizeof words, outside ? "(%.4g, %.4g)" : "0", at[0], at[1]);
    pp_lettering_draw(cr, style, &set, x + length + off, y - off, "x");
    pp_lettering_draw(cr, style, &set, x + off, y - length, "y");
    const struct pp_lettering origin = {.size = PP_TEXT_SMALL, .italic = true};
    pp_lettering_draw(cr, style, &origin, x + 0.4 * off, y - 1.9 * off, words);
}

void pp_block_plan_draw(cairo_t *cr, const struct pp_style *style,
                        const struct pp_world *world, struct pp_box box)
{
    double caption = 1.8 * style->text[PP_TEXT_SMALL];
    struct pp_box drawing = {box.x, box.y, box.width, box.height - caption};
    struct pp_room_plan frame = frame_of_blocks(style, world, drawing);
    struct pp_labels *labels = calloc(1, sizeof *labels);
    if (!labels) {
        pp_canvas_lacks_memory(cr);
        return;
    }
    labels->field = drawing;
    cairo_save(cr);
    cairo_new_path(cr);
    cairo_rectangle(cr, drawing.x, drawing.y, drawing.width, drawing.height);
    cairo_clip(cr);
    for (int i = 0; i < world->block_count; i++) {
        double xy[4][2];
        base_of(&world->blocks[i], xy);
        for (int k = 0; k < 4; k++)
            cairo_line_to(cr, pp_plan_frame_x(&frame, xy[k][0]),
                          pp_plan_frame_y(&frame, xy[k][1]));
        cairo_close_path(cr);
        pp_style_grey(cr, PP_GREY_FILL);
        cairo_fill_preserve(cr);
        pp_style_line(cr, style->thin, PP_INK);
        cairo_stroke(cr);
    }
    pp_room_plan_path(cr, &frame);
    pp_labels_note_path(labels, cr, -1);
    pp_style_line(cr, style->medium, PP_INK);
    cairo_stroke(cr);
    cairo_restore(cr);
    pp_block_plan_axes(cr, style, &frame);
    for (int i = 0; i < world->block_count; i++)
        say_block(cr, style, &frame, &world->blocks[i], labels);
    free(labels);
    char words[64];
    snprintf(words, sizeof words, "External blocks, 1:%g; lengths in metres",
             frame.scale);
    const struct pp_lettering set = {
        .size = PP_TEXT_SMALL, .grey = PP_GREY_TEXT, .across = 0.5, .down = 1.0};
    pp_lettering_draw(cr, style, &set, box.x + 0.5 * box.width, box.y + box.height,
                      words);
}
