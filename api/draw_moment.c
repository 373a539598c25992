/* draw_moment.c - see draw_moment.h. */
#include "api/draw_moment.h"

#include "charts/year/moment_chart.h"
#include "model/base/read_file.h"
#include "studies/year/moment_plan_study.h"

enum pp_status pp_draw_moment_plan(struct pp_canvas *canvas,
                                   const struct pp_study_room *room,
                                   const struct pp_study_options *study,
                                   const struct pp_chart_choice *choice,
                                   struct pp_error *err)
{
    const struct pp_annual_options options = {.samples = (int)study->samples,
                                              .error = study->error,
                                              .seed = study->seed,
                                              .threads = study->threads,
                                              .strict = study->strict,
                                              .watch = study->watch};
    struct pp_moment moment;
    struct pp_moment_plan plan;
    struct pp_error own = {0};
    enum pp_status status = pp_moment_at(&moment, choice->moment, room->world, &own);
    if (status == PP_OK)
        status = pp_moment_turn_slats(room->world, &moment, &own);
    if (status != PP_OK)
        return pp_fail(err, status, "%s: %s", pp_read_file_title(room->file),
                       own.message);
    status = pp_moment_plan_study_make(&plan, room, &moment, &options, err);
    plan.when = choice->moment->when;
    if (status == PP_OK)
        status = pp_moment_chart_draw(canvas, &plan, &room->light, err);
    pp_moment_plan_study_clear(&plan);
    return status;
}
