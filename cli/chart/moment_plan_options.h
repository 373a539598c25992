/* moment_plan_options.h - simulation options of a plan at one moment, and of a chart of
 * the year. */
#ifndef PP_CLI_CHART_MOMENT_PLAN_OPTIONS_H
#define PP_CLI_CHART_MOMENT_PLAN_OPTIONS_H

#include "cli/chart/chart_run.h"
#include "cli/moment_choice.h"

/* Moves the values of --when, --weather and --sky perez,... from the options of a plan
 * to *moment. Other kinds keep their weather file and sky. PP_BAD_INPUT if options are
 * missing, or do not apply to this kind or to illuminances. */
enum pp_status pp_moment_plan_options_settle(struct pp_moment_choice *moment,
                                             struct pp_chart_words *chart,
                                             struct pp_room_options *room,
                                             const struct pp_chart_kind *kind,
                                             struct pp_error *err);

#endif
