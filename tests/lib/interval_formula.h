/* interval_formula.h - recomputes the formulae of model/results/steps.h from printed figures, in
 * interval arithmetic: a printed figure stands for all that are rounded to it.
 */
#ifndef PP_TESTS_LIB_INTERVAL_FORMULA_H
#define PP_TESTS_LIB_INTERVAL_FORMULA_H

#include <stdbool.h>

struct interval {
    double low, high;
};

/* Figures by symbol; the latest of a name counts. Zero it to begin with. */
struct figures {
    int count;
    struct figure {
        char symbol[32];
        struct interval value;
    } list[2000];
};

void figures_add(struct figures *figures, const char *symbol, struct interval value);

/* Interval of a printed number: half a unit of its last digit to either side. */
struct interval figure_as_printed(const char *digits);

/* All values that the formula may have. False, with a message, where it makes no sense
 * or names a figure that is not there. */
bool formula_evaluate(struct interval *value, const char *formula,
                      const struct figures *figures, char message[128]);

#endif
