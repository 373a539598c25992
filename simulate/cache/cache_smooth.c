/* cache_smooth.c - the least-squares fit of each record to its neighbours. */
#include "simulate/cache/cache_smooth.h"

#include <math.h>
#include <stdlib.h>

/* Neighbours are nearer than this many radii. Chosen by trial, as are the next two. */
static const double NEAR = 2.0;

/* A neighbour is an outlier if its difference from the expected value exceeds this many
 * times the noise of both. */
static const double OUTLIER = 4.0;

/* A neighbour has no weight if, over its distance, curvature may cause a departure from
 * a linear change of this many times the noise. */
static const double MOST_DEPARTURE = 10.0;

/* Lower limit of the ratio of the gradient's noise (times the radius) to the value's
 * noise; its inverse is the upper limit. */
static const double LEAST_NOISE = 1e-3;

/* The fit of one record. */
struct fit {
    const struct pp_cache_layer *layer;
    const struct pp_cache_entry *entry;
    int number;         /* index of the record */
    int *met;           /* last fit that used each record, so that a neighbour counts
                         * once */
    double matrix[6];   /* symmetric: 00 01 02 11 12 22; unknowns E, R dE/da, R dE/db */
    double right[3][3]; /* by channel */
};

static void add_equation(struct fit *fit, double weight, const double row[3],
                         struct pp_rgb says)
{
    const double channels[3] = {says.r, says.g, says.b};
    for (int i = 0, at = 0; i < 3; i++) {
        for (int k = i; k < 3; k++)
            fit->matrix[at++] += weight * row[i] * row[k];
        for (int c = 0; c < 3; c++)
            fit->right[c][i] += weight * row[i] * channels[c];
    }
}

/* The irradiance that a surface with normal n would receive at the record's place. */
static struct pp_rgb turned_to(const struct pp_cache_record *is, struct pp_vec3 n)
{
    struct pp_vec3 turn = pp_vec_sub(n, is->normal);
    return pp_rgb(is->value.r + pp_vec_dot(is->turned[0], turn),
                  is->value.g + pp_vec_dot(is->turned[1], turn),
                  is->value.b + pp_vec_dot(is->turned[2], turn));
}

static struct pp_cache_place record_place(const struct pp_cache_record *is)
{
    return (struct pp_cache_place){is->point, is->normal, is->space};
}

static void add_neighbour(void *context, int record)
{
    struct fit *fit = context;
    if (record == fit->number || fit->met[record] == fit->number)
        return;
    fit->met[record] = fit->number;
    const struct pp_cache_entry *other = &fit->layer->entries[record];
    const struct pp_cache_record *is = &fit->entry->is;
    const struct pp_cache_record_settings *settings = &fit->layer->settings;
    struct pp_cache_place here = record_place(is), there = record_place(&other->is);
    double distance = fmax(pp_cache_entry_distance(fit->entry, &there, INFINITY),
                           pp_cache_entry_distance(other, &here, INFINITY));
    if (!(distance < NEAR))
        return;
    double radius = is->radii_m[0];
    double departure = 0.5 * fit->entry->curvature * radius * radius * distance
                       * distance / settings->noise;
    if (!(departure < MOST_DEPARTURE))
        return;
    double spread2 = 1.0 + departure * departure;
    struct pp_rgb says = turned_to(&other->is, is->normal);
    double expected = pp_rgb_luminance(pp_cache_entry_read(fit->entry, &there));
    double off = fabs(pp_rgb_luminance(says) - expected)
                 / (settings->noise * pp_rgb_luminance(is->value));
    struct pp_vec3 away = pp_vec_sub(other->is.point, is->point);
    double steep = pp_vec_length(away) * fit->entry->along_noise;
    if (!(off * off < OUTLIER * OUTLIER * (spread2 + 1.0 + steep * steep)))
        return;
    const double row[3] = {1.0, pp_vec_dot(away, fit->entry->a) / radius,
                           pp_vec_dot(away, fit->entry->b) / radius};
    add_equation(fit, 1.0 / spread2, row, says);
}

/* Solves the fit for one channel by Cholesky's method. The matrix is never singular,
 * since it contains the record's own equations. */
static void solve(const double m[6], const double right[3], double x[3])
{
    double l00 = sqrt(m[0]), l10 = m[1] / l00, l20 = m[2] / l00;
    double l11 = sqrt(m[3] - l10 * l10), l21 = (m[4] - l20 * l10) / l11;
    double l22 = sqrt(m[5] - l20 * l20 - l21 * l21);
    double y0 = right[0] / l00, y1 = (right[1] - l10 * y0) / l11;
    double y2 = (right[2] - l20 * y0 - l21 * y1) / l22;
    x[2] = y2 / l22;
    x[1] = (y1 - l21 * x[2]) / l11;
    x[0] = (y0 - l10 * x[1] - l20 * x[2]) / l00;
}

static void smooth(struct fit *fit, struct pp_cache_entry *entry)
{
    const struct pp_cache_record *is = &entry->is;
    double radius = is->radii_m[0], x[3][3];
    double noise = entry->along_noise * radius;
    double sure = 1.0 / fmin(fmax(noise, LEAST_NOISE), 1.0 / LEAST_NOISE);
    pp_cache_entry_unsmooth(entry);
    for (int i = 0; i < 3; i++) {
        const double row[3] = {i == 0, i == 1, i == 2};
        const struct pp_vec3 axis = i == 1 ? entry->a : entry->b;
        add_equation(fit, i == 0 ? 1.0 : sure * sure, row,
                     i == 0 ? is->value
                            : pp_rgb_scale(pp_rgb(pp_vec_dot(is->along[0], axis),
                                                  pp_vec_dot(is->along[1], axis),
                                                  pp_vec_dot(is->along[2], axis)),
                                           radius));
    }
    double slow = fit->layer->settings.noise * fit->layer->settings.most_m / radius;
    fit->matrix[3] += slow * slow;
    fit->matrix[5] += slow * slow;
    pp_cache_octree_visit_near(&fit->layer->tree, is->point,
                               NEAR * fmax(is->radii_m[0], is->radii_m[1]),
                               add_neighbour, fit);
    for (int c = 0; c < 3; c++) {
        solve(fit->matrix, fit->right[c], x[c]);
        entry->along[c] = pp_vec_along(pp_vec_scale(entry->a, x[c][1] / radius),
                                       x[c][2] / radius, entry->b);
    }
    entry->value = pp_rgb(fmax(x[0][0], 0.0), fmax(x[1][0], 0.0), fmax(x[2][0], 0.0));
}

/* Records that the pool's workers fit; each fit reads the others' original values. */
struct fitting {
    struct pp_cache_layer *layer;
    int *met; /* records met in a fit, by worker */
};

static bool fit_one(void *data, int worker, int i)
{
    const struct fitting *fitting = data;
    struct pp_cache_layer *layer = fitting->layer;
    struct pp_cache_entry *entry = &layer->entries[i];
    struct fit fit = {.layer = layer,
                      .entry = entry,
                      .number = i,
                      .met =
                          fitting->met + (size_t)worker * (size_t)layer->entry_count};
    if (entry->is.radii_m[0] > 0.0 && pp_rgb_luminance(entry->is.value) > 0.0)
        smooth(&fit, entry);
    return true;
}

enum pp_status pp_cache_smooth_layer(struct pp_cache_layer *layer,
                                     struct pp_thread_pool *pool, struct pp_error *err)
{
    size_t count = (size_t)layer->entry_count * (size_t)pp_thread_pool_size(pool);
    struct fitting fitting = {layer, malloc((count + 1) * sizeof *fitting.met)};
    if (!fitting.met)
        return pp_fail_memory(err);
    for (size_t i = 0; i < count; i++)
        fitting.met[i] = -1;
    pp_thread_pool_run_small(pool, 0, layer->entry_count, fit_one, &fitting);
    free(fitting.met);
    return PP_OK;
}
