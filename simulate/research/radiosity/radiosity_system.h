/* radiosity_system.h - the radiosity equations of all elements, solved by Gauss-Seidel.
 *
 *     B = exitance + rho E + tau E',  E = sum of form factor times B over elements,
 *                                       openings and cells outside
 *
 * E' is the illuminance of the other side of a scattering pane. Each undivided element and
 * each cell outside has one equation.
 */
#ifndef PP_SIMULATE_RESEARCH_RADIOSITY_RADIOSITY_SYSTEM_H
#define PP_SIMULATE_RESEARCH_RADIOSITY_RADIOSITY_SYSTEM_H

#include "model/base/thread_pool.h"
#include "simulate/research/radiosity/element_light.h"
#include "simulate/research/radiosity/outside_cells.h"

struct pp_radiosity_system_accuracy {
    struct pp_opening_light_accuracy openings;
    double even; /* tolerated variation, as a share of an element's illuminance */
    struct pp_element_light_accuracy elements; /* except its tolerance */
    int directions; /* directions outdoors, from an element of a scattering pane */
};

/* The equation of one element: the light that it receives. */
struct pp_radiosity_system_row {
    struct pp_light_sum openings, elements;
    struct pp_light_sum behind; /* E', of a pane that scatters */
    struct pp_wanted wanted;
    double illuminance;
    bool has_openings;
};

struct pp_radiosity_system {
    struct pp_element_tree *tree; /* none of these is owned */
    const struct pp_light_room *room;
    struct pp_outside_cells *cells;
    struct pp_thread_pool *pool;
    struct pp_radiosity_system_accuracy accuracy;
    struct pp_radiosity_system_row *rows; /* by element; of undivided ones only */
    int row_count, row_room;
};

void pp_radiosity_system_clear(struct pp_radiosity_system *system); /* its rows */

/* Makes the rows for all elements that are undivided now; light gathered earlier from
 * openings is kept. */
enum pp_status pp_radiosity_system_gather(struct pp_radiosity_system *system,
                                          struct pp_error *err);

/* Sets all radiosities, of elements and cells. */
void pp_radiosity_system_solve(struct pp_radiosity_system *system);

/* Adds the present value of the sum, by component, to value[]. With `scattered`, an
 * element's light from behind its pane counts as sky or external component; otherwise
 * each term has its own component. */
void pp_radiosity_system_value(const struct pp_radiosity_system *system,
                               const struct pp_light_sum *sum, bool scattered,
                               double value[PP_LIGHT_PARTS]);

/* Divides the elements of the list, each once; *divided counts them. */
enum pp_status pp_radiosity_system_divide(struct pp_radiosity_system *system,
                                          const struct pp_wanted *wanted, int *divided,
                                          struct pp_error *err);

#endif
