/* sunlight.c - hours of sun at windows, by [BR209].
 *
 *   S >= 25 %    of the hours of sun in a year on open ground
 *   W >= 5 %     of the same hours, from 21 September to 21 March
 *
 * at the centre of the outside of windows that face within 90 degrees of due south (of
 * due north, south of the equator). If the former room is given, lower values also pass
 * if
 *
 *   S >= 0.8 S before  and  W >= 0.8 W before,  or  S before - S <= 4 %
 *
 * [BR209] counts probable hours, which are reduced by average cloud. A weather file
 * gives the probability of sunshine (studies/climate/sunshine.h). Without one, each
 * hour with the sun above the horizon counts. Such possible hours
 * (methods/exact/sunlit_hours.h) are stated but not assessed; the winter fraction of
 * possible hours is larger than that of probable hours. The room's sky has no effect.
 */
#include <math.h>

#include "methods/exact/sunlit_hours.h"
#include "studies/criteria/bearing.h"
#include "studies/criteria/criteria.h"
#include "studies/criteria/windows/opening_words.h"

#define YEAR_WANTED 0.25
#define WINTER_WANTED 0.05
#define FORMER_SHARE 0.8
#define SMALL_LOSS 0.04

static const char possible[] =
    "share of possible hours, in which the sun is above the horizon; BR 209 assesses "
    "probable hours, which need --weather FILE.epw";
static const char probable[] =
    "share of probable hours: each month and hour is weighted by the share of records "
    "with direct sun above 120 W/m2";
static const char no_place[] = "the room file has no latitude (site)";
static const char other_side[] =
    "the window faces more than 90 degrees from due south: not required";
static const char equator_side[] =
    "the window faces more than 90 degrees from due north: not required";

/* True if the opening faces within 90 degrees of the direction of the noon sun;
 * horizontal glass faces all sides. */
static bool faces_noon(const struct pp_world *world, const struct pp_opening *opening)
{
    const double slack = 1e-9; /* due east and due west count */
    struct pp_vec3 n = opening->inner.normal;
    double south = n.y * cos(world->north_rad) - n.x * sin(world->north_rad);
    return (world->latitude_rad < 0.0 ? -south : south) >= -slack;
}

/* Hours of sun, as fractions of the hours in a year on open ground. */
static enum pp_status find_shares(struct pp_sunlit_year *shares,
                                  const struct pp_world *world,
                                  const struct pp_opening *opening,
                                  const struct pp_sunshine *sunshine,
                                  struct pp_error *err)
{
    struct pp_sunlit_place place = {world->latitude_rad, world->north_rad,
                                    world->longitude_rad};
    struct pp_hidden_view view = pp_hidden_cones_outside(opening);
    struct pp_hidden_cones cones;
    struct pp_sunlit_year open;
    const double(*share)[24] = sunshine ? sunshine->share : NULL;
    enum pp_status status = pp_hidden_cones_init(&cones, world, &view, err);
    if (status != PP_OK)
        return status;
    status = pp_sunlit_hours_of_year(shares, &cones, place, share, err);
    pp_hidden_cones_clear(&cones);
    if (status == PP_OK)
        status = pp_sunlit_hours_of_year(&open, NULL, place, share, err);
    if (status == PP_OK) {
        shares->all /= open.all;
        shares->winter /= open.all;
    }
    return status;
}

/* True if enough of the former hours remains. */
static bool is_kept(const struct pp_sunlit_year *now, const struct pp_sunlit_year *then)
{
    return (now->all >= FORMER_SHARE * then->all
            && now->winter >= FORMER_SHARE * then->winter)
           || then->all - now->all <= SMALL_LOSS;
}

static enum pp_status add_finding(struct pp_finding_list *findings, double now,
                                  double then, double wanted, bool kept, bool judged,
                                  const struct pp_opening *opening, const char *window,
                                  const char *season, struct pp_error *err)
{
    struct pp_finding finding = pp_finding_of(
        PP_FIGURE_SHARE, now, judged ? wanted : NAN, false, "%s, %s", window, season);
    finding.line = opening->line;
    finding.season = season;
    pp_finding_compares(&finding, PP_FIGURE_SHARE, now, then);
    if (!isnan(then))
        pp_finding_note(&finding, "%.1f %% now, %.1f %% before", 100.0 * now,
                        100.0 * then);
    if (finding.verdict == PP_NOT_MET && kept) {
        finding.verdict = PP_MET;
        pp_finding_note(&finding, "; at least 0.8 of the former sunlight remains, or "
                                  "no more than 4 %% of the year's hours are lost");
    }
    return pp_finding_list_add(findings, &finding, err);
}

static enum pp_status judge_window(const struct pp_inquiry *inquiry, int index,
                                   const char *window, struct pp_finding_list *findings,
                                   struct pp_error *err)
{
    const struct pp_opening *opening = &inquiry->world->openings[index];
    struct pp_sunlit_year now, then = {NAN, NAN};
    enum pp_status status =
        find_shares(&now, inquiry->world, opening, inquiry->sunshine, err);
    if (status == PP_OK && inquiry->before)
        status = find_shares(&then, inquiry->before,
                             &inquiry->before->openings[inquiry->pairs[index]],
                             inquiry->sunshine, err);
    bool kept = inquiry->before && is_kept(&now, &then);
    if (status == PP_OK)
        status = add_finding(findings, now.all, then.all, YEAR_WANTED, kept,
                             inquiry->sunshine != NULL, opening, window, "year", err);
    if (status == PP_OK)
        status = add_finding(findings, now.winter, then.winter, WINTER_WANTED, kept,
                             inquiry->sunshine != NULL, opening, window, "winter", err);
    return status;
}

static enum pp_status assess_sunlight(const struct pp_inquiry *inquiry,
                                      struct pp_finding_list *findings,
                                      struct pp_error *err)
{
    const struct pp_world *world = inquiry->world;
    bool place = !isnan(world->latitude_rad)
                 && !(inquiry->before && isnan(inquiry->before->latitude_rad));
    if (!place || world->opening_count == 0) {
        struct pp_finding finding = pp_finding_not_judged(
            place ? "the room has no openings" : no_place, "windows");
        return pp_finding_list_add(findings, &finding, err);
    }
    pp_finding_list_add_basis(findings, "%s", inquiry->sunshine ? probable : possible);
    enum pp_status status = PP_OK;
    for (int i = 0; i < world->opening_count && status == PP_OK; i++) {
        const struct pp_opening *opening = &world->openings[i];
        char words[PP_OPENING_WORDS];
        pp_opening_words(words, world, opening);
        if (faces_noon(world, opening)) {
            status = judge_window(inquiry, i, words, findings, err);
            continue;
        }
        struct pp_finding finding = pp_finding_not_judged(
            world->latitude_rad < 0.0 ? equator_side : other_side, "%s", words);
        finding.line = opening->line;
        status = pp_finding_list_add(findings, &finding, err);
    }
    return status;
}

const struct pp_criterion pp_criterion_sunlight = {
    .name = "sunlight",
    .alias = "apsh",
    .title = "Sunlight hours",
    .source = "BR209",
    .summary = "25 % of annual probable sunlight hours, 5 % in winter, at windows that "
               "face south",
    .bears_on_use = pp_bearing_is_lived_in,
    .of_states = true,
    .without_trees = true,
    .evaluate = assess_sunlight,
};
