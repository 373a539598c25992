/* against_radiance.h - daylight factors of the simulation beside those of Radiance's
 * rtrace, of the same rooms: exported, worked out by the script that goes with them. */
#ifndef PP_CLI_VALIDATE_AGAINST_RADIANCE_H
#define PP_CLI_VALIDATE_AGAINST_RADIANCE_H

#include "cli/exit_status.h"
#include "reports/parts/format.h"
#include "cli/rooms.h"

/* Traces, runs and prints. Where oconv or rtrace is not on PATH that is said, and
 * nothing is done: PP_EXIT_MACHINE. */
enum pp_exit pp_against_radiance(const struct pp_rooms *rooms,
                                 const struct pp_room_options *options,
                                 enum pp_format format);

/* The same as a suite. page: a file for the page, or NULL. PP_EXIT_INPUT where more lies
 * outside than may. */
enum pp_exit pp_against_radiance_suite(const struct pp_rooms *rooms,
                                       const struct pp_room_options *options,
                                       enum pp_format format, const char *page);

#endif
