/* annual_state.h - the light of a room in some hours of a year, with its windows in one
 * state: open, or with closed blinds. Inside studies/year/ only.
 *
 * The light through a group of windows is calculated with the windows of all groups in
 * the same state. In hours with some groups closed, light through an open group without a
 * device is that of the closed state (annual_closed.c). Otherwise a group in another state
 * reflects another share of that light, which is neglected.
 */
#ifndef PP_STUDIES_YEAR_ANNUAL_STATE_H
#define PP_STUDIES_YEAR_ANNUAL_STATE_H

#include "simulate/year/plain_year.h"
#include "simulate/year/year_coefficients.h"
#include "simulate/year/year_store.h"
#include "studies/year/blind_groups.h"

struct pp_annual_state {
    const struct pp_world *world; /* not owned */
    struct pp_world *turned;      /* copy of the world with slats turned, or with
                                   * trees in one season; owned; NULL: none */
    int count;                    /* number of hours */
    int *hours;                   /* the year's sky of each hour; owned */
    struct pp_perez_sky *skies;   /* in the room's axes; owned */
    size_t step;                  /* numbers from one row of hours to the next */
    struct pp_light_scene *scene;
    struct pp_environment *environment;
    struct pp_light_columns columns;
    struct pp_year_coefficients *coefficients; /* NULL for the plain year */
    struct pp_plain_year *plain;
    float *direct;     /* [receiver][group][column]: direct light of sky and ground */
    float *direct_sun; /* [receiver][group][hour], lx */
    float
        *share; /* [group][sky of the year]: share of the group's light with blinds that
                   * is of this state; owned; NULL: open windows */
};

struct pp_annual_work;

/* Prepares the state of a world: for all hours, or for those in which it has a share. The
 * caller clears *state, even after a failure. */
enum pp_status pp_annual_state_init(struct pp_annual_state *state,
                                    const struct pp_annual_work *work,
                                    struct pp_error *err);
void pp_annual_state_clear(struct pp_annual_state *state);

/* Traces the paths: `paths` per point and randomisation, unless they are in the stores.
 * stores NULL: none. */
enum pp_status pp_annual_state_trace(struct pp_annual_state *state,
                                     struct pp_annual_work *work, int paths,
                                     const struct pp_year_stores *stores,
                                     struct pp_error *err);

/* Finds the sunlit cells of every hour, after the paths. */
enum pp_status pp_annual_state_light(struct pp_annual_state *state,
                                     struct pp_error *err);

/* Calculates the direct light of point x: its coefficients and its sun in every hour. */
enum pp_status pp_annual_state_see(struct pp_annual_state *state,
                                   const struct pp_annual_work *work, int x);

#endif
