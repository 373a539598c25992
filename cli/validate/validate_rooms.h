/* validate_rooms.h - hand methods against the simulation, in the rooms of files: as a table
 * of bias and spread, or as a suite, figure by figure.
 */
#ifndef PP_CLI_VALIDATE_VALIDATE_ROOMS_H
#define PP_CLI_VALIDATE_VALIDATE_ROOMS_H

#include "cli/exit_status.h"
#include "cli/rooms.h"
#include "reports/parts/format.h"

/* Traces the rooms and the worlds that their methods have in mind, over ranks where there
 * are some, and prints. What time there is for a room, each of its worlds gets a share
 * of. */
enum pp_exit pp_validate_rooms(const struct pp_rooms *rooms,
                               const struct pp_room_options *options,
                               enum pp_format format);

/* page: a file for the page, or NULL. PP_EXIT_INPUT where more lies outside than may. */
enum pp_exit pp_validate_rooms_suite(const struct pp_rooms *rooms,
                                     const struct pp_room_options *options,
                                     enum pp_format format, const char *page);

#endif
