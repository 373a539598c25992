/* room_section.c - chooses the scale of a section, and draws cut faces, openings, the
 * working plane, and lines of sight. */
#include "charts/section/room_section.h"
#include "charts/room/room_elevation.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "charts/room/device_drawing.h"
#include "charts/room/room_plan.h"
#include "charts/section/section_crowns.h"
#include "charts/section/section_outside.h"
#include "charts/section/section_sight.h"
#include "charts/section/section_words.h"
#include "charts/sheet/page.h"
#include "charts/sheet/lettering.h"
#include "model/base/text.h"
#include "model/geometry/tolerance.h"

bool pp_room_section_has_outside(const struct pp_room_section *section, bool near)
{
    struct pp_section_sight sight =
        pp_section_sight_of(section->cut, section->world, near);
    return sight.angle_rad > 0.0 || sight.overhang_rad < 0.5 * PP_PI
           || pp_section_crowns_are_outside(section->cut, section->world, near);
}

/* Height (mm) of names, dimensions and caption below the floor. */
static double below_mm(const struct pp_room_section *section,
                       const struct pp_style *style)
{
    double names = section->named ? pp_section_words_mm(style) : 0.0;
    return names + (section->no_caption ? 0.0 : 3.2 * style->text[PP_TEXT_SMALL]);
}

void pp_room_section_fit(struct pp_room_section *section, const struct pp_style *style,
                         double length_mm, double height_mm)
{
    double low, high;
    pp_section_frame_heights(section->cut, &low, &high);
    double free_mm = fmax(height_mm - below_mm(section, style), 5.0);
    double least = fmax(1000.0 * section->cut->length_m / length_mm,
                        1000.0 * (high - low) / free_mm);
    double scale = pp_room_plan_usual_scale(fmax(least, section->least_scale));
    section->mm_per_m = 1000.0 / scale;
    section->height_mm = section->mm_per_m * (high - low) + below_mm(section, style);
}

/* ---- drawing ---- */

struct section_drawing {
    const struct pp_room_section *section;
    cairo_t *cr;
    const struct pp_style *style;
    double low, high; /* lowest and highest z of the cut faces */
};

static double at_s(const struct section_drawing *drawing, double s)
{
    return pp_section_frame_x(drawing->section, s);
}

static double at_z(const struct section_drawing *drawing, double z)
{
    return pp_section_frame_y(drawing->section, z);
}

static void line(const struct section_drawing *drawing, const double s[2],
                 const double z[2])
{
    cairo_move_to(drawing->cr, at_s(drawing, s[0]), at_z(drawing, z[0]));
    cairo_line_to(drawing->cr, at_s(drawing, s[1]), at_z(drawing, z[1]));
}

static void stroke_cuts(const struct section_drawing *drawing, enum pp_cut_kind kind,
                        double weight_mm, double grey, cairo_line_cap_t cap)
{
    const struct pp_section_cut *cut = drawing->section->cut;
    pp_style_line(drawing->cr, weight_mm, grey);
    cairo_set_line_cap(drawing->cr, cap);
    for (int i = 0; i < cut->count; i++)
        if (cut->list[i].kind == kind)
            line(drawing, cut->list[i].s, cut->list[i].z);
    cairo_stroke(drawing->cr);
}

/* True if the opening is seen edge-on in the section, like glass in a slope that the
 * section cuts beside the glass. s, z: the two corners that are farthest apart, which
 * are the ends of the visible line. */
static bool is_edge_on(const struct section_drawing *drawing,
                       const struct pp_polygon *outline, double s[2], double z[2])
{
    const struct pp_section_cut *cut = drawing->section->cut;
    double longest = -1.0, widest = 0.0;
    for (int a = 0; a < outline->count; a++)
        for (int b = a + 1; b < outline->count; b++) {
            double sa = pp_section_cut_s(cut, outline->vertices[a]);
            double sb = pp_section_cut_s(cut, outline->vertices[b]);
            double za = outline->vertices[a].z, zb = outline->vertices[b].z;
            if (hypot(sb - sa, zb - za) <= longest)
                continue;
            longest = hypot(sb - sa, zb - za);
            s[0] = sa, s[1] = sb, z[0] = za, z[1] = zb;
        }
    for (int i = 0; i < outline->count && longest > 0.0; i++) {
        double across =
            (s[1] - s[0]) * (outline->vertices[i].z - z[0])
            - (z[1] - z[0]) * (pp_section_cut_s(cut, outline->vertices[i]) - s[0]);
        widest = fmax(widest, fabs(across) / longest);
    }
    return widest * drawing->section->mm_per_m < drawing->style->thick;
}

/* Draws glass that is seen edge-on beside the section, as a dashed gap in the line of
 * its face. */
static void draw_edge_on(const struct section_drawing *drawing)
{
    const struct pp_world *world = drawing->section->world;
    double dash = 0.9 * drawing->style->scale, s[2], z[2];
    for (int i = 0; i < world->opening_count; i++) {
        if (pp_section_frame_is_cut(drawing->section->cut, i)
            || !is_edge_on(drawing, &world->openings[i].inner, s, z))
            continue;
        pp_style_line(drawing->cr, 0.55 * drawing->style->thick, 1.0);
        cairo_set_dash(drawing->cr, &dash, 1, 0.0);
        line(drawing, s, z);
        cairo_stroke(drawing->cr);
    }
}

/* True if the outline lies beyond the ends of the section, for example in another wing
 * of an L-shaped room. */
static bool is_beyond_ends(const struct pp_section_cut *cut,
                           const struct pp_polygon *outline)
{
    double s = pp_section_cut_s(cut, pp_polygon_middle(outline));
    return s < -PP_TOUCH_M || s > cut->length_m + PP_TOUCH_M;
}

/* Draws dashed outlines, in elevation, of the openings behind or in front of the
 * section that it does not cut. Returns their number. */
static int draw_openings_behind(const struct section_drawing *drawing)
{
    const struct pp_world *world = drawing->section->world;
    const struct pp_section_cut *cut = drawing->section->cut;
    int drawn = 0;
    pp_style_line(drawing->cr, drawing->style->thin, PP_GREY_LINE);
    double dash = 0.9 * drawing->style->scale;
    cairo_set_dash(drawing->cr, &dash, 1, 0.0);
    for (int i = 0; i < world->opening_count; i++) {
        const struct pp_polygon *outline = &world->openings[i].inner;
        if (pp_section_frame_is_cut(cut, i) || is_beyond_ends(cut, outline))
            continue;
        cairo_new_sub_path(drawing->cr);
        for (int k = 0; k < outline->count; k++)
            cairo_line_to(drawing->cr,
                          at_s(drawing, pp_section_cut_s(cut, outline->vertices[k])),
                          at_z(drawing, outline->vertices[k].z));
        cairo_close_path(drawing->cr);
        drawn++;
    }
    cairo_stroke(drawing->cr);
    return drawn;
}

/* True if the outline is on the far side of the section. */
static bool is_behind(const struct pp_section_cut *cut,
                      const struct pp_polygon *outline)
{
    struct pp_vec3 middle = pp_polygon_middle(outline);
    return (middle.y - cut->origin[1]) * cut->along[0]
           > (middle.x - cut->origin[0]) * cut->along[1];
}

/* Draws doors and dados in elevation behind the section: a thin outline with diagonal
 * lines. */
static void draw_covers_behind(const struct section_drawing *drawing)
{
    const struct pp_world *world = drawing->section->world;
    const struct pp_section_cut *cut = drawing->section->cut;
    cairo_set_dash(drawing->cr, NULL, 0, 0.0);
    pp_style_line(drawing->cr, drawing->style->thin, PP_GREY_LINE);
    for (int i = world->face_count; i < world->surface_count; i++) {
        const struct pp_polygon *outline = &world->surfaces[i].outline;
        if (world->surfaces[i].role != PP_COVER || !is_behind(cut, outline)
            || is_beyond_ends(cut, outline))
            continue;
        cairo_new_path(drawing->cr);
        for (int k = 0; k < outline->count; k++)
            cairo_line_to(drawing->cr,
                          at_s(drawing, pp_section_cut_s(cut, outline->vertices[k])),
                          at_z(drawing, outline->vertices[k].z));
        cairo_close_path(drawing->cr);
        pp_room_elevation_hatch(drawing->cr, drawing->style);
    }
}

/* Draws the blind, screen or curtain beside cut glass. ends: ends of the glass on
 * paper. Slats follow each other from the lower to the upper end. */
static void draw_device_cut(const struct section_drawing *drawing,
                            const struct pp_opening *opening, double ends[2][2])
{
    const struct pp_section_cut *cut = drawing->section->cut;
    int low = ends[0][1] < ends[1][1];
    double dx = ends[!low][0] - ends[low][0], dy = ends[!low][1] - ends[low][1];
    double length = hypot(dx, dy);
    const struct pp_vec3 n = opening->inner.normal;
    double inwards[2] = {dy / length, -dx / length};
    /* Coordinates: s runs to the right on paper, z upwards. */
    if ((n.x * cut->along[0] + n.y * cut->along[1]) * inwards[0] - n.z * inwards[1]
        < 0.0) {
        inwards[0] = -inwards[0];
        inwards[1] = -inwards[1];
    }
    pp_device_drawing_cut(drawing->cr, drawing->style, opening, ends[low], ends[!low],
                          inwards, !opening->device.vertical);
}

/* Draws glass as two thin lines, and the sides of a reveal between face and glass. */
static void draw_openings_cut(const struct section_drawing *drawing)
{
    const struct pp_section_cut *cut = drawing->section->cut;
    const struct pp_world *world = drawing->section->world;
    double half = 0.45 * drawing->style->thick;
    for (int i = 0; i < cut->count; i++) {
        const struct pp_cut *glass = &cut->list[i];
        bool is_opening = glass->kind == PP_CUT_OPENING;
        if (!is_opening && glass->kind != PP_CUT_GLASS)
            continue;
        if (is_opening && world->openings[glass->of].reveal_m > 0.0)
            continue;
        double x0 = at_s(drawing, glass->s[0]), y0 = at_z(drawing, glass->z[0]);
        double x1 = at_s(drawing, glass->s[1]), y1 = at_z(drawing, glass->z[1]);
        double length = hypot(x1 - x0, y1 - y0);
        if (!(length > 0.0))
            continue;
        double nx = half * (y1 - y0) / length, ny = -half * (x1 - x0) / length;
        pp_style_line(drawing->cr, drawing->style->thin, PP_INK);
        for (int side = -1; side <= 1; side += 2) {
            cairo_move_to(drawing->cr, x0 + side * nx, y0 + side * ny);
            cairo_line_to(drawing->cr, x1 + side * nx, y1 + side * ny);
        }
        for (int k = 0; k < cut->count; k++) {
            const struct pp_cut *inner = &cut->list[k];
            if (glass->kind != PP_CUT_GLASS || inner->kind != PP_CUT_OPENING
                || inner->of != glass->of)
                continue;
            for (int end = 0; end < 2; end++)
                line(drawing, (double[]){glass->s[end], inner->s[end]},
                     (double[]){glass->z[end], inner->z[end]});
        }
        cairo_stroke(drawing->cr);
        draw_device_cut(drawing, &world->openings[glass->of],
                        (double[2][2]){{x0, y0}, {x1, y1}});
    }
}

/* Distance on paper (mm) from a cut face to its facade; 0: there is no facade. */
static double facade_mm(const struct section_drawing *drawing, int face)
{
    const struct pp_world *world = drawing->section->world;
    for (int i = 0; i < world->facade_count; i++)
        if (world->facades[i].face == face)
            return world->facades[i].depth_m * drawing->section->mm_per_m;
    return 0.0;
}

/* Traces a band beside a cut, at horizontal distances from `from` to `to` (mm,
 * negative: to the left). */
static void trace_beside(const struct section_drawing *drawing,
                         const struct pp_cut *cut, double from, double to)
{
    double x[2] = {at_s(drawing, cut->s[0]), at_s(drawing, cut->s[1])};
    double y[2] = {at_z(drawing, cut->z[0]), at_z(drawing, cut->z[1])};
    cairo_new_path(drawing->cr);
    cairo_move_to(drawing->cr, x[0] + from, y[0]);
    cairo_line_to(drawing->cr, x[1] + from, y[1]);
    cairo_line_to(drawing->cr, x[1] + to, y[1]);
    cairo_line_to(drawing->cr, x[0] + to, y[0]);
    cairo_close_path(drawing->cr);
}

/* Draws a door as a leaf in the line of the wall, with an opening in the facade in
 * front of it, and a dado as a narrow white strip in front of the wall. */
static void draw_cover_cut(const struct section_drawing *drawing,
                           const struct pp_cut *cut)
{
    const struct pp_section_cut *section = drawing->section->cut;
    const struct pp_surface *cover = &drawing->section->world->surfaces[cut->of];
    const struct pp_style *style = drawing->style;
    cairo_t *cr = drawing->cr;
    struct pp_vec3 normal = cover->outline.normal;
    double in = normal.x * section->along[0] + normal.y * section->along[1];
    double side = copysign(1.0, in), face = 0.5 * side * style->thick;
    double facade = facade_mm(drawing, cover->owner);
    if (cover->is_door && facade > 0.0) {
        trace_beside(drawing, cut, 0.0, -side * (facade + style->medium));
        pp_style_grey(cr, 1.0);
        cairo_fill(cr);
        trace_beside(drawing, cut, 0.0, -side * facade);
        pp_style_line(cr, style->thin, PP_INK);
        cairo_stroke(cr);
    }
    trace_beside(drawing, cut, face,
                 cover->is_door ? -face : face + side * style->scale);
    pp_style_grey(cr, cover->is_door ? PP_GREY_FILL : 1.0);
    cairo_fill_preserve(cr);
    pp_style_line(cr, style->thin, PP_INK);
    cairo_stroke(cr);
}

static void draw_plane(const struct section_drawing *drawing)
{
    const struct pp_room_section *section = drawing->section;
    cairo_t *cr = drawing->cr;
    double y = at_z(drawing, section->cut->height_m);
    double dashes[] = {1.6 * drawing->style->scale, 0.9 * drawing->style->scale};
    pp_style_line(cr, drawing->style->thin, PP_INK);
    cairo_set_dash(cr, dashes, 2, 0.0);
    cairo_move_to(cr, at_s(drawing, 0.0), y);
    cairo_line_to(cr, at_s(drawing, section->cut->length_m), y);
    cairo_stroke(cr);
    pp_style_line(cr, drawing->style->thin, PP_INK);
    double tick = 0.8 * drawing->style->scale;
    for (int i = 0; i < section->report->receiver_count; i++) {
        double x =
            at_s(drawing, pp_section_cut_s(section->cut,
                                           section->report->receivers[i].position));
        cairo_move_to(cr, x, y - tick);
        cairo_line_to(cr, x, y + tick);
    }
    cairo_stroke(cr);
}

/* Draws the ground outside, if it is near the floor. */
static void draw_ground(const struct section_drawing *drawing)
{
    const struct pp_room_section *section = drawing->section;
    double z = section->world->ground_level_m, y = at_z(drawing, z);
    if (fabs(z - drawing->low) * section->mm_per_m > 3.0 * drawing->style->scale)
        return;
    pp_style_line(drawing->cr, drawing->style->thin, PP_INK);
    for (int near = 0; near < 2; near++) {
        double wall = at_s(drawing, near ? 0.0 : section->cut->length_m);
        double reach = near ? section->left_mm : section->right_mm;
        if (reach < 10.0 * drawing->style->scale)
            continue;
        cairo_move_to(drawing->cr, wall, y);
        cairo_line_to(drawing->cr, near ? wall - reach : wall + reach, y);
    }
    cairo_stroke(drawing->cr);
}

static void write_caption(const struct section_drawing *drawing, int behind)
{
    const struct pp_room_section *section = drawing->section;
    char text[512], length[32], height[32], plane[32], room[96] = "";
    pp_style_metres(length, sizeof length, section->cut->length_m);
    pp_style_metres(plane, sizeof plane, section->cut->height_m);
    pp_style_metres(height, sizeof height, drawing->high - drawing->low);
    if (!section->named)
        snprintf(room, sizeof room, "Room %s long; %s high; ", length, height);
    snprintf(text, sizeof text, "Section %s1:%g. %s%s points %s above the floor",
             section->named ? "A\u2013A, " : "", 1000.0 / section->mm_per_m, room,
             *room ? "calculation" : "Calculation", plane);
    double low = INFINITY, high = -INFINITY;
    for (int i = 0; i < section->cut->count; i++) {
        const struct pp_cut *cut = &section->cut->list[i];
        if (cut->kind != PP_CUT_OPENING
            || section->world->openings[cut->of].face != section->cut->near_face)
            continue;
        low = fmin(low, fmin(cut->z[0], cut->z[1]));
        high = fmax(high, fmax(cut->z[0], cut->z[1]));
    }
    if (high > low) {
        char sill[32], head[32];
        pp_style_metres(sill, sizeof sill, low);
        pp_style_metres(head, sizeof head, high);
        pp_text_append(text, sizeof text, "; window sill %s, head %s", sill, head);
    }
    pp_text_append(text, sizeof text, ".%s",
                   behind ? " Openings that are not cut by the section are dashed."
                          : "");
    for (int near = 1; near >= 0 && section->no_angles; near--)
        pp_section_outside_say(text, sizeof text, section, near);
    struct pp_lettering set = {.size = PP_TEXT_SMALL, .grey = PP_GREY_TEXT};
    double left = section->x, right = at_s(drawing, section->cut->length_m);
    /* A caption wider than the room begins to the left of the room if necessary. */
    set.width = fmax(right - left, 90.0 * drawing->style->scale);
    if (section->most_x > 0.0)
        left = fmin(left,
                    fmax(section->most_x - set.width, section->x - section->left_mm));
    set.lines = section->no_angles ? 3 : 2;
    /* The caption has a white background, since a facade and the ground outside may
     * continue below the floor. */
    pp_lettering_draw_on_white(
        drawing->cr, drawing->style, &set, left,
        at_z(drawing, drawing->low) + 1.4 * drawing->style->scale
            + (section->named ? pp_section_words_mm(drawing->style) : 0.0),
        text);
}

void pp_room_section_draw(cairo_t *cr, const struct pp_style *style,
                          const struct pp_room_section *section)
{
    struct section_drawing drawing = {section, cr, style, 0.0, 0.0};
    pp_section_frame_heights(section->cut, &drawing.low, &drawing.high);
    /* Ground and obstructions outside may be far wider than the sheet. */
    cairo_save(cr);
    double left = section->x - section->left_mm;
    double right = at_s(&drawing, section->cut->length_m) + section->right_mm;
    cairo_rectangle(cr, left, section->y - section->head_mm, right - left,
                    section->height_mm + section->head_mm);
    cairo_clip(cr);
    int behind = draw_openings_behind(&drawing);
    draw_covers_behind(&drawing);
    draw_ground(&drawing);
    pp_section_crowns_draw(cr, style, section);
    stroke_cuts(&drawing, PP_CUT_OUTSIDE, style->medium, PP_INK, CAIRO_LINE_CAP_SQUARE);
    for (int near = 1; near >= 0 && !section->no_sights; near--)
        pp_section_outside_draw(cr, style, section, near);
    stroke_cuts(&drawing, PP_CUT_FACE, style->thick, PP_INK, CAIRO_LINE_CAP_SQUARE);
    stroke_cuts(&drawing, PP_CUT_INSIDE, style->medium, PP_INK, CAIRO_LINE_CAP_BUTT);
    draw_edge_on(&drawing);
    draw_openings_cut(&drawing);
    for (int i = 0; i < section->cut->count; i++)
        if (section->cut->list[i].kind == PP_CUT_COVER)
            draw_cover_cut(&drawing, &section->cut->list[i]);
    draw_plane(&drawing);
    cairo_restore(cr);
    if (section->named)
        pp_section_words_draw(cr, style, section);
    if (!section->no_caption)
        write_caption(&drawing, behind);
}
