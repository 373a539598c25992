/* site_shape.c - see site_shape.h. */
#include "charts/site/site_shape.h"

#include "charts/sheet/hatch.h"

static void trace_shape(cairo_t *cr, const struct pp_room_plan *frame,
                        const struct pp_site_shape *shape)
{
    for (int i = 0, ring = 0; i < shape->count; i++) {
        cairo_line_to(cr, pp_plan_frame_x(frame, shape->corners[i].x),
                      pp_plan_frame_y(frame, shape->corners[i].y));
        if (shape->ends && i + 1 == shape->ends[ring]) {
            cairo_close_path(cr);
            cairo_new_sub_path(cr);
            ring++;
        }
    }
    if (!shape->ends)
        cairo_close_path(cr);
}

/* Traces the edges of a part of a mesh that are drawn as lines; if `unseen` is set, the
 * other edges. */
static void trace_edges(cairo_t *cr, const struct pp_room_plan *frame,
                        const struct pp_site_shape *shape, bool unseen)
{
    cairo_new_path(cr);
    for (int ring = 0, from = 0; ring < shape->ring_count; ring++) {
        int end = shape->ends[ring];
        for (int i = from; i < end; i++) {
            const struct pp_vec3 *a = &shape->corners[i];
            const struct pp_vec3 *b = &shape->corners[i + 1 < end ? i + 1 : from];
            if (shape->unseen[i] != unseen)
                continue;
            if (i == from || shape->unseen[i - 1] != unseen)
                cairo_move_to(cr, pp_plan_frame_x(frame, a->x),
                              pp_plan_frame_y(frame, a->y));
            cairo_line_to(cr, pp_plan_frame_x(frame, b->x),
                          pp_plan_frame_y(frame, b->y));
        }
        from = end;
    }
}

/* Draws the boundary of the drawing where it cuts the shape, so that the outline of the
 * shape is closed. */
static void close_at_edge(cairo_t *cr, const struct pp_style *style,
                          const struct pp_room_plan *frame, struct pp_box within,
                          const struct pp_site_shape *shape)
{
    if (!shape->is_level)
        return;
    cairo_save(cr);
    cairo_new_path(cr);
    trace_shape(cr, frame, shape);
    cairo_clip(cr);
    cairo_rectangle(cr, within.x, within.y, within.width, within.height);
    pp_style_line(cr, 1.5 * style->hair, PP_GREY_TEXT);
    cairo_stroke(cr);
    cairo_restore(cr);
}

void pp_site_shape_draw(cairo_t *cr, const struct pp_style *style,
                        const struct pp_room_plan *frame, struct pp_box within,
                        const struct pp_site_shape *shape)
{
    static const double gone_dashes[] = {1.4, 0.8};
    double dashes[2] = {gone_dashes[0] * style->scale, gone_dashes[1] * style->scale};
    cairo_new_path(cr);
    trace_shape(cr, frame, shape);
    if (shape->is_level && shape->when != PP_SITE_GONE) {
        pp_style_grey(cr, shape->is_room ? 1.0 : PP_GREY_FILL);
        cairo_fill_preserve(cr);
        if (shape->when == PP_SITE_NEW) {
            cairo_path_t *path = cairo_copy_path(cr);
            pp_hatch_path(cr, within, 1.4 * style->scale, style->hair, PP_GREY_TEXT);
            cairo_append_path(cr, path);
            cairo_path_destroy(path);
        }
    }
    if (shape->unseen && shape->is_level && shape->when == PP_SITE_ALWAYS) {
        /* Covers the white gaps between adjoining parts along common edges, which are
         * not drawn as lines. */
        trace_edges(cr, frame, shape, true);
        pp_style_line(cr, style->thin, PP_GREY_FILL);
        cairo_stroke(cr);
    }
    if (shape->unseen)
        trace_edges(cr, frame, shape, false);
    pp_style_line(cr,
                  shape->is_room                  ? style->medium
                  : shape->when == PP_SITE_ALWAYS ? style->hair
                                                  : style->thin,
                  shape->is_room ? PP_INK : PP_GREY_TEXT);
    if (shape->when == PP_SITE_GONE)
        cairo_set_dash(cr, dashes, 2, 0.0);
    cairo_stroke(cr);
    cairo_set_dash(cr, NULL, 0, 0.0);
    close_at_edge(cr, style, frame, within, shape);
}
