/* protractor_disc.c - draws the two halves of a protractor: rim with degrees, primary
 * scale, and semicircles of the auxiliary scale.
 */
#include "charts/drawing_board/protractor_disc.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "charts/sheet/lettering.h"
#include "model/geometry/vec.h"

/* Radius of the innermost semicircle divided by the radius of the outermost. */
static const double innermost = 0.24;

double pp_protractor_disc_border(const struct pp_style *style)
{
    return 1.9 * style->text[PP_TEXT_SMALL];
}

double pp_protractor_disc_arc(const struct pp_style *style, double radius)
{
    return radius - 6.5 * style->scale;
}

void pp_protractor_disc_section(const struct pp_protractor_disc *disc, double angle_rad,
                                double distance, double xy[2])
{
    xy[0] = disc->x + (disc->to_right ? 1.0 : -1.0) * distance * cos(angle_rad);
    xy[1] = disc->y - distance * sin(angle_rad);
}

void pp_protractor_disc_plan(const struct pp_protractor_disc *disc, double angle_rad,
                             double distance, double xy[2])
{
    /* An angle to the right of the normal, seen from inside, is clockwise on paper. */
    double c = cos(angle_rad), s = sin(angle_rad);
    xy[0] = disc->x + distance * (c * disc->plan[0] - s * disc->plan[1]);
    xy[1] = disc->y + distance * (s * disc->plan[0] + c * disc->plan[1]);
}

double pp_protractor_disc_semicircle(const struct pp_style *style,
                                     const struct pp_protractor_disc *disc,
                                     double average_rad)
{
    double share = average_rad / disc->scale->last_average_rad;
    return pp_protractor_disc_arc(style, disc->radius)
           * (1.0 - (1.0 - innermost) * share);
}

typedef void place_function(const struct pp_protractor_disc *disc, double angle_rad,
                            double distance, double xy[2]);

static void radial(cairo_t *cr, const struct pp_protractor_disc *disc,
                   place_function *place, double angle, double from, double to)
{
    double xy[2];
    place(disc, angle, from, xy);
    cairo_move_to(cr, xy[0], xy[1]);
    place(disc, angle, to, xy);
    cairo_line_to(cr, xy[0], xy[1]);
}

static void arc(cairo_t *cr, const struct pp_protractor_disc *disc,
                place_function *place, double distance, double from, double to)
{
    double a[2], b[2];
    place(disc, from, distance, a);
    place(disc, to, distance, b);
    double first = atan2(a[1] - disc->y, a[0] - disc->x);
    double middle[2];
    place(disc, (from + to) / 2.0, distance, middle);
    double turn = atan2(middle[1] - disc->y, middle[0] - disc->x) - first;
    bool clockwise = sin(turn) > 0.0;
    double last = atan2(b[1] - disc->y, b[0] - disc->x);
    cairo_new_sub_path(cr);
    if (clockwise)
        cairo_arc(cr, disc->x, disc->y, distance, first, last);
    else
        cairo_arc_negative(cr, disc->x, disc->y, distance, first, last);
}

/* Writes text with its baseline towards the centre. On a plan, the baseline is away
 * from the centre where the text would otherwise be upside down. */
static void write_round(cairo_t *cr, const struct pp_style *style,
                        const struct pp_protractor_disc *disc, place_function *place,
                        double angle, double distance, double grey, const char *words)
{
    double xy[2];
    place(disc, angle, distance, xy);
    double turn = atan2(xy[0] - disc->x, disc->y - xy[1]);
    if (fabs(turn) > PP_PI / 2.0 + 0.01)
        turn += turn > 0.0 ? -PP_PI : PP_PI;
    const struct pp_lettering set = {.size = PP_TEXT_SMALL,
                                     .across = 0.5,
                                     .down = 0.5,
                                     .grey = grey,
                                     .turn_rad = turn};
    pp_lettering_draw(cr, style, &set, xy[0], xy[1], words);
}

/* Draws degree marks on the rim from `low` to `high`. first_label: first degree that is
 * labelled; as many degrees at the other end have no label either. Labels give the
 * angle from 0, without a sign. */
static void draw_rim(cairo_t *cr, const struct pp_style *style,
                     const struct pp_protractor_disc *disc, place_function *place,
                     int low, int high, int first_label)
{
    double tick = 0.8 * style->scale;
    pp_style_line(cr, style->thin, disc->grey);
    for (int degree = low; degree <= high; degree++) {
        double length = degree % 10 == 0 ? 2.4 : degree % 5 == 0 ? 1.7 : 1.0;
        radial(cr, disc, place, degree * PP_RAD, disc->radius,
               disc->radius - length * tick);
    }
    arc(cr, disc, place, disc->radius, low * PP_RAD, high * PP_RAD);
    cairo_stroke(cr);
    for (int degree = first_label; degree <= high + (low - first_label); degree += 10) {
        char words[16];
        snprintf(words, sizeof words, "%d\u00b0", abs(degree));
        write_round(cr, style, disc, place, degree * PP_RAD,
                    disc->radius + 0.85 * style->text[PP_TEXT_SMALL], disc->grey,
                    words);
    }
}

static void primary_marks(cairo_t *cr, const struct pp_style *style,
                          const struct pp_protractor_disc *disc)
{
    const struct pp_protractor_scale *scale = disc->scale;
    double at = pp_protractor_disc_arc(style, disc->radius);
    static const double length[] = {1.1, 1.7, 2.5};
    pp_style_line(cr, style->hair, disc->grey);
    for (int i = 0; i < scale->mark_count; i++)
        radial(cr, disc, pp_protractor_disc_section, scale->marks[i].angle_rad, at,
               at - length[scale->marks[i].rank] * style->scale);
    cairo_stroke(cr);
    pp_style_line(cr, style->thin, disc->grey);
    arc(cr, disc, pp_protractor_disc_section, at, 0.0, scale->range_rad);
    cairo_stroke(cr);
    for (int i = 0; i < scale->mark_count; i++) {
        if (scale->marks[i].rank != PP_MARK_LABELLED)
            continue;
        char words[16];
        snprintf(words, sizeof words, "%.4g", 100.0 * scale->marks[i].share);
        write_round(cr, style, disc, pp_protractor_disc_section,
                    scale->marks[i].angle_rad,
                    at - 2.7 * style->scale - 0.55 * style->text[PP_TEXT_SMALL],
                    disc->grey, words);
    }
}

void pp_protractor_disc_primary(cairo_t *cr, const struct pp_style *style,
                                const struct pp_protractor_disc *disc, bool both)
{
    struct pp_protractor_disc other = *disc;
    other.to_right = !disc->to_right;
    bool twice = both && disc->scale->range_rad < PP_PI / 2.0 + 1e-6;
    int last = (int)floor(disc->scale->range_rad / PP_RAD + 1e-6);
    draw_rim(cr, style, disc, pp_protractor_disc_section, 0, last, 0);
    primary_marks(cr, style, disc);
    if (twice) {
        draw_rim(cr, style, &other, pp_protractor_disc_section, 0, last - 1, 0);
        primary_marks(cr, style, &other);
        pp_style_line(cr, style->thin, disc->grey);
        arc(cr, &other, pp_protractor_disc_section, disc->radius, 0.0, PP_PI / 2.0);
        cairo_stroke(cr);
    }
    /* Draws the radii of the base line and of the end of the scale, and a short mark
     * towards the zenith. */
    double at = pp_protractor_disc_arc(style, disc->radius);
    pp_style_line(cr, style->thin, disc->grey);
    radial(cr, disc, pp_protractor_disc_section, 0.0, 0.0, disc->radius);
    if (twice || disc->scale->range_rad > PP_PI - 1e-6)
        radial(cr, &other, pp_protractor_disc_section, 0.0, 0.0, disc->radius);
    if (!twice && disc->scale->range_rad < PP_PI - 1e-6)
        radial(cr, disc, pp_protractor_disc_section, disc->scale->range_rad, 0.0,
               disc->radius);
    radial(cr, disc, pp_protractor_disc_section, PP_PI / 2.0, 0.0, 0.1 * at);
    cairo_stroke(cr);
}

static void draw_lines(cairo_t *cr, const struct pp_style *style,
                       const struct pp_protractor_disc *disc)
{
    const struct pp_protractor_scale *scale = disc->scale;
    for (int heavy = 0; heavy < 2; heavy++) {
        pp_style_line(cr, heavy ? 1.2 * style->thin : style->hair, disc->grey);
        cairo_set_line_join(cr, CAIRO_LINE_JOIN_ROUND);
        for (int i = 0; i < scale->line_count; i++) {
            const struct pp_protractor_line *line = &scale->lines[i];
            bool is_heavy = (int)(100.0 * line->factor + 0.5) % 10 == 0;
            for (int side = -1; side <= 1 && is_heavy == (heavy == 1); side += 2)
                for (int k = 0; k < line->count; k++) {
                    double xy[2];
                    pp_protractor_disc_plan(
                        disc, side * line->jamb_rad[k],
                        pp_protractor_disc_semicircle(style, disc,
                                                      k * PP_PROTRACTOR_LINE_STEP_RAD),
                        xy);
                    if (k == 0)
                        cairo_move_to(cr, xy[0], xy[1]);
                    else
                        cairo_line_to(cr, xy[0], xy[1]);
                }
        }
        cairo_stroke(cr);
    }
}

static void write_factors(cairo_t *cr, const struct pp_style *style,
                          const struct pp_protractor_disc *disc)
{
    const struct pp_protractor_scale *scale = disc->scale;
    double at =
        pp_protractor_disc_arc(style, disc->radius) + 0.58 * style->text[PP_TEXT_SMALL];
    for (int i = 0; i < scale->line_count; i++) {
        const struct pp_protractor_line *line = &scale->lines[i];
        if ((int)(100.0 * line->factor + 0.5) % 10 != 0)
            continue;
        char words[16];
        snprintf(words, sizeof words, "%.1f", line->factor);
        for (int side = -1; side <= 1; side += 2)
            write_round(cr, style, disc, pp_protractor_disc_plan,
                        side * line->jamb_rad[0], at, disc->grey, words);
    }
}

/* Writes the average altitudes of the semicircles on the normal: every 10 degrees, or
 * every 20 if the semicircles are close together. */
static void write_averages(cairo_t *cr, const struct pp_style *style,
                           const struct pp_protractor_disc *disc)
{
    int last = (int)(disc->scale->last_average_rad / PP_RAD + 0.5);
    double apart = pp_protractor_disc_semicircle(style, disc, 0.0)
                   - pp_protractor_disc_semicircle(style, disc, 10.0 * PP_RAD);
    int step = apart > 1.5 * style->text[PP_TEXT_SMALL] ? 10 : 20;
    for (int degree = 0; degree <= last; degree += step) {
        char words[16];
        double xy[2];
        snprintf(words, sizeof words, "%d\u00b0", degree);
        pp_protractor_disc_plan(
            disc, 0.0, pp_protractor_disc_semicircle(style, disc, degree * PP_RAD), xy);
        const struct pp_lettering set = {
            .size = PP_TEXT_SMALL, .across = 0.5, .down = 0.5, .grey = disc->grey};
        pp_lettering_draw_on_white(cr, style, &set, xy[0], xy[1], words);
    }
}

void pp_protractor_disc_auxiliary(cairo_t *cr, const struct pp_style *style,
                                  const struct pp_protractor_disc *disc, bool whole)
{
    /* On a whole disc, the ends of the base are labelled with the section half. */
    draw_rim(cr, style, disc, pp_protractor_disc_plan, -90, 90, whole ? -80 : -90);
    int last = (int)(disc->scale->last_average_rad / PP_RAD + 0.5);
    pp_style_line(cr, style->thin, disc->grey);
    for (int degree = 0; degree <= last; degree += 10)
        arc(cr, disc, pp_protractor_disc_plan,
            pp_protractor_disc_semicircle(style, disc, degree * PP_RAD), -PP_PI / 2.0,
            PP_PI / 2.0);
    cairo_stroke(cr);
    draw_lines(cr, style, disc);
    pp_style_line(cr, style->thin, disc->grey);
    radial(cr, disc, pp_protractor_disc_plan, 0.0, 0.0,
           pp_protractor_disc_arc(style, disc->radius));
    for (int side = -1; side <= 1; side += 2)
        radial(cr, disc, pp_protractor_disc_plan, side * PP_PI / 2.0, 0.0,
               disc->radius);
    cairo_stroke(cr);
    write_factors(cr, style, disc);
    write_averages(cr, style, disc);
}
