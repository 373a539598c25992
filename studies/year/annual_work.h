/* annual_work.h - data of a room's year while it is computed. Inside studies/year/
 * only. */
#ifndef PP_STUDIES_YEAR_ANNUAL_WORK_H
#define PP_STUDIES_YEAR_ANNUAL_WORK_H

#include "simulate/year/plain_year.h"
#include "simulate/year/year_coefficients.h"
#include "studies/year/annual.h"
#include "studies/year/annual_lighting.h"
#include "studies/year/blind_groups.h"
#include "studies/year/year_metrics.h"

struct pp_annual_work {
    struct pp_annual_sheet *sheet;
    const struct pp_world *world;
    const struct pp_outside_light *light;
    const struct pp_receiver *receivers;
    int receiver_count;
    const struct pp_weather_year *year;
    const struct pp_annual_options *options;
    struct pp_perez_sky *skies; /* in the room's axes */
    struct pp_year_clock clock;
    struct pp_blind_groups groups;
    struct pp_thread_pool *pool;
    struct pp_light_scene *scene;
    struct pp_environment *environment;
    struct pp_light_columns columns;
    struct pp_year_coefficients *coefficients; /* NULL for the plain year */
    struct pp_plain_year *plain;
    struct pp_annual_lighting *lighting; /* NULL: no electric light */
    int samples;

    int block;         /* points that a worker computes together */
    size_t step;       /* numbers from one row of hours to the next */
    float *direct;     /* [receiver][group][column]: direct light of sky and ground */
    float *direct_sun; /* [receiver][group][sky], lx */
    unsigned char *closed; /* [group][sky]: true if the group's blinds are closed */
    float *on_panes;       /* [group][batch][step], lx outside */
    double *without;       /* [receiver][batch][figure]: figures without that batch */
    double begun, ended;   /* share of the whole before and after the current step */
    pp_thread_pool_work *function; /* of each block of points */
    int blocks;
    bool stopped;                   /* the watch has stopped the computation */
    double *group_light;            /* [receiver][group][1 + batch], lx h */
    struct pp_annual_space *spaces; /* by worker */
    enum pp_status *status;         /* by receiver */
};

/* Computes the direct light of point x: its coefficients and its sun in every hour.
 * (annual_direct.c) */
bool pp_annual_direct_see(void *work, int worker, int x);

/* Finds the hours with closed blinds, from the direct sun at all points, and the light
 * on the panes. */
void pp_annual_direct_close_blinds(struct pp_annual_work *work);

/* Number of points in a block: the reflected sunlight of a block takes 20 MB at most,
 * with any number of groups of openings. Allocates space for the hours of a block, for
 * each worker; computes hours and figures of the points of a block. (annual_point.c) */
int pp_annual_point_block_size(int groups);
enum pp_status pp_annual_point_make_spaces(struct pp_annual_work *work,
                                           struct pp_error *err);
void pp_annual_point_clear_spaces(struct pp_annual_work *work);
bool pp_annual_point_block(void *work, int worker, int block);

/* Measures the error of patches and cells on a sample of points and hours.
 * (annual_discretisation.c) */
enum pp_status pp_annual_discretisation_measure(struct pp_annual_work *work,
                                                struct pp_error *err);

#endif
