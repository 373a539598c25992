/* annual_direct.c - direct light of sky and sun at the points, and the hours in which
 * the sun closes the blinds. */
#include "methods/exact/sky_view.h"
#include "studies/year/annual_work.h"

/* Largest pieces of sky, a third of the patches: 1.7 degrees. */
static const double PIECE_RAD = 0.03;

struct piece_sums {
    const struct pp_annual_work *work;
    float *rows;
};

static void add_piece_of_sky(void *data, const struct pp_sky_piece *piece)
{
    struct piece_sums *sums = data;
    const struct pp_annual_work *work = sums->work;
    float *row = sums->rows
                 + work->groups.of_opening[piece->opening] * work->columns.column_count;
    if (piece->ground)
        row[work->columns.patches.count] +=
            (float)(piece->coefficient * pp_outside_light_ground(work->light) / PP_PI);
    else
        row[pp_sky_patches_of(&work->columns.patches, piece->u)] +=
            (float)piece->coefficient;
}

static enum pp_status see_from(struct pp_annual_work *work, int x)
{
    struct pp_sky_view view;
    int groups = work->groups.count;
    enum pp_status status =
        pp_sky_view_init(&view, work->world, &work->receivers[x], NULL);
    if (status != PP_OK)
        return status;
    struct piece_sums sums = {
        work,
        work->direct + (size_t)x * (size_t)groups * (size_t)work->columns.column_count};
    status = pp_sky_view_pieces(&view, PIECE_RAD, add_piece_of_sky, &sums, NULL);
    int count = work->year->sky_count;
    float *sun = work->direct_sun + (size_t)x * (size_t)groups * (size_t)count;
    for (int t = 0; t < count; t++) {
        const struct pp_perez_sky *sky = &work->skies[t];
        int opening;
        double share =
            sky->direct_lx > 0.0 ? pp_sky_view_sun(&view, sky->sun, &opening) : 0.0;
        if (share > 0.0)
            sun[(size_t)work->groups.of_opening[opening] * (size_t)count + (size_t)t] =
                (float)(share * sky->direct_lx);
    }
    pp_sky_view_clear(&view);
    return status;
}

bool pp_annual_direct_see(void *data, int worker, int x)
{
    struct pp_annual_work *work = data;
    (void)worker;
    work->status[x] = see_from(work, x);
    return work->status[x] == PP_OK;
}

void pp_annual_direct_close_blinds(struct pp_annual_work *work)
{
    static const float SUNLIT_LX = 1000.0f;
    int count = work->year->sky_count;
    for (int g = 0; g < work->groups.count; g++)
        for (int t = 0; t < count; t++) {
            int sunlit = 0;
            for (int x = 0; x < work->receiver_count; x++)
                sunlit += work->direct_sun[((size_t)x * (size_t)work->groups.count
                                            + (size_t)g)
                                               * (size_t)count
                                           + (size_t)t]
                          >= SUNLIT_LX;
            bool closes = pp_blind_groups_closes(sunlit, work->receiver_count);
            work->closed[(size_t)g * (size_t)count + (size_t)t] = closes;
            if (closes)
                work->sheet->groups[g].closed_h += work->clock.occupied_h[t];
        }
    for (int g = 0; g < work->groups.count && work->coefficients; g++)
        pp_year_coefficients_on_panes(work->coefficients, g,
                                      work->on_panes
                                          + (size_t)(g * PP_YEAR_BATCHES) * work->step);
}
