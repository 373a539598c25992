/* selection.h - the methods selected by a user: a list separated by commas of
 *
 *     default   exact+bre, brs-table+bre, average-df; the same as NULL. If exact+bre
 *               does not cover the room, also the pair that replaces it
 *               (default_methods.h)
 *     all       every direct method with bre, except those with by_name (method.h);
 *               exact with every internal method; all methods for the whole daylight
 *               factor
 *     A+B       direct component by A, internally reflected one by B, and their sum
 *     NAME      one method, with the components that it gives
 */
#ifndef PP_METHODS_SELECTION_H
#define PP_METHODS_SELECTION_H

#include "methods/method.h"

/* One method, or a pair: one for the direct, another for the internally reflected
 * component. */
struct pp_choice {
    const struct pp_method *method;
    const struct pp_method *internal; /* internal method of a pair, else NULL */
};

/* Selected methods in list order, each once. */
struct pp_selection {
    int count;
    struct pp_choice *choices;
    bool usual; /* the selection contains "default" */
};

/* Reads a list of that form; NULL is the default. A wrong name is PP_BAD_INPUT, with
 * the valid names and the most similar one; so is a pair of methods that do not give
 * the two components. On success the caller clears the selection. */
enum pp_status pp_selection_parse(struct pp_selection *selection, const char *text,
                                  struct pp_error *err);
void pp_selection_clear(struct pp_selection *selection);

/* Adds a method: a direct one in a pair with bre, an internal one in a pair with exact,
 * any other alone. Does nothing if the selection already has the method. */
enum pp_status pp_selection_include(struct pp_selection *selection,
                                    const struct pp_method *method,
                                    struct pp_error *err);

/* PP_OK if pp_selection_parse would accept the text, else its error. */
enum pp_status pp_selection_check(const char *selection, struct pp_error *err);

#endif
