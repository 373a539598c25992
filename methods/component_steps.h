/* component_steps.h - the last steps of every method: the corrections of each opening's
 * components, and the sum over openings. */
#ifndef PP_METHODS_COMPONENT_STEPS_H
#define PP_METHODS_COMPONENT_STEPS_H

#include "methods/method.h"

/* Names ("sky component") and symbols ("SC", for corrected values) of the
 * components. */
extern const char *const pp_component_steps_names[PP_COMPONENT_COUNT];
extern const char *const pp_component_steps_symbols[PP_COMPONENT_COUNT];

/* The component that a method returns in part.sky or part.value. */
enum pp_component pp_component_steps_given(const struct pp_method *method);

double pp_component_steps_figure(const struct pp_amounts *amounts,
                                 enum pp_component component);

/* Records the corrections of an opening, D included, and the corrected components,
 * after the method's own steps, which begin at index `first`. */
void pp_component_steps_add(struct pp_steps *steps, const struct pp_method *method,
                            const struct pp_world *world, int index,
                            const struct pp_part *part,
                            const struct pp_amounts *corrected, int first);

/* Records the sums over the openings if there is more than one. */
void pp_component_steps_add_sums(struct pp_steps *steps, const struct pp_method *method,
                                 const struct pp_world *world,
                                 const struct pp_amounts *sum);

#endif
