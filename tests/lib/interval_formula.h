/* interval_formula.h - recomputes the formulae of model/results/steps.h from printed
 * figures, in interval arithmetic: a printed figure represents all values that are
 * rounded to it. */
#ifndef PP_TESTS_LIB_INTERVAL_FORMULA_H
#define PP_TESTS_LIB_INTERVAL_FORMULA_H

#include <stdbool.h>

struct interval {
    double low, high;
};

/* Figures by symbol; the latest counts if a symbol repeats. Initialise with zeros. */
struct figures {
    int count;
    struct figure {
        char symbol[32];
        struct interval value;
    } list[2000];
};

void figures_add(struct figures *figures, const char *symbol, struct interval value);

/* Interval of a printed number: plus or minus half a unit of its last digit. */
struct interval figure_as_printed(const char *digits);

/* An interval that contains all values that the formula may have. False, with a
 * message, if it is invalid or uses an unknown symbol. */
bool formula_evaluate(struct interval *value, const char *formula,
                      const struct figures *figures, char message[128]);

#endif
