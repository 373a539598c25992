/* suite.c - the list of suites. */
#include "studies/research/validation/suite.h"

#include <math.h>
#include <string.h>

#include "studies/research/validation/cie171.h"
#include "studies/research/validation/closed_forms.h"
#include "studies/research/validation/printed_tables.h"
#include "studies/research/validation/worked_examples.h"

static enum pp_status run_quick(struct pp_known_cases *cases,
                                const struct pp_known_trace *how, struct pp_error *err)
{
    enum pp_status status = pp_closed_forms(cases, how, err);
    return status == PP_OK ? pp_worked_examples(cases, err) : status;
}

static enum pp_status run_published(struct pp_known_cases *cases,
                                    const struct pp_known_trace *how,
                                    struct pp_error *err)
{
    enum pp_status status = pp_worked_examples(cases, err);
    return status == PP_OK ? pp_printed_tables(cases, how, err) : status;
}

static enum pp_status run_cie171(struct pp_known_cases *cases,
                                 const struct pp_known_trace *how, struct pp_error *err)
{
    return pp_cie171(cases, how, 3.0, err);
}

const struct pp_suite pp_suite_quick = {
    .name = "quick",
    .summary = "results that can be calculated by hand",
    .limits = "to the known digits of the expected results; simulated results: within "
              "four standard errors",
    .samples = 512,
    .run = run_quick,
};

const struct pp_suite pp_suite_rooms = {
    .name = "rooms",
    .summary = "Each method compared with the simulation",
    .limits =
        "within the atlas band for similar rooms, widened by three standard errors of "
        "the simulation; 1 in 20 may be outside, because the band contains 95 % of the "
        "values",
    .chance = 0.05,
    .of_rooms = true,
};

const struct pp_suite pp_suite_radiance = {
    .name = "radiance",
    .summary = "The simulation compared with Radiance's rtrace",
    .limits = "within three standard errors of the difference, or 1 % of the result of "
              "rtrace; 1 in 100 may be outside",
    .chance = 0.01,
    .of_rooms = true,
};

const struct pp_suite pp_suite_engines = {
    .name = "engines",
    .summary = "simulation engines compared with the path tracer",
    .limits = "within three standard errors of the difference, plus 2 % for the "
              "irradiance cache, which has a bias; 1 in 100 may be outside",
    .chance = 0.01,
    .of_rooms = true,
};

static const struct pp_suite analytic = {
    .name = "analytic",
    .summary = "closed forms, limits and configuration factors",
    .limits = "to the known digits of the expected results; simulated results: within "
              "four standard errors",
    .samples = 512,
    .run = pp_closed_forms};

static const struct pp_suite published = {
    .name = "published",
    .summary = "worked examples, and printed tables cell by cell",
    .limits = "within the last printed digit and the known errors of a table; for "
              "simulated results, also within four standard errors",
    .samples = 512,
    .run = run_published};

static const struct pp_suite cie171 = {
    .name = "cie171",
    .summary = "the daylight cases of CIE 171:2006, 2592 values",
    .limits = "exact: within 0.1 % (0.25 % where a mask covers part of the opening) "
              "of an independent integration, or within a daylight factor of 0.001 %. "
              "The same results are within 1 %, or a daylight factor of 0.02 %, of "
              "those printed values that are sound. Traced: within three standard "
              "errors of exact; 1 in 100 may be outside",
    .samples = 64,
    .chance = 0.01,
    .run = run_cie171};

static const struct pp_suite *const list[] = {
    &analytic,       &published,         &cie171,
    &pp_suite_rooms, &pp_suite_radiance, &pp_suite_engines};

enum { COUNT = sizeof list / sizeof *list };

const struct pp_suite *pp_suite_at(int index)
{
    return index < COUNT ? list[index] : NULL;
}

const struct pp_suite *pp_suite_find(const char *name)
{
    for (int i = 0; i < COUNT; i++)
        if (strcmp(list[i]->name, name) == 0)
            return list[i];
    return NULL;
}

struct pp_suite_score pp_suite_score(const struct pp_suite *suite,
                                     const struct pp_known_cases *cases)
{
    struct pp_suite_score score = {0};
    for (int i = 0; i < cases->count; i++) {
        bool traced = !isnan(cases->list[i].std_error);
        bool wrong = !pp_known_case_is_right(&cases->list[i]);
        if (!pp_known_case_is_judged(&cases->list[i])) {
            score.unjudged++;
            continue;
        }
        score.count += !traced;
        score.wrong += !traced && wrong;
        score.traced += traced;
        score.traced_wrong += traced && wrong;
    }
    score.passes =
        score.wrong == 0 && score.traced_wrong <= suite->chance * score.traced;
    return score;
}
