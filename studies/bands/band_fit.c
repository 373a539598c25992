/* band_fit.c - fits the bands of a column in each regime. Also fits bands to one half
 * of the rooms and tests them on the other half. */
#include "studies/bands/band_fit.h"

#include <math.h>
#include <stdlib.h>

#include "studies/research/atlas/room_features.h"

/* ---- ratios ---- */

enum ratio { WHOLE, FORMULA, ASSUMPTION };

static double ratio_of(const struct pp_band_figures *figures, int row, enum ratio which)
{
    double above = which == FORMULA ? figures->own[row] : figures->truth[row];
    double below = which == ASSUMPTION ? figures->own[row] : figures->hand[row];
    return pp_band_regime_ratio(above, below, PP_BAND_OFFSET);
}

/* Makes the sample of one kind of ratio. The caller frees *ratios. */
static bool take_sample(struct pp_band_sample *sample, double **ratios,
                        const struct pp_band_figures *figures, enum ratio which)
{
    *ratios = malloc(((size_t)figures->count + 1) * sizeof **ratios);
    for (int row = 0; *ratios && row < figures->count; row++)
        (*ratios)[row] = ratio_of(figures, row, which);
    *sample = (struct pp_band_sample){figures->count, figures->rooms, *ratios,
                                      figures->feature_count, figures->features};
    return *ratios != NULL;
}

/* Keeps the rows for which the simulated value in the simplified room is known. Returns
 * their number. */
static int keep_known(int *rows, int count, const struct pp_band_figures *figures)
{
    int kept = 0;
    for (int i = 0; i < count; i++)
        if (isfinite(figures->own[rows[i]]))
            rows[kept++] = rows[i];
    return kept;
}

/* ---- entries ---- */

struct column_fit {
    const struct pp_band_figures *figures;
    struct pp_band_sample samples[3];
    double *ratios[3];
    int *rows; /* indices of rows; space for all rows */
};

static enum pp_status fill_entry(struct pp_band_entry *entry,
                                 const struct column_fit *fit,
                                 const struct pp_band_regime *regime,
                                 struct pp_error *err)
{
    struct pp_band_quantiles *const parts[] = {
        [FORMULA] = &entry->formula, [ASSUMPTION] = &entry->assumption};
    int count = pp_band_tree_rows(fit->rows, &fit->samples[WHOLE], regime);
    *entry = (struct pp_band_entry){
        .regime = *regime, .formula = {NAN, NAN, NAN}, .assumption = {NAN, NAN, NAN}};
    enum pp_status status = pp_band_sample_spread(&entry->spread, &fit->samples[WHOLE],
                                                  fit->rows, count, err);
    count = keep_known(fit->rows, count, fit->figures);
    for (int which = FORMULA; which <= ASSUMPTION && count > 0 && status == PP_OK;
         which++)
        status = pp_band_sample_quantiles(parts[which], &fit->samples[which], fit->rows,
                                          count, err);
    return status;
}

/* Separates ordinary rooms from unusual ones, since common bands would be too wide for
 * ordinary rooms and too narrow for unusual ones. If there are too few rooms of either
 * kind, all rooms are one regime. Returns the number of regimes. */
static int begin_band_regimes(struct pp_band_regime begun[2],
                              const struct column_fit *fit,
                              const struct pp_band_rules *rules)
{
    bool enough = true;
    for (int i = 0; i < 2; i++) {
        begun[i] = (struct pp_band_regime){
            .conditions = {{PP_ROOM_ORDINARY, i == 0 ? 1.0 : -INFINITY,
                            i == 0 ? INFINITY : 1.0}},
            .condition_count = 1};
        int count = pp_band_tree_rows(fit->rows, &fit->samples[WHOLE], &begun[i]);
        enough &= pp_band_sample_rooms(&fit->samples[WHOLE], fit->rows, count)
                  >= rules->rooms_least;
    }
    if (enough)
        return 2;
    begun[0].condition_count = 0;
    return 1;
}

static enum pp_status fit_column(struct pp_band_entry **entries, int *count,
                                 const struct column_fit *fit,
                                 const struct pp_band_rules *rules,
                                 struct pp_error *err)
{
    struct pp_band_regime *regimes, begun[2];
    int begun_count = begin_band_regimes(begun, fit, rules);
    enum pp_status status = pp_band_tree_grow(&regimes, count, &fit->samples[WHOLE],
                                              rules, begun, begun_count, err);
    if (status != PP_OK)
        return status;
    *entries = calloc((size_t)*count + 1, sizeof **entries);
    if (!*entries)
        status = pp_fail_memory(err);
    for (int i = 0; i < *count && status == PP_OK; i++)
        status = fill_entry(&(*entries)[i], fit, &regimes[i], err);
    free(regimes);
    return status;
}

enum pp_status pp_band_fit(struct pp_band_entry **entries, int *count,
                           const struct pp_band_figures *figures,
                           const struct pp_band_rules *rules, struct pp_error *err)
{
    struct column_fit fit = {
        .figures = figures,
        .rows = malloc(((size_t)figures->count + 1) * sizeof *fit.rows)};
    *entries = NULL;
    *count = 0;
    bool good = fit.rows != NULL;
    for (int which = WHOLE; which <= ASSUMPTION && good; which++)
        good = take_sample(&fit.samples[which], &fit.ratios[which], figures,
                           (enum ratio)which);
    for (int row = 0; good && row < figures->count; row++)
        fit.rows[row] = row;
    bool enough = good
                  && pp_band_sample_rooms(&fit.samples[WHOLE], fit.rows, figures->count)
                         >= rules->rooms_least;
    enum pp_status status = !good    ? pp_fail_memory(err)
                            : enough ? fit_column(entries, count, &fit, rules, err)
                                     : PP_OK;
    for (int which = WHOLE; which <= ASSUMPTION; which++)
        free(fit.ratios[which]);
    free(fit.rows);
    if (status != PP_OK) {
        free(*entries);
        *entries = NULL;
    }
    return status;
}

/* ---- halves ---- */

/* Tests each entry on the rooms in `figures`. *inside: fraction of all points inside
 * their bands. */
static enum pp_status test_entries(struct pp_band_trial *trials, int count,
                                   double *inside,
                                   const struct pp_band_figures *figures,
                                   struct pp_error *err)
{
    struct pp_band_sample sample;
    double *ratios, points = 0.0, all = 0.0;
    int *rows = malloc(((size_t)figures->count + 1) * sizeof *rows);
    bool good = take_sample(&sample, &ratios, figures, WHOLE) && rows;
    for (int i = 0; i < count && good; i++) {
        struct pp_band_trial *trial = &trials[i];
        const struct pp_band_regime *regime = &trial->entry.regime;
        int found = pp_band_tree_rows(rows, &sample, regime);
        trial->rooms = pp_band_sample_rooms(&sample, rows, found);
        trial->inside =
            pp_band_sample_inside(&sample, rows, found, &regime->ratio, true);
        trial->between =
            pp_band_sample_inside(&sample, rows, found, &regime->ratio, false);
        trial->limit = 3.0 * sqrt(0.0475 * (1.0 / regime->rooms + 1.0 / trial->rooms));
        if (found == 0)
            continue;
        points += found * trial->inside;
        all += found;
    }
    *inside = all > 0.0 ? points / all : NAN;
    free(ratios);
    free(rows);
    return good ? PP_OK : pp_fail_memory(err);
}

static enum pp_status try_halves(struct pp_band_trial **trials, int *count,
                                 double *inside, const struct pp_band_figures halves[2],
                                 const struct pp_band_rules *rules,
                                 struct pp_error *err)
{
    struct pp_band_entry *entries;
    enum pp_status status = pp_band_fit(&entries, count, &halves[0], rules, err);
    if (status != PP_OK)
        return status;
    *trials = calloc((size_t)*count + 1, sizeof **trials);
    for (int i = 0; *trials && i < *count; i++)
        (*trials)[i].entry = entries[i];
    status = *trials ? test_entries(*trials, *count, inside, &halves[1], err)
                     : pp_fail_memory(err);
    free(entries);
    return status;
}

enum pp_status pp_band_fit_try(struct pp_band_trial **trials, int *count,
                               double *inside, const struct pp_band_figures *figures,
                               const struct pp_band_rules *rules, int side,
                               struct pp_error *err)
{
    struct pp_band_figures halves[2];
    enum pp_status status = PP_OK;
    *trials = NULL;
    for (int i = 0; i < 2; i++)
        pp_band_figures_init(&halves[i], figures->feature_count);
    for (int i = 0; i < 2 && status == PP_OK; i++)
        status =
            pp_band_figures_half(&halves[i], figures, i == 0 ? side : 1 - side, err);
    if (status == PP_OK)
        status = try_halves(trials, count, inside, halves, rules, err);
    for (int i = 0; i < 2; i++)
        pp_band_figures_clear(&halves[i]);
    if (status != PP_OK) {
        free(*trials);
        *trials = NULL;
    }
    return status;
}
