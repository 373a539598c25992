/* no_sky_line.c - the fraction of the working plane from which sky can be seen.
 *
 * The no-sky line bounds the part of the working plane from which no sky can be seen
 * (studies/lit_line.h), through any kind of glass.
 *
 *   no-sky-line  the area behind the line, only stated; if the former room is given,
 *                the area that sees sky must be 0.8 of its former size or more
 *                [BR209]
 *   sky-line     80 % of the plane or more must see sky: the back of a room looks
 *                gloomy if a fifth of the plane lies behind the line      [BS8206],
 *                [BREEAM14]
 */
#include <math.h>

#include "studies/criteria/bearing.h"
#include "studies/criteria/criteria.h"
#include "studies/lit_line.h"

#define SEEN_WANTED 0.8
#define FORMER_SHARE_WANTED 0.8

static const char no_plane[] = "the room has no working plane";

/* Areas of the working plane, and of its part that sees sky. */
struct sky_view_area {
    double plane_m2, sky_m2;
    double error_m2; /* error of sky_m2, due to the tolerance of the line */
};

static enum pp_status find_view(struct sky_view_area *view,
                                const struct pp_world *world, struct pp_error *err)
{
    struct pp_lit_area area;
    enum pp_status status = pp_lit_line_find(&area, world, PP_LIT_NO_SKY, err);
    *view = (struct sky_view_area){area.plane_m2, area.lit_m2, area.error_m2};
    pp_lit_area_clear(&area);
    return status;
}

/* Adds the finding; not assessed if the room has no working plane. */
static enum pp_status add_if_plane(struct pp_finding_list *findings,
                                   const struct sky_view_area *view,
                                   struct pp_finding finding, struct pp_error *err)
{
    if (!(view->plane_m2 > 0.0))
        finding = pp_finding_not_judged(no_plane, "%s", finding.what);
    return pp_finding_list_add(findings, &finding, err);
}

/* Adds the finding on the ratio of the area that sees sky now to the former area. */
static enum pp_status add_former(const struct sky_view_area *now,
                                 const struct pp_world *before,
                                 struct pp_finding_list *findings, struct pp_error *err)
{
    static const char what[] = "area with a view of the sky, ratio to the former area";
    struct sky_view_area then;
    enum pp_status status = find_view(&then, before, err);
    if (status != PP_OK)
        return status;
    struct pp_finding share = pp_finding_not_judged(
        "no part of the plane had a view of the sky before", what);
    if (then.sky_m2 > 0.0) {
        share = pp_finding_of(PP_FIGURE_RATIO, now->sky_m2 / then.sky_m2,
                              FORMER_SHARE_WANTED, false, what);
        pp_finding_compares(&share, PP_FIGURE_AREA, now->sky_m2, then.sky_m2);
        pp_finding_within(&share, (now->error_m2 + then.error_m2) / then.sky_m2);
        pp_finding_note(&share, "%.2f m2 now, %.2f m2 before", now->sky_m2,
                        then.sky_m2);
    }
    return pp_finding_list_add(findings, &share, err);
}

/* Adds a finding with the reason why the line cannot be found, now or in the former
 * state. */
static enum pp_status add_refused(const struct pp_inquiry *inquiry, const char *what,
                                  struct pp_finding_list *findings,
                                  struct pp_error *err)
{
    struct pp_finding finding = pp_finding_not_judged(
        pp_lit_line_refuses(inquiry->world, inquiry->before), "%s", what);
    return pp_finding_list_add(findings, &finding, err);
}

static enum pp_status evaluate_line(const struct pp_inquiry *inquiry,
                                    struct pp_finding_list *findings,
                                    struct pp_error *err)
{
    struct sky_view_area view;
    if (pp_lit_line_refuses(inquiry->world, inquiry->before))
        return add_refused(inquiry, "area without a view of the sky", findings, err);
    enum pp_status status = find_view(&view, inquiry->world, err);
    if (status != PP_OK)
        return status;
    double no_sky_m2 = view.plane_m2 - view.sky_m2;
    struct pp_finding area = pp_finding_of(PP_FIGURE_AREA, no_sky_m2, NAN, true,
                                           "area without a view of the sky");
    pp_finding_compares(&area, PP_FIGURE_AREA, view.sky_m2, NAN);
    if (view.plane_m2 > 0.0)
        pp_finding_note(&area, "%.1f %% of the working plane",
                        100.0 * no_sky_m2 / view.plane_m2);
    status = add_if_plane(findings, &view, area, err);
    if (status == PP_OK && inquiry->before)
        status = add_former(&view, inquiry->before, findings, err);
    return status;
}

static enum pp_status evaluate_rule(const struct pp_inquiry *inquiry,
                                    struct pp_finding_list *findings,
                                    struct pp_error *err)
{
    struct sky_view_area view;
    if (pp_lit_line_refuses(inquiry->world, NULL))
        return add_refused(inquiry, "working plane with a view of the sky", findings,
                           err);
    enum pp_status status = find_view(&view, inquiry->world, err);
    if (status != PP_OK)
        return status;
    struct pp_finding share =
        pp_finding_of(PP_FIGURE_SHARE, view.sky_m2 / view.plane_m2, SEEN_WANTED, false,
                      "working plane with a view of the sky");
    pp_finding_within(&share, view.error_m2 / view.plane_m2);
    return add_if_plane(findings, &view, share, err);
}

const struct pp_criterion pp_criterion_no_sky_line = {
    .name = "no-sky-line",
    .alias = "nsl",
    .title = "No-sky line",
    .source = "BR209",
    .summary = "area without a view of the sky; with --before, at least 0.8 of the "
               "former area with a view of the sky remains",
    .bears_on_use = pp_bearing_needs_daylight,
    .of_states = true,
    .without_trees = true,
    .evaluate = evaluate_line,
};

const struct pp_criterion pp_criterion_sky_line = {
    .name = "sky-line",
    .title = "Sky-line rule",
    .source = "BS8206, BREEAM14",
    .withdrawn = "BS 8206-2 was withdrawn in 2019; later versions of BREEAM replaced "
                 "the 2014 version",
    .summary = "at least 80 % of the working plane has a view of the sky",
    .bears_on_use = pp_bearing_needs_daylight,
    .without_trees = true,
    .evaluate = evaluate_rule,
};
