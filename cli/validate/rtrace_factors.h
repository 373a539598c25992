/* rtrace_factors.h - daylight factors at the points of a room, calculated with
 * Radiance's rtrace by the script in the room's export. */
#ifndef PP_CLI_VALIDATE_RTRACE_FACTORS_H
#define PP_CLI_VALIDATE_RTRACE_FACTORS_H

#include <stdbool.h>

#include "model/base/error.h"
#include "model/results/reading.h"
#include "studies/study_room.h"

/* Number of runs for each point. rtrace does not give standard errors; they are
 * estimated from the scatter of the runs. */
enum { PP_RTRACE_REPEATS = 16 };

/* True if Radiance's oconv and rtrace are in PATH. */
bool pp_rtrace_is_there(void);

/* Computes the daylight factors at the room's receivers, as fractions. Uses a temporary
 * directory below TMPDIR, and removes it. PP_SYSTEM if a program fails; PP_INTERRUPTED
 * if the user interrupts. */
enum pp_status pp_rtrace_factors(struct pp_reading *readings,
                                 const struct pp_study_room *room,
                                 struct pp_error *err);

#endif
