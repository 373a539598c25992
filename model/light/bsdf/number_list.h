/* number_list.h - numbers separated by white space or commas, as in the data of
 * WINDOW's files. */
#ifndef PP_MODEL_LIGHT_BSDF_NUMBER_LIST_H
#define PP_MODEL_LIGHT_BSDF_NUMBER_LIST_H

#include <stdbool.h>

/* Initialise with zeros; the caller frees the list. */
struct pp_number_list {
    double *list;
    int count, capacity;
    bool out_of_memory;
};

/* The first character that is neither white nor a comma. */
const char *pp_number_list_skip(const char *text);

/* Appends the numbers from *text on, up to a brace or the end; *text is moved there.
 * False if there is other text among the numbers, if there are more than `most`
 * numbers, or if memory runs out. */
bool pp_number_list_read(struct pp_number_list *numbers, const char **text, int most);

#endif
