/* clock.h - a clock to measure durations by. */
#ifndef PP_MODEL_BASE_CLOCK_H
#define PP_MODEL_BASE_CLOCK_H

/* Seconds since an arbitrary moment, by a monotonic clock. */
double pp_clock_s(void);

#endif
