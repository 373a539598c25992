/* part_steps.h - the parts of an opening that are read one by one, sky here and an
 * obstruction there, as they stand in formulae: sc_1, erc_2, sc_3, and their sums.
 */
#ifndef PP_METHODS_PART_STEPS_H
#define PP_METHODS_PART_STEPS_H

#include <stdbool.h>

#include "model/results/steps.h"

struct pp_part_steps {
    struct pp_steps *steps;      /* NULL: nothing is set down */
    int first;                   /* the first step of this opening */
    int parts;                   /* in all: of a single one names have no number */
    int number;                  /* of the part that is being read, from 1 */
    int sky_count, hidden_count; /* read so far */
    double sky;                  /* sum */
};

/* Names for formulae. */
struct pp_symbol {
    char text[16];
};

/* `parts` are about to be read. */
struct pp_part_steps pp_part_steps_begin(struct pp_steps *steps, int parts);

/* Goes on to the next part. */
void pp_part_steps_next(struct pp_part_steps *terms);

/* The name of a figure of this part: "n", or "n_2" where there are several. */
struct pp_symbol pp_part_steps_symbol(const struct pp_part_steps *terms,
                                      const char *name);

/* Sets down a figure of this part, worked out by a formula in which each # stands for
 * the part's number: "k_r# - k_l#". */
void pp_part_steps_figure(struct pp_part_steps *terms, enum pp_step_unit unit,
                          double value, const char *name, const char *formula,
                          const char *what);

/* Sets down what this part comes to, sky component or externally reflected one, by a
 * formula of that kind. */
void pp_part_steps_component(struct pp_part_steps *terms, bool hidden, double share,
                             const char *formula, const char *what);

/* Sets down the sums: sc, and erc where anything is hidden. A sum of sky that comes out
 * below 0 counts as 0. */
void pp_part_steps_end(struct pp_part_steps *terms);

#endif
