/* site_names.c - see site_names.h. */
#include "charts/site/site_names.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

#include "charts/sheet/page.h"
#include "model/base/text.h"

struct pp_box pp_site_names_frame(const struct pp_room_plan *frame)
{
    double width = (frame->extent.high[0] - frame->extent.low[0]) * frame->mm_per_m;
    double height = (frame->extent.high[1] - frame->extent.low[1]) * frame->mm_per_m;
    return (struct pp_box){frame->x, frame->y - height, width, height};
}

double pp_site_names_deep(const struct pp_style *style)
{
    return 2.6 * style->scale;
}

double pp_site_names_near(const struct pp_style *style, int storey)
{
    return 0.5 * style->medium + storey * pp_site_names_deep(style);
}

/* Writes a text within `area`, centred at the free place nearest to x, y. */
static void write_near(struct pp_site_drawing *drawing, struct pp_box area, double x,
                       double y, double width, const char *words)
{
    const struct pp_lettering set = {.size = PP_TEXT_SMALL, .width = width};
    struct pp_box size =
        pp_lettering_measure(drawing->cr, &drawing->style, &set, 0.0, 0.0, words);
    double step = 1.2 * drawing->style.scale, best = INFINITY;
    struct pp_box found = {0};
    int across = (int)(area.width / step), down = (int)(area.height / step);
    for (int i = -across; i <= across; i++)
        for (int k = -down; k <= down; k++) {
            struct pp_box box = {x + i * step - 0.5 * size.width,
                                 y + k * step - 0.5 * size.height, size.width,
                                 size.height};
            double off = hypot(i, k);
            if (off >= best || box.x < area.x || box.y < area.y
                || box.x + box.width > area.x + area.width
                || box.y + box.height > area.y + area.height
                || !pp_labels_is_free(drawing->labels, box))
                continue;
            best = off;
            found = box;
        }
    if (!isfinite(best))
        return;
    pp_lettering_draw_on_white(drawing->cr, &drawing->style, &set, found.x, found.y,
                               words);
    pp_labels_note_box(drawing->labels, found);
}

/* Box on paper of a shape's corners, limited to the drawing. */
static struct pp_box shape_box(const struct pp_site_drawing *drawing,
                               const struct pp_site_shape *shape)
{
    struct pp_box frame = pp_site_names_frame(&drawing->frame);
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    for (int i = 0; i < shape->count; i++) {
        double x = pp_plan_frame_x(&drawing->frame, shape->corners[i].x);
        double y = pp_plan_frame_y(&drawing->frame, shape->corners[i].y);
        x = fmin(fmax(x, frame.x), frame.x + frame.width);
        y = fmin(fmax(y, frame.y), frame.y + frame.height);
        low[0] = fmin(low[0], x), low[1] = fmin(low[1], y);
        high[0] = fmax(high[0], x), high[1] = fmax(high[1], y);
    }
    return (struct pp_box){low[0], low[1], high[0] - low[0], high[1] - low[1]};
}

/* ---- buildings ---- */

/* True if a room has this name. A room may also be among the surroundings of other
 * rooms, as shapes with its name. */
static bool is_room_name(const struct pp_site_sheet *sheet, const char *name)
{
    for (int i = 0; i < sheet->shape_count; i++)
        if (sheet->shapes[i].is_room && sheet->shapes[i].name
            && strcmp(sheet->shapes[i].name, name) == 0)
            return true;
    return false;
}

/* Area of a shape in plan (m2). middle: mean of its corners. */
static double covered_m2(const struct pp_site_shape *shape, double middle[2])
{
    double area = 0.0;
    middle[0] = middle[1] = 0.0;
    for (int i = 0; i < shape->count; i++) {
        const struct pp_vec3 *p = &shape->corners[i];
        const struct pp_vec3 *q = &shape->corners[(i + 1) % shape->count];
        area += 0.5 * (p->x * q->y - q->x * p->y);
        middle[0] += p->x / shape->count;
        middle[1] += p->y / shape->count;
    }
    return fabs(area);
}

/* Data of all shapes with the same name. */
struct named_thing {
    double area_m2, middle[2]; /* area and middle of the largest shape */
    int largest;
    double top_m;
    bool first; /* the given shape is the first of its name */
};

static struct named_thing gather_named(const struct pp_site_sheet *sheet, int index)
{
    const struct pp_site_shape *asked = &sheet->shapes[index];
    struct named_thing thing = {.area_m2 = -1.0, .top_m = -INFINITY, .first = true};
    for (int i = 0; i < sheet->shape_count; i++) {
        const struct pp_site_shape *shape = &sheet->shapes[i];
        double middle[2];
        if (!shape->name || shape->is_room || shape->when != asked->when
            || strcmp(shape->name, asked->name) != 0)
            continue;
        thing.first &= i >= index;
        thing.top_m = fmax(thing.top_m, shape->top_m);
        double area = covered_m2(shape, middle);
        if (area > thing.area_m2) {
            thing.area_m2 = area;
            thing.largest = i;
            thing.middle[0] = middle[0];
            thing.middle[1] = middle[1];
        }
    }
    return thing;
}

/* Writes name and height of a building, once for all shapes with that name. */
static void name_shape(struct pp_site_drawing *drawing, int index)
{
    static const char *const states[] = {[PP_SITE_ALWAYS] = NULL,
                                         [PP_SITE_NEW] = "proposed",
                                         [PP_SITE_GONE] = "existing"};
    const struct pp_site_shape *shape = &drawing->sheet->shapes[index];
    struct pp_box frame = pp_site_names_frame(&drawing->frame);
    char words[96], height[32];
    if (!shape->name || shape->is_room || is_room_name(drawing->sheet, shape->name))
        return;
    const struct named_thing thing = gather_named(drawing->sheet, index);
    if (!thing.first)
        return;
    const char *state = states[shape->when];
    if (state && strncasecmp(shape->name, state, strlen(state)) == 0)
        state = NULL;
    pp_style_metres(height, sizeof height, thing.top_m - drawing->sheet->ground_m);
    snprintf(words, sizeof words, "%.40s%s%s, %s", shape->name, state ? ", " : "",
             state ? state : "", height);
    double x = pp_plan_frame_x(&drawing->frame, thing.middle[0]);
    double y = pp_plan_frame_y(&drawing->frame, thing.middle[1]);
    bool is_off = x < frame.x || x > frame.x + frame.width || y < frame.y
                  || y > frame.y + frame.height;
    if (is_off && drawing->sheet->cell_count > 0)
        return;
    struct pp_box box = shape_box(drawing, &drawing->sheet->shapes[thing.largest]);
    x = fmin(fmax(x, box.x), box.x + box.width);
    y = fmin(fmax(y, box.y), box.y + box.height);
    double width = fmax(box.width - 2.0, 20.0 * drawing->style.scale);
    double beyond = 6.0 * drawing->style.scale;
    struct pp_box area = {box.x - beyond, box.y - beyond, box.width + 2.0 * beyond,
                          box.height + 2.0 * beyond};
    write_near(drawing, area, x, y, width, words);
}

/* ---- rooms and gardens ---- */

/* True if one of the rooms is above the other. */
static bool same_place(const struct pp_site_shape *a, const struct pp_site_shape *b)
{
    double p[2], q[2];
    covered_m2(a, p);
    covered_m2(b, q);
    return hypot(p[0] - q[0], p[1] - q[1]) < 0.5;
}

/* Writes the names of rooms that lie one above the other once, in the first of them. */
static void name_rooms(struct pp_site_drawing *drawing, int index)
{
    const struct pp_site_sheet *sheet = drawing->sheet;
    const struct pp_site_shape *room = &sheet->shapes[index];
    char words[256] = "";
    for (int i = 0; i < sheet->shape_count; i++) {
        const struct pp_site_shape *other = &sheet->shapes[i];
        if (!other->is_room || !other->name || !same_place(room, other))
            continue;
        if (i < index)
            return;
        pp_text_append(words, sizeof words, "%s%.30s", *words ? "\n" : "", other->name);
    }
    struct pp_box box = shape_box(drawing, room);
    if (*words)
        write_near(drawing, box, box.x + 0.5 * box.width, box.y + 0.5 * box.height,
                   box.width - 1.0, words);
}

static void name_garden(struct pp_site_drawing *drawing,
                        const struct pp_site_garden *garden)
{
    char words[96] = "";
    struct pp_bounds2 box = pp_bounds2_empty();
    for (int i = 0; i < garden->count; i++)
        pp_bounds2_add(&box, pp_plan_frame_x(&drawing->frame, garden->corners[i][0]),
                       pp_plan_frame_y(&drawing->frame, garden->corners[i][1]));
    if (garden->name)
        pp_text_append(words, sizeof words, "%.40s", garden->name);
    if (isfinite(garden->share))
        pp_text_append(words, sizeof words, "%s%.0f\u00a0%%", garden->name ? " " : "",
                       100.0 * garden->share);
    double beyond = 12.0 * drawing->style.scale;
    struct pp_box area = {box.low[0] - beyond, box.low[1] - beyond,
                          box.high[0] - box.low[0] + 2.0 * beyond,
                          box.high[1] - box.low[1] + 2.0 * beyond};
    if (words[0])
        write_near(drawing, area, 0.5 * (box.low[0] + box.high[0]),
                   0.5 * (box.low[1] + box.high[1]), 0.0, words);
}

/* ---- windows ---- */

/* True if the strips of two windows are in the same stack. */
static bool same_stack(const struct pp_site_window *a, const struct pp_site_window *b)
{
    double off[2];
    for (int k = 0; k < 2; k++) {
        const double *p = k ? &a->from.y : &a->from.x, *q = k ? &a->to.y : &a->to.x;
        const double *r = k ? &b->from.y : &b->from.x, *s = k ? &b->to.y : &b->to.x;
        off[k] = 0.5 * (*p + *q - *r - *s);
    }
    return pp_vec_dot(a->out, b->out) > 0.999 && hypot(off[0], off[1]) < 1.0;
}

/* Lists the names of the windows in a stack, from the lowest storey upwards. Returns
 * the highest storey. */
static int stack_names(const struct pp_site_sheet *sheet,
                       const struct pp_site_window *lowest, char *words, size_t room)
{
    int highest = 0;
    words[0] = '\0';
    for (int i = 0; i < sheet->window_count; i++)
        if (same_stack(&sheet->windows[i], lowest))
            highest =
                sheet->windows[i].storey > highest ? sheet->windows[i].storey : highest;
    for (int storey = 0; storey <= highest; storey++)
        for (int i = 0; i < sheet->window_count; i++)
            if (sheet->windows[i].storey == storey
                && same_stack(&sheet->windows[i], lowest))
                pp_text_append(words, room, "%s%s", *words ? ", " : "",
                               sheet->windows[i].label);
    return highest;
}

void pp_site_names_windows(struct pp_site_drawing *drawing)
{
    const struct pp_site_sheet *sheet = drawing->sheet;
    const struct pp_style *style = &drawing->style;
    for (int i = 0; i < sheet->window_count; i++) {
        const struct pp_site_window *window = &sheet->windows[i];
        char words[160];
        if (window->storey > 0)
            continue;
        int highest = stack_names(sheet, window, words, sizeof words);
        double x = 0.5
                   * (pp_plan_frame_x(&drawing->frame, window->from.x)
                      + pp_plan_frame_x(&drawing->frame, window->to.x));
        double y = 0.5
                   * (pp_plan_frame_y(&drawing->frame, window->from.y)
                      + pp_plan_frame_y(&drawing->frame, window->to.y));
        double out[2] = {window->out.x, -window->out.y};
        double from = pp_site_names_near(style, highest + 1) + 0.6 * style->scale;
        bool left = out[0] < -1e-6 || (fabs(out[0]) <= 1e-6 && out[1] > 0.0);
        struct pp_lettering set = {.size = PP_TEXT_SMALL,
                                   .across = left ? 1.0 : 0.0,
                                   .down = 0.5,
                                   .turn_rad = left ? atan2(-out[1], -out[0])
                                                    : atan2(out[1], out[0])};
        double length =
            pp_lettering_measure(drawing->cr, style, &set, 0.0, 0.0, words).width;
        x += from * out[0];
        y += from * out[1];
        if (sheet->tree_count > 0) /* a crown may be hatched below the name */
            pp_lettering_draw_on_white(drawing->cr, style, &set, x, y, words);
        else
            pp_lettering_draw(drawing->cr, style, &set, x, y, words);
        for (int side = -1; side <= 1; side++) {
            double dx = -0.9 * side * style->scale * out[1],
                   dy = 0.9 * side * style->scale * out[0];
            pp_labels_note(drawing->labels, -1, x + dx, y + dy,
                           x + length * out[0] + dx, y + length * out[1] + dy);
        }
    }
}

void pp_site_names_draw(struct pp_site_drawing *drawing)
{
    const struct pp_site_sheet *sheet = drawing->sheet;
    for (int i = 0; i < sheet->shape_count; i++)
        if (sheet->shapes[i].is_room)
            name_rooms(drawing, i);
    for (int i = 0; i < sheet->shape_count; i++)
        if (sheet->shapes[i].is_room)
            pp_labels_note_box(drawing->labels, shape_box(drawing, &sheet->shapes[i]));
    for (int i = 0; i < sheet->garden_count; i++)
        name_garden(drawing, &sheet->gardens[i]);
    for (int pass = 0; pass < 2; pass++)
        for (int i = 0; i < sheet->shape_count; i++)
            if ((sheet->shapes[i].when == PP_SITE_GONE) == (pass == 1))
                name_shape(drawing, i);
}
