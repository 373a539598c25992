/* annual_work.h - data of a room's year while it is computed. Inside studies/year/
 * only. */
#ifndef PP_STUDIES_YEAR_ANNUAL_WORK_H
#define PP_STUDIES_YEAR_ANNUAL_WORK_H

#include "studies/year/annual.h"
#include "studies/year/annual_lighting.h"
#include "studies/year/annual_state.h"
#include "studies/year/year_metrics.h"

struct pp_annual_work {
    struct pp_annual_sheet *sheet;
    const struct pp_world *world;
    const struct pp_outside_light *light;
    const struct pp_receiver *receivers;
    int receiver_count;
    double area_m2; /* of all receivers; NAN: they have none, and count equally */
    double whole;   /* sum of their weights (point_areas.h) */
    const struct pp_weather_year *year;
    const struct pp_annual_options *options;
    struct pp_year_clock clock;
    struct pp_blind_groups groups;
    struct pp_thread_pool *pool;
    struct pp_world *opened;     /* world without its devices; NULL: it has none */
    struct pp_annual_state open; /* in all hours */
    struct pp_annual_state bare; /* the same without leaves; world NULL: none */
    struct pp_world *season;     /* open.world in one season; NULL: the same always */
    struct pp_world *leafless;   /* bare.world; NULL: none */
    unsigned char *is_bare;      /* [sky]: true without leaves */
    struct pp_annual_state *closed; /* with the room's own blinds */
    int closed_count;
    struct pp_annual_state *state;       /* whose direct light is being calculated */
    struct pp_annual_lighting *lighting; /* NULL: no electric light */
    int samples;

    int block;             /* points that a worker computes together */
    unsigned char *closes; /* [group][sky]: true if the group is closed */
    unsigned char *taken;  /* [group][sky]: true if its light with blinds is that of a
                            * closed state */
    float *on_panes;       /* [group][batch][step], lx outside */
    double *without;       /* [receiver][batch][figure]: figures without that
                                   * batch */
    double scale;          /* factor on the shares of the steps with open windows */
    double begun, ended;   /* share of the whole before and after the current
                                   * step */
    pp_thread_pool_work *function; /* of each block of points */
    int blocks;
    bool stopped;                   /* true: the watch has stopped the computation */
    double *group_light;            /* [receiver][group][1 + batch]: light of the year,
                                     * lx h */
    struct pp_annual_space *spaces; /* indexed by worker */
    enum pp_status *status;         /* indexed by receiver */
};

/* Shows the share that is done of the current step; false if the computation shall
 * stop. data: the work. */
bool pp_annual_work_goes_on(void *data, double done);

/* Begins a step of the computation that ends at this share of the whole. */
bool pp_annual_work_next_step(struct pp_annual_work *work, double ended);

/* Calls a function for every block of points. PP_BAD_INPUT: the outline of the sky seen
 * through an opening has too many corners; PP_INTERRUPTED; otherwise it fails only if
 * out of memory. */
enum pp_status pp_annual_work_for_points(struct pp_annual_work *work, int block,
                                         pp_thread_pool_work *function,
                                         struct pp_error *err);

/* Calculates the direct light of point x in the state. (annual_direct.c) */
bool pp_annual_direct_see(void *work, int worker, int x);

/* Finds the hours with closed blinds by the chosen control, with the direct sun at all
 * points through open windows, and the light on the panes. Counts the hours in which
 * closed blinds still let too much direct sun pass. */
enum pp_status pp_annual_direct_find(struct pp_annual_work *work, struct pp_error *err);
void pp_annual_direct_count_unmet(struct pp_annual_work *work);

/* Plans the states of closed windows, each with its shares: those of closed groups with a
 * device of their own and, in the same hours, of groups without one that are open.
 * (annual_closed.c) */
enum pp_status pp_annual_closed_plan(struct pp_annual_work *work, struct pp_error *err);

/* True if the group has a device of its own. */
bool pp_annual_direct_has_device(const struct pp_annual_work *work, int group);

/* Number of points in a block: the light of a block takes 40 MB at most, with any
 * number of groups of openings (80 MB if trees lose their leaves). Allocates space for
 * the hours of a block, for each worker; computes hours and figures of the points of a
 * block. (annual_point.c) */
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
