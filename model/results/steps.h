/* steps.h - a calculation as written on paper: input values and values calculated from
 * them, in order, each with formula and unit.
 *
 * A formula is written for printed units: per cent, degrees, metres. Its language is
 * that of expression.h, with the symbols of earlier steps (the latest if a symbol
 * repeats). Recomputing a step from printed figures gives its printed value, within
 * rounding; a test checks this.
 */
#ifndef PP_MODEL_RESULTS_STEPS_H
#define PP_MODEL_RESULTS_STEPS_H

#include <stdarg.h>
#include <stdbool.h>

/* Unit of a value. Values are stored in the program's unit. They are printed, and
 * written in formulae, in the printed unit. The two units differ only for daylight
 * factors and angles: a formula for a daylight factor of 2 % must give 2, and the
 * program stores 0.02. */
enum pp_step_unit {
    /* A daylight factor, a component of one, or another illuminance divided by the
     * horizontal illuminance of the open sky. Stored as a fraction; in per cent when
     * printed, and in the text of formulae. */
    PP_UNIT_DAYLIGHT_FACTOR,
    PP_UNIT_NUMBER, /* ratio, factor or reflectance; a fraction also when printed */
    PP_UNIT_COUNT,  /* squares or dots; may be fractional */
    PP_UNIT_ANGLE,  /* stored in radians; degrees when printed, and in formulae */
    PP_UNIT_METRE,
    PP_UNIT_SQUARE_METRE,
    PP_UNIT_LUX,
};

/* Printed units per stored unit: 100 for daylight factors, 1/PP_RAD for angles, else
 * 1. */
double pp_steps_printed_unit(enum pp_step_unit unit);

struct pp_calculation_step {
    char what[96];     /* "altitude of the head of the reveal" */
    char symbol[16];   /* "R_fw"; empty: no symbol */
    char formula[640]; /* formula of a calculated value; empty: input */
    double value;
    enum pp_step_unit unit;
    int line; /* line of the opening in the room file; 0: none */
};

struct pp_steps {
    struct pp_calculation_step *list;
    int count, capacity;
    int line;    /* member `line` of the next steps; set by the caller */
    bool failed; /* out of memory: steps are missing */
};

/* Appends a step for an input value that later formulae use by its symbol. Does nothing
 * if steps is NULL. */
void pp_steps_add_named(struct pp_steps *steps, enum pp_step_unit unit, double value,
                        const char *symbol, const char *what, ...)
    __attribute__((format(printf, 5, 6)));

/* Appends a step for a value calculated by a formula from earlier steps. */
void pp_steps_add_worked(struct pp_steps *steps, enum pp_step_unit unit, double value,
                         const char *symbol, const char *formula, const char *what, ...)
    __attribute__((format(printf, 6, 7)));

/* Common implementation of both functions above. */
void pp_steps_add_v(struct pp_steps *steps, enum pp_step_unit unit, double value,
                    const char *symbol, const char *formula, const char *what,
                    va_list args) __attribute__((format(printf, 6, 0)));

/* Appends a sum of daylight factors: symbol = symbol_1 + symbol_2 + ... The terms are
 * the steps from `first` on with numbers up to `count`; missing numbers are skipped.
 * The sum is 0 without terms, and is divided into several steps if it is long. */
void pp_steps_add_sum(struct pp_steps *steps, int first, int count, const char *symbol,
                      const char *what);

/* Last step from `first` on with that symbol; NULL: none. */
const struct pp_calculation_step *pp_steps_find(const struct pp_steps *steps, int first,
                                                const char *symbol);

void pp_steps_clear(struct pp_steps *steps);

#endif
