/* blame.c - sets are judged by the sum of their parts, traced where they may be likely,
 * and judged again. */
#include "studies/compare/blame.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/array.h"

/* That a kind of suspect is at work, beforehand; and a common factor, which so many things
 * are: what has the pattern of one is to be called sure by its size alone only where
 * that fits closely. */
static const double AT_WORK = 0.12, FACTOR_AT_WORK = 0.4;
/* Sets so much (in logarithms) less likely than the best are traced no more; and those so
 * much less likely by white noise are not looked at with any other. */
static const double FAR_BEHIND = 4.0, FAR_FROM_LIKELY = 12.0;
/* What two do together is off from the sum by a share of the smaller, up to this either
 * way, much the same at all points; and by as much again at each point by itself. What
 * three do is off from what their pairs do by the last. */
static const double OFF_SHARE = 0.6, OFF_SHARE_AT_A_POINT = 0.1;
enum { OFF_STEPS = 9 };
static const double LEAST_PROBABILITY = 0.001;
/* A suspect that does less than this (root mean square of logarithms) is not told. */
static const double LEAST_EFFECT = 0.001;
static const int nobody[1] = {0};

/* What a traced set does; those without a common factor only. */
struct known_set {
    int suspects[PP_BLAME_MOST], count;
    bool makes_sense;
    double *effect, *variance;
};

struct blame_candidate {
    struct pp_blame_set set;
    double prior;       /* logarithm */
    double log_density; /* with the prior; by white noise where it is not near */
    bool is_known;
    double off; /* share of the smaller by which its pairs are off, at its best */
};

struct blame_search {
    const struct pp_blame_question *question;
    struct known_set *known;
    int known_count;
    struct blame_candidate *candidates;
    int candidate_count, candidate_space;
    double *effect, *variance; /* scratch, one a point */
    int traced;                /* sets of several */
};

/* ---- what is known of sets ---- */

static const struct known_set *find(const struct blame_search *search,
                                    const int *suspects, int count)
{
    for (int i = 0; i < search->known_count; i++)
        if (search->known[i].count == count
            && memcmp(search->known[i].suspects, suspects,
                      (size_t)count * sizeof *suspects)
                   == 0)
            return &search->known[i];
    return NULL;
}

/* The set without common factors; returns how many. */
static int without_factor(const struct blame_search *search,
                          const struct pp_blame_set *set, int suspects[PP_BLAME_MOST])
{
    int count = 0;
    for (int i = 0; i < set->count; i++)
        if (!search->question->suspects[set->suspects[i]]->is_factor)
            suspects[count++] = set->suspects[i];
    return count;
}

static bool is_felt(const double *effect, int points)
{
    double sum = 0.0;
    for (int i = 0; i < points; i++)
        sum += effect[i] * effect[i];
    return sum > points * LEAST_EFFECT * LEAST_EFFECT;
}

static enum pp_status trace(struct blame_search *search, const int *suspects, int count,
                            struct pp_error *err)
{
    int points = search->question->data.count;
    if (pp_array_append(&search->known, search->known_count, sizeof *search->known, err)
        != PP_OK)
        return PP_SYSTEM;
    struct known_set *known = &search->known[search->known_count];
    *known = (struct known_set){.count = count, .makes_sense = true};
    memcpy(known->suspects, suspects, (size_t)count * sizeof *suspects);
    known->effect = calloc(2 * (size_t)points + 1, sizeof *known->effect);
    if (!known->effect)
        return pp_fail_memory(err);
    known->variance = known->effect + points;
    search->known_count++;
    struct pp_error own = {0};
    enum pp_status status =
        search->question->trace(search->question->tracer, suspects, count,
                                known->effect, known->variance, &own);
    known->makes_sense =
        status == PP_OK && (count != 1 || is_felt(known->effect, points));
    if (status == PP_OK || status == PP_BAD_INPUT)
        return PP_OK;
    return pp_fail(err, status, "%s", own.message);
}

static double smaller(double a, double b)
{
    return fmin(fabs(a), fabs(b));
}

/* What a pair does beyond the sum of both, at a point: traced, or that share of the
 * smaller. *left grows by as much as that may be wrong. */
static double together(const struct blame_search *search, const struct known_set *a,
                       const struct known_set *b, int point, double share, double *left)
{
    int pair[] = {a->suspects[0], b->suspects[0]};
    const struct known_set *both = find(search, pair, 2);
    if (both && both->makes_sense)
        return both->effect[point] - a->effect[point] - b->effect[point];
    double smallest = smaller(a->effect[point], b->effect[point]);
    *left += OFF_SHARE_AT_A_POINT * smallest;
    return share * smallest;
}

/* Fills effect and variance with what the set does by what is known of its parts, its pairs
 * off by that share; and as near to the gap as that may be wrong. False where a part makes
 * no sense. */
static bool predict(struct blame_search *search, const int *suspects, int count,
                    double share)
{
    const struct known_set *part[PP_BLAME_MOST];
    for (int k = 0; k < count; k++) {
        part[k] = find(search, &suspects[k], 1);
        if (!part[k]->makes_sense)
            return false;
    }
    for (int i = 0; i < search->question->data.count; i++) {
        double effect = 0.0, variance = 0.0, left = 0.0, least = INFINITY;
        for (int k = 0; k < count; k++) {
            effect += part[k]->effect[i];
            variance += part[k]->variance[i];
            least = fmin(least, fabs(part[k]->effect[i]));
            for (int m = 0; m < k; m++)
                effect += together(search, part[m], part[k], i, share, &left);
        }
        left += count > 2 ? OFF_SHARE_AT_A_POINT * least : 0.0;
        double gap = search->question->data.gap[i];
        search->effect[i] =
            effect < gap ? fmin(effect + left, gap) : fmax(effect - left, gap);
        search->variance[i] = variance;
    }
    return true;
}

/* ---- sets judged ---- */

static struct pp_supposition supposed(const struct blame_search *search,
                                      const struct blame_candidate *candidate,
                                      const struct known_set *known)
{
    struct pp_supposition supposition = {known ? known->effect : search->effect,
                                         known ? known->variance : search->variance,
                                         false};
    for (int i = 0; i < candidate->set.count; i++)
        supposition.has_factor |=
            search->question->suspects[candidate->set.suspects[i]]->is_factor;
    return supposition;
}

/* Of a set that is not traced, at its best. */
static void judge_unknown(struct blame_search *search,
                          struct blame_candidate *candidate, const int *suspects,
                          int count)
{
    for (int k = 0; k < OFF_STEPS; k++) {
        double share = OFF_SHARE * (2.0 * k / (OFF_STEPS - 1.0) - 1.0);
        if (!predict(search, suspects, count, share))
            return;
        struct pp_supposition supposition = supposed(search, candidate, NULL);
        double log_density =
            candidate->prior + pp_evidence_white(&search->question->data, &supposition);
        if (log_density > candidate->log_density) {
            candidate->log_density = log_density;
            candidate->off = share;
        }
    }
}

/* By white noise. */
static void judge_roughly(struct blame_search *search,
                          struct blame_candidate *candidate)
{
    int suspects[PP_BLAME_MOST];
    int count = without_factor(search, &candidate->set, suspects);
    const struct known_set *known = find(search, suspects, count);
    candidate->is_known = known != NULL;
    candidate->log_density = -INFINITY;
    if (!known)
        judge_unknown(search, candidate, suspects, count);
    if (!known || !known->makes_sense)
        return;
    struct pp_supposition supposition = supposed(search, candidate, known);
    candidate->log_density =
        candidate->prior + pp_evidence_white(&search->question->data, &supposition);
}

/* By all kinds of noise. */
static enum pp_status judge_fully(struct blame_search *search,
                                  struct blame_candidate *candidate,
                                  struct pp_error *err)
{
    int suspects[PP_BLAME_MOST];
    int count = without_factor(search, &candidate->set, suspects);
    const struct known_set *known = find(search, suspects, count);
    if (!known)
        predict(search, suspects, count, candidate->off);
    struct pp_supposition supposition = supposed(search, candidate, known);
    enum pp_status status = pp_evidence(&candidate->set.evidence,
                                        &search->question->data, &supposition, err);
    candidate->log_density = candidate->prior + candidate->set.evidence.log_density;
    return status;
}

/* Of the sets that are traced. */
static double best(const struct blame_search *search)
{
    double most = -INFINITY;
    for (int i = 0; i < search->candidate_count; i++)
        if (search->candidates[i].is_known)
            most = fmax(most, search->candidates[i].log_density);
    return most;
}

static enum pp_status judge(struct blame_search *search, struct pp_error *err)
{
    for (int i = 0; i < search->candidate_count; i++)
        judge_roughly(search, &search->candidates[i]);
    double least = best(search) - FAR_FROM_LIKELY;
    enum pp_status status = PP_OK;
    for (int i = 0; i < search->candidate_count && status == PP_OK; i++) {
        struct blame_candidate *candidate = &search->candidates[i];
        if (candidate->log_density >= least)
            status = judge_fully(search, candidate, err);
        else
            candidate->log_density = -INFINITY;
    }
    return status;
}

/* ---- the sets that there are ---- */

static bool same_kind(const struct blame_search *search, int a, int b)
{
    const struct pp_suspect *const *suspects = search->question->suspects;
    return strcmp(suspects[a]->kind, suspects[b]->kind) == 0;
}

static bool excludes(const struct blame_search *search, int a, int b)
{
    const struct pp_suspect *const *suspects = search->question->suspects;
    return same_kind(search, a, b) || suspects[a]->is_alone || suspects[b]->is_alone;
}

/* How much likelier than not a suspect is at work beforehand; logarithm. */
static double odds(const struct blame_search *search, int suspect)
{
    int alike = 0;
    double at_work =
        search->question->suspects[suspect]->is_factor ? FACTOR_AT_WORK : AT_WORK;
    for (int i = 0; i < search->question->suspect_count; i++)
        alike += same_kind(search, i, suspect);
    return log(at_work / (1.0 - at_work) / alike);
}

/* The set and all with further suspects behind its last. */
static enum pp_status add_sets(struct blame_search *search,
                               const struct blame_candidate *from, struct pp_error *err)
{
    if (pp_array_reserve(&search->candidates, &search->candidate_space,
                         search->candidate_count + 1, sizeof *search->candidates, err)
        != PP_OK)
        return PP_SYSTEM;
    search->candidates[search->candidate_count++] = *from;
    const struct pp_blame_set *set = &from->set;
    enum pp_status status = PP_OK;
    int next = set->count > 0 ? set->suspects[set->count - 1] + 1 : 0;
    for (; next < search->question->suspect_count && status == PP_OK
           && set->count < PP_BLAME_MOST;
         next++) {
        struct blame_candidate more = *from;
        bool fits = true;
        for (int i = 0; i < set->count; i++)
            fits = fits && !excludes(search, set->suspects[i], next);
        more.set.suspects[more.set.count++] = next;
        more.prior += odds(search, next);
        if (fits)
            status = add_sets(search, &more, err);
    }
    return status;
}

/* ---- the search ---- */

static enum pp_status begin(struct blame_search *search,
                            const struct pp_blame_question *question,
                            struct pp_error *err)
{
    size_t points = (size_t)question->data.count;
    *search = (struct blame_search){.question = question};
    search->effect = calloc(2 * points + 1, sizeof *search->effect);
    if (!search->effect)
        return pp_fail_memory(err);
    search->variance = search->effect + points;
    enum pp_status status = add_sets(search, &(struct blame_candidate){0}, err);
    if (status == PP_OK)
        status = trace(search, nobody, 0, err);
    for (int i = 0; i < question->suspect_count && status == PP_OK; i++)
        if (!question->suspects[i]->is_factor)
            status = trace(search, &i, 1, err);
    return status;
}

static void end(struct blame_search *search)
{
    for (int i = 0; i < search->known_count; i++)
        free(search->known[i].effect);
    free(search->known);
    free(search->candidates);
    free(search->effect);
}

/* The likeliest of the sets that are not traced, as far as it matters; NULL: none. */
static const struct blame_candidate *to_trace(const struct blame_search *search)
{
    const struct blame_candidate *next = NULL;
    double least = best(search) - FAR_BEHIND;
    for (int i = 0; i < search->candidate_count; i++) {
        const struct blame_candidate *candidate = &search->candidates[i];
        if (!candidate->is_known && candidate->log_density > least
            && (!next || candidate->log_density > next->log_density))
            next = candidate;
    }
    return next;
}

/* How much two may do beyond the sum of both: by what is smaller of them at each
 * point. */
static double unknown_of(const struct blame_search *search, const int pair[2])
{
    const struct known_set *a = find(search, &pair[0], 1);
    const struct known_set *b = find(search, &pair[1], 1);
    double sum = 0.0;
    for (int i = 0; i < search->question->data.count; i++)
        sum += smaller(a->effect[i], b->effect[i]);
    return find(search, pair, 2) ? 0.0 : sum;
}

/* What to trace of three: them, or of those pairs that have not been traced the one that
 * may do most beyond its sum, from which there is more to learn. Returns how many. */
static int first_to_trace(const struct blame_search *search,
                          int suspects[PP_BLAME_MOST], int count)
{
    double most = 0.0;
    int chosen[2] = {0, 0};
    for (int k = 1; k < count && count > 2; k++)
        for (int m = 0; m < k; m++) {
            const int pair[2] = {suspects[m], suspects[k]};
            double unknown = unknown_of(search, pair);
            if (unknown > most) {
                most = unknown;
                memcpy(chosen, pair, sizeof chosen);
            }
        }
    if (!(most > 0.0))
        return count;
    memcpy(suspects, chosen, sizeof chosen);
    return 2;
}

static int likelier(const void *a, const void *b)
{
    const struct pp_blame_set *left = a, *right = b;
    return (left->probability < right->probability)
           - (left->probability > right->probability);
}

static enum pp_status hand_over(struct pp_blame *blame,
                                const struct blame_search *search, struct pp_error *err)
{
    double most = best(search), sum = 0.0;
    blame->sets = calloc((size_t)search->candidate_count + 1, sizeof *blame->sets);
    if (!blame->sets)
        return pp_fail_memory(err);
    for (int i = 0; i < search->candidate_count; i++)
        if (search->candidates[i].is_known)
            sum += exp(search->candidates[i].log_density - most);
    for (int i = 0; i < search->candidate_count; i++) {
        const struct blame_candidate *candidate = &search->candidates[i];
        double probability =
            candidate->is_known ? exp(candidate->log_density - most) / sum : 0.0;
        for (int k = 0; k < candidate->set.count; k++)
            blame->probability[candidate->set.suspects[k]] += probability;
        if (probability < LEAST_PROBABILITY)
            continue;
        blame->sets[blame->count] = candidate->set;
        blame->sets[blame->count++].probability = probability;
    }
    qsort(blame->sets, (size_t)blame->count, sizeof *blame->sets, likelier);
    return PP_OK;
}

enum pp_status pp_blame_find(struct pp_blame *blame,
                             const struct pp_blame_question *question,
                             struct pp_error *err)
{
    struct blame_search search;
    const struct blame_candidate *next;
    *blame = (struct pp_blame){0};
    enum pp_status status = begin(&search, question, err);
    if (status == PP_OK)
        status = judge(&search, err);
    while (status == PP_OK && (next = to_trace(&search)) != NULL && !blame->is_cut) {
        int suspects[PP_BLAME_MOST];
        int count = without_factor(&search, &next->set, suspects);
        count = first_to_trace(&search, suspects, count);
        blame->is_cut = search.traced++ == question->traced_most;
        if (!blame->is_cut)
            status = trace(&search, suspects, count, err);
        if (!blame->is_cut && status == PP_OK)
            status = judge(&search, err);
    }
    if (status == PP_OK)
        status = hand_over(blame, &search, err);
    end(&search);
    if (status != PP_OK)
        pp_blame_clear(blame);
    return status;
}

void pp_blame_clear(struct pp_blame *blame)
{
    free(blame->sets);
    *blame = (struct pp_blame){0};
}
