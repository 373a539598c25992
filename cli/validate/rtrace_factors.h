/* rtrace_factors.h - daylight factors at a room's points by Radiance's rtrace, from the
 * export of the room and its script. */
#ifndef PP_CLI_VALIDATE_RTRACE_FACTORS_H
#define PP_CLI_VALIDATE_RTRACE_FACTORS_H

#include <stdbool.h>

#include "model/base/error.h"
#include "model/results/reading.h"
#include "studies/study_room.h"

/* Number of runs for each point: rtrace has no standard error, their scatter gives
 * one. */
enum { PP_RTRACE_REPEATS = 16 };

/* True if Radiance's oconv and rtrace are on PATH. */
bool pp_rtrace_is_there(void);

/* The readings of the room's receivers, fractions. Works in a temporary directory below
 * TMPDIR, which it removes. PP_SYSTEM if a program fails, PP_INTERRUPTED. */
enum pp_status pp_rtrace_factors(struct pp_reading *readings,
                                 const struct pp_study_room *room,
                                 struct pp_error *err);

#endif
