/* clock.h - a monotonic clock for durations. */
#ifndef PP_MODEL_BASE_CLOCK_H
#define PP_MODEL_BASE_CLOCK_H

/* Seconds since an arbitrary moment. */
double pp_clock_s(void);

#endif
