/* sunlit_gardens.c - sun on gardens and other open ground, by [BR209].
 *
 *   S >= 1/2                    of the area has two hours of sun or more on 21 March
 *   S >= 1/2  or  S >= 0.8 S before
 *
 * The hours are possible hours over a level horizon (studies/site/garden_sun.h). A
 * building's gardens are assessed with one of its rooms.
 */
#include <math.h>

#include "studies/criteria/criteria.h"
#include "studies/site/garden_sun.h"

#define SHARE_WANTED 0.5
#define FORMER_SHARE 0.8

static const char no_place[] = "the room file has no latitude (site)";

/* The former garden with the same corners; NULL: there was none. */
static const struct pp_garden *find_before(const struct pp_world *before,
                                           const struct pp_garden *garden)
{
    for (int i = 0; before && i < before->garden_count; i++) {
        const struct pp_garden *other = &before->gardens[i];
        bool same = other->outline.count == garden->outline.count;
        for (int k = 0; same && k < other->outline.count; k++)
            same = pp_vec_length(pp_vec_sub(other->outline.vertices[k],
                                            garden->outline.vertices[k]))
                   < 0.01;
        if (same)
            return other;
    }
    return NULL;
}

static enum pp_status sunlit_garden_share(double *share, double *error,
                                          const struct pp_world *world,
                                          const struct pp_garden *garden,
                                          struct pp_error *err)
{
    struct pp_garden_sun sun;
    enum pp_status status = pp_garden_sun_find(&sun, world, garden, err);
    *share = sun.sunlit_m2 / sun.area_m2;
    *error = sun.error_m2 / sun.area_m2;
    pp_garden_sun_clear(&sun);
    return status;
}

static enum pp_status judge_garden(const struct pp_inquiry *inquiry,
                                   const struct pp_garden *garden,
                                   struct pp_finding_list *findings,
                                   struct pp_error *err)
{
    const struct pp_garden *former = find_before(inquiry->before, garden);
    double now, then = NAN, error, then_error;
    enum pp_status status =
        sunlit_garden_share(&now, &error, inquiry->world, garden, err);
    if (status == PP_OK && former)
        status = sunlit_garden_share(&then, &then_error, inquiry->before, former, err);
    if (status != PP_OK)
        return status;
    struct pp_finding finding =
        pp_finding_of(PP_FIGURE_SHARE, now, SHARE_WANTED, false, "%.40s",
                      garden->name ? garden->name : "garden");
    pp_finding_within(&finding, error);
    finding.line = garden->line;
    pp_finding_compares(&finding, PP_FIGURE_SHARE, now, then);
    pp_finding_note(&finding, "garden area %.1f m2", garden->outline.area_m2);
    if (former)
        pp_finding_note(&finding, "; %.1f %% now, %.1f %% before", 100.0 * now,
                        100.0 * then);
    if (finding.verdict == PP_NOT_MET && now >= FORMER_SHARE * then) {
        finding.verdict = PP_MET;
        pp_finding_note(&finding, "; at least 0.8 of the former sunlit area remains");
    }
    return pp_finding_list_add(findings, &finding, err);
}

static enum pp_status assess_sunlit_gardens(const struct pp_inquiry *inquiry,
                                            struct pp_finding_list *findings,
                                            struct pp_error *err)
{
    const struct pp_world *world = inquiry->world;
    enum pp_status status = PP_OK;
    for (int i = 0; i < world->garden_count && status == PP_OK; i++) {
        if (!isnan(world->latitude_rad)
            && !(inquiry->before && isnan(inquiry->before->latitude_rad))) {
            status = judge_garden(inquiry, &world->gardens[i], findings, err);
            continue;
        }
        const struct pp_garden *garden = &world->gardens[i];
        struct pp_finding finding = pp_finding_not_judged(
            no_place, "%.40s", garden->name ? garden->name : "garden");
        finding.line = garden->line;
        status = pp_finding_list_add(findings, &finding, err);
    }
    return status;
}

const struct pp_criterion pp_criterion_gardens = {
    .name = "gardens",
    .title = "Sun on gardens",
    .source = "BR209",
    .summary = "at least two hours of sun on 21 March on half of each garden",
    .of_gardens = true,
    .of_states = true,
    .without_trees = true,
    .evaluate = assess_sunlit_gardens,
};
