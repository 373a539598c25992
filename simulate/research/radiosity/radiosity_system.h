/* radiosity_system.h - the radiosity equations of all elements, solved by Gauss-Seidel.
 *
 *     B = exitance + rho E + tau E',  E = sum of form factor times B over elements,
 *                                       openings and cells outside
 *
 * B is the radiosity of an element and E its illuminance. E' is the illuminance of the
 * other side of a scattering pane. Each undivided element and each cell outside has one
 * equation.
 */
#ifndef PP_SIMULATE_RESEARCH_RADIOSITY_RADIOSITY_SYSTEM_H
#define PP_SIMULATE_RESEARCH_RADIOSITY_RADIOSITY_SYSTEM_H

#include "model/base/thread_pool.h"
#include "simulate/research/radiosity/element_light.h"
#include "simulate/research/radiosity/outside_cells.h"

struct pp_radiosity_system_accuracy {
    struct pp_opening_light_accuracy openings;
    double even; /* tolerated variation, as a fraction of an element's illuminance */
    struct pp_element_light_accuracy elements; /* all but the tolerance */
    int directions; /* directions outdoors, from an element of a scattering pane */
};

/* The equation of one element: the light that it receives. */
struct pp_radiosity_system_row {
    struct pp_light_sum openings, elements;
    struct pp_light_sum behind; /* E', for a scattering pane */
    struct pp_wanted wanted;
    double illuminance;
    bool has_openings;
};

struct pp_radiosity_system {
    struct pp_element_tree *tree; /* this and the next three: not owned */
    const struct pp_light_room *room;
    struct pp_outside_cells *cells;
    struct pp_thread_pool *pool;
    struct pp_radiosity_system_accuracy accuracy;
    struct pp_radiosity_system_row *rows; /* by element; not used if it is divided */
    int row_count, row_room;
};

void pp_radiosity_system_clear(struct pp_radiosity_system *system); /* the rows */

/* Makes the rows of all elements that are undivided now. Keeps light that was gathered
 * from openings before. */
enum pp_status pp_radiosity_system_gather(struct pp_radiosity_system *system,
                                          struct pp_error *err);

/* Sets all radiosities, of elements and cells. */
void pp_radiosity_system_solve(struct pp_radiosity_system *system);

/* Adds the present value of the sum, by component, to value[]. With `scattered`, light
 * that an element receives from behind its pane counts as sky or external component.
 * Otherwise each term has its own component. */
void pp_radiosity_system_value(const struct pp_radiosity_system *system,
                               const struct pp_light_sum *sum, bool scattered,
                               double value[PP_LIGHT_PARTS]);

/* Divides each element of the list once, and counts the divided elements in
 * *divided. */
enum pp_status pp_radiosity_system_divide(struct pp_radiosity_system *system,
                                          const struct pp_wanted *wanted, int *divided,
                                          struct pp_error *err);

#endif
