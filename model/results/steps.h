/* steps.h - a calculation as set out on paper: the figures that were read or put in,
 * and those calculated from them, each with its formula and unit, in order.
 *
 * A formula is written in the figures as printed: per cent, degrees, metres, in the
 * language of expression.h, with the symbols of steps before it (the latest of a name
 * counts). Recomputing a step from the printed figures gives its printed value, up to
 * their rounding; a test does so.
 */
#ifndef PP_MODEL_RESULTS_STEPS_H
#define PP_MODEL_RESULTS_STEPS_H

#include <stdarg.h>
#include <stdbool.h>

/* Unit of a value. It is stored in the program's unit and printed, as in the texts of
 * formulae, in the unit of print. The two differ for daylight factors and angles only:
 * a formula for a daylight factor of 2 % must give 2, and the program stores 0.02. */
enum pp_step_unit {
    /* A daylight factor, a component of one, or another illuminance over the horizontal one
     * of the open sky. Stored as a fraction; printed, and in formula texts, per cent. */
    PP_UNIT_DAYLIGHT_FACTOR,
    PP_UNIT_NUMBER, /* a ratio, a factor, a reflectance: a fraction in both */
    PP_UNIT_COUNT,  /* of squares or dots; need not be whole */
    PP_UNIT_ANGLE,  /* stored in radians; printed, and in formula texts, degrees */
    PP_UNIT_METRE,
    PP_UNIT_SQUARE_METRE,
    PP_UNIT_LUX,
};

/* Unit of print over that of storage: 100 for daylight factors, 1/PP_RAD for angles,
 * else 1. */
double pp_steps_printed_unit(enum pp_step_unit unit);

struct pp_calculation_step {
    char what[96];     /* "altitude of the head of the reveal" */
    char symbol[16];   /* "R_fw"; empty: has no name */
    char formula[640]; /* by which it was worked out; empty: read or put in */
    double value;
    enum pp_step_unit unit;
    int line; /* of the opening in the room file that it belongs to; 0: to none */
};

struct pp_steps {
    struct pp_calculation_step *list;
    int count, capacity;
    int line; /* of the opening that further steps belong to, as in a step; set by the
               * caller */
    bool failed; /* memory ran out: the list is not whole */
};

/* Sets down one step, of a figure that formulae further on name by its symbol; steps may
 * be NULL, then nothing is done. */
void pp_steps_add_named(struct pp_steps *steps, enum pp_step_unit unit, double value,
                        const char *symbol, const char *what, ...)
    __attribute__((format(printf, 5, 6)));

/* The same of one that was worked out of figures before it by a formula. */
void pp_steps_add_worked(struct pp_steps *steps, enum pp_step_unit unit, double value,
                         const char *symbol, const char *formula, const char *what, ...)
    __attribute__((format(printf, 6, 7)));

/* The common form of the three. */
void pp_steps_add_v(struct pp_steps *steps, enum pp_step_unit unit, double value,
                    const char *symbol, const char *formula, const char *what,
                    va_list args) __attribute__((format(printf, 6, 0)));

/* Puts down a sum of daylight factors: symbol = symbol_1 + symbol_2 + ..., on as many
 * lines as needed, over the terms up to `count` that exist from step `first` on; 0 if
 * there are none. */
void pp_steps_add_sum(struct pp_steps *steps, int first, int count, const char *symbol,
                      const char *what);

/* The last step from `first` on that has that symbol; NULL: none has. */
const struct pp_calculation_step *pp_steps_find(const struct pp_steps *steps, int first,
                                                const char *symbol);

void pp_steps_clear(struct pp_steps *steps);

#endif
