/* steps.h - a calculation as it would be set out on paper: what was read or worked out,
 * in order, with its unit. */
#ifndef PP_MODEL_STEPS_H
#define PP_MODEL_STEPS_H

#include <stdbool.h>

enum pp_unit {
    PP_UNIT_SHARE,  /* a fraction of the open-sky horizontal illuminance */
    PP_UNIT_NUMBER, /* a ratio, a factor */
    PP_UNIT_COUNT,  /* of squares or dots; need not be whole */
    PP_UNIT_ANGLE,  /* radians */
    PP_UNIT_METRE,
};

struct pp_step {
    char what[96]; /* "window on line 12: altitude of the head" */
    double value;
    enum pp_unit unit;
};

struct pp_steps {
    struct pp_step *list;
    int count, capacity;
    bool failed; /* memory ran out: the list is not whole */
};

/* Sets down one step; steps may be NULL, then nothing is done. */
void pp_step(struct pp_steps *steps, enum pp_unit unit, double value, const char *what,
             ...) __attribute__((format(printf, 4, 5)));

void pp_steps_clear(struct pp_steps *steps);

#endif
