/* selection.h - which methods somebody asked for. */
#ifndef PP_METHODS_SELECTION_H
#define PP_METHODS_SELECTION_H

#include "methods/method.h"

/* One method, or a direct one with an internal one. */
struct pp_choice {
    const struct pp_method *method;
    const struct pp_method *internal; /* of a pair; else NULL */
};

/* In the order asked for, each once. */
struct pp_selection {
    int count;
    struct pp_choice *choices;
};

/* Reads a selection as methods/evaluate.h describes it; NULL is the default one. */
enum pp_status pp_selection_parse(struct pp_selection *selection, const char *text,
                                  struct pp_error *err);
void pp_selection_clear(struct pp_selection *selection);

#endif
