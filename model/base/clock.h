/* clock.h - how long things take. */
#ifndef PP_MODEL_BASE_CLOCK_H
#define PP_MODEL_BASE_CLOCK_H

/* Seconds since some moment of the past, on a clock that nobody sets. */
double pp_clock_s(void);

#endif
