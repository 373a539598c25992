/* mistakes.h - all mistakes in an input file, collected before they are printed. */
#ifndef PP_MODEL_BASE_MISTAKES_H
#define PP_MODEL_BASE_MISTAKES_H

#include <stdbool.h>

struct pp_input_mistake {
    int line;   /* from 1; 0: the file as a whole */
    char *text; /* the mistake, and the expected value */
};

struct pp_mistakes {
    char *file; /* as given by the user */
    struct pp_input_mistake *list;
    int count;
    bool truncated; /* more than PP_MISTAKES_MOST mistakes, or out of memory */
};

enum { PP_MISTAKES_MOST = 1000 };

/* Allocates the list, for users of pepperpot.h, which does not define the struct. NULL
 * if memory runs out. */
struct pp_mistakes *pp_mistakes_create(const char *file);
void pp_mistakes_destroy(struct pp_mistakes *mistakes); /* NULL is allowed */
int pp_mistakes_count(const struct pp_mistakes *mistakes);
int pp_mistakes_line(const struct pp_mistakes *mistakes, int index);
const char *pp_mistakes_text(const struct pp_mistakes *mistakes, int index);

void pp_mistakes_init(struct pp_mistakes *mistakes, const char *file);
void pp_mistakes_clear(struct pp_mistakes *mistakes);

/* Adds a mistake, unless the same text on the same line exists. */
void pp_mistakes_add(struct pp_mistakes *mistakes, int line, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* Sorts by line; mistakes on one line keep their order. */
void pp_mistakes_sort(struct pp_mistakes *mistakes);

#endif
