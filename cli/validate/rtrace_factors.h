/* rtrace_factors.h - daylight factors at a room's points, calculated with Radiance's
 * rtrace by the script in the room's export. */
#ifndef PP_CLI_VALIDATE_RTRACE_FACTORS_H
#define PP_CLI_VALIDATE_RTRACE_FACTORS_H

#include <stdbool.h>

#include "model/base/error.h"
#include "model/results/reading.h"
#include "studies/study_room.h"

/* Number of runs for each point. rtrace gives no standard error; it is estimated from
 * the scatter of the runs. */
enum { PP_RTRACE_REPEATS = 16 };

/* True if Radiance's oconv and rtrace are in PATH. */
bool pp_rtrace_is_there(void);

/* Computes the readings at the room's receivers, fractions. Works in a temporary
 * directory below TMPDIR, and removes it. PP_SYSTEM if a program fails; PP_INTERRUPTED
 * after Ctrl-C. */
enum pp_status pp_rtrace_factors(struct pp_reading *readings,
                                 const struct pp_study_room *room,
                                 struct pp_error *err);

#endif
