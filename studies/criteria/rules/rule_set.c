/* rule_set.c - see rule_set.h.
 *
 * Each row that applies to the room gives its own findings. Rows of kind "or1" and
 * "or2" are alternatives: their findings are optional, and one more finding counts the
 * alternatives that meet all of their rows.
 */
#include "studies/criteria/rules/rule_set.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "studies/criteria/rules/rule_quantity.h"
#include "studies/criteria/rules/rule_table.h"

static const struct pp_rule_quantity *const quantities[] = {&pp_rule_mean_factor,
                                                            &pp_rule_point_factor,
                                                            &pp_rule_share_factor,
                                                            &pp_rule_uniformity,
                                                            &pp_rule_vertical_factor,
                                                            &pp_rule_glass_ratio,
                                                            &pp_rule_glass_light_ratio,
                                                            &pp_rule_sun_hours,
                                                            &pp_rule_sda,
                                                            &pp_rule_ase,
                                                            &pp_rule_year_lux,
                                                            &pp_rule_mean_lux_hours,
                                                            &pp_rule_least_lux_hours};

enum { QUANTITIES = sizeof quantities / sizeof *quantities, ALTERNATIVES = 2 };

static bool is_alternative(const struct pp_rule *rule)
{
    return strncmp(rule->kind, "or", 2) == 0;
}

/* True if glass at less than 75 degrees is more than half of the openings' area, as
 * for uniformity (averages.c). */
static bool has_rooflights(const struct pp_world *world)
{
    double roof_m2 = 0.0, all_m2 = 0.0;
    for (int i = 0; i < world->opening_count; i++) {
        const struct pp_opening *opening = &world->openings[i];
        all_m2 += opening->inner.area_m2;
        roof_m2 += opening->slope_rad < 75.0 * PP_RAD ? opening->inner.area_m2 : 0.0;
    }
    return roof_m2 > 0.5 * all_m2;
}

static bool applies_to_room(const struct pp_rule *rule, const struct pp_world *world)
{
    return pp_rule_table_has_use(rule, world->use)
           && (strcmp(rule->openings, "any") == 0
               || (strcmp(rule->openings, "rooflights") == 0) == has_rooflights(world));
}

/* Adds edition, certainty, source and note of the row to its findings from `first`
 * on. */
static void cite_rule(const struct pp_rule *rule, struct pp_finding_list *findings,
                      int first)
{
    const char *how = strcmp(rule->certainty, "seen") == 0 ? "numbers seen at"
                      : strcmp(rule->certainty, "secondary") == 0
                          ? "numbers from a secondary source,"
                          : "numbers not seen,";
    for (int i = first; i < findings->count; i++) {
        struct pp_finding *finding = &findings->list[i];
        pp_finding_note(finding, "%s%s; %s %s%s%s", finding->note[0] ? "; " : "",
                        rule->edition, how, rule->source,
                        pp_rule_table_has(rule->note) ? "; " : "",
                        pp_rule_table_has(rule->note) ? rule->note : "");
    }
}

static enum pp_status evaluate_rule(const struct pp_rule *rule,
                                    const struct pp_inquiry *inquiry,
                                    struct pp_finding_list *findings,
                                    struct pp_error *err)
{
    char what[PP_RULE_WORDS];
    enum pp_status status = PP_OK;
    pp_rule_table_words(what, rule);
    int first = findings->count;
    if (!pp_rule_table_is_judged(rule)) {
        struct pp_finding finding = pp_finding_not_judged(
            strcmp(rule->quantity, "other") == 0 ? "not calculated"
                                                 : "the numbers are not established",
            "%s", what);
        status = pp_finding_list_add(findings, &finding, err);
    } else {
        for (int q = 0; q < QUANTITIES && status == PP_OK; q++)
            if (strcmp(quantities[q]->name, rule->quantity) == 0)
                status = quantities[q]->evaluate(rule, inquiry, what, findings, err);
    }
    for (int i = first; i < findings->count; i++) {
        struct pp_finding *finding = &findings->list[i];
        finding->is_optional = strcmp(rule->kind, "all") != 0;
        bool judged = finding->verdict == PP_MET || finding->verdict == PP_UNDECIDED;
        if (strcmp(rule->bound, "necessary") == 0 && judged) {
            finding->verdict = PP_UNDECIDED;
            finding->confidence = NAN;
        }
        finding->strict = strcmp(rule->bound, "above") == 0;
        if (finding->strict && finding->verdict == PP_MET
            && finding->figure <= finding->wanted * (1.0 + 1e-9)) {
            finding->verdict = PP_NOT_MET;
            finding->confidence = NAN;
        }
    }
    cite_rule(rule, findings, first);
    return status;
}

/* The verdict on rows that are required together. */
static enum pp_verdict join(enum pp_verdict a, enum pp_verdict b)
{
    static const enum pp_verdict worst[] = {PP_NOT_MET, PP_NOT_JUDGED, PP_UNDECIDED};
    for (size_t i = 0; i < sizeof worst / sizeof *worst; i++)
        if (a == worst[i] || b == worst[i])
            return worst[i];
    return PP_MET;
}

/* Counts the alternatives that are met; one is enough. */
static struct pp_finding count_alternatives(const enum pp_verdict *verdicts,
                                            const bool *exists)
{
    int met = 0, count = 0, unknown = 0, unjudged = 0;
    for (int i = 0; i < ALTERNATIVES; i++) {
        count += exists[i];
        met += exists[i] && verdicts[i] == PP_MET;
        unjudged += exists[i] && verdicts[i] == PP_NOT_JUDGED;
        unknown +=
            exists[i] && (verdicts[i] == PP_UNDECIDED || verdicts[i] == PP_NOT_JUDGED);
    }
    if (unjudged == count)
        return pp_finding_not_judged("no alternative can be judged",
                                     "alternatives met");
    struct pp_finding finding = pp_finding_of(PP_FIGURE_COUNT, met, 1.0, false,
                                              "alternatives met, of %d", count);
    if (met == 0 && unknown > 0)
        finding.verdict = PP_UNDECIDED;
    return finding;
}

static enum pp_status judge_rules(const struct pp_inquiry *inquiry,
                                  struct pp_finding_list *findings,
                                  struct pp_error *err)
{
    const struct pp_rule_set *set = inquiry->rules;
    const struct pp_rule *rule;
    enum pp_verdict verdicts[ALTERNATIVES] = {PP_MET, PP_MET};
    bool exists[ALTERNATIVES] = {false};
    enum pp_status status = PP_OK;
    for (int i = 0; (rule = pp_rule_table_at(i)) != NULL && status == PP_OK; i++) {
        if (strcmp(rule->name, set->criterion.name) != 0
            || !applies_to_room(rule, inquiry->world))
            continue;
        int first = findings->count, which = rule->kind[2] - '1';
        status = evaluate_rule(rule, inquiry, findings, err);
        for (int k = first; k < findings->count && is_alternative(rule); k++) {
            exists[which] = true;
            verdicts[which] = join(verdicts[which], findings->list[k].verdict);
        }
    }
    if (status == PP_OK && findings->count == 0) {
        struct pp_finding none = pp_finding_not_judged(
            "no row of these rules applies to a room of this use", "all rules");
        return pp_finding_list_add(findings, &none, err);
    }
    if (status == PP_OK && (exists[0] || exists[1])) {
        struct pp_finding sum = count_alternatives(verdicts, exists);
        status = pp_finding_list_add(findings, &sum, err);
    }
    if (set->plane_m > 0.0)
        pp_finding_list_add_basis(findings, "%sworking plane %g m above the floor",
                                  findings->basis[0] ? "; " : "", set->plane_m);
    return status;
}

/* ---- a set ---- */

static bool is_quantity(const struct pp_rule *rule, const struct pp_rule_quantity *of)
{
    return strcmp(rule->quantity, of->name) == 0;
}

/* Adds the requirements of a rule that can be assessed. */
static void add_rule(struct pp_rule_set *set, const struct pp_rule *rule)
{
    bool of_year = is_quantity(rule, &pp_rule_sda) || is_quantity(rule, &pp_rule_ase)
                   || strstr(rule->quantity, "lux") != NULL;
    set->is_judged = true;
    set->of_year |= of_year;
    set->only_year &= of_year;
    set->of_sda |= is_quantity(rule, &pp_rule_sda) || is_quantity(rule, &pp_rule_ase);
    set->of_average |= is_quantity(rule, &pp_rule_mean_factor);
    set->of_windows |= is_quantity(rule, &pp_rule_vertical_factor);
    set->criterion.of_factors |= is_quantity(rule, &pp_rule_mean_factor)
                                 || is_quantity(rule, &pp_rule_share_factor)
                                 || is_quantity(rule, &pp_rule_uniformity);
    set->criterion.without_trees |= is_quantity(rule, &pp_rule_sun_hours);
    if (is_quantity(rule, &pp_rule_point_factor))
        set->point = rule->point;
    if (pp_rule_table_has(rule->sky))
        set->sky = rule->sky;
    if (isfinite(rule->plane_m))
        set->plane_m = rule->plane_m;
}

bool pp_rule_set_init(struct pp_rule_set *set, const char *name)
{
    const struct pp_rule *rule, *first = NULL;
    *set = (struct pp_rule_set){.plane_m = NAN, .only_year = true, .country = ""};
    for (int i = 0; (rule = pp_rule_table_at(i)) != NULL; i++) {
        if (strcmp(rule->name, name) != 0)
            continue;
        first = first ? first : rule;
        if (pp_rule_table_is_judged(rule))
            add_rule(set, rule);
    }
    if (!first)
        return false;
    bool national = pp_rule_table_has(first->country);
    snprintf(set->title, sizeof set->title, "%s%s%s, %s",
             national ? first->country : "", national ? ": " : "", first->scheme,
             first->edition);
    set->country = national ? first->country : "";
    set->criterion.name = first->name;
    set->criterion.title = set->title;
    set->criterion.source = first->source;
    set->criterion.summary = first->scheme;
    set->criterion.evaluate = judge_rules;
    return true;
}
