/* rule_quantity.h - the quantities of rules. Each quantity produces the findings for
 * the rows of the table (rule_table.h) that use it. */
#ifndef PP_STUDIES_CRITERIA_RULES_RULE_QUANTITY_H
#define PP_STUDIES_CRITERIA_RULES_RULE_QUANTITY_H

#include "studies/criteria/criterion.h"
#include "studies/criteria/rules/rule_table.h"

struct pp_rule_quantity {
    const char *name; /* as in the table */

    /* Adds one or more findings named `what` (for a window, with "W1, south: " in
     * front), without notes on the rule's source. */
    enum pp_status (*evaluate)(const struct pp_rule *rule,
                               const struct pp_inquiry *inquiry, const char *what,
                               struct pp_finding_list *findings, struct pp_error *err);
};

extern const struct pp_rule_quantity pp_rule_mean_factor, pp_rule_point_factor,
    pp_rule_share_factor, pp_rule_uniformity, pp_rule_vertical_factor,
    pp_rule_glass_ratio, pp_rule_glass_light_ratio, pp_rule_sun_hours, pp_rule_sda,
    pp_rule_ase, pp_rule_year_lux, pp_rule_mean_lux_hours, pp_rule_least_lux_hours;

#endif
