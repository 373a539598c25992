/* moment_plan_options.c - see moment_plan_options.h. */
#include "cli/chart/moment_plan_options.h"

/* First option given that applies only to daylight factors; NULL: none. */
static const char *option_of_factors(const struct pp_chart_words *chart,
                                     const struct pp_study_options *study)
{
    const struct pp_chart_choice *choice = &chart->choice;
    return chart->before                            ? "--before"
           : choice->line_said                      ? "--line"
           : choice->cut.kind != PP_SECTION_OF_ROOM ? "--cut"
           : choice->fill != PP_FILL_NONE           ? "--fill"
           : study->seconds > 0.0                   ? "--time"
                                                    : NULL;
}

enum pp_status pp_moment_plan_options_settle(struct pp_moment_choice *moment,
                                             struct pp_chart_words *chart,
                                             struct pp_room_options *room,
                                             const struct pp_chart_kind *kind,
                                             struct pp_error *err)
{
    struct pp_study_options *study = &room->study;
    if (kind != &pp_draw_plan && moment->when)
        return pp_fail(err, PP_BAD_INPUT,
                       "--when is for a plan; expected no --when for %s", kind->name);
    if (kind->of_year && (study->error > 0.0 || study->samples > 0)) {
        study->simulate = true;
        return pp_moment_choice_check_paths(room, err);
    }
    if (kind != &pp_draw_plan)
        return PP_OK;
    moment->weather = chart->choice.availability.weather;
    chart->choice.availability.weather = NULL;
    enum pp_status status = pp_moment_choice_settle(moment, room, err);
    if (status != PP_OK || !pp_moment_choice_said(moment))
        return status;
    const char *other = option_of_factors(chart, study);
    if (other)
        return pp_fail(err, PP_BAD_INPUT,
                       "%s is for a plan of daylight factors; a plan of one moment "
                       "shows illuminances; expected no %s",
                       other, other);
    study->simulate = true;
    return pp_moment_choice_check_paths(room, err);
}
