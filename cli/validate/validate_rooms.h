/* validate_rooms.h - hand methods against the simulation, in the rooms of files: as a
 * table of bias and spread, or as a suite of cases, one for each value.
 */
#ifndef PP_CLI_VALIDATE_VALIDATE_ROOMS_H
#define PP_CLI_VALIDATE_VALIDATE_ROOMS_H

#include "cli/exit_status.h"
#include "cli/rooms.h"
#include "reports/parts/format.h"

/* Simulates the rooms and the worlds that their methods assume, over ranks if there are
 * any, and prints. The time limit of a room is divided equally among it and its
 * worlds. */
enum pp_exit pp_validate_rooms(const struct pp_rooms *rooms,
                               const struct pp_room_options *options,
                               enum pp_format format);

/* page: file for the page, or NULL. PP_EXIT_INPUT if more cases than allowed are
 * outside their limits. */
enum pp_exit pp_validate_rooms_suite(const struct pp_rooms *rooms,
                                     const struct pp_room_options *options,
                                     enum pp_format format, const char *page);

#endif
