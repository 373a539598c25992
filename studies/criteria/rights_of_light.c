/* rights_of_light.c - the area of a room that is adequately lit in the English law of
 * easements (studies/lit_line.h), and the part of it that was lost.
 *
 * A room is adequately lit if the 0.2 % contour of the sky factor encloses half of its
 * area or more. The lost area is also divided into zones.
 */
#include <math.h>

#include "studies/criteria/criteria.h"
#include "studies/lit_line.h"

#define SHARE_WANTED 0.5

/* Adds the losses by zone, and the first-zone equivalent. */
static enum pp_status add_zones(const struct pp_lit_loss *loss,
                                struct pp_finding_list *findings, struct pp_error *err)
{
    enum pp_status status = PP_OK;
    for (int i = 0; i < PP_ZONE_COUNT && status == PP_OK; i++) {
        if (!(loss->zones_m2[i] > 0.0))
            continue;
        struct pp_finding zone = pp_finding_of(
            PP_FIGURE_AREA, loss->zones_m2[i], NAN, true, "area lost in the %s",
            pp_lit_area_zone_name((enum pp_lit_zone)i));
        status = pp_finding_list_add(findings, &zone, err);
    }
    if (status != PP_OK || !(loss->equivalent_m2 > 0.0))
        return status;
    struct pp_finding equivalent =
        pp_finding_of(PP_FIGURE_AREA, loss->equivalent_m2, NAN, true,
                      "area lost, as equivalent first zone");
    return pp_finding_list_add(findings, &equivalent, err);
}

/* Adds the area that was adequately lit in the former state, and the part of it that is
 * lost. */
static enum pp_status add_loss(struct pp_finding_list *findings, struct pp_error *err)
{
    const struct pp_lit_change *lit = &findings->lit;
    struct pp_finding former = pp_finding_of(PP_FIGURE_AREA, lit->before_m2, NAN, false,
                                             "adequately lit area before");
    struct pp_finding lost =
        pp_finding_of(PP_FIGURE_AREA, lit->lost_m2, NAN, true, "area lost");
    if (lit->before_m2 > 0.0)
        pp_finding_note(&lost, "%.1f %% of the area that was adequately lit before",
                        100.0 * lit->lost_m2 / lit->before_m2);
    enum pp_status status = pp_finding_list_add(findings, &former, err);
    if (status == PP_OK)
        status = pp_finding_list_add(findings, &lost, err);
    return status == PP_OK ? add_zones(&lit->loss, findings, err) : status;
}

static enum pp_status find_before(double *before_m2, const struct pp_inquiry *inquiry,
                                  struct pp_error *err)
{
    struct pp_lit_area then;
    *before_m2 = NAN;
    if (!inquiry->before)
        return PP_OK;
    enum pp_status status =
        pp_lit_line_find(&then, inquiry->before, PP_LIT_SKY_FACTOR, err);
    if (status == PP_OK)
        *before_m2 = then.lit_m2;
    pp_lit_area_clear(&then);
    return status;
}

static enum pp_status add_findings(const struct pp_lit_area *now,
                                   const struct pp_inquiry *inquiry,
                                   struct pp_finding_list *findings,
                                   struct pp_error *err)
{
    if (!(now->plane_m2 > 0.0)) {
        struct pp_finding finding =
            pp_finding_not_judged("the room does not reach 0.85 m above its floor",
                                  "share of the room inside the 0.2 %% contour");
        return pp_finding_list_add(findings, &finding, err);
    }
    struct pp_finding area =
        pp_finding_of(PP_FIGURE_AREA, now->lit_m2, NAN, false,
                      "adequately lit area (inside the 0.2 %% contour)");
    struct pp_finding share =
        pp_finding_of(PP_FIGURE_SHARE, now->lit_m2 / now->plane_m2, SHARE_WANTED, false,
                      "share of the room that is adequately lit");
    pp_finding_within(&share, now->error_m2 / now->plane_m2);
    double before_m2;
    enum pp_status status = find_before(&before_m2, inquiry, err);
    if (status != PP_OK)
        return status;
    findings->lit = pp_lit_area_change(now->plane_m2, before_m2, now->lit_m2);
    status = pp_finding_list_add(findings, &area, err);
    if (status == PP_OK)
        status = pp_finding_list_add(findings, &share, err);
    return status == PP_OK && inquiry->before ? add_loss(findings, err) : status;
}

static enum pp_status assess_rights_of_light(const struct pp_inquiry *inquiry,
                                             struct pp_finding_list *findings,
                                             struct pp_error *err)
{
    struct pp_lit_area now;
    const char *why = pp_lit_line_refuses(inquiry->world, inquiry->before);
    if (why) {
        struct pp_finding finding =
            pp_finding_not_judged(why, "share of the room that is adequately lit");
        return pp_finding_list_add(findings, &finding, err);
    }
    enum pp_status status =
        pp_lit_line_find(&now, inquiry->world, PP_LIT_SKY_FACTOR, err);
    if (status != PP_OK)
        return status;
    status = add_findings(&now, inquiry, findings, err);
    pp_lit_area_clear(&now);
    return status;
}

const struct pp_criterion pp_criterion_rights_of_light = {
    .name = "rights-of-light",
    .title = "Rights of light",
    .source = "WW23",
    .summary = "sky factor of 0.2 % or more at 0.85 m over half of the room",
    .countries = "GB IE",
    .without_trees = true,
    .evaluate = assess_rights_of_light,
};
