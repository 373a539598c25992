/* moment_choice.h - --when and --weather of df: illuminances in one hour of a weather file in
 * place of daylight factors. */
#ifndef PP_CLI_DF_MOMENT_CHOICE_H
#define PP_CLI_DF_MOMENT_CHOICE_H

#include "cli/exit_status.h"
#include "cli/options.h"
#include "cli/rooms.h"
#include "formats/epw/month_day.h"
#include "reports/parts/format.h"

struct pp_moment_choice {
    const char *when; /* as typed, "2023-03-21 15:00"; NULL: not given */
    const char *weather;
    struct pp_month_day date;
    double clock_h;
};

extern const struct pp_option pp_moment_options[]; /* of a struct pp_moment_choice */

/* Both or none, and nothing that is of daylight factors alone. */
enum pp_status pp_moment_choice_settle(const struct pp_moment_choice *choice,
                                       const struct pp_room_options *room,
                                       struct pp_error *err);

/* Computes and prints the rooms in that hour. */
enum pp_exit pp_moment_choice_run(const struct pp_moment_choice *choice,
                                  const struct pp_room_options *room,
                                  enum pp_format format, bool array,
                                  const struct pp_rooms *rooms);

#endif
