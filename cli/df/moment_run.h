/* moment_run.h - the command df for one moment: illuminances instead of daylight
 * factors. */
#ifndef PP_CLI_DF_MOMENT_RUN_H
#define PP_CLI_DF_MOMENT_RUN_H

#include "cli/moment_choice.h"
#include "cli/rooms.h"
#include "reports/parts/format.h"

/* Computes and prints the illuminances in the rooms at the chosen moment. */
enum pp_exit pp_moment_run(struct pp_moment_choice *choice,
                           const struct pp_room_options *room, enum pp_format format,
                           bool array, const struct pp_rooms *rooms);

#endif
