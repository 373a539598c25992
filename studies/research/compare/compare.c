/* compare.c - simulates our values without causes, and with sets of causes when the
 * search needs them. Calculates the remainder after the most likely set, and the effect
 * of each of its causes. */
#include "studies/research/compare/compare.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/array.h"
#include "studies/research/compare/cause_shares.h"

/* The constant c in f(v) = ln(v + c), relative to the mean of our values. c gives less
 * weight to darker points. */
static const double DARK_SHARE = 0.005;
/* Sets are listed, the most likely first, until the sum of their probabilities reaches
 * this value. */
static const double LISTED = 0.98;
static const double SURE = 0.98;
enum { TRACED_MOST = 40 };
static const int nobody[1] = {0};

/* Our values, simulated with a set of causes. */
struct traced_set {
    int causes[PP_CAUSE_SEARCH_MOST], count;
    double value;          /* value of the fitted cause; 0: none */
    enum pp_status status; /* PP_BAD_INPUT: the set is not possible here */
    double *values, *errors;
};

struct pp_compare {
    struct pp_compare_subject subject;
    struct pp_compare_options options;
    const struct pp_cause *causes[PP_CAUSES_MOST];
    int cause_count;
    struct traced_set *sets; /* the first one has no causes */
    int set_count;
    struct pp_vec3 *places;
    double dark; /* c */
};

/* ---- sets traced ---- */

static enum pp_status trace_cause_set(struct pp_compare *compare,
                                      struct traced_set *set, struct pp_error *err)
{
    struct pp_room_variant variant = compare->options.variant;
    enum pp_status status = PP_OK;
    size_t points = (size_t)compare->subject.count;
    set->values = calloc(2 * points + 1, sizeof *set->values);
    if (!set->values)
        return pp_fail_memory(err);
    set->errors = set->values + points;
    for (int i = 0; i < set->count && status == PP_OK; i++)
        status = pp_causes_set_variant(&variant, compare->causes[set->causes[i]],
                                       set->value, err);
    if (status == PP_OK)
        status = pp_compare_subject_values(set->values, set->errors, &compare->subject,
                                           &variant, &compare->options.tracing, err);
    return status;
}

/* Sets *set to our values with a set of causes, without common factors; simulates the
 * values if necessary. *set is valid until the next call. */
static enum pp_status set_of(struct pp_compare *compare, const int *causes, int count,
                             double value, const struct traced_set **set,
                             struct pp_error *err)
{
    for (int i = 0; i < compare->set_count; i++) {
        *set = &compare->sets[i];
        if ((*set)->count == count && (*set)->value == value
            && memcmp((*set)->causes, causes, (size_t)count * sizeof *causes) == 0)
            return (*set)->status == PP_OK
                       ? PP_OK
                       : pp_fail(err, (*set)->status, "the switch does not apply here");
    }
    if (pp_array_append(&compare->sets, compare->set_count, sizeof *compare->sets, err)
        != PP_OK)
        return PP_SYSTEM;
    struct traced_set *next = &compare->sets[compare->set_count];
    *next = (struct traced_set){.count = count, .value = value};
    memcpy(next->causes, causes, (size_t)count * sizeof *causes);
    next->status = trace_cause_set(compare, next, err);
    if (next->status == PP_OK || next->status == PP_BAD_INPUT)
        compare->set_count++;
    else
        free(next->values);
    *set = next;
    return next->status;
}

static double scale(const struct pp_compare *compare, double value)
{
    return log(value + compare->dark);
}

static enum pp_status effect_of(void *tracer, const int *causes, int count,
                                double value, double *effect, double *variance,
                                struct pp_error *err)
{
    struct pp_compare *compare = tracer;
    const struct traced_set *set;
    enum pp_status status = set_of(compare, causes, count, value, &set, err);
    for (int i = 0; i < compare->subject.count && status == PP_OK; i++) {
        double error = set->errors[i] / (set->values[i] + compare->dark);
        effect[i] =
            scale(compare, set->values[i]) - scale(compare, compare->sets[0].values[i]);
        variance[i] = error * error;
    }
    return status;
}

/* ---- effects of the most likely set ---- */

static double mean(const double *list, int count)
{
    double sum = 0.0;
    for (int i = 0; i < count; i++)
        sum += list[i] / count;
    return sum;
}

static double squares(const double *list, int count)
{
    double sum = 0.0;
    for (int i = 0; i < count; i++)
        sum += list[i] * list[i];
    return sum;
}

/* Effect of those causes of the set whose bits are set in `subset`. */
static enum pp_status subset_effect(struct pp_compare *compare,
                                    const struct pp_cause_set *set, int subset,
                                    double *effect, double *variance,
                                    struct pp_error *err)
{
    int causes[PP_CAUSE_SEARCH_MOST], count = 0;
    double theta = 0.0, value = 0.0;
    for (int i = 0; i < set->count; i++)
        if (subset >> i & 1) {
            const struct pp_cause *cause = compare->causes[set->causes[i]];
            if (pp_causes_is_fitted(cause))
                value = set->value;
            if (cause->is_factor)
                theta = set->likelihood.theta;
            else
                causes[count++] = set->causes[i];
        }
    enum pp_status status =
        effect_of(compare, causes, count, value, effect, variance, err);
    for (int i = 0; i < compare->subject.count && status == PP_OK; i++)
        effect[i] += theta;
    return status;
}

/* The other program's stated noise, combined with the mean noise of our own values; 0:
 * not stated. */
static double stated_noise(const struct pp_compare *compare, const double *variance)
{
    double noise = compare->options.noise;
    return noise > 0.0 ? sqrt(noise * noise + mean(variance, compare->subject.count))
                       : 0.0;
}

static enum pp_status weigh_cause_shares(struct pp_compared *compared,
                                         struct pp_compare *compare, const double *gap,
                                         double *effect, struct pp_error *err)
{
    const struct pp_cause_set *set = &compared->search.sets[0];
    int count = compared->count, whole = (1 << set->count) - 1;
    double means[1 << PP_CAUSE_SEARCH_MOST], closed[1 << PP_CAUSE_SEARCH_MOST];
    double all = squares(gap, count);
    enum pp_status status = PP_OK;
    for (int subset = 0; subset <= whole && status == PP_OK; subset++) {
        status = subset_effect(compare, set, subset, effect, effect + count, err);
        means[subset] = mean(effect, count);
        for (int i = 0; i < count; i++)
            effect[i] = gap[i] - effect[i];
        closed[subset] = all > 0.0 ? 1.0 - squares(effect, count) / all : 0.0;
        compared->left = mean(effect, count);
        compared->left_rms = sqrt(squares(effect, count) / count);
        if (status == PP_OK && subset == whole)
            status = pp_left_over(&compared->over, effect, compare->places, count,
                                  stated_noise(compare, effect + count), err);
    }
    if (status != PP_OK)
        return status;
    pp_cause_shares(compared->effects, means, set->count);
    pp_cause_shares(compared->shares, closed, set->count);
    for (int i = 0; i < count; i++)
        compared->explained[i] =
            (compared->theirs[i] + compare->dark) * exp(-effect[i]) - compare->dark;
    for (int i = 0; i < set->count; i++)
        if (compare->causes[set->causes[i]]->is_factor)
            compared->factor = exp(set->likelihood.theta);
    return PP_OK;
}

static void list_sets(struct pp_compared *compared)
{
    double sum = 0.0;
    const struct pp_cause_search *search = &compared->search;
    for (int i = 0; i < search->count && i < PP_COMPARE_LISTED_MOST && sum < LISTED;
         i++) {
        sum += search->sets[i].probability;
        compared->listed = i + 1;
    }
}

static enum pp_status explain(struct pp_compared *compared, struct pp_compare *compare,
                              double *gap, double *effect, struct pp_error *err)
{
    int count = compared->count;
    for (int i = 0; i < count; i++)
        gap[i] =
            scale(compare, compared->theirs[i]) - scale(compare, compared->ours[i]);
    compared->gap = mean(gap, count);
    compared->gap_rms = sqrt(squares(gap, count) / count);
    const struct pp_cause_search_question question = {
        .data = {count, gap, compare->places},
        .causes = compare->causes,
        .cause_count = compare->cause_count,
        .trace = effect_of,
        .tracer = compare,
        .traced_most =
            compare->options.traced_most ? compare->options.traced_most : TRACED_MOST};
    enum pp_status status = pp_cause_search_find(&compared->search, &question, err);
    if (status == PP_OK)
        status = weigh_cause_shares(compared, compare, gap, effect, err);
    if (status == PP_OK)
        list_sets(compared);
    return status;
}

enum pp_status pp_compare_explain(struct pp_compared *compared,
                                  struct pp_compare *compare, const double *theirs,
                                  struct pp_error *err)
{
    size_t count = (size_t)compare->subject.count;
    *compared = (struct pp_compared){.count = (int)count,
                                     .ours = compare->sets[0].values,
                                     .errors = compare->sets[0].errors,
                                     .factor = 1.0};
    compared->theirs = calloc(2 * count + 1, sizeof *compared->theirs);
    double *scratch = calloc(3 * count + 1, sizeof *scratch);
    enum pp_status status = compared->theirs && scratch ? PP_OK : pp_fail_memory(err);
    if (status == PP_OK) {
        compared->explained = compared->theirs + count;
        memcpy(compared->theirs, theirs, count * sizeof *theirs);
        status = explain(compared, compare, scratch, scratch + count, err);
    }
    free(scratch);
    if (status != PP_OK)
        pp_compare_clear(compared);
    return status;
}

void pp_compare_clear(struct pp_compared *compared)
{
    pp_cause_search_clear(&compared->search);
    free(compared->theirs);
    *compared = (struct pp_compared){0};
}

bool pp_compare_is_sure(const struct pp_compared *compared, int cause)
{
    return compared->search.probability[cause] >= SURE
           && compared->search.without[cause] >= PP_COMPARE_HIDES
           && compared->search.sets[0].likelihood.sigma < PP_COMPARE_HIDES
           && pp_left_over_is_noise(&compared->over);
}

/* ---- ours ---- */

int pp_compare_causes(const struct pp_compare *compare,
                      const struct pp_cause *const **list)
{
    *list = compare->causes;
    return compare->cause_count;
}

const double *pp_compare_ours(const struct pp_compare *compare, const double **errors)
{
    *errors = compare->sets[0].errors;
    return compare->sets[0].values;
}

static enum pp_status begin_compare(struct pp_compare *compare, struct pp_error *err)
{
    const struct pp_compare_subject *subject = &compare->subject;
    const struct traced_set *none;
    int count = subject->count;
    if (count > PP_COMPARE_POINTS_MOST)
        return pp_fail(err, PP_BAD_INPUT, "there are %d points; expected at most %d",
                       count, PP_COMPARE_POINTS_MOST);
    compare->cause_count = pp_causes_of(compare->causes, subject);
    compare->places = calloc((size_t)count + 1, sizeof *compare->places);
    if (!compare->places)
        return pp_fail_memory(err);
    for (int i = 0; i < count; i++)
        compare->places[i] = subject->points[i].position;
    enum pp_status status = set_of(compare, nobody, 0, 0.0, &none, err);
    if (status == PP_OK)
        compare->dark = fmax(DARK_SHARE * mean(none->values, count), 1e-9);
    return status;
}

enum pp_status pp_compare_create(struct pp_compare **result,
                                 const struct pp_compare_subject *subject,
                                 const struct pp_compare_options *options,
                                 struct pp_error *err)
{
    *result = NULL;
    struct pp_compare *compare = calloc(1, sizeof *compare);
    if (!compare)
        return pp_fail_memory(err);
    compare->subject = *subject;
    compare->options = *options;
    enum pp_status status = begin_compare(compare, err);
    if (status != PP_OK) {
        pp_compare_destroy(compare);
        return status;
    }
    *result = compare;
    return PP_OK;
}

void pp_compare_destroy(struct pp_compare *compare)
{
    if (!compare)
        return;
    for (int i = 0; i < compare->set_count; i++)
        free(compare->sets[i].values);
    free(compare->sets);
    free(compare->places);
    free(compare);
}
