/* validate_known.c - a suite's cases in the order in which they were added. */
#include "reports/validate/validate_known.h"

#include <math.h>
#include <string.h>

#include "reports/parts/format.h"
#include "reports/parts/json.h"
#include "reports/parts/print.h"

/* ---- text ---- */

enum { NAME_WIDTH = 40 };

/* Figures in columns; a longer name has a line of its own before them. */
static void print_case(const struct pp_known_case *one, FILE *out)
{
    bool fits = strlen(one->what) <= NAME_WIDTH;
    if (!fits)
        fprintf(out, "  %s\n", one->what);
    fprintf(out, "  %-*s %8.6f %8.6f %+6.0e %5.0e %s\n", NAME_WIDTH,
            fits ? one->what : "", one->answer, one->expected,
            one->answer - one->expected, one->limit,
            pp_known_case_is_right(one) ? "right" : "WRONG");
}

void pp_validate_known_text(const struct pp_known_result *result, int width, FILE *out)
{
    const struct pp_known_cases *cases = &result->cases;
    const char *group = "";
    fprintf(out, "The program against %s;\nshares of the open sky\n\n",
            result->suite->summary);
    fprintf(out, "  %-*s %8s %8s %6s %5s\n", NAME_WIDTH, "", "answer", "expected",
            "differ", "limit");
    for (int i = 0; i < cases->count; i++) {
        const struct pp_known_case *one = &cases->list[i];
        if (strcmp(group, one->group) != 0)
            fprintf(out, "\n%s\n", one->group);
        group = one->group;
        print_case(one, out);
    }
    struct pp_suite_score score = pp_suite_score(result->suite, cases);
    char text[600];
    snprintf(text, sizeof text, "%d of %d right: %s",
             cases->count - score.wrong - score.traced_wrong, cases->count,
             result->suite->limits);
    fputs("\n  ", out);
    pp_print_wrapped(text, 2, 2, width, out);
}

/* ---- JSON ---- */

static struct json_object *case_object(const struct pp_known_case *one)
{
    struct json_object *object = json_object_new_object();
    bool good = object && pp_json_text(object, "group", one->group)
                && pp_json_text(object, "what", one->what)
                && pp_json_text(object, "by", one->by)
                && pp_json_number(object, "answer", one->answer)
                && pp_json_number(object, "expected", one->expected)
                && pp_json_number(object, "difference", one->answer - one->expected)
                && pp_json_number(object, "tolerance", one->limit);
    if (good && isfinite(one->std_error))
        good = pp_json_number(object, "se", one->std_error);
    if (good)
        good = pp_json_add(object, "right",
                           json_object_new_boolean(pp_known_case_is_right(one)));
    if (good)
        pp_json_on_one_line(object);
    return pp_json_whole(object, good);
}

enum pp_status pp_validate_known_json(const struct pp_known_result *result, FILE *out,
                                      struct pp_error *err)
{
    const struct pp_known_cases *cases = &result->cases;
    struct pp_suite_score score = pp_suite_score(result->suite, cases);
    struct json_object *object = json_object_new_object();
    struct json_object *answers = json_object_new_array();
    bool good = object && pp_json_text(object, "format", "pepperpot-validate-1")
                && pp_json_text(object, "suite", result->suite->name)
                && pp_json_add(object, "passes", json_object_new_boolean(score.passes))
                && pp_json_add(object, "answers", answers);
    for (int i = 0; i < cases->count && good; i++)
        good = pp_json_append(answers, case_object(&cases->list[i]));
    return pp_json_print(out, pp_json_whole(object, good), err);
}

/* ---- CSV ---- */

void pp_validate_known_csv(const struct pp_known_result *result, FILE *out)
{
    fputs("what,by,answer,expected,difference,tolerance,std_error,right,group\r\n",
          out);
    for (int i = 0; i < result->cases.count; i++) {
        const struct pp_known_case *one = &result->cases.list[i];
        const double numbers[] = {one->answer, one->expected,
                                  one->answer - one->expected, one->limit,
                                  one->std_error};
        pp_format_csv_field(one->what, out);
        fprintf(out, ",%s", one->by);
        for (size_t k = 0; k < sizeof numbers / sizeof numbers[0]; k++)
            pp_format_csv_number(numbers[k], out);
        fprintf(out, ",%s,", pp_known_case_is_right(one) ? "yes" : "no");
        pp_format_csv_field(one->group, out);
        fputs("\r\n", out);
    }
}
