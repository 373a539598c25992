/* facade_sensitivity.c - see facade_sensitivity.h. */
#include "studies/criteria/facade_sensitivity.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "model/room/room_facades.h"
#include "studies/criteria/grid/plane_trace.h"

/* Length by which walls are extended: beyond 30 m a longer wall hides less than 3
 * degrees more of the ground in front of the window. */
static const double REACH_M = 30.0;

/* Ratio of the target errors for the room with extended walls to those for the room
 * itself. Larger errors are sufficient, since only a verdict is needed. */
static const double COARSER = 2.0;

static bool is_sampled(const struct pp_finding *finding)
{
    return isfinite(finding->confidence)
           && (finding->verdict == PP_MET || finding->verdict == PP_NOT_MET);
}

static bool any_sampled(const struct pp_assessment *assessment)
{
    for (int i = 0; i < assessment->answers.count; i++)
        for (int k = 0; k < assessment->answers.list[i].findings.count; k++)
            if (is_sampled(&assessment->answers.list[i].findings.list[k]))
                return true;
    return false;
}

/* The finding about the room with extended walls that corresponds to this one; NULL:
 * there is none. */
static const struct pp_finding *counterpart(const struct pp_assessment *other,
                                            const struct pp_criterion *criterion,
                                            const struct pp_finding *finding, int index)
{
    for (int i = 0; i < other->answers.count; i++) {
        const struct pp_finding_list *findings = &other->answers.list[i].findings;
        if (other->answers.list[i].criterion == criterion && index < findings->count
            && strcmp(findings->list[index].what, finding->what) == 0)
            return &findings->list[index];
    }
    return NULL;
}

static void doubt(struct pp_finding *finding, const struct pp_finding *other)
{
    if (!other || isnan(other->figure) || !is_sampled(finding)
        || other->verdict == finding->verdict)
        return;
    bool percent =
        finding->kind == PP_FIGURE_FACTOR || finding->kind == PP_FIGURE_SHARE;
    char value[40];
    if (finding->kind == PP_FIGURE_LUX)
        snprintf(value, sizeof value, "%.0f lx", other->figure);
    else
        snprintf(value, sizeof value, "%.3g%s", (percent ? 100.0 : 1.0) * other->figure,
                 percent ? " %" : "");
    finding->confidence = NAN;
    pp_finding_note(
        finding,
        "%sthe value would be %s (%s) if the window walls were larger, as in "
        "a larger house; describe the real wall with <facade>",
        finding->note[0] ? ". " : "", value, pp_finding_verdict(other->verdict));
}

static void compare_assessments(struct pp_assessment *assessment,
                                const struct pp_assessment *other)
{
    for (int i = 0; i < assessment->answers.count; i++) {
        struct pp_answer *answer = &assessment->answers.list[i];
        for (int k = 0; k < answer->findings.count; k++)
            doubt(&answer->findings.list[k],
                  counterpart(other, answer->criterion, &answer->findings.list[k], k));
    }
}

/* Assesses the room with extended walls, and marks the verdicts that differ. */
static enum pp_status judge_other(struct pp_assessment *assessment,
                                  const struct pp_study_room *room,
                                  const struct pp_assess_options *options,
                                  struct pp_error *err)
{
    struct pp_study_options coarser = *options->study;
    struct pp_assess_options wanted = *options;
    struct pp_assessment other;
    coarser.error *= COARSER;
    coarser.seconds *= PP_FACADE_SENSITIVITY_SHARE;
    wanted.study = &coarser;
    wanted.verdicts_only = true;
    wanted.trace_again = false;
    wanted.with_year = false;
    enum pp_status status = pp_assessment_begin(&other, room, 1, NULL, &wanted, err);
    if (status == PP_OK && other.has_factors)
        status = pp_plane_trace(&other.report, &coarser, other.has_average,
                                &other.by_clock, err);
    assessment->report.finished &= other.report.finished;
    assessment->by_clock |= other.by_clock;
    if (status == PP_OK)
        status = pp_assessment_judge(&other, &wanted, err);
    if (status == PP_OK && other.report.finished)
        compare_assessments(assessment, &other);
    pp_assessment_clear(&other);
    return status;
}

enum pp_status pp_facade_sensitivity_check(struct pp_assessment *assessment,
                                           const struct pp_assess_options *options,
                                           struct pp_error *err)
{
    const struct pp_study_room *own = assessment->room;
    if (!options->study->simulate || !assessment->report.finished
        || !any_sampled(assessment))
        return PP_OK;
    struct pp_room *room = NULL;
    struct pp_world *world = NULL;
    int added = 0;
    enum pp_status status = pp_room_copy(&room, own->room, err);
    if (status == PP_OK)
        status = pp_room_facades_add(room, own->world, REACH_M, &added, err);
    bool other = status == PP_OK && (added > 0 || own->world->ground_is_open);
    if (other) {
        struct pp_mistakes mistakes;
        pp_room_set_ground(room, own->light.ground_reflectance, false);
        pp_mistakes_init(&mistakes, own->file);
        status = pp_world_create(&world, room, &mistakes, err);
        pp_mistakes_clear(&mistakes);
    }
    if (other && status == PP_OK) {
        struct pp_study_room changed;
        pp_study_room_init(&changed, own->file, own->building, own->index, room, world,
                           &own->light);
        status = judge_other(assessment, &changed, options, err);
        pp_study_room_clear(&changed);
    }
    pp_room_destroy(room);
    return status;
}
