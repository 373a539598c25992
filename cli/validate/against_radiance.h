/* against_radiance.h - compares simulated daylight factors with results of Radiance's
 * rtrace for the same rooms. Each room is exported, and the script in the export runs
 * Radiance. */
#ifndef PP_CLI_VALIDATE_AGAINST_RADIANCE_H
#define PP_CLI_VALIDATE_AGAINST_RADIANCE_H

#include "cli/exit_status.h"
#include "reports/parts/format.h"
#include "cli/rooms.h"

/* Simulates the rooms, runs rtrace and prints the comparison. PP_EXIT_MACHINE, with a
 * message, if oconv or rtrace is not in PATH. */
enum pp_exit pp_against_radiance(const struct pp_rooms *rooms,
                                 const struct pp_room_options *options,
                                 enum pp_format format);

/* Runs the comparison as a suite. page: file for the page of results; NULL: none.
 * PP_EXIT_INPUT if more cases than permitted are outside their limits. */
enum pp_exit pp_against_radiance_suite(const struct pp_rooms *rooms,
                                       const struct pp_room_options *options,
                                       enum pp_format format, const char *page);

#endif
