/* iso_lines.c - marching squares on the logarithms of the values. */
#include "model/pictures/iso_lines.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Without tags: neighbours whose natural logarithms differ by more than this belong to
 * different surfaces. Chosen by trial. */
static const double edge_log = 0.3;

struct log_picture {
    int width, height;
    double *logs; /* logarithms of the values; -INFINITY: no value */
    const int *tags;
};

static size_t at(const struct log_picture *field, int x, int y)
{
    return (size_t)y * (size_t)field->width + (size_t)x;
}

/* True if two pixels show the same surface. */
static bool alike(const struct log_picture *field, size_t a, size_t b)
{
    if (!isfinite(field->logs[a]) || !isfinite(field->logs[b]))
        return false;
    if (field->tags)
        return field->tags[a] == field->tags[b];
    return fabs(field->logs[a] - field->logs[b]) < edge_log;
}

/* ---- smoothing ---- */

/* Smooths along rows or columns, from field->logs to out. */
static void smooth_along(const struct log_picture *field, double *out, bool rows,
                         double deviation)
{
    int reach = (int)ceil(3.0 * deviation);
    size_t step = rows ? 1 : (size_t)field->width;
    for (int y = 0; y < field->height; y++)
        for (int x = 0; x < field->width; x++) {
            size_t here = at(field, x, y);
            out[here] = field->logs[here];
            if (!isfinite(field->logs[here]))
                continue;
            int place = rows ? x : y, end = rows ? field->width : field->height;
            double sum = exp(field->logs[here]), weights = 1.0;
            for (int way = -1; way <= 1; way += 2)
                for (int k = 1; k <= reach; k++) {
                    int other = place + way * k;
                    if (other < 0 || other >= end)
                        break;
                    size_t there =
                        way < 0 ? here - (size_t)k * step : here + (size_t)k * step;
                    if (!alike(field, here, there))
                        break;
                    double t = k / deviation, weight = exp(-0.5 * t * t);
                    sum += weight * exp(field->logs[there]);
                    weights += weight;
                }
            out[here] = log(sum / weights);
        }
}

/* True if a neighbour of the pixel belongs to a different surface, so that the pixel's
 * value may be a mixture of both. */
static bool is_mixed(const struct log_picture *field, int x, int y)
{
    for (int j = y > 0 ? y - 1 : y; j <= y + 1 && j < field->height; j++)
        for (int i = x > 0 ? x - 1 : x; i <= x + 1 && i < field->width; i++)
            if (field->tags[at(field, i, j)] != field->tags[at(field, x, y)])
                return true;
    return false;
}

static enum pp_status make_field(struct log_picture *field,
                                 const struct pp_picture *picture, const int *tags,
                                 double unit, double smooth, struct pp_error *err)
{
    size_t pixels = (size_t)picture->width * (size_t)picture->height;
    *field = (struct log_picture){picture->width, picture->height,
                                  malloc(pixels * sizeof(double)), tags};
    double *other = malloc(pixels * sizeof *other);
    if (!field->logs || !other) {
        free(field->logs);
        free(other);
        return pp_fail_memory(err);
    }
    for (int y = 0; y < picture->height; y++)
        for (int x = 0; x < picture->width; x++) {
            double value = unit * pp_rgb_luminance(pp_picture_rgb(picture, x, y));
            bool good =
                value > 0.0 && isfinite(value) && !(tags && is_mixed(field, x, y));
            field->logs[at(field, x, y)] = good ? log(value) : -INFINITY;
        }
    if (smooth > 0.0) {
        double *first = field->logs;
        smooth_along(field, other, true, smooth);
        field->logs = other;
        smooth_along(field, first, false, smooth);
        field->logs = first;
    }
    free(other);
    return PP_OK;
}

/* ---- squares ---- */

/* Edges between adjacent pixels have the numbers 2 i (right of pixel i) and 2 i + 1
 * (below pixel i). A line crosses a square from edge to edge, with the brighter side on
 * its left; next[e] is the edge after e on the line. */
struct squares {
    const struct log_picture *field;
    double level; /* logarithm */
    int *next;    /* by edge; -1: none */
    bool *entered;
};

/* Adds a line segment from one edge of a square to another. */
static void link_edges(struct squares *squares, int from, int to)
{
    squares->next[from] = to;
    squares->entered[to] = true;
}

/* Adds the lines of the square whose upper left pixel is x, y. Corners are numbered
 * clockwise in the picture. */
static void cross_square(struct squares *squares, int x, int y)
{
    const struct log_picture *field = squares->field;
    const size_t corner[4] = {at(field, x, y), at(field, x + 1, y),
                              at(field, x + 1, y + 1), at(field, x, y + 1)};
    for (int i = 1; i < 4; i++)
        if (!alike(field, corner[0], corner[i]))
            return;
    /* Edge i is between corners i and i + 1. */
    const int edge[4] = {(int)(2 * corner[0]), (int)(2 * corner[1] + 1),
                         (int)(2 * corner[3]), (int)(2 * corner[0] + 1)};
    bool above[4];
    double mean = 0.0;
    for (int i = 0; i < 4; i++) {
        above[i] = field->logs[corner[i]] > squares->level;
        mean += 0.25 * field->logs[corner[i]];
    }
    /* Going clockwise, a line with the bright side on its left enters between a dark
     * and a bright corner and leaves between a bright and a dark one. */
    int in[2], out[2], count_in = 0, count_out = 0;
    for (int i = 0; i < 4; i++) {
        if (!above[i] && above[(i + 1) % 4])
            in[count_in++] = edge[i];
        if (above[i] && !above[(i + 1) % 4])
            out[count_out++] = edge[i];
    }
    if (count_in == 1) {
        link_edges(squares, in[0], out[0]);
    } else if (count_in == 2) {
        /* Two opposite bright corners are joined if the mean is bright. in[0] precedes
         * out[0] if corner 0 is dark. */
        bool joined = mean > squares->level;
        bool swapped = above[0] ? !joined : joined;
        link_edges(squares, in[0], out[swapped ? 1 : 0]);
        link_edges(squares, in[1], out[swapped ? 0 : 1]);
    }
}

static void place_of_edge(const struct squares *squares, int edge, double xy[2])
{
    const struct log_picture *field = squares->field;
    int pixel = edge / 2, x = pixel % field->width, y = pixel / field->width;
    bool below = edge % 2;
    double a = field->logs[pixel];
    double b = field->logs[below ? at(field, x, y + 1) : at(field, x + 1, y)];
    double t = (squares->level - a) / (b - a);
    xy[0] = x + 0.5 + (below ? 0.0 : t);
    xy[1] = y + 0.5 + (below ? t : 0.0);
}

/* Removes the line that begins at edge `start` from the squares, and stores the line if
 * it is long enough. */
static enum pp_status take_iso_line(struct squares *squares, int start, double shortest,
                                    struct pp_curve_list *lines, struct pp_error *err)
{
    int count = 1;
    bool closed = false;
    for (int edge = squares->next[start]; edge >= 0; edge = squares->next[edge]) {
        if (edge == start) {
            closed = true;
            break;
        }
        count++;
    }
    struct pp_curve curve = {.level = exp(squares->level),
                             .closed = closed && count >= 3,
                             .xy = malloc((size_t)count * sizeof *curve.xy)};
    if (!curve.xy)
        return pp_fail_memory(err);
    for (int edge = start, i = 0; i < count; i++) {
        double xy[2];
        place_of_edge(squares, edge, xy);
        pp_curve_add_point(&curve, xy);
        int next = squares->next[edge];
        squares->next[edge] = -1;
        edge = next;
    }
    if (curve.count < 2 || (curve.closed && curve.count < 3)
        || pp_curve_length(&curve) < shortest) {
        free(curve.xy);
        return PP_OK;
    }
    return pp_curve_list_add(lines, curve, err);
}

static enum pp_status trace_iso_lines(struct squares *squares, double shortest,
                                      struct pp_curve_list *lines, struct pp_error *err)
{
    const struct log_picture *field = squares->field;
    int edges = 2 * field->width * field->height;
    for (int i = 0; i < edges; i++) {
        squares->next[i] = -1;
        squares->entered[i] = false;
    }
    for (int y = 0; y + 1 < field->height; y++)
        for (int x = 0; x + 1 < field->width; x++)
            cross_square(squares, x, y);
    enum pp_status status = PP_OK;
    for (int i = 0; i < edges && status == PP_OK; i++)
        if (squares->next[i] >= 0 && !squares->entered[i])
            status = take_iso_line(squares, i, shortest, lines, err);
    for (int i = 0; i < edges && status == PP_OK; i++)
        if (squares->next[i] >= 0)
            status = take_iso_line(squares, i, shortest, lines, err);
    return status;
}

enum pp_status pp_iso_lines(struct pp_curve_list *lines,
                            const struct pp_picture *picture, const int *tags,
                            double unit, const double *levels, int count, double smooth,
                            double shortest, struct pp_error *err)
{
    struct log_picture field;
    enum pp_status status = make_field(&field, picture, tags, unit, smooth, err);
    if (status != PP_OK)
        return status;
    size_t edges = 2 * (size_t)picture->width * (size_t)picture->height;
    struct squares squares = {&field, 0.0, malloc(edges * sizeof *squares.next),
                              malloc(edges * sizeof *squares.entered)};
    if (!squares.next || !squares.entered)
        status = pp_fail_memory(err);
    for (int i = 0; i < count && status == PP_OK; i++) {
        int before = lines->count;
        squares.level = log(levels[i]);
        status = trace_iso_lines(&squares, shortest, lines, err);
        for (int k = before; k < lines->count; k++)
            lines->list[k].level = levels[i];
    }
    free(squares.next);
    free(squares.entered);
    free(field.logs);
    return status;
}
