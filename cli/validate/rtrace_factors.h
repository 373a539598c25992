/* rtrace_factors.h - daylight factors of a room's points by Radiance's rtrace, through what
 * is exported of the room and the script that goes with that.
 */
#ifndef PP_CLI_VALIDATE_RTRACE_FACTORS_H
#define PP_CLI_VALIDATE_RTRACE_FACTORS_H

#include <stdbool.h>

#include "model/base/error.h"
#include "model/results/reading.h"
#include "studies/study_room.h"

/* Each point is asked so often: rtrace has no standard error, their spread gives one. */
enum { PP_RTRACE_REPEATS = 16 };

/* True if Radiance's oconv and rtrace are on PATH. */
bool pp_rtrace_is_there(void);

/* The readings of the room's receivers, fractions. Works in a directory of its own below
 * TMPDIR, which is removed. PP_SYSTEM where a program fails, PP_INTERRUPTED. */
enum pp_status pp_rtrace_factors(struct pp_reading *readings,
                                 const struct pp_study_room *room,
                                 struct pp_error *err);

#endif
