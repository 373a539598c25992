/* known_case.c - the list of cases, and their verdicts. */
#include "studies/research/validation/known_case.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/array.h"

struct pp_known_cases pp_known_case_none(void)
{
    return (struct pp_known_cases){.whole = true};
}

void pp_known_case_clear(struct pp_known_cases *cases)
{
    free(cases->list);
    *cases = pp_known_case_none();
}

void pp_known_case_add(struct pp_known_cases *cases, const char *what, const char *by,
                       double answer, double expected, double limit)
{
    if (pp_array_append(&cases->list, cases->count, sizeof *cases->list, NULL)
        != PP_OK) {
        cases->whole = false;
        return;
    }
    struct pp_known_case *one = &cases->list[cases->count++];
    *one = (struct pp_known_case){.by = by,
                                  .answer = answer,
                                  .expected = expected,
                                  .limit = limit,
                                  .least = -limit,
                                  .std_error = NAN,
                                  .assumption = NAN,
                                  .formula = NAN};
    snprintf(one->group, sizeof one->group, "%s", cases->group ? cases->group : by);
    snprintf(one->what, sizeof one->what, "%s", what);
}

/* Half a unit of the last decimal of a value in per cent, as a fraction, with a small
 * tolerance. */
static double rounding(int decimals)
{
    return 0.5001 * pow(10.0, -decimals - 2);
}

void pp_known_case_add_per_cent(struct pp_known_cases *cases, const char *what,
                                const char *by, double answer, double per_cent,
                                int decimals)
{
    pp_known_case_add(cases, what, by, answer, per_cent / 100.0, rounding(decimals));
}

static void add_traced(struct pp_known_cases *cases, const char *what,
                       struct pp_reading reading, double expected, double limit)
{
    int before = cases->count;
    pp_known_case_add(cases, what, "traced", reading.value, expected, limit);
    if (cases->count > before)
        cases->list[before].std_error = reading.std_error;
}

void pp_known_case_add_traced(struct pp_known_cases *cases, const char *what,
                              struct pp_reading reading, double expected,
                              double std_errors)
{
    add_traced(cases, what, reading, expected, std_errors * reading.std_error + 1e-12);
}

void pp_known_case_add_traced_printed(struct pp_known_cases *cases, const char *what,
                                      struct pp_reading reading, double per_cent,
                                      int decimals)
{
    add_traced(cases, what, reading, per_cent / 100.0,
               rounding(decimals) + 4.0 * reading.std_error);
}

bool pp_known_case_is_right(const struct pp_known_case *one)
{
    double difference = one->answer - one->expected;
    return difference >= one->least && difference <= one->limit;
}

bool pp_known_case_is_judged(const struct pp_known_case *one)
{
    return !isnan(one->limit);
}

/* True if an earlier case has the same reason. */
static bool is_repeated(const struct pp_known_cases *cases, int at)
{
    for (int i = 0; i < at; i++)
        if (cases->list[i].why && strcmp(cases->list[i].why, cases->list[at].why) == 0)
            return true;
    return false;
}

const char *pp_known_case_reason(const struct pp_known_cases *cases, int index,
                                 int *count)
{
    const char *why = NULL;
    *count = 0;
    for (int i = 0; i < cases->count; i++) {
        if (!cases->list[i].why)
            continue;
        if (!why && !is_repeated(cases, i) && index-- == 0)
            why = cases->list[i].why;
        *count += why && strcmp(cases->list[i].why, why) == 0;
    }
    return why;
}

bool pp_known_case_has_parts(const struct pp_known_cases *cases)
{
    for (int i = 0; i < cases->count; i++)
        if (isfinite(cases->list[i].assumption))
            return true;
    return false;
}

double pp_known_case_share(const struct pp_known_case *one)
{
    double difference = one->answer - one->expected;
    double middle = (one->least + one->limit) / 2.0;
    double half = (one->limit - one->least) / 2.0;
    if (one->least <= 0.0 && one->limit >= 0.0)
        return difference == 0.0  ? 0.0
               : difference > 0.0 ? difference / one->limit
                                  : difference / -one->least;
    return (difference - middle) / half;
}
