/* balance.h - the system of equations: what every element takes of all others, of the
 * openings and of what is outside, and the radiosities at which all of it balances.
 *
 *     B = exitance + rho E + tau E',  E = sum over all that it takes
 *
 * E' of the other side of a pane that scatters. Undivided elements and cells outside have
 * an equation each; they are solved by turns (Gauss-Seidel) in their order.
 */
#ifndef PP_SIMULATE_ELEMENTS_BALANCE_H
#define PP_SIMULATE_ELEMENTS_BALANCE_H

#include "model/base/thread_pool.h"
#include "simulate/elements/element_light.h"
#include "simulate/elements/outside_cells.h"

struct pp_balance_accuracy {
    struct pp_opening_light_accuracy openings;
    double even; /* share of an element's illuminance that another may err by */
    struct pp_element_light_accuracy elements; /* but for its tolerance */
    int directions; /* outdoors, from an element of a pane that scatters */
};

/* What one element takes. */
struct pp_balance_row {
    struct pp_light_sum openings, elements;
    struct pp_light_sum behind; /* E', of a pane that scatters */
    struct pp_wanted wanted;
    double illuminance;
    bool has_openings;
};

struct pp_balance {
    struct pp_element_tree *tree; /* none of these is owned */
    const struct pp_light_room *room;
    struct pp_outside_cells *cells;
    struct pp_thread_pool *pool;
    struct pp_balance_accuracy accuracy;
    struct pp_balance_row *rows; /* by element; of undivided ones only */
    int row_count, row_room;
};

void pp_balance_clear(struct pp_balance *balance); /* its rows */

/* The rows for all elements that are undivided now; what came by openings before is
 * kept. */
enum pp_status pp_balance_gather(struct pp_balance *balance, struct pp_error *err);

/* Sets all radiosities, of elements and cells. */
void pp_balance_solve(struct pp_balance *balance);

/* What the sum comes to now, by component, added to value[]. With `scattered` an element's
 * light from behind is sky's or outside's, else all is the term's own component. */
void pp_balance_value(const struct pp_balance *balance, const struct pp_light_sum *sum,
                      bool scattered, double value[PP_LIGHT_PARTS]);

/* Divides the elements of the list, each once; *divided counts them. */
enum pp_status pp_balance_divide(struct pp_balance *balance,
                                 const struct pp_wanted *wanted, int *divided,
                                 struct pp_error *err);

#endif
