/* validate_engines.h - the suite engines: what simulates, beside each other in the rooms of
 * files. */
#ifndef PP_CLI_VALIDATE_VALIDATE_ENGINES_H
#define PP_CLI_VALIDATE_VALIDATE_ENGINES_H

#include "cli/exit_status.h"
#include "cli/rooms.h"
#include "reports/parts/format.h"

/* Runs every engine in every room, over ranks where there are some, and judges how far apart
 * they are. page: a file for the page, or NULL. PP_EXIT_INPUT where more lies outside than
 * may. */
enum pp_exit pp_validate_engines(const struct pp_rooms *rooms,
                                 const struct pp_room_options *options,
                                 enum pp_format format, const char *page);

#endif
