/* rule_year.h - findings on a room's simulated year. */
#ifndef PP_STUDIES_CRITERIA_RULES_RULE_YEAR_H
#define PP_STUDIES_CRITERIA_RULES_RULE_YEAR_H

#include "model/results/sheets/annual_sheet.h"
#include "studies/criteria/criterion.h"
#include "studies/criteria/finding.h"

/* Finding on a fraction of the plane or of the hours, with its standard error. */
struct pp_finding pp_rule_year_share(const struct pp_annual_value *value, double wanted,
                                     bool at_most, const char *what);

/* Reason why figures of the year are not known; NULL if they are known. */
const char *pp_rule_year_missing(const struct pp_inquiry *inquiry);

/* Finding on the illuminance that a part of the plane reaches in half of the daylight
 * hours, from the points of the simulated year. The noise is assumed to be common to
 * all points, which overestimates its effect. lux NAN: the illuminance is only
 * stated. */
enum pp_status pp_rule_year_level(struct pp_finding *finding,
                                  const struct pp_inquiry *inquiry, double lux,
                                  double part, const char *what, struct pp_error *err);

#endif
