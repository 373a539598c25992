/* year_coefficients.h - the illuminances of a room's points in every hour of a year,
 * without direct light, in independent randomisations.
 *
 * Paths are traced only once, for coefficients that do not depend on the hour: for the
 * columns of light, and for sun on cells (year_batch.h). The hours need no paths: the
 * sky is given by its patches, and the sun is tested at its true position.
 *
 * Usage: create the coefficients for a room, add the light of a year, then read points,
 * from several threads at once if needed.
 */
#ifndef PP_SIMULATE_YEAR_YEAR_COEFFICIENTS_H
#define PP_SIMULATE_YEAR_YEAR_COEFFICIENTS_H

#include "simulate/year/light_columns.h"
#include "simulate/year/sun_sums.h"
#include "simulate/year/year_store.h"

enum { PP_YEAR_CELLS_MOST = 65535 };

struct pp_year_coefficient_options {
    int paths;   /* paths per point in each randomisation; a power of two */
    int cells;   /* approximate number of cells */
    int patches; /* 145, 577, 2305 */
    uint64_t seed;
    const struct pp_year_stores *stores; /* NULL: none */

    /* Called between the rows of a batch, by the thread that called the function. done:
     * fraction of the batches that are done. Return false to stop. NULL: never
     * stops. */
    bool (*goes_on)(void *data, double done);
    void *data;
};

struct pp_year_coefficients;

/* scene: of a world, with diffuse finishes only. group_of_opening: group of each
 * opening, 0 to group_count - 1, with at most PP_YEAR_GROUPS_MOST groups. If a group
 * contains openings that scatter light by direction, all its openings must be of the
 * same kind and in one face, and none may be clear. All arguments, the receivers and
 * the pool must outlive *coefficients. PP_INTERRUPTED if goes_on has returned false;
 * likewise in pp_year_coefficients_light. */
enum pp_status pp_year_coefficients_create(
    struct pp_year_coefficients **coefficients, const struct pp_light_scene *scene,
    const struct pp_environment *environment, const struct pp_receiver *receivers,
    int receiver_count, const int *group_of_opening, int group_count,
    const struct pp_year_coefficient_options *options, struct pp_thread_pool *pool,
    struct pp_error *err);
void pp_year_coefficients_destroy(struct pp_year_coefficients *coefficients);

/* Finds the cells that the sun reaches in every hour. light must outlive the
 * coefficients. */
enum pp_status pp_year_coefficients_light(struct pp_year_coefficients *coefficients,
                                          const struct pp_light_columns *light,
                                          struct pp_error *err);

/* Mean illuminance (lx) on the outside of a group's panes in every hour and batch:
 * lx[batch][hour]. Each row has tiles x PP_LIGHT_LANES entries. */
void pp_year_coefficients_on_panes(const struct pp_year_coefficients *coefficients,
                                   int group, float *lx);

/* Illuminance (lx) of a receiver from a group's panes, each with a uniform exitance of
 * 1 lm/m2, in one batch. */
float pp_year_coefficients_by_panes(const struct pp_year_coefficients *coefficients,
                                    int receiver, int group, int batch);

/* Parts of a point's illuminances, lx. */
struct pp_year_point {
    float *sky; /* sky and ground: [group][batch][hour]; each row has tiles x
                 * PP_LIGHT_LANES entries */
    float *sun; /* sunlight that surfaces reflect or panes scatter: same order */
};

/* Fills `sky` of receivers first to first + count - 1, one after the other. direct:
 * [receiver][group][column], added to the coefficients of all batches; NULL: nothing is
 * added. */
enum pp_status pp_year_coefficients_sky(const struct pp_year_coefficients *coefficients,
                                        int first, int count, const float *direct,
                                        float *sky, struct pp_error *err);

/* Fills `sun` in the same way; count: at most PP_YEAR_BLOCK. */
enum pp_status pp_year_coefficients_sun(const struct pp_year_coefficients *coefficients,
                                        int first, int count, float *sun,
                                        struct pp_error *err);

/* Relative standard error of a point's simulated light for equal values in all columns
 * of light, without sunlight. This estimate needs no hours; 0 without light. */
double pp_year_coefficients_spread(const struct pp_year_coefficients *coefficients,
                                   int receiver);

/* Mean of a receiver's coefficients over the batches, by column, for all groups
 * together, without direct light. */
void pp_year_coefficients_mean(const struct pp_year_coefficients *coefficients,
                               int receiver, float *mean);

int pp_year_coefficients_cells(const struct pp_year_coefficients *coefficients);
const struct pp_sky_patches *pp_year_coefficients_patches(
    const struct pp_year_coefficients *coefficients);

#endif
