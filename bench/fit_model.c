/* fit_model.c - value and derivatives of the model, and the fit. */
#include "bench/fit_model.h"

#include <math.h>
#include <string.h>

static double length_of(enum pp_fit_range range, const struct pp_fit_opening *o)
{
    switch (range) {
    case PP_FIT_ROOT:
        return sqrt(o->w_r * o->h_r);
    case PP_FIT_HEIGHT:
        return o->h_r;
    default:
        return 2.0 * o->w_r * o->h_r / (o->w_r + o->h_r);
    }
}

/* Product f_d f_s of the decreases with depth and sideways (fit_model.h). */
static double place_of(const struct pp_fit_model *model, const struct pp_fit_opening *o,
                       double k, double s, double c)
{
    double each = pow(1.0 - o->R, model->power) / length_of(model->range, o);
    double q = k * o->d_r * each, u = o->x / o->d_r, f = 1.0;
    if (model->shape == PP_FIT_EXPONENTIAL)
        f = q * exp(-q * u) / (1.0 - exp(-q));
    else if (model->shape == PP_FIT_COSH)
        f = q * (exp(-q * u) + exp(-q * (2.0 - u))) / (1.0 - exp(-2.0 * q));
    else if (model->shape == PP_FIT_INSIDE) {
        q -= c * pow(1.0 - o->R, model->power);
        double m = fmax(fabs(q), 0.001);
        f = m * exp(-q * u + (q - m) / 2.0) / (1.0 - exp(-m));
    }
    if (model->side == PP_FIT_ALIKE)
        return f;
    double breadth = model->side == PP_FIT_WALL ? o->w_r : fmax(o->w_r - o->w, 0.0);
    double q_s = fmax(s * breadth * each, 1e-6);
    return f * q_s * exp(-2.0 * q_s * o->y / o->w_r) / (1.0 - exp(-q_s));
}

/* The source, with its parts reduced by the obstructions. */
static double source_of(const struct pp_fit_model *model,
                        const struct pp_fit_opening *o, const double *value)
{
    const double *part = o->source[model->source], b = value[PP_FIT_SHADE_B];
    double g = model->shade == PP_FIT_OWN_SHADE   ? value[PP_FIT_SHADE_G]
               : model->shade == PP_FIT_ONE_SHADE ? b
                                                  : b / 2.0;
    double up = model->upward ? value[PP_FIT_UPWARD_U] : 1.0;
    return part[0] + part[1] * pow(o->v, b)
           + part[2] * pow(up, model->fading ? 1.0 - o->R : 1.0) * pow(o->v, g);
}

static double terms_of(const struct pp_fit_model *model, const struct pp_fit_opening *o)
{
    double sum = 0.0;
    for (int j = 0; j < model->count; j++)
        sum += model->value[PP_FIT_FIRST_TERM + j] * o->term[model->terms[j]];
    return exp(sum);
}

double pp_fit_model_value(const struct pp_fit_model *model,
                          const struct pp_fit_row *row)
{
    const double *value = model->value;
    double sum = 0.0;
    for (int i = 0; i < row->count; i++) {
        const struct pp_fit_opening *o = row->openings + i;
        sum += source_of(model, o, value) * terms_of(model, o)
               * (row->average ? 1.0
                               : place_of(model, o, value[PP_FIT_DEPTH_K],
                                          value[PP_FIT_SIDE_S], value[PP_FIT_START_C]));
    }
    return sum;
}

/* Logarithm of the value, and its derivatives with respect to the parameters. */
static double derive(const struct pp_fit_model *model, const struct pp_fit_row *row,
                     double slope[PP_FIT_PARAMETERS])
{
    const double step = 1e-5, *value = model->value;
    double k = value[PP_FIT_DEPTH_K], s = value[PP_FIT_SIDE_S],
           c = value[PP_FIT_START_C];
    double sum = 0.0;
    memset(slope, 0, PP_FIT_PARAMETERS * sizeof *slope);
    for (int i = 0; i < row->count; i++) {
        const struct pp_fit_opening *o = row->openings + i;
        double terms = terms_of(model, o), source = source_of(model, o, value), f = 1.0;
        if (!row->average) {
            f = place_of(model, o, k, s, c);
            double in_step = source * terms / step;
            slope[PP_FIT_DEPTH_K] += in_step * (place_of(model, o, k + step, s, c) - f);
            slope[PP_FIT_SIDE_S] += in_step * (place_of(model, o, k, s + step, c) - f);
            slope[PP_FIT_START_C] += in_step * (place_of(model, o, k, s, c + step) - f);
        }
        double in_step = terms * f / step;
        for (int j = PP_FIT_SHADE_B; j <= PP_FIT_UPWARD_U; j++) {
            double stepped[PP_FIT_PARAMETERS];
            memcpy(stepped, value, sizeof stepped);
            stepped[j] += step;
            slope[j] += in_step * (source_of(model, o, stepped) - source);
        }
        double power = source * terms * f;
        sum += power;
        for (int j = 0; j < model->count; j++)
            slope[PP_FIT_FIRST_TERM + j] += power * o->term[model->terms[j]];
    }
    for (int j = 0; j < PP_FIT_PARAMETERS; j++)
        slope[j] /= sum;
    return log(sum);
}

static double truth_of(const struct pp_fit_model *model, const struct pp_fit_row *row)
{
    return model->of_df ? row->df : row->irc;
}

static bool takes_part(const struct pp_fit_model *model, const struct pp_fit_row *row)
{
    bool average = model->shape == PP_FIT_EVEN && model->side == PP_FIT_ALIKE;
    return row->average == average && isfinite(log(truth_of(model, row)));
}

/* Residuals at dark points count 1.5 times (squared), since formulae are mostly used
 * for dark points. */
static double weight_of(const struct pp_fit_row *row, int times)
{
    return times * row->weight * row->weight * (row->dark ? 2.25 : 1.0);
}

static double cost_of(const struct pp_fit_model *model,
                      const struct pp_fit_rooms *rooms, const int *times)
{
    double sum = 0.0;
    for (int i = 0; i < rooms->count; i++) {
        const struct pp_fit_row *row = rooms->rows + i;
        if ((times && times[i] == 0) || !takes_part(model, row))
            continue;
        double figure = pp_fit_model_value(model, row), truth = truth_of(model, row);
        double off = log(figure / truth), by = model->differ * 100.0 * (figure - truth);
        sum += weight_of(row, times ? times[i] : 1) * (off * off + by * by);
    }
    return sum;
}

/* Solves a x = b for n equations by elimination with partial pivoting. */
static void solve(int n, double a[PP_FIT_PARAMETERS][PP_FIT_PARAMETERS + 1])
{
    for (int i = 0; i < n; i++) {
        int best = i;
        for (int k = i + 1; k < n; k++)
            if (fabs(a[k][i]) > fabs(a[best][i]))
                best = k;
        for (int k = 0; k <= n; k++) {
            double kept = a[i][k];
            a[i][k] = a[best][k];
            a[best][k] = kept;
        }
        for (int k = 0; k < n; k++) {
            double factor = k == i ? 0.0 : a[k][i] / a[i][i];
            for (int j = i; j <= n && factor != 0.0; j++)
                a[k][j] -= factor * a[i][j];
        }
    }
    for (int i = 0; i < n; i++)
        a[i][n] /= a[i][i];
}

/* Normal equations at the present parameters. */
static void normal(const struct pp_fit_model *model, const struct pp_fit_rooms *rooms,
                   const int *times, double a[PP_FIT_PARAMETERS][PP_FIT_PARAMETERS],
                   double b[PP_FIT_PARAMETERS])
{
    memset(a, 0, PP_FIT_PARAMETERS * sizeof *a);
    memset(b, 0, PP_FIT_PARAMETERS * sizeof *b);
    for (int i = 0; i < rooms->count; i++) {
        const struct pp_fit_row *row = rooms->rows + i;
        double slope[PP_FIT_PARAMETERS];
        if ((times && times[i] == 0) || !takes_part(model, row))
            continue;
        double truth = truth_of(model, row), ratio = derive(model, row, slope);
        double off = ratio - log(truth), figure = exp(ratio);
        double of_figure = model->differ * 100.0 * figure,
               by = model->differ * 100.0 * (figure - truth);
        double weight = weight_of(row, times ? times[i] : 1);
        for (int j = 0; j < PP_FIT_PARAMETERS; j++) {
            b[j] -= weight * slope[j] * (off + of_figure * by);
            for (int k = 0; k < PP_FIT_PARAMETERS; k++)
                a[j][k] += weight * slope[j] * slope[k] * (1.0 + of_figure * of_figure);
        }
    }
}

/* Makes one damped step. The damping grows until the step reduces the cost; false if no
 * step does, or if it no longer matters. */
static bool step_on(struct pp_fit_model *model, const struct pp_fit_rooms *rooms,
                    const int *times, double *damping, double *cost)
{
    double a[PP_FIT_PARAMETERS][PP_FIT_PARAMETERS], b[PP_FIT_PARAMETERS];
    int free_ones[PP_FIT_PARAMETERS], n = 0;
    if (!model->held && model->shape != PP_FIT_EVEN)
        free_ones[n++] = PP_FIT_DEPTH_K;
    if (!model->held && model->shape == PP_FIT_INSIDE)
        free_ones[n++] = PP_FIT_START_C;
    if (!model->held && model->side != PP_FIT_ALIKE)
        free_ones[n++] = PP_FIT_SIDE_S;
    if (!model->held && model->source >= PP_FIT_SPHERE_NOW) {
        free_ones[n++] = PP_FIT_SHADE_B;
        if (model->shade == PP_FIT_OWN_SHADE)
            free_ones[n++] = PP_FIT_SHADE_G;
    }
    if (model->upward)
        free_ones[n++] = PP_FIT_UPWARD_U;
    for (int j = 0; j < model->count; j++)
        free_ones[n++] = PP_FIT_FIRST_TERM + j;
    normal(model, rooms, times, a, b);
    for (int turn = 0; turn < 8; turn++) {
        double system[PP_FIT_PARAMETERS][PP_FIT_PARAMETERS + 1];
        struct pp_fit_model next = *model;
        for (int j = 0; j < n; j++) {
            for (int k = 0; k < n; k++)
                system[j][k] = a[free_ones[j]][free_ones[k]];
            system[j][j] *= 1.0 + *damping;
            system[j][j] += 1e-9;
            system[j][n] = b[free_ones[j]];
        }
        solve(n, system);
        for (int j = 0; j < n; j++)
            next.value[free_ones[j]] += system[j][n];
        double now = cost_of(&next, rooms, times);
        if (now < *cost) {
            bool worth_it = now < *cost * (1.0 - 1e-7);
            *model = next;
            *cost = now;
            *damping /= 5.0;
            return worth_it;
        }
        *damping *= 8.0;
    }
    return false;
}

void pp_fit_model_fit(struct pp_fit_model *model, const struct pp_fit_rooms *rooms,
                      const int *times)
{
    double damping = 1e-4, cost = cost_of(model, rooms, times);
    for (int i = 0; i < 30; i++)
        if (!step_on(model, rooms, times, &damping, &cost))
            return;
}

void pp_fit_model_note(struct pp_fit_error *error, double figure, double truth)
{
    double ratio = log(figure / truth);
    error->count++;
    error->log += ratio * ratio;
    error->relative += (figure / truth - 1.0) * (figure / truth - 1.0);
    error->absolute += 1e4 * (figure - truth) * (figure - truth);
    error->bias += ratio;
}
