/* band_tree.c - splits regimes by means of histograms. Features and ratios are assigned
 * to bins once. The scores of all splits of a regime then require one pass over its
 * rows for each feature. */
#include "studies/bands/band_tree.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    EDGES = 31, /* maximum number of limits tried for a feature */
    BINS = EDGES + 1,
    STEPS = 256,      /* number of bins for the logarithm of the ratio */
    LOOKED_AT = 4000, /* maximum number of rows used to choose the limits */
};

const struct pp_band_rules pp_band_tree_rules = {
    .rooms_least = 300, .regimes_most = 20, .gain_least = 0.004};

/* Limits at which a feature can be split. A value v is in bin b if at[b - 1] <= v <
 * at[b]. */
struct edges {
    double at[EDGES];
    int count;
};

struct split {
    int feature; /* -1: none */
    double at, gain;
};

struct node {
    struct pp_band_regime regime;
    int *rows; /* row indices in ascending order; owned */
    int count;
    double score; /* sum of the scores of the rows */
    struct split best;
};

struct tree {
    const struct pp_band_sample *sample;
    const struct pp_band_rules *rules;
    struct edges *edges; /* limits for each feature */
    uint8_t *bins;       /* bin of each feature of each row */
    uint8_t *steps;      /* bin of the ratio of each row */
    double first,
        width; /* logarithm of the ratio in the middle of bin 0, and width of a bin */
    struct node *nodes;
    int count;
};

/* ---- bins ---- */

static int compare_feature_values(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Rounds a limit to two significant digits. */
static double two_digits(double value)
{
    char text[32];
    snprintf(text, sizeof text, "%.1e", value);
    return atof(text);
}

/* Finite values of a feature at evenly chosen rows, in ascending order. feature -1:
 * logarithms of the ratios. Returns the number of values. */
static int sample_feature_values(double values[LOOKED_AT],
                                 const struct pp_band_sample *sample, int feature)
{
    int stride = sample->count / LOOKED_AT + 1, count = 0;
    for (int row = 0; row < sample->count; row += stride) {
        double value =
            feature < 0
                ? log(sample->ratios[row])
                : sample->features[(size_t)row * sample->feature_count + feature];
        if (isfinite(value))
            values[count++] = value;
    }
    qsort(values, (size_t)count, sizeof *values, compare_feature_values);
    return count;
}

static struct edges choose_edges(const struct pp_band_sample *sample, int feature)
{
    double values[LOOKED_AT];
    int count = sample_feature_values(values, sample, feature);
    struct edges edges = {.count = 0};
    for (int i = 1; i <= EDGES && count > 0; i++) {
        double edge = two_digits(values[(int)((int64_t)i * count / (EDGES + 1))]);
        if (edge > values[0] && (edges.count == 0 || edge > edges.at[edges.count - 1]))
            edges.at[edges.count++] = edge;
    }
    return edges;
}

static int bin_of(const struct edges *edges, double value)
{
    int bin = 0;
    while (bin < edges->count && value >= edges->at[bin])
        bin++;
    return bin;
}

static void fill_bins(struct tree *tree)
{
    const struct pp_band_sample *sample = tree->sample;
    size_t features = (size_t)sample->feature_count;
    for (int f = 0; f < sample->feature_count; f++) {
        tree->edges[f] = choose_edges(sample, f);
        for (int row = 0; row < sample->count; row++)
            tree->bins[row * features + f] =
                (uint8_t)bin_of(&tree->edges[f], sample->features[row * features + f]);
    }
}

/* Chooses the bins of the ratio so that they contain all ratios except the lowest and
 * the highest 0.1 %. */
static void fill_steps(struct tree *tree)
{
    double values[LOOKED_AT];
    int count = sample_feature_values(values, tree->sample, -1), out = count / 1000;
    double low = values[out], high = values[count - 1 - out];
    tree->width = fmax((high - low) / (STEPS - 1), 1e-9);
    tree->first = low;
    for (int row = 0; row < tree->sample->count; row++) {
        double step = floor((log(tree->sample->ratios[row]) - low) / tree->width + 0.5);
        tree->steps[row] = (uint8_t)fmin(fmax(step, 0.0), STEPS - 1);
    }
}

/* ---- scores ---- */

/* Loss of the quantile of probability p: the sum over the weights of (s - q) p for bins
 * s above q, and of (q - s)(1 - p) for bins below. The loss is least if q is the true
 * quantile. */
static double quantile_loss(const double weights[STEPS], double total, double moment,
                            double p)
{
    double below = 0.0, moment_below = 0.0;
    int q = 0;
    while (q < STEPS - 1 && below + weights[q] < p * total) {
        below += weights[q];
        moment_below += q * weights[q];
        q++;
    }
    return p * (moment - q * total) - (moment_below - q * below);
}

/* Sum of the interval scores of a histogram, in units of bins. */
static double histogram_score(const double weights[STEPS])
{
    static const double alphas[] = {0.5, 0.2};
    double total = 0.0, moment = 0.0, score = 0.0;
    for (int s = 0; s < STEPS; s++) {
        total += weights[s];
        moment += s * weights[s];
    }
    for (int i = 0; i < 2; i++)
        score += 2.0 / alphas[i]
                 * (quantile_loss(weights, total, moment, 0.5 * alphas[i])
                    + quantile_loss(weights, total, moment, 1.0 - 0.5 * alphas[i]));
    return score;
}

/* Histogram of a node for one feature. weights: weight of the node's rows, by bin of
 * the feature and bin of the ratio. lowest, highest: number of the node's rooms whose
 * lowest or highest feature bin is this one. */
struct counts {
    double weights[BINS][STEPS];
    int lowest[BINS], highest[BINS];
};

static void count_rows(struct counts *counts, const struct tree *tree,
                       const struct node *node, int feature)
{
    const struct pp_band_sample *sample = tree->sample;
    memset(counts, 0, sizeof *counts);
    for (int i = 0, end; i < node->count; i = end) {
        int room = sample->rooms[node->rows[i]], lowest = BINS - 1, highest = 0;
        for (end = i; end < node->count && sample->rooms[node->rows[end]] == room;)
            end++;
        for (int k = i; k < end; k++) {
            int row = node->rows[k];
            int bin = tree->bins[(size_t)row * sample->feature_count + feature];
            counts->weights[bin][tree->steps[row]] += 1.0 / (end - i);
            lowest = bin < lowest ? bin : lowest;
            highest = bin > highest ? bin : highest;
        }
        counts->lowest[lowest]++;
        counts->highest[highest]++;
    }
}

static double node_score(const struct tree *tree, const struct node *node)
{
    const struct pp_band_sample *sample = tree->sample;
    double weights[STEPS] = {0};
    for (int i = 0, end; i < node->count; i = end) {
        int room = sample->rooms[node->rows[i]];
        for (end = i; end < node->count && sample->rooms[node->rows[end]] == room;)
            end++;
        for (int k = i; k < end; k++)
            weights[tree->steps[node->rows[k]]] += 1.0 / (end - i);
    }
    return histogram_score(weights);
}

/* ---- splits ---- */

/* True if the regime has space for a condition on the feature. */
static bool has_space(const struct pp_band_regime *regime, int feature)
{
    for (int i = 0; i < regime->condition_count; i++)
        if (regime->conditions[i].feature == feature)
            return true;
    return regime->condition_count < PP_BAND_CONDITIONS;
}

/* Finds the best split by one feature. Stores it if it is better than the best split of
 * the node so far. */
static void try_feature(struct node *node, struct counts *counts,
                        const struct tree *tree, int feature)
{
    const struct edges *edges = &tree->edges[feature];
    double left[STEPS] = {0}, right[STEPS] = {0};
    int rooms_left = 0, rooms_right = 0;
    count_rows(counts, tree, node, feature);
    for (int bin = 0; bin <= edges->count; bin++) {
        rooms_right += counts->highest[bin];
        for (int s = 0; s < STEPS; s++)
            right[s] += counts->weights[bin][s];
    }
    for (int bin = 0; bin < edges->count; bin++) {
        rooms_left += counts->lowest[bin];
        rooms_right -= counts->highest[bin];
        for (int s = 0; s < STEPS; s++) {
            left[s] += counts->weights[bin][s];
            right[s] = fmax(right[s] - counts->weights[bin][s], 0.0);
        }
        if (rooms_left < tree->rules->rooms_least
            || rooms_right < tree->rules->rooms_least)
            continue;
        double gain = node->score - histogram_score(left) - histogram_score(right);
        if (gain > node->best.gain)
            node->best = (struct split){feature, edges->at[bin], gain};
    }
}

static void find_split(struct node *node, const struct tree *tree,
                       struct counts *counts)
{
    node->score = node_score(tree, node);
    node->best = (struct split){.feature = -1, .gain = 0.0};
    for (int f = 0; f < tree->sample->feature_count; f++)
        if (tree->edges[f].count > 0 && has_space(&node->regime, f))
            try_feature(node, counts, tree, f);
}

/* Adds a condition to a regime: values at or above the limit, or below it. */
static void narrow(struct pp_band_regime *regime, struct split split, bool above)
{
    int i = 0;
    while (i < regime->condition_count
           && regime->conditions[i].feature != split.feature)
        i++;
    struct pp_band_condition *condition = &regime->conditions[i];
    if (i == regime->condition_count) {
        *condition = (struct pp_band_condition){split.feature, -INFINITY, INFINITY};
        regime->condition_count++;
    }
    if (above)
        condition->from = split.at;
    else
        condition->to = split.at;
}

static bool fill_node(struct node *node, const struct tree *tree,
                      struct pp_band_regime regime, struct counts *counts)
{
    *node = (struct node){.regime = regime};
    node->rows = malloc(((size_t)tree->sample->count + 1) * sizeof *node->rows);
    if (!node->rows)
        return false;
    node->count = pp_band_tree_rows(node->rows, tree->sample, &regime);
    find_split(node, tree, counts);
    return true;
}

/* Replaces a node by the two nodes of its best split. Returns false if memory is
 * exhausted. */
static bool split_node(struct tree *tree, int index, struct counts *counts)
{
    struct node *node = &tree->nodes[index], halves[2] = {{.rows = NULL}};
    for (int above = 0; above < 2; above++) {
        struct pp_band_regime regime = node->regime;
        narrow(&regime, node->best, above);
        if (!fill_node(&halves[above], tree, regime, counts)) {
            free(halves[0].rows);
            return false;
        }
    }
    free(node->rows);
    memmove(node + 2, node + 1, (size_t)(tree->count - index - 1) * sizeof *node);
    memcpy(node, halves, sizeof halves);
    tree->count++;
    return true;
}

/* Index of the node with the greatest gain by a split; -1: no gain is sufficient. */
static int next_node(const struct tree *tree, double gain_least)
{
    int next = -1;
    for (int i = 0; i < tree->count; i++)
        if (tree->nodes[i].best.feature >= 0 && tree->nodes[i].best.gain >= gain_least
            && (next < 0 || tree->nodes[i].best.gain > tree->nodes[next].best.gain))
            next = i;
    return next;
}

static bool grow_band_tree(struct tree *tree, const struct pp_band_regime *begun,
                           int begun_count, struct counts *counts)
{
    double score = 0.0;
    fill_bins(tree);
    fill_steps(tree);
    while (tree->count < begun_count) {
        struct node *node = &tree->nodes[tree->count];
        if (!fill_node(node, tree, begun[tree->count], counts))
            return false;
        score += node->score;
        tree->count++;
    }
    double gain_least = tree->rules->gain_least * score;
    for (int next; tree->count < tree->rules->regimes_most;) {
        next = next_node(tree, gain_least);
        if (next < 0)
            break;
        if (!split_node(tree, next, counts))
            return false;
    }
    return true;
}

/* ---- regimes ---- */

int pp_band_tree_rows(int *rows, const struct pp_band_sample *sample,
                      const struct pp_band_regime *regime)
{
    int count = 0;
    for (int row = 0; row < sample->count; row++)
        if (pp_band_regime_holds(regime, sample->features
                                             + (size_t)row * sample->feature_count))
            rows[count++] = row;
    return count;
}

static enum pp_status take_regimes(struct pp_band_regime *regimes,
                                   const struct tree *tree, struct pp_error *err)
{
    enum pp_status status = PP_OK;
    for (int i = 0; i < tree->count && status == PP_OK; i++) {
        const struct node *node = &tree->nodes[i];
        regimes[i] = node->regime;
        regimes[i].rooms = pp_band_sample_rooms(tree->sample, node->rows, node->count);
        status = pp_band_sample_quantiles(&regimes[i].ratio, tree->sample, node->rows,
                                          node->count, err);
    }
    return status;
}

enum pp_status pp_band_tree_grow(struct pp_band_regime **regimes, int *count,
                                 const struct pp_band_sample *sample,
                                 const struct pp_band_rules *rules,
                                 const struct pp_band_regime *begun, int begun_count,
                                 struct pp_error *err)
{
    size_t rows = (size_t)sample->count, features = (size_t)sample->feature_count;
    struct tree tree = {.sample = sample, .rules = rules};
    struct counts *counts = malloc(sizeof *counts);
    tree.edges = calloc(features + 1, sizeof *tree.edges);
    tree.bins = malloc(rows * features + 1);
    tree.steps = malloc(rows + 1);
    tree.nodes = calloc((size_t)rules->regimes_most + 1, sizeof *tree.nodes);
    *regimes = calloc((size_t)rules->regimes_most + 1, sizeof **regimes);
    bool good = counts && tree.edges && tree.bins && tree.steps && tree.nodes
                && *regimes && grow_band_tree(&tree, begun, begun_count, counts);
    enum pp_status status =
        good ? take_regimes(*regimes, &tree, err) : pp_fail_memory(err);
    *count = tree.count;
    for (int i = 0; i < tree.count; i++)
        free(tree.nodes[i].rows);
    free(tree.nodes);
    free(tree.steps);
    free(tree.bins);
    free(tree.edges);
    free(counts);
    if (status != PP_OK) {
        free(*regimes);
        *regimes = NULL;
    }
    return status;
}
