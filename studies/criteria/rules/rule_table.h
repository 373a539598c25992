/* rule_table.h - the rules of countries and schemes, as in tables/rules.csv. */
#ifndef PP_STUDIES_CRITERIA_RULES_RULE_TABLE_H
#define PP_STUDIES_CRITERIA_RULES_RULE_TABLE_H

#include <stdbool.h>
#include <stddef.h>

#include "model/room/room_use.h"

/* A row of the table; the table describes the columns. Texts without a value are "-",
 * numbers NAN. */
struct pp_rule {
    const char *name, *country, *scheme, *edition, *use, *kind, *openings, *quantity,
        *bound;
    double threshold, share, lux;
    const char *sky;
    double plane_m, above_m, sill_m;
    const char *point, *from, *to;
    double from_h, to_h, altitude_deg, plan_angle_deg, obstruction_deg, breaks;
    const char *certainty, *source, *note;
};

/* Row by index, in the order of the table; NULL past the last. */
const struct pp_rule *pp_rule_table_at(int index);

/* Name of a set of rules by index, in the order of the table; NULL past the last. Each
 * name occurs once. */
const char *pp_rule_table_name(int index);

/* True if the row can be assessed: its numbers were seen at their source or come from a
 * secondary source, and the program calculates its quantity. */
bool pp_rule_table_is_judged(const struct pp_rule *rule);

/* True if the row applies to rooms of that use. Every row applies to rooms of unknown
 * use. */
bool pp_rule_table_has_use(const struct pp_rule *rule, enum pp_room_use use);

/* True if that text of a row has a value. */
bool pp_rule_table_has(const char *text);

enum { PP_RULE_WORDS = 128 };

/* The quantity in words, with its sky: "daylight factor over 90 % of the plane, uniform
 * sky". */
void pp_rule_table_words(char words[PP_RULE_WORDS], const struct pp_rule *rule);

/* The bound in words: ">= 2 %"; empty if the row has no number. */
void pp_rule_table_bound(char words[PP_RULE_WORDS], const struct pp_rule *rule);

#endif
