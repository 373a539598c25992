/* site_crowns.c - see site_crowns.h. */
#include "charts/site/site_crowns.h"

#include <math.h>

#include "charts/sheet/page.h"

/* Hatches a box within the clip by vertical lines. Their distance is 1 mm for an opaque
 * crown. */
static void hatch_crown(cairo_t *cr, const struct pp_style *style, struct pp_box box,
                        double transmittance)
{
    double step = style->scale / fmax(1.0 - transmittance, 0.05);
    pp_style_line(cr, style->hair, PP_GREY_LINE);
    for (double x = box.x + 0.5 * step; x < box.x + box.width; x += step) {
        cairo_move_to(cr, x, box.y);
        cairo_line_to(cr, x, box.y + box.height);
    }
    cairo_stroke(cr);
}

/* Draws the crown whose outline is the current path, and clears the path. */
static void draw_crown(cairo_t *cr, const struct pp_style *style, struct pp_box box,
                       const struct pp_site_tree *tree)
{
    const double dashes[] = {1.4 * style->scale, 0.8 * style->scale};
    bool is_gone = tree->when == PP_SITE_GONE;
    cairo_path_t *outline = cairo_copy_path(cr);
    cairo_save(cr);
    cairo_clip(cr);
    struct pp_box left = box, right = box;
    left.width = right.width = 0.5 * box.width;
    right.x += left.width;
    if (!is_gone) {
        hatch_crown(cr, style, left, tree->transmittance);
        hatch_crown(cr, style, right, tree->winter_transmittance);
    }
    cairo_restore(cr);
    cairo_append_path(cr, outline);
    cairo_path_destroy(outline);
    pp_style_line(cr, tree->when == PP_SITE_NEW ? style->medium : style->thin,
                  PP_GREY_TEXT);
    if (is_gone)
        cairo_set_dash(cr, dashes, 2, 0.0);
    cairo_stroke(cr);
    cairo_set_dash(cr, NULL, 0, 0.0);
}

void pp_site_crowns_draw_plan(cairo_t *cr, const struct pp_style *style,
                              const struct pp_room_plan *frame,
                              const struct pp_site_tree *tree)
{
    double x = pp_plan_frame_x(frame, tree->foot.x),
           y = pp_plan_frame_y(frame, tree->foot.y),
           radius = 0.5 * tree->crown_width_m * frame->mm_per_m;
    cairo_new_path(cr);
    cairo_arc(cr, x, y, radius, 0.0, 2.0 * PP_PI);
    cairo_close_path(cr);
    draw_crown(cr, style,
               (struct pp_box){x - radius, y - radius, 2.0 * radius, 2.0 * radius},
               tree);
    cairo_arc(cr, x, y, 0.5 * style->scale, 0.0, 2.0 * PP_PI);
    pp_style_grey(cr, PP_GREY_TEXT);
    cairo_fill(cr);
}

void pp_site_crowns_draw_front(cairo_t *cr, const struct pp_style *style,
                               const struct pp_room_plan *frame,
                               const struct pp_site_elevation *elevation,
                               const struct pp_site_sheet *site)
{
    struct pp_box field = {pp_plan_frame_x(frame, elevation->low[0]),
                           pp_plan_frame_y(frame, elevation->high[1]),
                           (elevation->high[0] - elevation->low[0]) * frame->mm_per_m,
                           (elevation->high[1] - elevation->low[1]) * frame->mm_per_m};
    cairo_save(cr);
    cairo_new_path(cr);
    cairo_rectangle(cr, field.x, field.y, field.width, field.height);
    cairo_clip(cr);
    for (int i = 0; i < elevation->crown_count; i++) {
        const struct pp_bounds2 *crown = &elevation->crowns[i];
        const struct pp_site_tree *tree = &site->trees[elevation->crown_trees[i]];
        struct pp_box box = {pp_plan_frame_x(frame, crown->low[0]),
                             pp_plan_frame_y(frame, crown->high[1]),
                             tree->crown_width_m * frame->mm_per_m,
                             (crown->high[1] - crown->low[1]) * frame->mm_per_m};
        cairo_rectangle(cr, box.x, box.y, box.width, box.height);
        draw_crown(cr, style, box, tree);
        double middle = box.x + 0.5 * box.width;
        cairo_move_to(cr, middle, box.y + box.height);
        cairo_line_to(cr, middle, pp_plan_frame_y(frame, tree->foot.z));
        pp_style_line(cr, style->thin, PP_GREY_TEXT);
        cairo_stroke(cr);
        /* Trees farther back are not drawn over this crown. */
        cairo_rectangle(cr, field.x, field.y, field.width, field.height);
        cairo_rectangle(cr, box.x, box.y, box.width, box.height);
        cairo_set_fill_rule(cr, CAIRO_FILL_RULE_EVEN_ODD);
        cairo_clip(cr);
        cairo_set_fill_rule(cr, CAIRO_FILL_RULE_WINDING);
    }
    cairo_restore(cr);
}

void pp_site_crowns_say(char *text, size_t room, bool has_former)
{
    pp_page_say(text, room,
                "Crowns of trees are hatched, more closely the less light they "
                "transmit: the left half with leaves, the right half without%s. The "
                "vertical sky component leaves trees out.",
                has_former ? "; those of former trees are dashed outlines" : "");
}
