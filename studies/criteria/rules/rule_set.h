/* rule_set.h - all rows of one name in the table of rules, assessed together. */
#ifndef PP_STUDIES_CRITERIA_RULES_RULE_SET_H
#define PP_STUDIES_CRITERIA_RULES_RULE_SET_H

#include "studies/criteria/criterion.h"

struct pp_rule_set {
    struct pp_criterion criterion; /* name, title and source are those of the set */
    char title[160];
    const char *country;      /* "": none */
    const char *sky;          /* "overcast" or "uniform"; NULL: no row depends on the
                               * sky */
    double plane_m;           /* height of the working plane; NAN: the room's own */
    const char *point;        /* "file" or "half-depth"; NULL: no row has points */
    bool of_average, of_year; /* true: a row needs the mean daylight factor; a row needs
                               * a year */
    bool of_windows;          /* true: a row needs the vertical daylight factor */
    bool only_year;           /* true: all assessed rows need a year */
    bool of_sda;              /* true: a row needs the points of LM-83 */
    bool is_judged;           /* false: the table only lists these rules */
};

/* Gathers the rows of that name; false if there are none. The criterion refers to the
 * set, which must not move. */
bool pp_rule_set_init(struct pp_rule_set *set, const char *name);

#endif
