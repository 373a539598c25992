/* section_outside.c - see section_outside.h. */
#include "charts/section/section_outside.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "charts/section/section_sight.h"
#include "charts/sheet/lettering.h"
#include "model/base/text.h"

/* Drawing state outside one end of the section. out: direction on paper, -1 to the
 * left, 1 to the right. */
struct outside_drawing {
    cairo_t *cr;
    const struct pp_style *style;
    const struct pp_room_section *section;
    struct pp_section_sight sight;
    double out;
    double x, y;  /* middle of the window */
    double reach; /* width of the strip outside the section */
    double run;   /* horizontal length of the line of sight on paper */
};

static double least_of(double a, double b, double c)
{
    return fmin(a, fmin(b, c));
}

/* Distance on paper (mm) from the window to the outermost part of the room's own wall,
 * which is a facade or a reveal. */
static double facade_mm(const struct outside_drawing *drawing)
{
    const struct pp_section_cut *cut = drawing->section->cut;
    double farthest = 0.0;
    for (int i = 0; i < cut->count; i++)
        for (int k = 0; k < 2; k++) {
            const struct pp_cut *one = &cut->list[i];
            const struct pp_surface *surface =
                &drawing->section->world->surfaces[one->of];
            bool glass = one->kind == PP_CUT_GLASS;
            if (glass || (one->kind == PP_CUT_OUTSIDE && surface->role == PP_FACADE))
                farthest = fmax(farthest, drawing->out * (one->s[k] - drawing->sight.s)
                                              * drawing->section->mm_per_m);
        }
    return fmin(farthest, 0.5 * drawing->reach);
}

/* Draws the line of sight to an overhang, dashed: the sky is visible below that
 * line. */
static void draw_overhang(const struct outside_drawing *drawing)
{
    const struct pp_room_section *section = drawing->section;
    const struct pp_style *style = drawing->style;
    double angle = drawing->sight.overhang_rad, dash = 1.2 * style->scale;
    double top = fmax(drawing->y - section->y + 0.8 * section->head_mm, 1.0);
    double run = fmin(drawing->reach, top / tan(angle));
    char words[48];
    pp_style_line(drawing->cr, style->thin, PP_INK);
    cairo_set_dash(drawing->cr, &dash, 1, 0.0);
    cairo_move_to(drawing->cr, drawing->x, drawing->y);
    cairo_line_to(drawing->cr, drawing->x + drawing->out * run,
                  drawing->y - run * tan(angle));
    cairo_stroke(drawing->cr);
    snprintf(words, sizeof words, "overhang: sky up to %.0f\u00b0", angle / PP_RAD);
    /* The building opposite may stand at the end of the strip. */
    double building = drawing->sight.angle_rad > 0.0 ? 4.0 * style->scale : 0.0;
    double wide = fmax(drawing->reach - building - facade_mm(drawing) - style->scale,
                       12.0 * style->scale);
    const struct pp_lettering text = {.down = 1.0, .width = wide, .lines = 3};
    double end = drawing->x + drawing->out * (drawing->reach - building);
    pp_lettering_draw_on_white(drawing->cr, style, &text,
                               drawing->out < 0.0 ? end : end - wide,
                               drawing->y - 0.5 * style->scale, words);
}

/* True if the obstruction at the end of the line of sight is drawn nearer than its true
 * distance at this scale. */
static bool is_moved(const struct outside_drawing *drawing)
{
    double distance = drawing->sight.distance_m;
    return isfinite(distance)
           && distance * drawing->section->mm_per_m > drawing->run + 0.1;
}

/* Width on paper (mm) of a building that is drawn nearer than it is. */
static double building_mm(const struct outside_drawing *drawing)
{
    return is_moved(drawing) ? 3.5 * drawing->style->scale : 0.0;
}

/* Draws the building opposite at the end of the line of sight, from the head of the
 * building down to the ground, but at most to 3 mm (on A4) below the floor. */
static void draw_building(const struct outside_drawing *drawing)
{
    cairo_t *cr = drawing->cr;
    const struct pp_room_section *section = drawing->section;
    double head = drawing->y - drawing->run * tan(drawing->sight.angle_rad);
    double low, high;
    pp_section_frame_heights(section->cut, &low, &high);
    double ground =
        fmin(pp_section_frame_y(section, section->world->ground_level_m),
             pp_section_frame_y(section, low) + 3.0 * drawing->style->scale);
    double face = drawing->x + drawing->out * drawing->run;
    cairo_new_path(cr);
    cairo_rectangle(cr, fmin(face, face + drawing->out * building_mm(drawing)), head,
                    building_mm(drawing), fmax(ground - head, 1.0));
    pp_style_grey(cr, PP_GREY_FILL);
    cairo_fill(cr);
    pp_style_line(cr, drawing->style->medium, PP_INK);
    cairo_move_to(cr, face + drawing->out * building_mm(drawing), head);
    cairo_line_to(cr, face, head);
    cairo_line_to(cr, face, ground);
    cairo_stroke(cr);
}

/* Draws two slanting strokes across the horizontal line, which show that the distance
 * is shortened. */
static void draw_break(const struct outside_drawing *drawing)
{
    cairo_t *cr = drawing->cr;
    double unit = drawing->style->scale;
    double x = drawing->x + 0.85 * drawing->out * drawing->run, y = drawing->y;
    pp_style_grey(cr, 1.0);
    cairo_rectangle(cr, x - 0.4 * unit, y - unit, 0.8 * unit, 2.0 * unit);
    cairo_fill(cr);
    pp_style_line(cr, drawing->style->thin, PP_INK);
    for (int side = -1; side <= 1; side += 2) {
        cairo_move_to(cr, x + (0.4 * side - 0.4) * unit, y + 1.2 * unit);
        cairo_line_to(cr, x + (0.4 * side + 0.4) * unit, y - 1.2 * unit);
    }
    cairo_stroke(cr);
}

/* Name of the obstruction to which the surface belongs; NULL: it has no name. */
static const char *obstruction_name(const struct pp_world *world, int surface)
{
    if (surface < 0)
        return NULL;
    return world->surfaces[surface].role == PP_BLOCK
               ? world->blocks[world->surfaces[surface].owner].name
               : world->surfaces[surface].name;
}

void pp_section_outside_say(char *text, size_t room,
                            const struct pp_room_section *section, bool near)
{
    struct pp_section_sight sight =
        pp_section_sight_of(section->cut, section->world, near);
    const char *name = obstruction_name(section->world, sight.of);
    if (!(sight.angle_rad > 0.0) || !isfinite(sight.distance_m))
        return;
    pp_text_append(text, room,
                   " %.40s: %.3g\u00a0m away, top %.3g\u00a0m above the floor (not to "
                   "scale).",
                   name ? name : "Obstruction", sight.distance_m,
                   sight.z + sight.distance_m * tan(sight.angle_rad));
}

/* Writes name, angle and distance below the horizontal line, between the obstruction
 * and the room's own facade. */
static void write_sight_words(const struct outside_drawing *drawing)
{
    const struct pp_style *style = drawing->style;
    const struct pp_section_sight *sight = &drawing->sight;
    const char *name = obstruction_name(drawing->section->world, sight->of);
    char words[160] = "", far[32] = "";
    if (isfinite(sight->distance_m) && sight->distance_m > 0.0)
        pp_style_metres(far, sizeof far, sight->distance_m);
    pp_text_append(words, sizeof words, "%s %.0f\u00b0%s%s",
                   sight->skyline ? "skyline" : "line of sight",
                   sight->angle_rad / PP_RAD, *far ? " at\u00a0" : "", far);
    if (name)
        pp_text_append(words, sizeof words, " to %.40s", name);
    double gap = 1.0 * style->scale, from = facade_mm(drawing) + gap,
           to = is_moved(drawing) ? drawing->run - gap : drawing->reach;
    struct pp_lettering text = {.size = PP_TEXT_SMALL,
                                .width = fmax(to - from, 12.0 * style->scale),
                                .lines = 4};
    double x = drawing->out < 0.0 ? drawing->x - from - text.width : drawing->x + from;
    pp_lettering_draw_on_white(drawing->cr, style, &text, x,
                               drawing->y + 1.6 * style->scale, words);
}

/* Draws the line of sight to the head of the obstruction, the horizontal line, and the
 * angle between them. */
static void draw_line_of_sight(const struct outside_drawing *drawing)
{
    cairo_t *cr = drawing->cr;
    const struct pp_style *style = drawing->style;
    double x = drawing->x, y = drawing->y, angle = drawing->sight.angle_rad;
    double end = is_moved(drawing) ? drawing->run : drawing->reach;
    if (is_moved(drawing))
        draw_building(drawing);
    if (drawing->section->no_angles)
        return;
    pp_style_line(cr, style->thin, PP_INK);
    cairo_move_to(cr, x, y);
    cairo_line_to(cr, x + drawing->out * drawing->run, y - drawing->run * tan(angle));
    cairo_stroke(cr);
    pp_style_line(cr, style->hair, PP_INK);
    cairo_move_to(cr, x, y);
    cairo_line_to(cr, x + drawing->out * end, y);
    cairo_stroke(cr);
    double radius = fmin(0.45 * end, 0.9 * drawing->run / cos(angle));
    cairo_new_path(cr);
    if (drawing->out < 0.0)
        cairo_arc(cr, x, y, radius, PP_PI, PP_PI + angle);
    else
        cairo_arc_negative(cr, x, y, radius, 0.0, -angle);
    cairo_stroke(cr);
    if (is_moved(drawing))
        draw_break(drawing);
    write_sight_words(drawing);
}

void pp_section_outside_draw(cairo_t *cr, const struct pp_style *style,
                             const struct pp_room_section *section, bool near)
{
    struct outside_drawing drawing = {
        .cr = cr,
        .style = style,
        .section = section,
        .sight = pp_section_sight_of(section->cut, section->world, near),
        .out = near ? -1.0 : 1.0,
        .reach = (near ? section->left_mm : section->right_mm) - 1.0};
    const struct pp_section_sight *sight = &drawing.sight;
    drawing.reach -=
        fabs(sight->s - (near ? 0.0 : section->cut->length_m)) * section->mm_per_m;
    drawing.x = pp_section_frame_x(section, sight->s);
    drawing.y = pp_section_frame_y(section, sight->z);
    if (sight->overhang_rad < 0.5 * PP_PI && !section->no_angles)
        draw_overhang(&drawing);
    if (!(sight->angle_rad > 0.0))
        return;
    /* The line of sight is extended as far as the strip and the top of the section
     * allow. A building drawn nearer than it is needs additional width beyond the
     * end. */
    double top = fmax(drawing.y - section->y + 0.8 * section->head_mm, 1.0);
    double far =
        sight->distance_m > 0.0 ? sight->distance_m * section->mm_per_m : INFINITY;
    double strip = isfinite(far) && far > drawing.reach
                       ? drawing.reach - 3.5 * style->scale
                       : drawing.reach;
    drawing.run = least_of(strip, top / tan(sight->angle_rad), far);
    draw_line_of_sight(&drawing);
}
