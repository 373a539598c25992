/* net_chart.c - draws the pieces of a net: solid lines to be cut, dashed lines to be
 * folded. */
#include "charts/net/net_chart.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "charts/drawing_board/board.h"
#include "charts/net/net_unfold.h"
#include "charts/sheet/labels.h"
#include "charts/sheet/page.h"
#include "model/base/text.h"

struct net_drawing {
    struct pp_canvas *canvas;
    cairo_t *cr;
    struct pp_style style;
    const struct pp_model_net *model;
    struct pp_net net;
    struct pp_box area; /* area of the sheet that is free for pieces */
    struct pp_labels *labels;
};

/* ---- panels ---- */

/* Converts a position on a piece to a position on paper. */
static void on_paper(const struct net_drawing *drawing,
                     const struct pp_net_panel *panel, const double xy[2],
                     double paper[2])
{
    const struct pp_net_piece *piece = &drawing->net.pieces[panel->piece];
    paper[0] = drawing->area.x + piece->place[0] + xy[0] - piece->extent.low[0];
    paper[1] = drawing->area.y + drawing->area.height - piece->place[1]
               - (xy[1] - piece->extent.low[1]);
}

static void go_to(const struct net_drawing *drawing, const struct pp_net_panel *panel,
                  const double xy[2])
{
    double paper[2];
    on_paper(drawing, panel, xy, paper);
    cairo_line_to(drawing->cr, paper[0], paper[1]);
}

static void trace_panel(const struct net_drawing *drawing,
                        const struct pp_net_panel *panel)
{
    cairo_new_path(drawing->cr);
    for (int i = 0; i < panel->count; i++) {
        double xy[2];
        pp_net_panels_corner(panel, i, xy);
        go_to(drawing, panel, xy);
    }
    cairo_close_path(drawing->cr);
}

/* True if the surface is a door or a dado in the panel's face. */
static bool covers(const struct pp_surface *surface, const struct pp_net_panel *panel)
{
    return surface->role == PP_COVER && surface->owner == panel->face;
}

/* Draws an edge that is cut or folded. A fold is drawn once, by the first of its two
 * panels. */
static void draw_edge(const struct net_drawing *drawing,
                      const struct pp_net_panel *panel, int edge, bool first)
{
    cairo_t *cr = drawing->cr;
    const struct pp_style *style = &drawing->style;
    const double dashes[] = {2.2 * style->scale, 1.1 * style->scale};
    enum pp_net_join join = panel->edges[edge].join;
    bool folded = join == PP_NET_FOLD || join == PP_NET_TAB;
    double tab[PP_NET_TAB_CORNERS][2], a[2], b[2];
    if (join == PP_NET_TAB) {
        pp_net_unfold_tab(panel, edge, tab);
        cairo_new_path(cr);
        for (int i = 0; i < PP_NET_TAB_CORNERS; i++)
            go_to(drawing, panel, tab[i]);
        pp_labels_note_path(drawing->labels, cr, -1);
        pp_style_line(cr, style->thin, PP_INK);
        cairo_stroke(cr);
    }
    if (join == PP_NET_FOLD && !first)
        return;
    cairo_new_path(cr);
    pp_net_panels_corner(panel, edge, a);
    pp_net_panels_corner(panel, edge + 1, b);
    go_to(drawing, panel, a);
    go_to(drawing, panel, b);
    pp_labels_note_path(drawing->labels, cr, -1);
    pp_style_line(cr, folded ? style->thin : style->medium, PP_INK);
    cairo_set_dash(cr, dashes, folded ? 2 : 0, 0.0);
    cairo_stroke(cr);
}

/* Traces an opening in a panel's face, and marks its area as occupied for labels. */
static void trace_opening(const struct net_drawing *drawing,
                          const struct pp_net_panel *panel,
                          const struct pp_polygon *outline)
{
    cairo_t *cr = drawing->cr;
    cairo_new_path(cr);
    /* Returns to the first corner, so that labels also avoid the last side. */
    for (int k = 0; k <= outline->count; k++) {
        double xy[2], paper[2], before[2];
        pp_net_panels_point(&drawing->net.panels, panel,
                            outline->vertices[k % outline->count], xy);
        on_paper(drawing, panel, xy, paper);
        cairo_get_current_point(cr, &before[0], &before[1]);
        if (k > 0)
            pp_labels_note(drawing->labels, -1, before[0], before[1], paper[0],
                           paper[1]);
        cairo_line_to(cr, paper[0], paper[1]);
    }
    cairo_close_path(cr);
}

/* Draws the outline of a door or a dado, except where it coincides with an edge of the
 * panel. */
static void draw_cover(const struct net_drawing *drawing,
                       const struct pp_net_panel *panel,
                       const struct pp_polygon *outline)
{
    const double same_mm = 0.1;
    const double dots[] = {0.3 * drawing->style.scale, 0.9 * drawing->style.scale};
    cairo_t *cr = drawing->cr;
    cairo_new_path(cr);
    for (int i = 0; i < outline->count; i++) {
        double own[2][2], xy[2], paper[2][2];
        for (int k = 0; k < 2; k++) {
            pp_net_panels_own(&drawing->net.panels, panel,
                              outline->vertices[(i + k) % outline->count], own[k]);
            pp_net_panels_place(panel, own[k], xy);
            on_paper(drawing, panel, xy, paper[k]);
        }
        if (pp_polygon_ring_edge_distance((const double(*)[2])panel->own, panel->count,
                                          0.5 * (own[0][0] + own[1][0]),
                                          0.5 * (own[0][1] + own[1][1]), NULL)
            < same_mm)
            continue;
        pp_labels_note(drawing->labels, -1, paper[0][0], paper[0][1], paper[1][0],
                       paper[1][1]);
        cairo_move_to(cr, paper[0][0], paper[0][1]);
        cairo_line_to(cr, paper[1][0], paper[1][1]);
    }
    pp_style_line(cr, drawing->style.thin, PP_INK);
    cairo_set_dash(cr, dots, 2, 0.0);
    cairo_stroke(cr);
}

/* Draws painted doors and dados, and the openings to be cut out. If the panel is only a
 * part of a face, they are clipped to that part. */
static void draw_in_face(const struct net_drawing *drawing,
                         const struct pp_net_panel *panel)
{
    const struct pp_world *world = drawing->model->world;
    cairo_t *cr = drawing->cr;
    cairo_save(cr);
    if (panel->parts > 1) {
        trace_panel(drawing, panel);
        cairo_clip(cr);
    }
    for (int i = world->face_count; i < world->surface_count; i++)
        if (covers(&world->surfaces[i], panel))
            draw_cover(drawing, panel, &world->surfaces[i].outline);
    for (int i = 0; i < world->opening_count; i++) {
        if (world->openings[i].face != panel->face)
            continue;
        trace_opening(drawing, panel, &world->openings[i].inner);
        pp_style_grey(cr, PP_GREY_FILL);
        cairo_fill_preserve(cr);
        pp_style_line(cr, drawing->style.medium, PP_INK);
        cairo_stroke(cr);
    }
    cairo_restore(cr);
}

/* ---- words ---- */

static const char *role_of(enum pp_role role)
{
    return role == PP_FLOOR ? "Floor" : role == PP_CEILING ? "Ceiling" : "Wall";
}

/* The painted area that a label describes: a panel, or a door or a dado in it. */
struct painted {
    const struct pp_net_panel *panel;
    const struct pp_surface *surface; /* the panel's face, or the door or dado */
};

/* Number of forms of a label: name and paint in two lines, in one line, or only the
 * paint. */
enum { WORDINGS = 3 };

static void painted_name(char *words, size_t room, const struct painted *painted,
                         int wording)
{
    const struct pp_surface *surface = painted->surface;
    const struct pp_net_panel *panel = painted->panel;
    char name[96];
    if (surface->role == PP_COVER)
        snprintf(name, sizeof name, "%.40s", surface->name);
    else
        snprintf(name, sizeof name, "%s%s%.40s", role_of(surface->role),
                 surface->name ? " " : "", surface->name ? surface->name : "");
    if (panel->parts > 1 && surface->role != PP_COVER)
        pp_text_append(name, sizeof name, ", part %d of %d", panel->part + 1,
                       panel->parts);
    if (wording < WORDINGS - 1)
        snprintf(words, room, "%s%spaint %.2f", name, wording == 0 ? "\n" : ", ",
                 surface->front);
    else
        snprintf(words, room, "paint %.2f", surface->front);
}

/* True if this point of the panel, in the panel's own coordinates, has this paint. */
static bool is_painted_so(const struct net_drawing *drawing,
                          const struct painted *painted, const double own[2])
{
    const struct pp_world *world = drawing->model->world;
    const struct pp_net_panel *panel = painted->panel;
    double mm = drawing->net.panels.mm_per_m;
    struct pp_vec3 point = pp_vec_along(
        pp_vec_along(panel->origin, own[0] / mm, panel->along), own[1] / mm, panel->up);
    if (pp_polygon_ring_side((const double(*)[2])panel->own, panel->count, own[0],
                             own[1], 0.5)
        != PP_INSIDE)
        return false;
    for (int i = 0; i < world->opening_count; i++)
        if (world->openings[i].face == panel->face
            && pp_polygon_side(&world->openings[i].inner, point, 0.0) != PP_OUTSIDE)
            return false;
    for (int i = world->face_count; i < world->surface_count; i++) {
        const struct pp_surface *cover = &world->surfaces[i];
        if (covers(cover, panel)
            && (pp_polygon_side(&cover->outline, point, 0.0) != PP_OUTSIDE)
                   != (cover == painted->surface))
            return false;
    }
    return true;
}

static struct pp_bounds2 painted_extent(const struct net_drawing *drawing,
                                        const struct painted *painted)
{
    const struct pp_net_panel *panel = painted->panel;
    const struct pp_polygon *outline = &painted->surface->outline;
    struct pp_bounds2 extent = pp_bounds2_empty();
    if (painted->surface->role != PP_COVER)
        for (int i = 0; i < panel->count; i++)
            pp_bounds2_add(&extent, panel->own[i][0], panel->own[i][1]);
    for (int i = 0; i < outline->count && painted->surface->role == PP_COVER; i++) {
        double own[2];
        pp_net_panels_own(&drawing->net.panels, panel, outline->vertices[i], own);
        pp_bounds2_add(&extent, own[0], own[1]);
    }
    return extent;
}

/* Writes a label as near to the middle of the painted area as possible without covering
 * a line. Returns false if there is no space. */
static bool write_words(const struct net_drawing *drawing,
                        const struct painted *painted, const char *words)
{
    enum { STEPS = 31 };
    const struct pp_net_panel *panel = painted->panel;
    const struct pp_lettering set = {.size = PP_TEXT_SMALL, .across = 0.5, .down = 0.5};
    const struct pp_bounds2 extent = painted_extent(drawing, painted);
    double best = INFINITY, found[2] = {0.0, 0.0};
    for (int i = 1; i < STEPS * STEPS; i++) {
        double at[2] = {(double)(i % STEPS) / STEPS, (double)(i / STEPS) / STEPS};
        double off = hypot(at[0] - 0.5, at[1] - 0.5), own[2], xy[2], paper[2];
        for (int k = 0; k < 2; k++)
            own[k] = extent.low[k] + at[k] * (extent.high[k] - extent.low[k]);
        if (off >= best || !is_painted_so(drawing, painted, own))
            continue;
        pp_net_panels_place(panel, own, xy);
        on_paper(drawing, panel, xy, paper);
        struct pp_box box = pp_lettering_measure(drawing->cr, &drawing->style, &set,
                                                 paper[0], paper[1], words);
        if (!pp_labels_is_free(drawing->labels, box))
            continue;
        best = off;
        found[0] = paper[0];
        found[1] = paper[1];
    }
    if (isfinite(best))
        pp_labels_note_box(drawing->labels,
                           pp_lettering_draw(drawing->cr, &drawing->style, &set,
                                             found[0], found[1], words));
    return isfinite(best);
}

static void write_name(const struct net_drawing *drawing, const struct painted *painted)
{
    char words[160];
    for (int i = 0; i < WORDINGS; i++) {
        painted_name(words, sizeof words, painted, i);
        if (write_words(drawing, painted, words))
            return;
    }
}

static void write_names(const struct net_drawing *drawing,
                        const struct pp_net_panel *panel)
{
    const struct pp_world *world = drawing->model->world;
    write_name(drawing, &(struct painted){panel, &world->surfaces[panel->face]});
    for (int i = world->face_count; i < world->surface_count; i++)
        if (covers(&world->surfaces[i], panel))
            write_name(drawing, &(struct painted){panel, &world->surfaces[i]});
}

/* Writes the number of an edge inside the panel, at the middle of the edge. An asterisk
 * means that the edge has no tab. */
static void number_edge(const struct net_drawing *drawing,
                        const struct pp_net_panel *panel, int edge)
{
    const struct pp_lettering set = {
        .size = PP_TEXT_SMALL, .bold = true, .across = 0.5, .down = 0.5};
    double a[2], b[2], at[2], paper[2], in = 0.8 * drawing->style.text[PP_TEXT_SMALL];
    char words[16];
    pp_net_panels_corner(panel, edge, a);
    pp_net_panels_corner(panel, edge + 1, b);
    double length = hypot(b[0] - a[0], b[1] - a[1]);
    if (panel->edges[edge].join == PP_NET_FOLD || length < 3.0 * in)
        return;
    at[0] = 0.5 * (a[0] + b[0]) - in * (b[1] - a[1]) / length;
    at[1] = 0.5 * (a[1] + b[1]) + in * (b[0] - a[0]) / length;
    on_paper(drawing, panel, at, paper);
    snprintf(words, sizeof words, "%d%s", panel->edges[edge].number + 1,
             panel->edges[edge].join == PP_NET_TAPE ? "*" : "");
    pp_labels_note_box(drawing->labels,
                       pp_lettering_draw(drawing->cr, &drawing->style, &set, paper[0],
                                         paper[1], words));
}

/* Appends, for a room with reveals, the note "Reveals are up to 6.0 mm deep; add them
 * on the outside." */
static void say_reveals(char *foot, size_t room, const struct pp_model_net *model)
{
    double deepest = 0.0;
    for (int i = 0; i < model->world->opening_count; i++)
        deepest = fmax(deepest, model->world->openings[i].reveal_m);
    if (deepest > 0.0)
        pp_page_say(foot, room,
                    "Reveals are up to %.1f\u00a0mm deep; add them on the outside.",
                    1000.0 * deepest / model->scale);
}

static bool has_covers(const struct pp_world *world)
{
    for (int i = world->face_count; i < world->surface_count; i++)
        if (world->surfaces[i].role == PP_COVER)
            return true;
    return false;
}

static void say_net_foot(char *foot, size_t room, const struct pp_model_net *model)
{
    static const int altitudes[] = {10, 20, 30, 45, 60, 90};
    pp_page_say(foot, room,
                "Print at 100\u00a0%%. The printed side is the inside. Cut along the "
                "solid lines and cut out the openings (grey). Fold towards you along "
                "the dashed lines. Glue each tab behind the edge with the same number "
                "(*: use tape). The paint number is the reflectance.");
    if (has_covers(model->world))
        pp_page_say(foot, room,
                    "Dotted lines bound doors and dados; paint these separately.");
    say_reveals(foot, room, model);
    pp_page_say(
        foot, room,
        "For measurements in a mirror box (artificial sky) with a reflectance of %.2g "
        "and a height of %.2g times its width, multiply the measured sky component by "
        "a factor. The factor depends on the altitude of the sky seen through the "
        "opening:",
        model->box.rho, model->box.height);
    for (int i = 0; i < 6; i++)
        pp_page_say(foot, room, "%.2f at %d\u00b0%s",
                    pp_mirror_box_correction(&model->box, altitudes[i] * PP_RAD),
                    altitudes[i], i < 5 ? "," : ".");
}

/* ---- sheets ---- */

/* Draws titles, notes and a ruler, and sets the free area. */
static void draw_page(struct net_drawing *drawing, int sheet)
{
    char subtitle[128], foot[1536] = "";
    snprintf(subtitle, sizeof subtitle, "Scale model 1:%g, sheet %d of %d",
             drawing->model->scale, sheet + 1, drawing->net.sheet_count);
    say_net_foot(foot, sizeof foot, drawing->model);
    const struct pp_page page = {drawing->model->world->name, subtitle, foot};
    struct pp_box body = pp_page_draw(drawing->canvas, &drawing->style, &page);
    double ruler = pp_board_ruler_height(&drawing->style);
    pp_board_ruler(drawing->cr, &drawing->style, body.x, body.y + body.height - ruler);
    body.height -= ruler + 2.0 * drawing->style.scale;
    drawing->area = body;
}

static void draw_pieces(struct net_drawing *drawing, int sheet)
{
    const struct pp_net *net = &drawing->net;
    drawing->labels->count = 0;
    drawing->labels->field = drawing->area;
    for (int i = 0; i < net->panels.count; i++) {
        const struct pp_net_panel *panel = &net->panels.list[i];
        if (net->pieces[panel->piece].sheet != sheet)
            continue;
        draw_in_face(drawing, panel);
        for (int k = 0; k < panel->count; k++)
            draw_edge(drawing, panel, k, panel->edges[k].panel > i);
    }
    for (int i = 0; i < net->panels.count; i++) {
        const struct pp_net_panel *panel = &net->panels.list[i];
        if (net->pieces[panel->piece].sheet != sheet)
            continue;
        for (int k = 0; k < panel->count; k++)
            number_edge(drawing, panel, k);
        write_names(drawing, panel);
    }
}

static enum pp_status draw_sheets(struct net_drawing *drawing, struct pp_error *err)
{
    enum pp_status status = PP_OK;
    if (drawing->net.sheet_count > 1 && !pp_canvas_has_sheets(drawing->canvas))
        return pp_fail(
            err, PP_BAD_INPUT,
            "the net needs %d sheets, but only a PDF can hold several; expected -o "
            "FILE.pdf, a larger --paper, or --scale for a smaller model",
            drawing->net.sheet_count);
    for (int i = 0; i < drawing->net.sheet_count && status == PP_OK; i++) {
        if (i > 0)
            status = pp_canvas_next_sheet(drawing->canvas, err);
        if (status != PP_OK)
            return status;
        draw_page(drawing, i);
        draw_pieces(drawing, i);
    }
    return status;
}

/* Returns the free area that draw_page would set. */
static struct pp_box measure_area(const struct net_drawing *drawing)
{
    char foot[1536] = "";
    say_net_foot(foot, sizeof foot, drawing->model);
    const struct pp_page page = {drawing->model->world->name, "Scale model", foot};
    struct pp_box body = pp_page_measure(drawing->canvas, &drawing->style, &page);
    body.height -= pp_board_ruler_height(&drawing->style) + 2.0 * drawing->style.scale;
    return body;
}

enum pp_status pp_net_chart_draw(struct pp_canvas *canvas,
                                 const struct pp_model_net *model, struct pp_error *err)
{
    struct net_drawing drawing = {.canvas = canvas,
                                  .cr = pp_canvas_cairo(canvas),
                                  .style = pp_page_style(canvas),
                                  .model = model,
                                  .labels = calloc(1, sizeof *drawing.labels)};
    if (!drawing.labels)
        return pp_fail_memory(err);
    struct pp_box area = measure_area(&drawing);
    const double size[2] = {area.width, area.height};
    enum pp_status status =
        pp_net_unfold(&drawing.net, model->world, 1000.0 / model->scale, size, err);
    if (status == PP_OK)
        status = draw_sheets(&drawing, err);
    pp_net_unfold_clear(&drawing.net);
    free(drawing.labels);
    return status;
}
