/* set_effects.c - effects of sets of causes: simulated, or predicted from their
 * parts. */
#include "studies/research/compare/set_effects.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/array.h"

/* Effect of a simulated set, without a common factor. */
struct pp_known_set {
    int causes[PP_CAUSE_SEARCH_MOST], count;
    bool makes_sense;
    double *effect, *variance;
    /* For a cause with a fitted value: effects in the middle and at the upper end of
     * its range; `effect` is at the lower end. NULL: no such cause. */
    double *middle, *most;
};

/* Uncertainty of the effect of a pair of causes that is not simulated, as fractions of
 * the smaller effect of the two. OFF_SHARE: greatest deviation, up or down, from the
 * sum of both effects; it is about equal at all points. OFF_SHARE_AT_A_POINT: further
 * deviation at single points; also the deviation of three causes from the sum of their
 * pairs. */
static const double OFF_SHARE = 0.6, OFF_SHARE_AT_A_POINT = 0.1;
/* Causes with a smaller effect (root mean square of logarithms) are not considered. */
static const double LEAST_EFFECT = 0.001;
/* Standard deviation that is added to the noise when the uncertainty of a fitted value
 * is calculated. */
static const double LEAST_NOISE = 0.003;
/* Number of steps of the golden section search for a fitted value, and number of equal
 * steps of its range to which the value is rounded. */
enum { FIT_STEPS = 16, LEVELS = 800 };
static const struct pp_known_set *find_known_set(const struct pp_set_effects *effects,
                                                 const int *causes, int count)
{
    for (int i = 0; i < effects->known_count; i++)
        if (effects->known[i].count == count
            && memcmp(effects->known[i].causes, causes, (size_t)count * sizeof *causes)
                   == 0)
            return &effects->known[i];
    return NULL;
}

bool pp_set_effects_are_known(const struct pp_set_effects *effects, const int *causes,
                              int count)
{
    return find_known_set(effects, causes, count) != NULL;
}

bool pp_set_effects_has_fitted(const struct pp_set_effects *effects, const int *causes,
                               int count)
{
    for (int i = 0; i < count; i++)
        if (pp_causes_is_fitted(effects->question->causes[causes[i]]))
            return true;
    return false;
}

/* True if a single cause has an effect. A cause with a fitted value has one if the
 * effects at the ends of its range differ. */
static bool is_felt(const struct pp_known_set *known, int points)
{
    double sum = 0.0;
    for (int i = 0; i < points; i++) {
        double does = known->effect[i] - (known->most ? known->most[i] : 0.0);
        sum += does * does;
    }
    return sum > points * LEAST_EFFECT * LEAST_EFFECT;
}

enum pp_status pp_set_effects_trace(struct pp_set_effects *effects, const int *causes,
                                    int count, struct pp_error *err)
{
    const struct pp_cause_search_question *question = effects->question;
    int points = question->data.count;
    if (pp_array_append(&effects->known, effects->known_count, sizeof *effects->known,
                        err)
        != PP_OK)
        return PP_SYSTEM;
    struct pp_known_set *known = &effects->known[effects->known_count];
    *known = (struct pp_known_set){.count = count, .makes_sense = true};
    memcpy(known->causes, causes, (size_t)count * sizeof *causes);
    known->effect = calloc(4 * (size_t)points + 1, sizeof *known->effect);
    if (!known->effect)
        return pp_fail_memory(err);
    known->variance = known->effect + points;
    effects->known_count++;
    struct pp_error own = {0};
    enum pp_status status = PP_OK;
    if (pp_set_effects_has_fitted(effects, causes, count)) {
        known->middle = known->variance + points;
        known->most = known->middle + points;
        status = question->trace(question->tracer, causes, count, PP_CAUSES_VALUE_MOST,
                                 known->most, known->variance, &own);
        if (status == PP_OK)
            status = question->trace(question->tracer, causes, count,
                                     0.5 * PP_CAUSES_VALUE_MOST, known->middle,
                                     known->variance, &own);
    }
    if (status == PP_OK)
        status = question->trace(question->tracer, causes, count, 0.0, known->effect,
                                 known->variance, &own);
    known->makes_sense = status == PP_OK && (count != 1 || is_felt(known, points));
    if (status == PP_OK || status == PP_BAD_INPUT)
        return PP_OK;
    return pp_fail(err, status, "%s", own.message);
}

/* Effect at level t of a fitted value: a parabola through the three simulated
 * levels. */
static double effect_at(const struct pp_known_set *known, int point, double t)
{
    if (!known->most)
        return known->effect[point];
    return (1.0 - t) * (1.0 - 2.0 * t) * known->effect[point]
           + 4.0 * t * (1.0 - t) * known->middle[point]
           + t * (2.0 * t - 1.0) * known->most[point];
}

static double smaller(double a, double b)
{
    return fmin(fabs(a), fabs(b));
}

/* Deviation of a pair's effect at a point from the sum of both effects, simulated or
 * assumed. Adds the uncertainty of this deviation to *slack. */
static double together(const struct pp_set_effects *effects,
                       const struct pp_known_set *a, const struct pp_known_set *b,
                       int point, double off, double level, double *slack)
{
    int pair[] = {a->causes[0], b->causes[0]};
    const struct pp_known_set *both = find_known_set(effects, pair, 2);
    double of_a = effect_at(a, point, level), of_b = effect_at(b, point, level);
    if (both && both->makes_sense)
        return effect_at(both, point, level) - of_a - of_b;
    *slack += OFF_SHARE_AT_A_POINT * smaller(of_a, of_b);
    return off * OFF_SHARE * smaller(of_a, of_b);
}

static void predict_known(struct pp_set_effects *effects,
                          const struct pp_known_set *known, double level)
{
    for (int i = 0; i < effects->question->data.count; i++) {
        effects->effect[i] = effect_at(known, i, level);
        effects->variance[i] = known->variance[i];
        effects->slack[i] = 0.0;
    }
}

bool pp_set_effects_predict(struct pp_set_effects *effects, const int *causes,
                            int count, double off, double level)
{
    const struct pp_known_set *part[PP_CAUSE_SEARCH_MOST],
        *known = find_known_set(effects, causes, count);
    if (known) {
        predict_known(effects, known, level);
        return known->makes_sense;
    }
    for (int k = 0; k < count; k++) {
        part[k] = find_known_set(effects, &causes[k], 1);
        if (!part[k]->makes_sense)
            return false;
    }
    for (int i = 0; i < effects->question->data.count; i++) {
        double effect = 0.0, variance = 0.0, slack = 0.0, least = INFINITY;
        for (int k = 0; k < count; k++) {
            double alone = effect_at(part[k], i, level);
            effect += alone;
            variance += part[k]->variance[i];
            least = fmin(least, fabs(alone));
            for (int m = 0; m < k; m++)
                effect += together(effects, part[m], part[k], i, off, level, &slack);
        }
        effects->effect[i] = effect;
        effects->variance[i] = variance;
        effects->slack[i] = slack + (count > 2 ? OFF_SHARE_AT_A_POINT * least : 0.0);
    }
    return true;
}

void pp_set_effects_lean(struct pp_set_effects *effects)
{
    for (int i = 0; i < effects->question->data.count; i++) {
        double gap = effects->question->data.gap[i], slack = effects->slack[i];
        effects->effect[i] = effects->effect[i] < gap
                                 ? fmin(effects->effect[i] + slack, gap)
                                 : fmax(effects->effect[i] - slack, gap);
    }
}

double pp_set_effects_unknown(const struct pp_set_effects *effects, const int pair[2],
                              double level)
{
    const struct pp_known_set *a = find_known_set(effects, &pair[0], 1);
    const struct pp_known_set *b = find_known_set(effects, &pair[1], 1);
    double sum = 0.0;
    for (int i = 0; i < effects->question->data.count; i++)
        sum += smaller(effect_at(a, i, level), effect_at(b, i, level));
    return find_known_set(effects, pair, 2) ? 0.0 : sum;
}

double pp_set_effects_left(struct pp_set_effects *effects, const int *causes, int count,
                           bool has_factor, double level)
{
    double sum = 0.0, squares = 0.0;
    int points = effects->question->data.count;
    pp_set_effects_predict(effects, causes, count, 0.0, level);
    for (int i = 0; i < points; i++) {
        double left = effects->question->data.gap[i] - effects->effect[i];
        sum += left;
        squares += left * left;
    }
    return has_factor ? squares - sum * sum / points : squares;
}

double pp_set_effects_fit(struct pp_set_effects *effects, const int *causes, int count,
                          bool has_factor, double *width)
{
    const double golden = 0.5 * (sqrt(5.0) - 1.0), step = 0.01;
    double low = 0.0, high = 1.0;
    for (int k = 0; k < FIT_STEPS; k++) {
        double inner = golden * (high - low);
        if (pp_set_effects_left(effects, causes, count, has_factor, high - inner)
            < pp_set_effects_left(effects, causes, count, has_factor, low + inner))
            high = low + inner;
        else
            low = high - inner;
    }
    /* The standard error of the level is the deviation that raises the sum of squares
     * by the variance s^2 of the noise. */
    double level = fmin(fmax(0.5 * (low + high), step), 1.0 - step);
    double least = pp_set_effects_left(effects, causes, count, has_factor, level);
    double bend =
        (pp_set_effects_left(effects, causes, count, has_factor, level - step)
         + pp_set_effects_left(effects, causes, count, has_factor, level + step)
         - 2.0 * least)
        / (2.0 * step * step);
    double noise = least / effects->question->data.count + LEAST_NOISE * LEAST_NOISE;
    *width = bend > 0.0 ? fmin(1.0, sqrt(2.0 * PP_PI * noise / bend)) : 1.0;
    return round(LEVELS * 0.5 * (low + high)) / LEVELS;
}

enum pp_status pp_set_effects_init(struct pp_set_effects *effects,
                                   const struct pp_cause_search_question *question,
                                   struct pp_error *err)
{
    size_t points = (size_t)question->data.count;
    *effects = (struct pp_set_effects){.question = question};
    effects->effect = calloc(3 * points + 1, sizeof *effects->effect);
    if (!effects->effect)
        return pp_fail_memory(err);
    effects->variance = effects->effect + points;
    effects->slack = effects->variance + points;
    return PP_OK;
}

void pp_set_effects_clear(struct pp_set_effects *effects)
{
    for (int i = 0; i < effects->known_count; i++)
        free(effects->known[i].effect);
    free(effects->known);
    free(effects->effect);
}
