/* part_steps.h - the steps of an opening that is read part by part.
 *
 * A part shows the sky or an obstruction. The steps of part k have symbols with that
 * number (sc_1, erc_2, sc_3); their sums are sc and erc.
 */
#ifndef PP_METHODS_PART_STEPS_H
#define PP_METHODS_PART_STEPS_H

#include <stdbool.h>

#include "model/results/worksheet.h"

struct pp_part_steps {
    struct pp_steps *steps;     /* NULL: no steps are recorded */
    struct pp_worksheet *sheet; /* NULL: figures are recorded as steps only */
    int first;                  /* index of the opening's first step */
    int parts;  /* number of parts of the opening; symbols of a single part have no
                 * number */
    int number; /* number of the current part, from 1 */
    int sky_count, hidden_count; /* components recorded so far */
    double sky;                  /* sum of the sky components so far */
};

/* Begins the steps of an opening with that number of parts: with a worksheet, or to
 * record steps alone. */
struct pp_part_steps pp_part_steps_on(struct pp_worksheet *sheet, int parts);
struct pp_part_steps pp_part_steps_begin(struct pp_steps *steps, int parts);

/* Begins the next part. If the opening has several parts, the part's number follows the
 * names of all quantities put on the sheet from here on. */
void pp_part_steps_next(struct pp_part_steps *terms);

/* Evaluates a formula for the sky component of the current part or, if `hidden`, for
 * the externally reflected component; returns the value. */
double pp_part_steps_work(struct pp_part_steps *terms, bool hidden,
                          const struct pp_formula *formula, const char *what);

/* Records a quantity that was read for the current part from a scale or a table, or
 * that was counted. */
void pp_part_steps_read(const struct pp_part_steps *terms, enum pp_step_unit unit,
                        double value, const char *name, const char *what);

/* Records a quantity of the current part calculated by a formula, in which each # is
 * replaced by the part's number: "k_r# - k_l#". */
void pp_part_steps_figure(struct pp_part_steps *terms, enum pp_step_unit unit,
                          double value, const char *name, const char *formula,
                          const char *what);

/* Records the sky component of the current part or, if `hidden`, the externally
 * reflected component. The formula is written as above. */
void pp_part_steps_component(struct pp_part_steps *terms, bool hidden, double share,
                             const char *formula, const char *what);

/* Records the sums: sc, and erc where a part is hidden. A negative sum of the sky
 * components counts as 0. */
void pp_part_steps_end(struct pp_part_steps *terms);

#endif
