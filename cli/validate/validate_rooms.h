/* validate_rooms.h - compares hand methods with simulation in the rooms of files. The
 * result is a table of bias and spread, or a suite with one case for each value.
 */
#ifndef PP_CLI_VALIDATE_VALIDATE_ROOMS_H
#define PP_CLI_VALIDATE_VALIDATE_ROOMS_H

#include "cli/exit_status.h"
#include "cli/rooms.h"
#include "reports/parts/format.h"

/* Simulates the rooms, over ranks if there are any, and prints the comparison. For each
 * method, a room is also simulated in a simplified version that satisfies the
 * assumptions of the method. The time limit is divided equally among a room and its
 * simplified versions. */
enum pp_exit pp_validate_rooms(const struct pp_rooms *rooms,
                               const struct pp_room_options *options,
                               enum pp_format format);

/* Runs the comparison as a suite. page: file for the page of results; NULL: none.
 * PP_EXIT_INPUT if more cases than permitted are outside their limits. */
enum pp_exit pp_validate_rooms_suite(const struct pp_rooms *rooms,
                                     const struct pp_room_options *options,
                                     enum pp_format format, const char *page);

#endif
