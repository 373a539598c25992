/* against_radiance.h - compares simulated daylight factors with those of Radiance's
 * rtrace for the same rooms, which are exported and computed by the script in the
 * export. */
#ifndef PP_CLI_VALIDATE_AGAINST_RADIANCE_H
#define PP_CLI_VALIDATE_AGAINST_RADIANCE_H

#include "cli/exit_status.h"
#include "reports/parts/format.h"
#include "cli/rooms.h"

/* Simulates, runs rtrace and prints. PP_EXIT_MACHINE, with a message, if oconv or
 * rtrace is not in PATH. */
enum pp_exit pp_against_radiance(const struct pp_rooms *rooms,
                                 const struct pp_room_options *options,
                                 enum pp_format format);

/* Runs the comparison as a suite. page: file for the page, or NULL. PP_EXIT_INPUT if
 * more cases than allowed are outside their limits. */
enum pp_exit pp_against_radiance_suite(const struct pp_rooms *rooms,
                                       const struct pp_room_options *options,
                                       enum pp_format format, const char *page);

#endif
