/* glare_criterion.c - protection from glare by [EN17037] 5.4: a limit of DGP is exceeded
 * in at most 5 % of the occupied hours.
 *
 *   minimum 0.45, medium 0.40, high 0.35
 *
 * Calculated for every view of the room file, at 8 to 18 h on all days. Blinds, screens
 * and curtains of the room are closed in all hours. Without such devices the level is
 * that of the unshaded room. The standard assesses a room with its blinds in use.
 */
#include <stdio.h>

#include "model/base/text.h"
#include "studies/criteria/criteria.h"
#include "studies/criteria/rules/rule_year.h"
#include "studies/glare/glare_study.h"

static enum pp_status add_view_levels(const struct pp_glare_sheet *glare, int view,
                                      struct pp_finding_list *findings,
                                      struct pp_error *err)
{
    static const char *const levels[PP_GLARE_LIMITS] = {"high", "medium", "minimum"};
    const struct pp_glare_year *year = &glare->years[view];
    double hours = glare->annual.occupied_h;
    enum pp_status status = PP_OK;
    for (int i = PP_GLARE_LIMITS - 1; i >= 0 && status == PP_OK; i--) {
        char name[80], what[128];
        if (glare->views[view].name)
            pp_text_excerpt(name, sizeof name, glare->views[view].name);
        else
            snprintf(name, sizeof name, "view %d", view + 1);
        snprintf(what, sizeof what, "%s, %s: hours with DGP above %.2f", name,
                 levels[i], pp_glare_sheet_limits[i]);
        const struct pp_annual_value share = {year->above_h[i].value / hours,
                                              year->above_h[i].std_error / hours};
        struct pp_finding finding =
            pp_rule_year_share(&share, PP_GLARE_SHARE, true, what);
        finding.line = 0;
        finding.level = PP_GLARE_LIMITS - i;
        finding.is_optional = i < PP_GLARE_LIMITS - 1;
        if (i == PP_GLARE_LIMITS - 1 && finding.verdict != PP_MET)
            pp_finding_note(&finding,
                            glare->has_devices
                                ? "with the devices of the room file in all hours"
                                : "without blinds; a blind is required");
        status = pp_finding_list_add(findings, &finding, err);
    }
    return status;
}

static enum pp_status evaluate_glare(const struct pp_inquiry *inquiry,
                                     struct pp_finding_list *findings,
                                     struct pp_error *err)
{
    const struct pp_glare_sheet *glare = inquiry->glare;
    const char *why_not =
        inquiry->world->view_count == 0
            ? "the room file has no view; expected <view x=\"2\" y=\"3\" "
              "bearing=\"180\"/>"
        : pp_glare_study_turning(inquiry->world) >= 0
            ? "slats follow the sun, and their glare over a year is not calculated"
        : !glare
            ? "no year was simulated; expected --weather FILE.epw, and no --by-hand"
        : !glare->annual.finished ? "the simulation of the year was interrupted"
                                  : NULL;
    if (why_not) {
        struct pp_finding finding =
            pp_finding_not_judged(why_not, "DGP in the occupied hours");
        return pp_finding_list_add(findings, &finding, err);
    }
    pp_finding_list_add_basis(
        findings,
        "daylight glare probability in %.0f occupied hours, 8 to 18 h on all days, "
        "%s; sources have %g cd/m2 or more",
        glare->annual.occupied_h,
        glare->has_devices ? "with blinds, screens and curtains closed in all hours"
                           : "without blinds",
        glare->threshold_cd_m2);
    enum pp_status status = PP_OK;
    for (int v = 0; v < glare->view_count && status == PP_OK; v++)
        status = add_view_levels(glare, v, findings, err);
    return status;
}

const struct pp_criterion pp_criterion_glare = {
    .name = "glare",
    .title = "protection from glare",
    .source = "EN17037, WC06",
    .summary =
        "DGP above 0.45, 0.40, 0.35 in at most 5 % of the occupied hours, for the "
        "views in the file; needs --weather, and is assessed only if named",
    .of_glare = true,
    .evaluate = evaluate_glare,
};
