/* year_coefficients.h - the illuminances of a room's points in every hour of a year,
 * without direct light, in independent randomisations.
 *
 *     coefficients, by paths alone:     light columns, sun on cells  (year_batch.h)
 *     hours, without any path:          sky by patch, sun by its true position
 *
 * Use: create it for a room, add the light of a year, then read points, by any number
 * of threads at once.
 */
#ifndef PP_SIMULATE_YEAR_YEAR_COEFFICIENTS_H
#define PP_SIMULATE_YEAR_YEAR_COEFFICIENTS_H

#include "simulate/year/light_columns.h"
#include "simulate/year/year_batch.h"

enum { PP_YEAR_BATCHES = 16, PP_YEAR_GROUPS_MOST = 16, PP_YEAR_CELLS_MOST = 65535 };

struct pp_year_coefficient_options {
    int paths;   /* of a point in each randomisation; a power of two */
    int cells;   /* wanted */
    int patches; /* 145, 577, 2305 */
    uint64_t seed;
};

struct pp_year_coefficients;

/* scene: of a world, with every finish diffuse; group_of_opening: by opening, 0 to
 * group_count - 1, PP_YEAR_GROUPS_MOST at most. All of these, and the receivers and the pool, must live as long. */
enum pp_status pp_year_coefficients_create(
    struct pp_year_coefficients **coefficients, const struct pp_light_scene *scene,
    const struct pp_environment *environment, const struct pp_receiver *receivers,
    int receiver_count, const int *group_of_opening, int group_count,
    const struct pp_year_coefficient_options *options, struct pp_thread_pool *pool,
    struct pp_error *err);
void pp_year_coefficients_destroy(struct pp_year_coefficients *coefficients);

/* Tests the sun of every hour on the cells. light must live as long. */
enum pp_status pp_year_coefficients_light(struct pp_year_coefficients *coefficients,
                                          const struct pp_light_columns *light,
                                          struct pp_error *err);

/* Illuminance (lx) on the outside of a group's panes, the mean over their area, in every
 * hour and batch: [batch][hour, tiles x PP_LIGHT_LANES of them]. */
void pp_year_coefficients_on_panes(const struct pp_year_coefficients *coefficients,
                                   int group, float *lx);

/* Illuminance of a receiver by panes of a group that have an even exitance of 1 lm/m2, by
 * batch. */
float pp_year_coefficients_by_panes(const struct pp_year_coefficients *coefficients,
                                    int receiver, int group, int batch);

/* Parts of a point's illuminances. */
struct pp_year_point {
    float *sky; /* [group][batch][hour, tiles x PP_LIGHT_LANES of them]: sky, ground */
    float *sun; /* the same: sunlight reflected by surfaces */
};

/* Fills both (lx). direct: [group][column], added to the coefficients of all batches;
 * NULL: nothing. */
enum pp_status pp_year_coefficients_point(
    const struct pp_year_coefficients *coefficients, int receiver, const float *direct,
    struct pp_year_point *point, struct pp_error *err);

/* Standard error of a point's simulated light over that light, under a uniform sky and
 * with equal sunlight on all cells: an estimate that needs no hours. 0 without
 * light. */
double pp_year_coefficients_spread(const struct pp_year_coefficients *coefficients,
                                   int receiver);

/* The mean over batches of a receiver's coefficients, all groups together, without its
 * direct light: by column. */
void pp_year_coefficients_mean(const struct pp_year_coefficients *coefficients,
                               int receiver, float *mean);

int pp_year_coefficients_cells(const struct pp_year_coefficients *coefficients);
const struct pp_sky_patches *pp_year_coefficients_patches(
    const struct pp_year_coefficients *coefficients);

#endif
