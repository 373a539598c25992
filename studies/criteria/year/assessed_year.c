/* assessed_year.c - see assessed_year.h. */
#include "studies/criteria/year/assessed_year.h"

#include "studies/criteria/criteria.h"
#include "studies/criteria/grid/plane_year.h"
#include "studies/glare/glare_study.h"
#include "studies/lighting/lighting_control.h"

/* True if the year is needed at points of the plane: for the rules, or for a criterion
 * of_plane_year. False if a criterion needs the year at the room's own points. */
static bool needs_year_of_plane(const bool chosen[PP_CRITERIA_MOST],
                                const struct pp_assess_options *options)
{
    bool of_plane = options->rules && options->rules->of_year;
    const struct pp_criterion *criterion;
    for (int i = 0; (criterion = pp_criteria_at(i)) != NULL; i++) {
        if (chosen[i] && criterion->of_year)
            return false;
        of_plane |= chosen[i] && criterion->of_plane_year;
    }
    return of_plane;
}

/* Simulates the room's year if there is a weather file, and the year is requested or a
 * chosen criterion needs it. */
static enum pp_status simulate_points(struct pp_assessment *assessment,
                                      const bool chosen[PP_CRITERIA_MOST], bool needed,
                                      const struct pp_assess_options *options,
                                      struct pp_error *err)
{
    const struct pp_study_room *room = assessment->room;
    bool of_plane = needs_year_of_plane(chosen, options);
    if (!options->year || !options->study->simulate
        || !(options->with_year || of_plane || needed))
        return PP_OK;
    struct pp_annual_options annual = pp_plane_year_options(options->study);
    if (options->with_year) {
        annual.lighting_count = PP_LIGHTING_CONTROL_IDEAL;
        pp_lighting_control_ideal(annual.lighting, annual.illuminances_lx[0]);
    }
    enum pp_status status =
        of_plane
            ? pp_plane_year_grid(&assessment->year_grid, room->world, &options->grid,
                                 options->rules && options->rules->of_sda, err)
            : PP_OK;
    if (status != PP_OK || (of_plane && assessment->year_grid.count == 0))
        return status;
    assessment->has_year = true;
    status = of_plane ? pp_annual_of_room(&assessment->year, room->world, &room->light,
                                          assessment->year_grid.receivers,
                                          assessment->year_grid.count, true,
                                          options->year, &annual, err)
                      : pp_annual_of_study_room(&assessment->year, room, options->year,
                                                &annual, err);
    if (status == PP_OK)
        assessment->report.finished &= assessment->year.finished;
    return status;
}

static bool glare_is_chosen(const bool chosen[PP_CRITERIA_MOST])
{
    for (int i = 0; pp_criteria_at(i); i++)
        if (chosen[i] && pp_criteria_at(i)->of_glare)
            return true;
    return false;
}

static enum pp_status simulate_glare(struct pp_assessment *assessment,
                                     const struct pp_assess_options *options,
                                     struct pp_error *err)
{
    const struct pp_study_room *room = assessment->room;
    struct pp_glare_options glare = pp_glare_options_default;
    glare.annual.strict = options->study->strict;
    glare.annual.seed = options->study->seed;
    glare.annual.threads = options->study->threads;
    glare.annual.watch = options->study->watch;
    assessment->has_glare = true;
    enum pp_status status =
        pp_glare_study_run(&assessment->glare, room, room->world->views,
                           room->world->view_count, NULL, options->year, &glare, err);
    if (status == PP_OK)
        assessment->report.finished &= assessment->glare.annual.finished;
    return status;
}

enum pp_status pp_assessed_year_simulate(struct pp_assessment *assessment,
                                         const bool chosen[PP_CRITERIA_MOST],
                                         bool needed,
                                         const struct pp_assess_options *options,
                                         struct pp_error *err)
{
    enum pp_status status = simulate_points(assessment, chosen, needed, options, err);
    if (status == PP_OK && options->year && options->study->simulate
        && assessment->room->world->view_count > 0 && glare_is_chosen(chosen)
        && pp_glare_study_turning(assessment->room->world) < 0)
        status = simulate_glare(assessment, options, err);
    return status;
}
