/* reading.h - one method's value of one component, at a point or of the room. */
#ifndef PP_MODEL_RESULTS_READING_H
#define PP_MODEL_RESULTS_READING_H

#include <math.h>

/* The parts that the literature keeps apart, and their sum. */
enum pp_component { PP_SC, PP_ERC, PP_IRC, PP_DF, PP_COMPONENT_COUNT };

struct pp_steps;

struct pp_reading {
    double value;     /* fraction of the open-sky horizontal illuminance: 0.02, never 2;
                       * NAN where there is none: see why */
    double std_error; /* of value; NAN where it was not sampled */
    const char *why;  /* one sentence, not owned; NULL where there is a value */
    const struct pp_steps *steps; /* the sum as on paper, not owned; NULL unless asked
                                   * for */
};

static inline struct pp_reading pp_reading_of(double value)
{
    return (struct pp_reading){value, NAN, 0, 0};
}

static inline struct pp_reading pp_reading_none(const char *why)
{
    return (struct pp_reading){NAN, NAN, why, 0};
}

#endif
