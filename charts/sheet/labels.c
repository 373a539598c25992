/* labels.c - finds the nearest free place for a label. All sides of the owner's
 * registered places are tried, at increasing distances. */
#include "charts/sheet/labels.h"

#include <math.h>

void pp_labels_note(struct pp_labels *labels, int owner, double x0, double y0,
                    double x1, double y1)
{
    double length = hypot(x1 - x0, y1 - y0);
    if (!isfinite(length))
        return;
    int steps = (int)ceil(fmin(length, 5000.0));
    for (int i = 0; i <= steps && labels->count < PP_LABEL_PLACES_MOST; i++) {
        double share = steps ? (double)i / steps : 0.0;
        labels->places[labels->count++] = (struct pp_label_place){
            x0 + share * (x1 - x0), y0 + share * (y1 - y0), owner};
    }
}

void pp_labels_note_path(struct pp_labels *labels, cairo_t *cr, int owner)
{
    cairo_path_t *path = cairo_copy_path_flat(cr);
    double x = 0.0, y = 0.0;
    for (int i = 0; i < path->num_data; i += path->data[i].header.length) {
        const cairo_path_data_t *data = &path->data[i];
        if (data->header.type == CAIRO_PATH_CLOSE_PATH)
            continue;
        double to[2] = {data[1].point.x, data[1].point.y};
        bool drawn = data->header.type == CAIRO_PATH_LINE_TO;
        /* Joins short pieces of a curve until they are 0.5 mm long. */
        bool last =
            i + data->header.length >= path->num_data
            || path->data[i + data->header.length].header.type != CAIRO_PATH_LINE_TO;
        if (drawn && !last && hypot(to[0] - x, to[1] - y) < 0.5)
            continue;
        if (drawn)
            pp_labels_note(labels, owner, x, y, to[0], to[1]);
        x = to[0];
        y = to[1];
    }
    cairo_path_destroy(path);
}

void pp_labels_note_box(struct pp_labels *labels, struct pp_box box)
{
    int rows = (int)ceil(box.height);
    for (int i = 0; i <= rows; i++) {
        double y = box.y + box.height * i / (rows ? rows : 1);
        pp_labels_note(labels, -1, box.x, y, box.x + box.width, y);
    }
}

bool pp_labels_is_near(const struct pp_labels *labels, int owner, double x, double y,
                       double distance)
{
    for (int i = 0; i < labels->count; i++) {
        const struct pp_label_place *p = &labels->places[i];
        if (p->owner == owner && hypot(p->x - x, p->y - y) < distance)
            return true;
    }
    return false;
}

/* True if the box is in the field, at least `pad` from registered places of other
 * owners, and at least pad/4 from places of its owner. covers_lines: lines are
 * ignored. */
static bool is_free(const struct pp_labels *labels, struct pp_box box, int owner,
                    double pad, bool covers_lines)
{
    const struct pp_box *field = &labels->field;
    if (box.x < field->x || box.y < field->y
        || box.x + box.width > field->x + field->width
        || box.y + box.height > field->y + field->height)
        return false;
    for (int i = 0; i < labels->count; i++) {
        const struct pp_label_place *p = &labels->places[i];
        double off = p->owner == owner ? 0.25 * pad : pad;
        if (covers_lines && p->owner >= 0 && p->owner < PP_LABEL_MARKS)
            continue;
        if (p->x > box.x - off && p->x < box.x + box.width + off && p->y > box.y - off
            && p->y < box.y + box.height + off)
            return false;
    }
    return true;
}

bool pp_labels_is_free(const struct pp_labels *labels, struct pp_box box)
{
    return is_free(labels, box, -2, 0.5, false);
}

bool pp_labels_covers_lines_only(const struct pp_labels *labels, struct pp_box box)
{
    return is_free(labels, box, -2, 0.3, true);
}

/* Distance (mm) from the line a-b to the nearest place of another owner. */
static double clearance(const struct pp_labels *labels, const double a[2],
                        const double b[2], int owner)
{
    double nearest = INFINITY, dx = b[0] - a[0], dy = b[1] - a[1];
    double square = dx * dx + dy * dy;
    for (int i = 0; i < labels->count; i++) {
        const struct pp_label_place *p = &labels->places[i];
        if (p->owner == owner)
            continue;
        double share =
            square > 0.0 ? ((p->x - a[0]) * dx + (p->y - a[1]) * dy) / square : 0.0;
        share = fmin(fmax(share, 0.0), 1.0);
        nearest =
            fmin(nearest, hypot(a[0] + share * dx - p->x, a[1] + share * dy - p->y));
    }
    return nearest;
}

/* Point of a box nearest to a given point. In y, only the middle 70 % of the box, with
 * the letters, is considered. */
static void nearest_in_box(struct pp_box box, const double from[2], double to[2])
{
    to[0] = fmin(fmax(from[0], box.x), box.x + box.width);
    to[1] = fmin(fmax(from[1], box.y + 0.15 * box.height), box.y + 0.85 * box.height);
}

bool pp_labels_find(const struct pp_labels *labels, const struct pp_style *style,
                    double width, double height, int owner, struct pp_box *found,
                    double anchor[2])
{
    static const double sides[][2] = {{1, -1},  {1, 0}, {0, -1}, {-1, 1},
                                      {-1, -1}, {1, 1}, {-1, 0}, {0, 1}};
    double unit = style->scale, best = INFINITY;
    int own = 0;
    for (int i = 0; i < labels->count; i++)
        own += labels->places[i].owner == owner;
    int stride = own > 60 ? own / 60 : 1, seen = 0;

    for (int i = 0; i < labels->count; i++) {
        const struct pp_label_place *p = &labels->places[i];
        if (p->owner != owner || seen++ % stride)
            continue;
        double at[2] = {p->x, p->y};
        /* Penalty for places between close lines, where the owner of a label is
         * ambiguous. */
        double apart = clearance(labels, at, at, owner);
        double doubt = 4.0 * fmax(0.0, 2.5 - apart / unit);
        for (int ring = 0; ring < 5; ring++)
            for (int s = 0; s < 8; s++) {
                double off = (1.0 + 3.0 * ring) * unit;
                double cost = off / unit + doubt + 0.3 * s;
                if (cost >= best)
                    continue;
                struct pp_box box = {
                    at[0] + sides[s][0] * off + 0.5 * (sides[s][0] - 1) * width,
                    at[1] + sides[s][1] * off + 0.5 * (sides[s][1] - 1) * height, width,
                    height};
                double end[2];
                nearest_in_box(box, at, end);
                if (!is_free(labels, box, owner, 1.6 * unit, false)
                    || (ring && clearance(labels, at, end, owner) < 0.3 * unit))
                    continue;
                best = cost;
                *found = box;
                anchor[0] = at[0];
                anchor[1] = at[1];
            }
    }
    return isfinite(best);
}

void pp_labels_lead(cairo_t *cr, const struct pp_style *style, struct pp_box box,
                    const double anchor[2])
{
    double end[2];
    nearest_in_box(box, anchor, end);
    if (hypot(end[0] - anchor[0], end[1] - anchor[1]) < 2.2 * style->scale)
        return;
    pp_style_line(cr, style->hair, PP_INK);
    cairo_move_to(cr, anchor[0], anchor[1]);
    cairo_line_to(cr, end[0], end[1]);
    cairo_stroke(cr);
}
