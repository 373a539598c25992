/* light_sum.h - the light received by a place, as a sum over its sources: a row of the
 * system of equations.
 *
 * Sky and fixed light outside are numbers. Elements and places outside are unknowns,
 * represented by a weight: the form factor times the transmittance. Each term belongs
 * to one component (PP_SC, PP_ERC or PP_IRC) at the place.
 */
#ifndef PP_SIMULATE_RESEARCH_RADIOSITY_LIGHT_SUM_H
#define PP_SIMULATE_RESEARCH_RADIOSITY_LIGHT_SUM_H

#include "pepperpot.h"
#include "simulate/research/radiosity/element_tree.h"

enum { PP_LIGHT_PARTS = 3 }; /* PP_SC, PP_ERC, PP_IRC */

struct pp_light_term {
    int source; /* an element; or -1 - i: place outside i (outside_cells.h) */
    enum pp_component part;
    double weight;
};

/* A place outside whose radiosity becomes a term. */
struct pp_outside_hit {
    int side; /* index of a facet's side; -1: the ground */
    struct pp_vec3 point;
    enum pp_component part;
    double weight;
};

struct pp_light_sum {
    double fixed[PP_LIGHT_PARTS];
    struct pp_light_term *terms;
    int term_count, term_room;
    struct pp_outside_hit *hits;
    int hit_count, hit_room;
    bool failed; /* memory was exhausted: the sum is incomplete */
};

void pp_light_sum_clear(struct pp_light_sum *sum); /* the sum is then empty */

void pp_light_sum_add(struct pp_light_sum *sum, int source, enum pp_component part,
                      double weight);
void pp_light_sum_hit(struct pp_light_sum *sum, int side, struct pp_vec3 point,
                      enum pp_component part, double weight);

/* Position in a sum, used to scale the light that is added later. */
struct pp_light_mark {
    double fixed[PP_LIGHT_PARTS];
    int term_count, hit_count;
};

struct pp_light_mark pp_light_sum_mark(const struct pp_light_sum *sum);

/* Multiplies all light added between the two marks by the factor; 0 removes it. */
void pp_light_sum_scale(struct pp_light_sum *sum, const struct pp_light_mark *from,
                        const struct pp_light_mark *to, double factor);

/* Drops terms and hits with weight 0. */
void pp_light_sum_tidy(struct pp_light_sum *sum);

#endif
