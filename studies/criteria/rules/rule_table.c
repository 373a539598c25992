/* rule_table.c - see rule_table.h. */
#include "studies/criteria/rules/rule_table.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "formats/epw/month_day.h"
#include "model/base/text.h"

static const struct pp_rule rules[] = {
#include "tables/rules.inc"
};

enum { RULES = sizeof rules / sizeof *rules };

const struct pp_rule *pp_rule_table_at(int index)
{
    return index < RULES ? &rules[index] : NULL;
}

const char *pp_rule_table_name(int index)
{
    for (int i = 0; i < RULES; i++)
        if ((i == 0 || strcmp(rules[i].name, rules[i - 1].name) != 0) && index-- == 0)
            return rules[i].name;
    return NULL;
}

bool pp_rule_table_has(const char *text)
{
    return strcmp(text, "-") != 0;
}

bool pp_rule_table_is_judged(const struct pp_rule *rule)
{
    return strcmp(rule->quantity, "other") != 0
           && (strcmp(rule->certainty, "seen") == 0
               || strcmp(rule->certainty, "secondary") == 0);
}

/* Words of the column `use`, and the rooms that they mean. */
#define USE(name) (1u << PP_USE_##name)
#define LIVING_DINING (USE(LIVING_ROOM) | USE(DINING_ROOM))
#define LIVING_ROOM (LIVING_DINING | USE(STUDIO))
#define LIVING (LIVING_DINING | USE(LIVING_KITCHEN) | USE(STUDIO))
#define HABITABLE (LIVING | USE(BEDROOM) | USE(STUDY))
#define UNLIT (USE(BATHROOM) | USE(CIRCULATION) | USE(STORE))
#define NOT(uses) (~((uses) | UNLIT))
static const struct {
    const char *word;
    unsigned uses;
    const char *label; /* text before the quantity; NULL: none */
} use_words[] = {
    {"any", NOT(0), NULL},
    {"dwelling", HABITABLE | USE(KITCHEN), NULL},
    {"habitable", HABITABLE, "habitable room"},
    {"living", LIVING | USE(KITCHEN), "living area"},
    {"living-room", LIVING_ROOM, "living room"},
    {"not-living-room", NOT(LIVING_ROOM | USE(BEDROOM)), "other room"},
    {"not-bedroom", NOT(USE(BEDROOM)), NULL},
    {"living-dining", LIVING_DINING, "living or dining room"},
    {"not-living-dining", NOT(LIVING_DINING), "other room"},
    {"bedroom", USE(BEDROOM), "bedroom"},
    {"kitchen", USE(KITCHEN), "kitchen"},
    {"work", NOT(LIVING | USE(BEDROOM) | USE(KITCHEN)), NULL},
};

bool pp_rule_table_has_use(const struct pp_rule *rule, enum pp_room_use use)
{
    for (size_t i = 0; i < sizeof use_words / sizeof *use_words; i++)
        if (strcmp(use_words[i].word, rule->use) == 0)
            return use == PP_USE_UNKNOWN || (use_words[i].uses & 1u << use) != 0;
    return false;
}

/* Converts "03-21" to "21 March". */
static const char *day_words(char *words, size_t room, const char *text)
{
    struct pp_month_day date = {0};
    sscanf(text, "%d-%d", &date.month, &date.day);
    return pp_month_day_words(words, room, date);
}

static void append_period(char words[PP_RULE_WORDS], const struct pp_rule *rule)
{
    char from[32], to[32];
    day_words(from, sizeof from, rule->from);
    day_words(to, sizeof to, rule->to);
    if (strcmp(from, to) == 0)
        pp_text_append(words, PP_RULE_WORDS, " on %s", from);
    else
        pp_text_append(words, PP_RULE_WORDS, " a day, %s to %s", from, to);
}

void pp_rule_table_words(char words[PP_RULE_WORDS], const struct pp_rule *rule)
{
    static const struct {
        const char *quantity, *words;
    } all[] = {{"mean-df", "mean daylight factor"},
               {"point-df", "daylight factor at the points"},
               {"share-df", "daylight factor"},
               {"uniformity", "uniformity of the daylight factor"},
               {"vertical-df", "vertical daylight factor"},
               {"glass-ratio", "glass over floor area"},
               {"glass-light-ratio", "glass times transmittance over floor area"},
               {"sun-hours", "hours of sun"},
               {"sda", "sDA"},
               {"ase", "ASE1000,250"},
               {"year-lux", "illuminance in half of the daylight hours"},
               {"mean-lux-hours", "hours with a mean of"},
               {"least-lux-hours", "hours with at least"},
               {"other", "not calculated"}};
    words[0] = '\0';
    for (size_t i = 0; i < sizeof use_words / sizeof *use_words; i++)
        if (use_words[i].label && strcmp(use_words[i].word, rule->use) == 0)
            pp_text_append(words, PP_RULE_WORDS, "%s: ", use_words[i].label);
    for (size_t i = 0; i < sizeof all / sizeof *all; i++)
        if (strcmp(all[i].quantity, rule->quantity) == 0)
            pp_text_append(words, PP_RULE_WORDS, "%s", all[i].words);
    if (strcmp(rule->quantity, "sda") == 0)
        pp_text_append(words, PP_RULE_WORDS, "%g/50", rule->lux);
    else if (isfinite(rule->lux))
        pp_text_append(
            words, PP_RULE_WORDS, " %g lx%s", rule->lux,
            strcmp(rule->quantity, "least-lux-hours") == 0 ? " at every point" : "");
    if (isfinite(rule->share))
        pp_text_append(words, PP_RULE_WORDS, " over%s %g %% of the plane",
                       strcmp(rule->bound, "over") == 0 ? " more than" : "",
                       rule->share);
    if (pp_rule_table_has(rule->from))
        append_period(words, rule);
    if (isfinite(rule->from_h))
        pp_text_append(words, PP_RULE_WORDS, ", %g to %g h", rule->from_h, rule->to_h);
    if (isfinite(rule->breaks))
        pp_text_append(words, PP_RULE_WORDS, ", %s",
                       rule->breaks > 0.0 ? "with one break" : "uninterrupted");
    if (isfinite(rule->altitude_deg))
        pp_text_append(words, PP_RULE_WORDS, ", sun above %g degrees",
                       rule->altitude_deg);
    if (isfinite(rule->plan_angle_deg))
        pp_text_append(words, PP_RULE_WORDS, ", %g degrees or more to the glass",
                       rule->plan_angle_deg);
    if (pp_rule_table_has(rule->sky))
        pp_text_append(words, PP_RULE_WORDS, ", %s sky", rule->sky);
}

void pp_rule_table_bound(char words[PP_RULE_WORDS], const struct pp_rule *rule)
{
    const char *of = rule->quantity;
    const char *unit = strcmp(of, "year-lux") == 0     ? " lx"
                       : strcmp(of, "uniformity") == 0 ? ""
                       : strstr(of, "hours")           ? " h"
                                                       : " %";
    const char *sign = strcmp(rule->bound, "most") == 0    ? "<="
                       : strcmp(rule->bound, "above") == 0 ? ">"
                                                           : ">=";
    words[0] = '\0';
    if (isfinite(rule->threshold))
        snprintf(words, PP_RULE_WORDS, "%s %g%s", sign, rule->threshold, unit);
}
