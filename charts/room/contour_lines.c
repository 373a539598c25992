/* contour_lines.c - draws a contour line with a gap for its figure, where the line is
 * straight and there is no other label nearby. */
#include "charts/room/contour_lines.h"

#include <math.h>
#include <stdlib.h>

#include "charts/sheet/canvas.h"

void pp_contour_lines_path(cairo_t *cr, const struct pp_room_plan *plan,
                           const struct pp_curve *curve)
{
    cairo_new_sub_path(cr);
    for (int i = 0; i < curve->count; i++)
        cairo_line_to(cr, pp_plan_frame_x(plan, curve->xy[i][0]),
                      pp_plan_frame_y(plan, curve->xy[i][1]));
    if (curve->closed)
        cairo_close_path(cr);
}

/* A curve on paper (mm); if closed, the first point is repeated at the end. */
struct track {
    int count;
    double (*xy)[2];
    double *length; /* length of the track from its start to each point, mm */
};

/* A point on a track, and the unit vector along the track. */
struct station {
    double x, y, dx, dy;
};

/* Converts a curve to a track on paper. Returns false if memory is exhausted. The
 * caller clears *track in either case. */
static bool lay_track(struct track *track, const struct pp_room_plan *plan,
                      const struct pp_curve *curve)
{
    int count = curve->count + (curve->closed ? 1 : 0);
    *track = (struct track){.count = count,
                            .xy = malloc((size_t)count * sizeof *track->xy),
                            .length = malloc((size_t)count * sizeof *track->length)};
    if (!track->xy || !track->length)
        return false;
    for (int i = 0; i < count; i++) {
        const double *xy = curve->xy[i % curve->count];
        track->xy[i][0] = pp_plan_frame_x(plan, xy[0]);
        track->xy[i][1] = pp_plan_frame_y(plan, xy[1]);
        track->length[i] = i ? track->length[i - 1]
                                   + hypot(track->xy[i][0] - track->xy[i - 1][0],
                                           track->xy[i][1] - track->xy[i - 1][1])
                             : 0.0;
    }
    return true;
}

static void clear_track(struct track *track)
{
    free(track->xy);
    free(track->length);
}

static struct station station_at(const struct track *track, double length)
{
    int low = 0, high = track->count - 1;
    while (high - low > 1) {
        int middle = (low + high) / 2;
        if (track->length[middle] <= length)
            low = middle;
        else
            high = middle;
    }
    const double *a = track->xy[low], *b = track->xy[high];
    double step = fmax(track->length[high] - track->length[low], 1e-9);
    double share = fmin(fmax((length - track->length[low]) / step, 0.0), 1.0);
    return (struct station){a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1]),
                            (b[0] - a[0]) / step, (b[1] - a[1]) / step};
}

/* Adds the part of the track between two lengths to the path. */
static void path_between(cairo_t *cr, const struct track *track, double from, double to)
{
    if (!(to > from))
        return;
    struct station first = station_at(track, from), last = station_at(track, to);
    cairo_move_to(cr, first.x, first.y);
    for (int i = 0; i < track->count; i++)
        if (track->length[i] > from && track->length[i] < to)
            cairo_line_to(cr, track->xy[i][0], track->xy[i][1]);
    cairo_line_to(cr, last.x, last.y);
}

/* Midpoint and direction of the chord between two points on the track, half of `width`
 * before and after `at`. *excess: relative difference between the length of the track
 * and of the chord; 0 on a straight line. */
static struct station chord_at(const struct track *track, double at, double width,
                               double *excess)
{
    struct station before = station_at(track, at - 0.5 * width);
    struct station after = station_at(track, at + 0.5 * width);
    double chord = fmax(hypot(after.x - before.x, after.y - before.y), 1e-6);
    *excess = 1.0 - chord / width;
    return (struct station){0.5 * (before.x + after.x), 0.5 * (before.y + after.y),
                            (after.x - before.x) / chord, (after.y - before.y) / chord};
}

/* True if a label at this station, turned along the line, is in the field and does not
 * cover places of other owners. */
static bool is_clear(const struct pp_labels *labels, int owner, struct station at,
                     double width, double height)
{
    const struct pp_box *field = &labels->field;
    double half = 0.5 * hypot(width, height);
    if (at.x - half < field->x || at.x + half > field->x + field->width
        || at.y - half < field->y || at.y + half > field->y + field->height)
        return false;
    for (int i = 0; i < labels->count; i++) {
        double x = labels->places[i].x - at.x, y = labels->places[i].y - at.y;
        if (labels->places[i].owner != owner
            && fabs(x * at.dx + y * at.dy) < 0.5 * width
            && fabs(y * at.dx - x * at.dy) < 0.5 * height)
            return false;
    }
    return true;
}

/* Best position for a label, as a length along the track: free of other labels, on a
 * straight part (excess below 0.2), and near the middle. Negative: there is none. The
 * weights were chosen by trial. */
static double best_place(const struct track *track, const struct pp_labels *labels,
                         int owner, double width, double height)
{
    double length = track->length[track->count - 1];
    double best = -1.0, least = INFINITY;
    int tries = (int)fmin(fmax(length / 2.0, 8.0), 60.0);
    for (int i = 1; i < tries; i++) {
        double at = length * i / tries, excess;
        if (at < 0.8 * width || at > length - 0.8 * width)
            continue;
        struct station chord = chord_at(track, at, width, &excess);
        double cost = 30.0 * excess + fabs(at / length - 0.5);
        if (cost < least && excess < 0.2
            && is_clear(labels, owner, chord, width, height)) {
            least = cost;
            best = at;
        }
    }
    return best;
}

static void draw_label(cairo_t *cr, const struct pp_style *style,
                       const struct track *track, double at, double width,
                       const char *words, struct pp_labels *labels)
{
    double excess;
    struct station chord = chord_at(track, at, width, &excess);
    double turn = atan2(chord.dy, chord.dx);
    if (turn > PP_PI / 2.0 + 1e-6)
        turn -= PP_PI;
    if (turn <= -PP_PI / 2.0 + 1e-6)
        turn += PP_PI;
    struct pp_lettering set = {
        .size = PP_TEXT_SMALL, .across = 0.5, .down = 0.5, .turn_rad = turn};
    struct pp_box box = pp_lettering_draw(cr, style, &set, chord.x, chord.y, words);
    for (int side = -1; side <= 1; side++) {
        double off = 0.4 * side * box.height;
        double cx = chord.x - off * sin(turn), cy = chord.y + off * cos(turn);
        double dx = 0.5 * box.width * cos(turn), dy = 0.5 * box.width * sin(turn);
        pp_labels_note(labels, -1, cx - dx, cy - dy, cx + dx, cy + dy);
    }
}

bool pp_contour_lines_draw(cairo_t *cr, const struct pp_style *style,
                           const struct pp_room_plan *plan,
                           const struct pp_curve *curve, double weight_mm,
                           const char *words, struct pp_labels *labels, int owner)
{
    struct pp_lettering set = {.size = PP_TEXT_SMALL};
    struct pp_box size = pp_lettering_measure(cr, style, &set, 0, 0, words);
    double gap = size.width + 1.6 * style->scale, at = -1.0;
    struct track track;
    bool laid = lay_track(&track, plan, curve);
    if (!laid)
        pp_canvas_lacks_memory(cr);
    if (laid && track.length[track.count - 1] > (curve->closed ? 5.0 : 2.0) * gap)
        at = best_place(&track, labels, owner, gap, size.height);

    pp_style_line(cr, weight_mm, PP_INK);
    cairo_set_line_join(cr, CAIRO_LINE_JOIN_ROUND);
    if (at < 0.0) {
        pp_contour_lines_path(cr, plan, curve);
    } else {
        path_between(cr, &track, 0.0, at - 0.5 * gap);
        path_between(cr, &track, at + 0.5 * gap, track.length[track.count - 1]);
    }
    cairo_stroke(cr);
    if (at >= 0.0)
        draw_label(cr, style, &track, at, gap, words, labels);
    clear_track(&track);
    return at >= 0.0;
}
