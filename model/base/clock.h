/* clock.h - a clock to measure durations by. */
#ifndef PP_MODEL_BASE_CLOCK_H
#define PP_MODEL_BASE_CLOCK_H

/* Seconds since some moment of the past, by a clock that nobody sets (monotonic). */
double pp_clock_s(void);

#endif
