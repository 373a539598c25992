/* cause_search.c - first estimates the effect of every set of causes from its parts.
 * Then simulates the sets that may be likely, and reassesses all sets after each
 * simulation. */
#include "studies/research/compare/cause_search.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/array.h"
#include "studies/research/compare/set_effects.h"

/* Prior probability that a cause of one kind is present, and that a common factor is
 * present. Many errors act like a common factor, which therefore counts as a cause only
 * if the fit is close. */
static const double AT_WORK = 0.12, FACTOR_AT_WORK = 0.4;
/* Differences in log posterior density from the best simulated set. A set farther below
 * than FAR_BEHIND is not simulated. A set farther below than FAR_FROM_LIKELY with white
 * noise is excluded, without an evaluation with correlated noise. */
static const double FAR_BEHIND = 4.0, FAR_FROM_LIKELY = 12.0;
/* Number of trial values, from -1 to 1, of a deviation: that of a set that is not
 * simulated from the sum of its parts. */
enum { OFF_STEPS = 9 };
static const double LEAST_PROBABILITY = 0.001;
static const int nobody[1] = {0};

struct cause_candidate {
    struct pp_cause_set set;
    double prior;       /* logarithm */
    double log_density; /* logarithm of the posterior density, not normalised; -INFINITY
                         * if the set is impossible or too unlikely */
    bool is_known;
    double off;   /* best-fitting deviation of the pairs' effects from the sums of
                   * single effects, as for pp_set_effects_predict */
    double level; /* fitted value of the cause, as a position in its range, 0 to 1 */
    double width; /* logarithm of the width of the likelihood around that level */
};

struct cause_search {
    const struct pp_cause_search_question *question;
    struct pp_set_effects effects;
    struct cause_candidate *candidates;
    int candidate_count, candidate_space;
    int traced; /* number of sets of several causes simulated so far */
};

/* Lists the causes of the set except common factors; returns their number. */
static int without_factor(const struct cause_search *search,
                          const struct pp_cause_set *set,
                          int causes[PP_CAUSE_SEARCH_MOST])
{
    int count = 0;
    for (int i = 0; i < set->count; i++)
        if (!search->question->causes[set->causes[i]]->is_factor)
            causes[count++] = set->causes[i];
    return count;
}

/* ---- sets judged ---- */

static struct pp_supposition supposed(const struct cause_search *search,
                                      const struct cause_candidate *candidate)
{
    struct pp_supposition supposition = {search->effects.effect,
                                         search->effects.variance, false};
    for (int i = 0; i < candidate->set.count; i++)
        supposition.has_factor |=
            search->question->causes[candidate->set.causes[i]]->is_factor;
    return supposition;
}

/* Calculates a candidate's log density with white noise only. For a set that is not
 * simulated, uses the deviation that fits best. */
static void judge_roughly(struct cause_search *search,
                          struct cause_candidate *candidate)
{
    int causes[PP_CAUSE_SEARCH_MOST];
    int count = without_factor(search, &candidate->set, causes);
    double width = 1.0;
    candidate->is_known = pp_set_effects_are_known(&search->effects, causes, count);
    candidate->log_density = -INFINITY;
    if (!pp_set_effects_predict(&search->effects, causes, count, 0.0, 0.0))
        return;
    if (pp_set_effects_has_fitted(&search->effects, causes, count))
        candidate->level = pp_set_effects_fit(&search->effects, causes, count,
                                              count < candidate->set.count, &width);
    candidate->set.value = PP_CAUSES_VALUE_MOST * candidate->level;
    candidate->width = log(width);
    for (int k = 0; k < (candidate->is_known ? 1 : OFF_STEPS); k++) {
        double share = 2.0 * k / (OFF_STEPS - 1.0) - 1.0;
        pp_set_effects_predict(&search->effects, causes, count, share,
                               candidate->level);
        pp_set_effects_lean(&search->effects);
        struct pp_supposition supposition = supposed(search, candidate);
        double log_density =
            candidate->prior + candidate->width
            + pp_likelihood_white(&search->question->data, &supposition);
        if (log_density > candidate->log_density) {
            candidate->log_density = log_density;
            candidate->off = share;
        }
    }
}

/* Calculates a candidate's log density with all kinds of noise. */
static enum pp_status judge_fully(struct cause_search *search,
                                  struct cause_candidate *candidate,
                                  struct pp_error *err)
{
    int causes[PP_CAUSE_SEARCH_MOST];
    int count = without_factor(search, &candidate->set, causes);
    pp_set_effects_predict(&search->effects, causes, count, candidate->off,
                           candidate->level);
    pp_set_effects_lean(&search->effects);
    struct pp_supposition supposition = supposed(search, candidate);
    enum pp_status status = pp_likelihood(&candidate->set.likelihood,
                                          &search->question->data, &supposition, err);
    candidate->log_density =
        candidate->prior + candidate->width + candidate->set.likelihood.log_density;
    return status;
}

/* Highest log density of the simulated sets. */
static double best(const struct cause_search *search)
{
    double most = -INFINITY;
    for (int i = 0; i < search->candidate_count; i++)
        if (search->candidates[i].is_known)
            most = fmax(most, search->candidates[i].log_density);
    return most;
}

static enum pp_status judge_cause_sets(struct cause_search *search,
                                       struct pp_error *err)
{
    for (int i = 0; i < search->candidate_count; i++)
        judge_roughly(search, &search->candidates[i]);
    double least = best(search) - FAR_FROM_LIKELY;
    enum pp_status status = PP_OK;
    for (int i = 0; i < search->candidate_count && status == PP_OK; i++) {
        struct cause_candidate *candidate = &search->candidates[i];
        if (candidate->log_density >= least)
            status = judge_fully(search, candidate, err);
        else
            candidate->log_density = -INFINITY;
    }
    return status;
}

/* ---- possible sets ---- */

static bool same_kind(const struct cause_search *search, int a, int b)
{
    const struct pp_cause *const *causes = search->question->causes;
    return strcmp(causes[a]->kind, causes[b]->kind) == 0;
}

static bool excludes(const struct cause_search *search, int a, int b)
{
    const struct pp_cause *const *causes = search->question->causes;
    return same_kind(search, a, b) || causes[a]->is_alone || causes[b]->is_alone;
}

/* Logarithm of the prior odds that a cause is present. */
static double odds(const struct cause_search *search, int cause)
{
    int alike = 0;
    double at_work =
        search->question->causes[cause]->is_factor ? FACTOR_AT_WORK : AT_WORK;
    for (int i = 0; i < search->question->cause_count; i++)
        alike += same_kind(search, i, cause);
    return log(at_work / (1.0 - at_work) / alike);
}

/* Adds the set, and all sets that contain it and causes later in the list. */
static enum pp_status add_sets(struct cause_search *search,
                               const struct cause_candidate *from, struct pp_error *err)
{
    if (pp_array_reserve(&search->candidates, &search->candidate_space,
                         search->candidate_count + 1, sizeof *search->candidates, err)
        != PP_OK)
        return PP_SYSTEM;
    search->candidates[search->candidate_count++] = *from;
    const struct pp_cause_set *set = &from->set;
    enum pp_status status = PP_OK;
    int next = set->count > 0 ? set->causes[set->count - 1] + 1 : 0;
    for (; next < search->question->cause_count && status == PP_OK
           && set->count < PP_CAUSE_SEARCH_MOST;
         next++) {
        struct cause_candidate more = *from;
        bool fits = true;
        for (int i = 0; i < set->count; i++)
            fits = fits && !excludes(search, set->causes[i], next);
        more.set.causes[more.set.count++] = next;
        more.prior += odds(search, next);
        if (fits)
            status = add_sets(search, &more, err);
    }
    return status;
}

/* ---- the search ---- */

static enum pp_status begin_cause_search(
    struct cause_search *search, const struct pp_cause_search_question *question,
    struct pp_error *err)
{
    *search = (struct cause_search){.question = question};
    enum pp_status status = pp_set_effects_init(&search->effects, question, err);
    if (status == PP_OK)
        status = add_sets(search, &(struct cause_candidate){0}, err);
    if (status == PP_OK)
        status = pp_set_effects_trace(&search->effects, nobody, 0, err);
    for (int i = 0; i < question->cause_count && status == PP_OK; i++)
        if (!question->causes[i]->is_factor)
            status = pp_set_effects_trace(&search->effects, &i, 1, err);
    return status;
}

static void end(struct cause_search *search)
{
    pp_set_effects_clear(&search->effects);
    free(search->candidates);
}

/* The most likely set that is not yet simulated and is at most FAR_BEHIND below the
 * best set; NULL: none. */
static const struct cause_candidate *to_trace(const struct cause_search *search)
{
    const struct cause_candidate *next = NULL;
    double least = best(search) - FAR_BEHIND;
    for (int i = 0; i < search->candidate_count; i++) {
        const struct cause_candidate *candidate = &search->candidates[i];
        if (!candidate->is_known && candidate->log_density > least
            && (!next || candidate->log_density > next->log_density))
            next = candidate;
    }
    return next;
}

/* Replaces a set to be simulated by a part of the set, if the simulation of the part is
 * more useful first. For three causes, this part is the pair, not yet simulated, whose
 * effect may deviate most from the sum. Otherwise the set is unchanged. Returns the
 * number of causes. */
static int first_to_trace(const struct cause_search *search,
                          int causes[PP_CAUSE_SEARCH_MOST], int count, double level)
{
    double most = 0.0;
    int chosen[2] = {0, 0};
    for (int k = 1; k < count && count > 2; k++)
        for (int m = 0; m < k; m++) {
            const int pair[2] = {causes[m], causes[k]};
            double unknown = pp_set_effects_unknown(&search->effects, pair, level);
            if (unknown > most) {
                most = unknown;
                memcpy(chosen, pair, sizeof chosen);
            }
        }
    if (!(most > 0.0))
        return count;
    memcpy(causes, chosen, sizeof chosen);
    return 2;
}

static int likelier(const void *a, const void *b)
{
    const struct pp_cause_set *left = a, *right = b;
    return (left->probability < right->probability)
           - (left->probability > right->probability);
}

static bool is_in(const struct pp_cause_set *set, int cause)
{
    for (int i = 0; i < set->count; i++)
        if (set->causes[i] == cause)
            return true;
    return false;
}

static void find_without(struct pp_cause_search *found, struct cause_search *search)
{
    for (int s = 0; s < search->question->cause_count; s++)
        found->without[s] = INFINITY;
    for (int i = 0; i < search->candidate_count; i++) {
        const struct cause_candidate *candidate = &search->candidates[i];
        int causes[PP_CAUSE_SEARCH_MOST];
        int count = without_factor(search, &candidate->set, causes);
        if (!candidate->is_known
            || !pp_set_effects_predict(&search->effects, causes, count, 0.0, 0.0))
            continue;
        double left =
            pp_set_effects_left(&search->effects, causes, count,
                                count < candidate->set.count, candidate->level);
        left = sqrt(fmax(left, 0.0) / search->question->data.count);
        for (int s = 0; s < search->question->cause_count; s++)
            if (!is_in(&candidate->set, s))
                found->without[s] = fmin(found->without[s], left);
    }
}

static enum pp_status hand_over(struct pp_cause_search *found,
                                const struct cause_search *search, struct pp_error *err)
{
    double most = best(search), sum = 0.0;
    found->sets = calloc((size_t)search->candidate_count + 1, sizeof *found->sets);
    if (!found->sets)
        return pp_fail_memory(err);
    for (int i = 0; i < search->candidate_count; i++)
        if (search->candidates[i].is_known)
            sum += exp(search->candidates[i].log_density - most);
    for (int i = 0; i < search->candidate_count; i++) {
        const struct cause_candidate *candidate = &search->candidates[i];
        double probability =
            candidate->is_known ? exp(candidate->log_density - most) / sum : 0.0;
        for (int k = 0; k < candidate->set.count; k++)
            found->probability[candidate->set.causes[k]] += probability;
        if (probability < LEAST_PROBABILITY)
            continue;
        found->sets[found->count] = candidate->set;
        found->sets[found->count++].probability = probability;
    }
    qsort(found->sets, (size_t)found->count, sizeof *found->sets, likelier);
    return PP_OK;
}

enum pp_status pp_cause_search_find(struct pp_cause_search *found,
                                    const struct pp_cause_search_question *question,
                                    struct pp_error *err)
{
    struct cause_search search;
    const struct cause_candidate *next;
    *found = (struct pp_cause_search){0};
    enum pp_status status = begin_cause_search(&search, question, err);
    if (status == PP_OK)
        status = judge_cause_sets(&search, err);
    while (status == PP_OK && (next = to_trace(&search)) != NULL && !found->is_cut) {
        int causes[PP_CAUSE_SEARCH_MOST];
        int count = without_factor(&search, &next->set, causes);
        count = first_to_trace(&search, causes, count, next->level);
        found->is_cut = search.traced++ == question->traced_most;
        if (!found->is_cut)
            status = pp_set_effects_trace(&search.effects, causes, count, err);
        if (!found->is_cut && status == PP_OK)
            status = judge_cause_sets(&search, err);
    }
    if (status == PP_OK)
        status = hand_over(found, &search, err);
    if (status == PP_OK)
        find_without(found, &search);
    end(&search);
    if (status != PP_OK)
        pp_cause_search_clear(found);
    return status;
}

void pp_cause_search_clear(struct pp_cause_search *found)
{
    free(found->sets);
    *found = (struct pp_cause_search){0};
}
