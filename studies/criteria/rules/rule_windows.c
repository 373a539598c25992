/* rule_windows.c - rules on windows: the vertical daylight factor of each window, and
 * the ratio of glass area to floor area. */
#include <math.h>

#include "methods/allowance.h"
#include "methods/exact/exterior.h"
#include "methods/reflected/interior.h"
#include "studies/criteria/rules/rule_quantity.h"
#include "studies/criteria/section_angle.h"
#include "studies/criteria/windows/opening_words.h"
#include "studies/criteria/windows/vertical_sky.h"

/* Finding by hand: an obstruction has a fixed fraction of the luminance of the sky that
 * it hides, and the ground is lit as in the open. Between high buildings both
 * assumptions give too much light, so only light from the sky can show that the rule is
 * met. */
static struct pp_finding vertical_by_hand(const struct pp_exterior_light *outside,
                                          double wanted, const char *words,
                                          const char *what)
{
    struct pp_finding finding =
        pp_finding_of(PP_FIGURE_FACTOR, outside->sky + outside->external, wanted, false,
                      "%s: %s", words, what);
    pp_finding_note(&finding, "%.1f %% from the sky, %.1f %% reflected",
                    100.0 * outside->sky, 100.0 * outside->external);
    if (finding.verdict == PP_MET && outside->sky < finding.wanted * (1.0 - 1e-9)) {
        finding.verdict = PP_UNDECIDED;
        pp_finding_note(&finding, "; reflected light is overestimated between "
                                  "buildings");
    }
    return finding;
}

/* Finding by simulation, whose reflected light is that of the scene. */
static struct pp_finding vertical_traced(const struct pp_exterior_light *outside,
                                         const struct pp_reading *traced, double wanted,
                                         const char *words, const char *what)
{
    struct pp_finding finding = pp_finding_of(PP_FIGURE_FACTOR, traced->value, wanted,
                                              false, "%s: %s", words, what);
    if (traced->std_error > 0.0)
        pp_finding_sampled(&finding, traced->std_error,
                           pp_finding_probability_at_least(
                               traced->value, traced->std_error, finding.wanted));
    pp_finding_note(&finding, "simulated; %.1f %% from the sky, %.1f %% reflected",
                    100.0 * outside->sky, 100.0 * (traced->value - outside->sky));
    return finding;
}

/* Assesses the illuminance at the centre of the window's outside from the sky, from
 * obstructions and from the ground, over Eh. */
static enum pp_status judge_vertical(const struct pp_rule *rule,
                                     const struct pp_inquiry *inquiry, const char *what,
                                     struct pp_finding_list *findings,
                                     struct pp_error *err)
{
    const struct pp_world *world = inquiry->world;
    enum pp_status status = PP_OK;
    if (world->opening_count == 0) {
        struct pp_finding none = pp_finding_of(
            PP_FIGURE_FACTOR, 0.0, 0.01 * rule->threshold, false, "%s", what);
        pp_finding_note(&none, "the room has no openings");
        return pp_finding_list_add(findings, &none, err);
    }
    for (int i = 0; i < world->opening_count && status == PP_OK; i++) {
        const struct pp_opening *opening = &world->openings[i];
        char words[PP_OPENING_WORDS];
        pp_opening_words(words, world, opening);
        struct pp_finding finding =
            pp_finding_not_judged("the opening is not vertical", "%s: %s", words, what);
        if (pp_vertical_sky_is_upright(opening)) {
            struct pp_exterior_light outside;
            status = pp_exterior_light_on_plane(
                &outside, world, inquiry->light, pp_exterior_opening_centroid(opening),
                pp_vec_scale(opening->inner.normal, -1.0), opening->face, err);
            if (status != PP_OK)
                return status;
            const struct pp_reading *traced =
                inquiry->windows && isfinite(inquiry->windows[i].value)
                    ? &inquiry->windows[i]
                    : NULL;
            double wanted = 0.01 * rule->threshold;
            finding = traced ? vertical_traced(&outside, traced, wanted, words, what)
                             : vertical_by_hand(&outside, wanted, words, what);
        }
        finding.line = opening->line;
        status = pp_finding_list_add(findings, &finding, err);
    }
    return status;
}

/* Net area of an opening's glass above a height; NAN: all of it. */
static double glass_above_m2(const struct pp_opening *opening, double above_m)
{
    double all_m2 = opening->inner.area_m2;
    double part_m2 = isnan(above_m)
                         ? all_m2
                         : all_m2 - pp_interior_area_below(&opening->inner, above_m);
    return pp_allowance_net_glass_m2(opening) * part_m2 / all_m2;
}

/* True if a window has a level shade outside, such as an overhang or a balcony. */
static bool has_balconies(const struct pp_world *world)
{
    for (int i = 0; i < world->surface_count; i++) {
        const struct pp_surface *surface = &world->surfaces[i];
        if (surface->is_shade && !surface->inside
            && fabs(surface->outline.normal.z) > 0.99)
            return true;
    }
    return false;
}

/* Angle of the highest obstruction before a vertical opening (rad), without the shades
 * of windows. */
static double highest_obstruction_rad(const struct pp_world *world)
{
    double highest = 0.0;
    for (int i = 0; i < world->opening_count; i++)
        if (pp_vertical_sky_is_upright(&world->openings[i]))
            highest =
                fmax(highest, pp_section_angle(world, &world->openings[i], false));
    return highest;
}

static enum pp_status add_ratio(const struct pp_rule *rule,
                                const struct pp_inquiry *inquiry, bool of_light,
                                const char *what, struct pp_finding_list *findings,
                                struct pp_error *err)
{
    const struct pp_world *world = inquiry->world;
    double floor_m2 = pp_world_floor_m2(world), glass_m2 = 0.0, sum_m2 = 0.0;
    for (int i = 0; i < world->opening_count; i++) {
        const struct pp_opening *opening = &world->openings[i];
        double m2 = glass_above_m2(opening, rule->above_m);
        glass_m2 += m2;
        sum_m2 += of_light ? m2 * opening->glass.normal : m2;
    }
    struct pp_finding finding = pp_finding_of(
        PP_FIGURE_SHARE, sum_m2 / floor_m2, 0.01 * rule->threshold, false, "%s", what);
    pp_finding_note(&finding, "%.2f m2 of glass, %.2f m2 of floor", glass_m2, floor_m2);
    double angle = isfinite(rule->obstruction_deg) ? highest_obstruction_rad(world) : 0;
    if (angle > rule->obstruction_deg * PP_RAD)
        finding = pp_finding_not_judged(
            "an obstruction is higher than the rule permits", "%s", what);
    else if (isfinite(rule->obstruction_deg) && has_balconies(world)
             && finding.verdict == PP_MET) {
        finding.verdict = PP_UNDECIDED;
        pp_finding_note(&finding, "; the floor area excludes the area below overhangs");
    }
    return pp_finding_list_add(findings, &finding, err);
}

static enum pp_status judge_glass(const struct pp_rule *rule,
                                  const struct pp_inquiry *inquiry, const char *what,
                                  struct pp_finding_list *findings,
                                  struct pp_error *err)
{
    return add_ratio(rule, inquiry, false, what, findings, err);
}

static enum pp_status judge_glass_light(const struct pp_rule *rule,
                                        const struct pp_inquiry *inquiry,
                                        const char *what,
                                        struct pp_finding_list *findings,
                                        struct pp_error *err)
{
    return add_ratio(rule, inquiry, true, what, findings, err);
}

const struct pp_rule_quantity pp_rule_vertical_factor = {"vertical-df", judge_vertical};
const struct pp_rule_quantity pp_rule_glass_ratio = {"glass-ratio", judge_glass};
const struct pp_rule_quantity pp_rule_glass_light_ratio = {"glass-light-ratio",
                                                           judge_glass_light};
