/* annual_point.c - illuminances of a point in all hours, and its figures with their
 * standard errors. */
#include <stdlib.h>
#include <string.h>

#include "studies/year/annual_seasons.h"
#include "studies/year/annual_work.h"

/* Working memory of one thread. */
struct pp_annual_space {
    float *skies;   /* [point of the block][group][batch][step] */
    float *suns;    /* the same order */
    float *bare[2]; /* skies and suns without leaves; NULL: not needed */
    float *sky;     /* the part of skies of the current point */
    float *sun;     /* the part of suns of the current point */
    float *open;    /* [batch][step]: all light */
    float *blinds;  /* [point of the block][batch][step]: all light with blinds */
    float *sums[5]; /* by hour: means over all batches */
    float *rank;
    double parts[2][PP_YEAR_BATCHES]; /* light of the year, lx h: of the sky, of sunlit
                                       * surfaces */
};

enum { SUM_OPEN, SUM_SKY, SUM_SUN, SUM_REFLECTED, SUM_BLINDS };

void pp_annual_point_clear_spaces(struct pp_annual_work *work)
{
    for (int i = 0; work->spaces && i < pp_thread_pool_size(work->pool); i++) {
        struct pp_annual_space *space = &work->spaces[i];
        free(space->skies);
        free(space->suns);
        free(space->bare[0]);
        free(space->bare[1]);
        free(space->open);
        free(space->blinds);
        for (int k = 0; k < 5; k++)
            free(space->sums[k]);
        free(space->rank);
    }
    free(work->spaces);
    work->spaces = NULL;
}

int pp_annual_point_block_size(int groups)
{
    enum { ROWS_MOST = 64 }; /* each with 16 batches of about 4700 hours */
    int size = PP_YEAR_BLOCK;
    while (size > 1 && size * groups > ROWS_MOST)
        size /= 2;
    return size;
}

enum pp_status pp_annual_point_make_spaces(struct pp_annual_work *work,
                                           struct pp_error *err)
{
    size_t batches = PP_YEAR_BATCHES * work->open.step, all = batches;
    /* A room without openings has no groups, but judge needs the space of one. */
    all *= work->groups.count > 0 ? (size_t)work->groups.count : 1;
    bool enough = true;
    work->spaces =
        calloc((size_t)pp_thread_pool_size(work->pool), sizeof *work->spaces);
    if (!work->spaces)
        return pp_fail_memory(err);
    for (int i = 0; i < pp_thread_pool_size(work->pool); i++) {
        struct pp_annual_space *space = &work->spaces[i];
        space->skies = calloc(all * (size_t)work->block, sizeof(float));
        space->suns = calloc(all * (size_t)work->block, sizeof(float));
        for (int k = 0; k < 2 && work->leafless; k++)
            enough &=
                (space->bare[k] = calloc(all * (size_t)work->block, sizeof(float)))
                != NULL;
        space->open = calloc(batches, sizeof(float));
        space->blinds = calloc(batches * (size_t)work->block, sizeof(float));
        space->rank = calloc(work->open.step, sizeof(float));
        enough &=
            space->skies && space->suns && space->open && space->blinds && space->rank;
        for (int k = 0; k < 5; k++)
            enough &= (space->sums[k] = calloc(work->open.step, sizeof(float))) != NULL;
    }
    return enough ? PP_OK : pp_fail_memory(err);
}

/* Adds the share of a closed state to a point's light with blinds. */
static void add_closed(const struct pp_annual_work *work,
                       const struct pp_annual_space *space,
                       const struct pp_annual_state *state, int x, float *blinds)
{
    size_t count = (size_t)state->count, skies = (size_t)work->year->sky_count;
    for (int g = 0; g < work->groups.count; g++) {
        const float *share = state->share + (size_t)g * skies;
        const float *direct =
            state->direct_sun
            + ((size_t)x * (size_t)work->groups.count + (size_t)g) * count;
        for (int b = 0; b < PP_YEAR_BATCHES; b++) {
            size_t row = (size_t)(g * PP_YEAR_BATCHES + b) * state->step;
            float *to = blinds + (size_t)b * work->open.step;
            for (size_t i = 0; i < count; i++) {
                int t = state->hours[i];
                if (share[t] > 0.0f)
                    to[t] += share[t]
                             * (space->sky[row + i] + space->sun[row + i] + direct[i]);
            }
        }
    }
}

/* Adds up the light of all groups at point x: each batch without and with blinds, the
 * parts of the light, the means over batches, and the light of each group. `blinds` has
 * the light that is taken from closed states. */
static void add_up(struct pp_annual_work *work, struct pp_annual_space *space, int x,
                   float *blinds)
{
    int count = work->year->sky_count, groups = work->groups.count;
    size_t step = work->open.step;
    const float *direct =
        work->open.direct_sun + (size_t)x * (size_t)groups * (size_t)count;
    for (int k = 0; k < 5; k++)
        memset(space->sums[k], 0, step * sizeof(float));
    memset(space->parts, 0, sizeof space->parts);
    memset(space->open, 0, PP_YEAR_BATCHES * step * sizeof(float));
    for (int g = 0; g < groups; g++) {
        const float *sun = direct + (size_t)g * (size_t)count;
        const unsigned char *closed = work->closes + (size_t)g * (size_t)count;
        const unsigned char *taken = work->taken + (size_t)g * (size_t)count;
        double k = work->groups.transmittance[g] * PP_BLIND_GROUPS_TRANSMITTANCE;
        double *light =
            work->group_light
            + ((size_t)x * (size_t)groups + (size_t)g) * (1 + PP_YEAR_BATCHES);
        for (int t = 0; t < count; t++)
            space->sums[SUM_SUN][t] += sun[t];
        for (int b = 0; b < PP_YEAR_BATCHES; b++) {
            size_t row = (size_t)(g * PP_YEAR_BATCHES + b) * step;
            float emitted = 0.0f;
            if (work->open.coefficients)
                emitted =
                    (float)k
                    * pp_year_coefficients_by_panes(work->open.coefficients, x, g, b);
            for (int t = 0; t < count; t++) {
                float sky = space->sky[row + (size_t)t];
                float reflected = space->sun[row + (size_t)t];
                float all = sky + reflected + sun[t];
                space->sums[SUM_SKY][t] += sky / PP_YEAR_BATCHES;
                space->sums[SUM_REFLECTED][t] += reflected / PP_YEAR_BATCHES;
                space->open[(size_t)b * step + (size_t)t] += all;
                blinds[(size_t)b * step + (size_t)t] +=
                    taken[t]    ? 0.0f
                    : closed[t] ? emitted * work->on_panes[row + (size_t)t]
                                : all;
                space->parts[0][b] += (double)sky * work->clock.length_h[t];
                space->parts[1][b] += (double)reflected * work->clock.length_h[t];
                light[1 + b] += (double)all * work->clock.length_h[t];
            }
            light[0] += light[1 + b] / PP_YEAR_BATCHES;
        }
    }
    for (int b = 0; b < PP_YEAR_BATCHES; b++)
        for (int t = 0; t < count; t++) {
            space->sums[SUM_OPEN][t] +=
                space->open[(size_t)b * step + (size_t)t] / PP_YEAR_BATCHES;
            space->sums[SUM_BLINDS][t] +=
                blinds[(size_t)b * step + (size_t)t] / PP_YEAR_BATCHES;
        }
}

/* Mean of all batches except one, from the mean of all. */
static void leave_out(float *out, const float *mean, const float *batch, int count)
{
    for (int t = 0; t < count; t++)
        out[t] = (PP_YEAR_BATCHES * mean[t] - batch[t]) / (PP_YEAR_BATCHES - 1);
}

static double total_without(const double *totals, int batch)
{
    double sum = 0.0;
    for (int b = 0; b < PP_YEAR_BATCHES; b++)
        sum += b == batch ? 0.0 : totals[b];
    return sum / (PP_YEAR_BATCHES - 1);
}

static void judge(struct pp_annual_work *work, struct pp_annual_space *space, int x,
                  const float *with_blinds)
{
    int worker = (int)(space - work->spaces);
    const struct pp_annual_options *options = work->options;
    struct pp_annual_figures *figures = &work->sheet->points[x];
    int count = work->year->sky_count;
    float *means[2] = {space->sums[SUM_OPEN], space->sums[SUM_BLINDS]};
    struct pp_year_values values = {.open = means[0],
                                    .sky = space->sums[SUM_SKY],
                                    .sun = space->sums[SUM_SUN],
                                    .sun_reflected = space->sums[SUM_REFLECTED],
                                    .blinds = work->sheet->has_blinds ? means[1] : NULL,
                                    .space = space->rank};
    pp_year_metrics_of(figures, &values, &work->clock, options->illuminances_lx,
                       options->illuminance_count);
    float *row = work->sheet->lx + (size_t)x * (size_t)count;
    bool used =
        options->blinds == PP_BLINDS_ALWAYS || options->blinds == PP_BLINDS_SCHEDULE;
    memcpy(row, used ? means[1] : means[0], (size_t)count * sizeof *row);
    memcpy(work->sheet->sun_lx + (size_t)x * (size_t)count, values.sun,
           (size_t)count * sizeof *row);

    if (work->lighting)
        pp_annual_lighting_add(work->lighting, worker, x, -1, means[0], means[1]);

    /* Figures without each of the batches. */
    double *without = work->without + (size_t)x * PP_YEAR_BATCHES * PP_ANNUAL_FIGURES;
    float *open = space->sky, *blinds = space->sun; /* the space is no longer needed and
                                                     * is used again */
    values.open = open;
    values.blinds = work->sheet->has_blinds ? blinds : NULL;
    for (int b = 0; b < PP_YEAR_BATCHES; b++) {
        struct pp_annual_figures part;
        leave_out(open, means[0], space->open + (size_t)b * work->open.step, count);
        leave_out(blinds, means[1], with_blinds + (size_t)b * work->open.step, count);
        pp_year_metrics_of(&part, &values, &work->clock, options->illuminances_lx,
                           options->illuminance_count);
        if (work->lighting)
            pp_annual_lighting_add(work->lighting, worker, x, b, open, blinds);
        part.sky_lxh.value = total_without(space->parts[0], b);
        part.sun_reflected_lxh.value = total_without(space->parts[1], b);
        for (int i = 0; i < PP_ANNUAL_FIGURES; i++)
            without[b * PP_ANNUAL_FIGURES + i] =
                pp_annual_sheet_figure(&part, i)->value;
    }
    for (int i = 0; i < PP_ANNUAL_FIGURES; i++) {
        double list[PP_YEAR_BATCHES];
        for (int b = 0; b < PP_YEAR_BATCHES; b++)
            list[b] = without[b * PP_ANNUAL_FIGURES + i];
        pp_annual_sheet_figure(figures, i)->std_error =
            pp_year_metrics_error(list, PP_YEAR_BATCHES);
    }
}

/* Calculates sky and sun of a block of points in the hours of a state. */
static enum pp_status light_block(const struct pp_annual_work *work,
                                  struct pp_annual_space *space,
                                  const struct pp_annual_state *state, int first,
                                  int count)
{
    if (state->plain) {
        struct pp_year_point point = {space->skies, space->suns};
        return pp_plain_year_point(state->plain, first, &state->columns, false, &point,
                                   NULL);
    }
    size_t row = (size_t)first * (size_t)work->groups.count
                 * (size_t)state->columns.column_count;
    enum pp_status status =
        pp_year_coefficients_sun(state->coefficients, first, count, space->suns, NULL);
    return status == PP_OK
               ? pp_year_coefficients_sky(state->coefficients, first, count,
                                          state->direct + row, space->skies, NULL)
               : status;
}

/* Calculates a block with open windows, each hour in its season. */
static enum pp_status light_open_block(const struct pp_annual_work *work,
                                       struct pp_annual_space *space, int first,
                                       int count)
{
    enum pp_status status = light_block(work, space, &work->open, first, count);
    if (status != PP_OK || !work->leafless)
        return status;
    struct pp_annual_space bare = {.skies = space->bare[0], .suns = space->bare[1]};
    size_t rows = (size_t)count * (size_t)work->groups.count * PP_YEAR_BATCHES;
    status = light_block(work, &bare, &work->bare, first, count);
    if (status == PP_OK) {
        pp_annual_seasons_merge(work, space->skies, bare.skies, rows);
        pp_annual_seasons_merge(work, space->suns, bare.suns, rows);
    }
    return status;
}

/* Calculates points first to end - 1 with the windows in one state. */
static enum pp_status compute_block(struct pp_annual_work *work,
                                    struct pp_annual_space *space,
                                    const struct pp_annual_state *state, int first,
                                    int end)
{
    size_t numbers = (size_t)work->groups.count * PP_YEAR_BATCHES * state->step;
    size_t all = PP_YEAR_BATCHES * work->open.step;
    enum pp_status status = state == &work->open
                                ? light_open_block(work, space, first, end - first)
                                : light_block(work, space, state, first, end - first);
    for (int x = first; x < end && status == PP_OK; x++) {
        float *blinds = space->blinds + (size_t)(x - first) * all;
        space->sky = space->skies + (size_t)(x - first) * numbers;
        space->sun = space->suns + (size_t)(x - first) * numbers;
        if (state != &work->open) {
            add_closed(work, space, state, x, blinds);
        } else {
            add_up(work, space, x, blinds);
            judge(work, space, x, blinds);
        }
    }
    return status;
}

bool pp_annual_point_block(void *data, int worker, int block)
{
    struct pp_annual_work *work = data;
    struct pp_annual_space *space = &work->spaces[worker];
    int first = block * work->block, end = first + work->block;
    end = end < work->receiver_count ? end : work->receiver_count;
    enum pp_status status = PP_OK;
    memset(space->blinds, 0,
           (size_t)work->block * PP_YEAR_BATCHES * work->open.step * sizeof(float));
    for (int s = 0; s < work->closed_count && status == PP_OK; s++)
        status = compute_block(work, space, &work->closed[s], first, end);
    if (status == PP_OK)
        status = compute_block(work, space, &work->open, first, end);
    work->status[first] = status;
    return status == PP_OK;
}
