/* moment_run.h - the command df for one moment: illuminances instead of daylight
 * factors. */
#ifndef PP_CLI_DF_MOMENT_RUN_H
#define PP_CLI_DF_MOMENT_RUN_H

#include "cli/moment_choice.h"
#include "cli/rooms.h"
#include "reports/parts/format.h"

/* Checks the number of paths, which must be a power of two for a moment. */
enum pp_status pp_moment_run_check(const struct pp_room_options *room,
                                   struct pp_error *err);

/* Computes and prints the rooms at that moment. */
enum pp_exit pp_moment_run(struct pp_moment_choice *choice,
                           const struct pp_room_options *room, enum pp_format format,
                           bool array, const struct pp_rooms *rooms);

#endif
