/* hidden_outline.c - outlines the sky that cones hide.
 *
 * At one bearing, a half-space n contains the altitudes a with
 *
 *     n.h cos a + n_z sin a >= 0
 *
 *   h  horizontal unit vector in the direction of the bearing
 *
 * so that each half-space bounds the hidden altitudes from below or from above, and a
 * cone hides one span of altitudes. The spans of all cones are merged at equal steps of
 * bearing, and where a protruding cone ends between two steps. Overlapping spans at
 * neighbouring bearings are then joined.
 */
#include "methods/exact/hidden_outline.h"

#include <math.h>
#include <stdlib.h>

#include "model/base/array.h"

#define STEP_RAD (0.25 * PP_RAD)
#define END_RAD (0.001 * PP_RAD)
#define SAME_RAD 1e-6 /* spans with a smaller gap are merged */

enum { STEPS = 1440 };

/* Hidden altitudes at a bearing, from low to high: of one cone, or of all together. */
struct hidden_span {
    double low, high;
    int cone;
};

struct hidden_spans {
    int count, capacity;
    struct hidden_span *list;
};

struct sky_column {
    double bearing;
    struct hidden_spans hidden;
};

struct sky_outline {
    const struct pp_hidden_cones *cones;
    double north_rad;
    struct hidden_spans single[STEPS + 1]; /* spans of the individual cones, at each
                                            * step */
    struct sky_column *columns;            /* all columns; those of the steps first */
    int column_count;
};

/* ---- spans ---- */

static enum pp_status add_span(struct hidden_spans *spans, struct hidden_span span,
                               struct pp_error *err)
{
    enum pp_status status = pp_array_reserve(
        &spans->list, &spans->capacity, spans->count + 1, sizeof *spans->list, err);
    if (status == PP_OK)
        spans->list[spans->count++] = span;
    return status;
}

static int by_low(const void *left, const void *right)
{
    const struct hidden_span *a = left, *b = right;
    return (a->low > b->low) - (a->low < b->low);
}

/* Merges spans that touch or overlap. */
static void merge(struct hidden_spans *spans)
{
    int count = 0;
    if (spans->count > 0)
        qsort(spans->list, (size_t)spans->count, sizeof *spans->list, by_low);
    for (int i = 0; i < spans->count; i++) {
        struct hidden_span *last = count > 0 ? &spans->list[count - 1] : NULL;
        if (last && spans->list[i].low <= last->high + SAME_RAD)
            last->high = fmax(last->high, spans->list[i].high);
        else
            spans->list[count++] = spans->list[i];
    }
    spans->count = count;
}

static bool is_within(struct hidden_span span, const struct hidden_spans *merged)
{
    for (int i = 0; i < merged->count; i++)
        if (span.low >= merged->list[i].low - SAME_RAD
            && span.high <= merged->list[i].high + SAME_RAD)
            return true;
    return false;
}

/* ---- cones ---- */

/* Finds the altitudes that a cone hides in the horizontal direction h. Returns false if
 * there are none. */
static bool hidden_towards(struct hidden_span *span,
                           const struct pp_hidden_cones *cones, int cone,
                           struct pp_vec3 h)
{
    *span = (struct hidden_span){0.0, 0.5 * PP_PI, cone};
    for (int i = cone > 0 ? cones->list[cone - 1].end : 0; i < cones->list[cone].end;
         i++) {
        double level = pp_vec_dot(cones->half_spaces[i], h);
        double up = cones->half_spaces[i].z;
        if (level >= 0.0 && up >= 0.0)
            continue;
        if (level < 0.0 && up <= 0.0)
            return false;
        if (level >= 0.0)
            span->high = fmin(span->high, atan2(level, -up));
        else
            span->low = fmax(span->low, atan2(-level, up));
    }
    return span->high - span->low > 1e-9;
}

static struct pp_vec3 towards(const struct sky_outline *outline, double bearing)
{
    double angle = bearing - outline->north_rad;
    return pp_vec(sin(angle), cos(angle), 0.0);
}

static bool hidden_at(struct hidden_span *span, const struct sky_outline *outline,
                      int cone, double bearing)
{
    return hidden_towards(span, outline->cones, cone, towards(outline, bearing));
}

/* Finds the span of each cone at each step. */
static enum pp_status find_single(struct sky_outline *outline, struct pp_error *err)
{
    enum pp_status status = PP_OK;
    for (int i = 0; i <= STEPS && status == PP_OK; i++) {
        struct pp_vec3 h = towards(outline, i * STEP_RAD);
        for (int c = 0; c < outline->cones->count && status == PP_OK; c++) {
            struct hidden_span span;
            if (hidden_towards(&span, outline->cones, c, h))
                status = add_span(&outline->single[i], span, err);
        }
    }
    return status;
}

/* ---- columns ---- */

/* Adds a column at a bearing: the merged spans there of all cones that hide something
 * at step `step` or, if the bearing is between steps, at this or the next step. */
static enum pp_status add_sky_column(struct sky_outline *outline, double bearing,
                                     int step, struct pp_error *err)
{
    enum pp_status status = pp_array_append(&outline->columns, outline->column_count,
                                            sizeof *outline->columns, err);
    if (status != PP_OK)
        return status;
    struct sky_column *column = &outline->columns[outline->column_count++];
    *column = (struct sky_column){.bearing = bearing};
    bool on_step = bearing == step * STEP_RAD;
    for (int k = 0; k < (on_step ? 1 : 2) && status == PP_OK; k++)
        for (int i = 0; i < outline->single[step + k].count && status == PP_OK; i++) {
            struct hidden_span span = outline->single[step + k].list[i];
            if (on_step || hidden_at(&span, outline, span.cone, bearing))
                status = add_span(&column->hidden, span, err);
        }
    merge(&column->hidden);
    return status;
}

/* Bisects between a bearing at which a cone hides something and one at which it does
 * not, to END_RAD. ends: the last hidden and the last clear bearing. */
static void end_between(double ends[2], const struct sky_outline *outline, int cone,
                        double hidden, double clear)
{
    struct hidden_span span;
    while (fabs(clear - hidden) > END_RAD) {
        double middle = 0.5 * (hidden + clear);
        if (hidden_at(&span, outline, cone, middle))
            hidden = middle;
        else
            clear = middle;
    }
    ends[0] = hidden;
    ends[1] = clear;
}

/* Adds columns where a cone begins or ends between a step and the next, unless the
 * other cones hide the sky there. The spans of a step are ordered by cone. */
static enum pp_status add_ends(struct sky_outline *outline, int step,
                               struct pp_error *err)
{
    const struct hidden_spans *sides[2] = {&outline->single[step],
                                           &outline->single[step + 1]};
    enum pp_status status = PP_OK;
    for (int here = 0; here < 2; here++) {
        const struct hidden_spans *there = sides[1 - here];
        for (int i = 0, k = 0; i < sides[here]->count && status == PP_OK; i++) {
            int cone = sides[here]->list[i].cone;
            while (k < there->count && there->list[k].cone < cone)
                k++;
            if (k < there->count && there->list[k].cone == cone)
                continue;
            double ends[2];
            struct hidden_span span;
            end_between(ends, outline, cone, (step + here) * STEP_RAD,
                        (step + 1 - here) * STEP_RAD);
            if (hidden_at(&span, outline, cone, ends[0])
                && is_within(span, &outline->columns[step].hidden)
                && is_within(span, &outline->columns[step + 1].hidden))
                continue;
            for (int end = 0; end < 2 && status == PP_OK; end++)
                if (ends[end] > step * STEP_RAD && ends[end] < (step + 1) * STEP_RAD)
                    status = add_sky_column(outline, ends[end], step, err);
        }
    }
    return status;
}

static int by_bearing(const void *left, const void *right)
{
    const struct sky_column *a = left, *b = right;
    return (a->bearing > b->bearing) - (a->bearing < b->bearing);
}

static enum pp_status find_columns(struct sky_outline *outline, struct pp_error *err)
{
    enum pp_status status = PP_OK;
    for (int i = 0; i <= STEPS && status == PP_OK; i++)
        status = add_sky_column(outline, i * STEP_RAD, i, err);
    for (int i = 0; i < STEPS && status == PP_OK; i++)
        status = add_ends(outline, i, err);
    if (status == PP_OK)
        qsort(outline->columns, (size_t)outline->column_count, sizeof *outline->columns,
              by_bearing);
    return status;
}

/* ---- pieces ---- */

static enum pp_status begin_piece(struct pp_sky_mask *mask, struct pp_error *err)
{
    enum pp_status status =
        pp_array_append(&mask->pieces, mask->count, sizeof *mask->pieces, err);
    if (status == PP_OK)
        mask->pieces[mask->count++] = (struct pp_sky_mask_piece){0};
    return status;
}

static enum pp_status add_outline_edge(struct pp_sky_mask_piece *piece, double bearing,
                                       const struct hidden_span *span,
                                       struct pp_error *err)
{
    enum pp_status status = pp_array_reserve(
        &piece->edges, &piece->capacity, piece->count + 1, sizeof *piece->edges, err);
    if (status != PP_OK)
        return status;
    double *edge = piece->edges[piece->count++];
    edge[0] = bearing;
    edge[1] = span->low;
    edge[2] = span->high;
    return PP_OK;
}

static bool meet(const struct hidden_span *a, const struct hidden_span *b)
{
    return a->low <= b->high && b->low <= a->high;
}

/* Number of spans that overlap this one; *which: the index of the last. */
static int count_meeting(const struct hidden_spans *spans,
                         const struct hidden_span *span, int *which)
{
    int count = 0;
    for (int i = 0; i < spans->count; i++)
        if (meet(&spans->list[i], span)) {
            *which = i;
            count++;
        }
    return count;
}

/* Where one span becomes several, or several become one, adds a piece for each
 * overlapping pair. */
static enum pp_status bridge(struct pp_sky_mask *mask, const struct sky_column *a,
                             const struct sky_column *b, const struct hidden_span *to,
                             struct pp_error *err)
{
    enum pp_status status = PP_OK;
    for (int i = 0; i < a->hidden.count && status == PP_OK; i++) {
        if (!meet(&a->hidden.list[i], to))
            continue;
        status = begin_piece(mask, err);
        if (status == PP_OK)
            status = add_outline_edge(&mask->pieces[mask->count - 1], a->bearing,
                                      &a->hidden.list[i], err);
        if (status == PP_OK)
            status =
                add_outline_edge(&mask->pieces[mask->count - 1], b->bearing, to, err);
    }
    return status;
}

/* Extends the pieces by one column, and begins new ones. From here on, a span's `cone`
 * is the index of the piece that it extends. */
static enum pp_status join_mask_columns(struct pp_sky_mask *mask,
                                        const struct sky_column *before,
                                        struct sky_column *column, struct pp_error *err)
{
    enum pp_status status = PP_OK;
    for (int i = 0; i < column->hidden.count && status == PP_OK; i++) {
        struct hidden_span *span = &column->hidden.list[i];
        int from = 0, back = 0;
        bool goes_on =
            before && count_meeting(&before->hidden, span, &from) == 1
            && count_meeting(&column->hidden, &before->hidden.list[from], &back) == 1;
        if (goes_on) {
            span->cone = before->hidden.list[from].cone;
        } else {
            if (before)
                status = bridge(mask, before, column, span, err);
            if (status == PP_OK)
                status = begin_piece(mask, err);
            span->cone = mask->count - 1;
        }
        if (status == PP_OK)
            status =
                add_outline_edge(&mask->pieces[span->cone], column->bearing, span, err);
    }
    return status;
}

enum pp_status pp_hidden_outline_add(struct pp_sky_mask *mask,
                                     const struct pp_hidden_cones *cones,
                                     double north_rad, struct pp_error *err)
{
    struct sky_outline *outline = calloc(1, sizeof *outline);
    if (!outline)
        return pp_fail_memory(err);
    outline->cones = cones;
    outline->north_rad = north_rad;
    enum pp_status status = find_single(outline, err);
    if (status == PP_OK)
        status = find_columns(outline, err);
    for (int i = 0; i < outline->column_count && status == PP_OK; i++)
        status = join_mask_columns(mask, i > 0 ? &outline->columns[i - 1] : NULL,
                                   &outline->columns[i], err);
    for (int i = 0; i < outline->column_count; i++)
        free(outline->columns[i].hidden.list);
    for (int i = 0; i <= STEPS; i++)
        free(outline->single[i].list);
    free(outline->columns);
    free(outline);
    return status;
}
