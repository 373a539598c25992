/* validate_known.c - prints the cases of a suite in the order in which they were
 * added. */
#include "reports/validate/validate_known.h"

#include <math.h>
#include <string.h>

#include "reports/parts/format.h"
#include "reports/parts/json.h"
#include "reports/parts/print.h"

/* ---- text ---- */

enum { NAME_WIDTH = 40 };

/* Prints a case: its name and figures in columns, or the name on a separate line if it
 * is too long. */
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

enum { PLACE_WIDTH = 20 };

/* Prints the difference between a method and the simulation in a room, in per cent,
 * with the permitted differences and the parts of the difference. */
static void print_parts(const struct pp_known_case *one, FILE *out)
{
    bool judged = pp_known_case_is_judged(one);
    fprintf(out, "  %-*s%7.3f%7.3f%+8.3f", PLACE_WIDTH, one->what, 100.0 * one->answer,
            100.0 * one->expected, 100.0 * (one->answer - one->expected));
    if (judged)
        fprintf(out, "%+8.3f%+8.3f", 100.0 * one->least, 100.0 * one->limit);
    else
        fprintf(out, "%8s%8s", "-", "-");
    fprintf(out, "%+7.2f%+7.2f %s\n", 100.0 * one->assumption, 100.0 * one->formula,
            !judged                       ? "-"
            : pp_known_case_is_right(one) ? "right"
                                          : "WRONG");
}

static void print_head(const struct pp_known_result *result, bool parts, FILE *out)
{
    fprintf(out, "%s%s;\n%s\n\n",
            result->suite->of_rooms ? "" : "Comparison of the program with ",
            result->suite->summary,
            parts ? "per cent of the open sky" : "shares of the open sky");
    if (parts)
        fprintf(out, "  %-*s%7s%7s%8s%8s%8s%7s%7s\n", PLACE_WIDTH, "", "answer",
                "traced", "differ", "from", "to", "assum.", "form.");
    else
        fprintf(out, "  %-*s %8s %8s %6s %5s\n", NAME_WIDTH, "", "answer", "expected",
                "differ", "limit");
}

/* Prints the name and file of the room if the previous case had a different room. */
static void print_known_room(const struct pp_known_case *one, const char **file,
                             const char **room, FILE *out)
{
    if (!one->file || (one->file == *file && one->room == *room))
        return;
    *file = one->file;
    *room = one->room;
    fputc('\n', out);
    if (one->room && *one->room) {
        pp_format_utf8_put(out, one->room);
        fputs(", ", out);
    }
    pp_format_utf8_put(out, one->file);
    fputc('\n', out);
}

static void print_reasons(const struct pp_known_cases *cases, int width, FILE *out)
{
    const char *why;
    int count;
    for (int i = 0; (why = pp_known_case_reason(cases, i, &count)); i++) {
        char text[600];
        snprintf(text, sizeof text, "%d without a verdict: %s", count, why);
        fputs("  ", out);
        pp_print_wrapped(text, 2, 2, width, out);
    }
}

void pp_validate_known_text(const struct pp_known_result *result, int width, FILE *out)
{
    const struct pp_known_cases *cases = &result->cases;
    const char *group = "", *file = NULL, *room = NULL;
    bool parts = pp_known_case_has_parts(cases);
    print_head(result, parts, out);
    for (int i = 0; i < cases->count; i++) {
        const struct pp_known_case *one = &cases->list[i];
        print_known_room(one, &file, &room, out);
        bool is_room = one->file && strcmp(one->by, "traced") == 0;
        if (strcmp(group, one->group) != 0 && !is_room) {
            fputc('\n', out);
            pp_format_utf8_put(out, one->group);
            fputc('\n', out);
        }
        group = one->group;
        if (parts)
            print_parts(one, out);
        else
            print_case(one, out);
    }
    struct pp_suite_score score = pp_suite_score(result->suite, cases);
    char text[600];
    snprintf(text, sizeof text, "%d of %d right: %s",
             score.count + score.traced - score.wrong - score.traced_wrong,
             score.count + score.traced, result->suite->limits);
    fputs("\n  ", out);
    pp_print_wrapped(text, 2, 2, width, out);
    print_reasons(cases, width, out);
}

/* ---- JSON ---- */

/* Adds further members for cases in a user's rooms. */
static bool add_of_room(struct json_object *object, const struct pp_known_case *one)
{
    bool good = pp_json_text(object, "file", one->file)
                && (!one->room || pp_json_text(object, "room", one->room));
    if (good && pp_known_case_is_judged(one))
        good = pp_json_number(object, "tolerance-below", one->least);
    if (good && isfinite(one->assumption))
        good = pp_json_number(object, "assumption", one->assumption)
               && pp_json_number(object, "formula", one->formula);
    return good && (!one->why || pp_json_text(object, "why", one->why));
}

static struct json_object *case_object(const struct pp_known_case *one)
{
    struct json_object *object = json_object_new_object();
    bool good = object && pp_json_text(object, "group", one->group)
                && pp_json_text(object, "what", one->what)
                && pp_json_text(object, "by", one->by)
                && pp_json_number(object, "answer", one->answer)
                && pp_json_number(object, "expected", one->expected)
                && pp_json_number(object, "difference", one->answer - one->expected);
    if (good && pp_known_case_is_judged(one))
        good = pp_json_number(object, "tolerance", one->limit);
    if (good && isfinite(one->std_error))
        good = pp_json_number(object, "se", one->std_error);
    if (good && pp_known_case_is_judged(one))
        good = pp_json_add(object, "right",
                           json_object_new_boolean(pp_known_case_is_right(one)));
    if (good && one->file)
        good = add_of_room(object, one);
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

/* Writes further columns for cases in a user's rooms. */
static void put_csv_of_room(const struct pp_known_case *one, FILE *out)
{
    const double numbers[] = {pp_known_case_is_judged(one) ? one->least : NAN,
                              one->assumption, one->formula};
    fputc(',', out);
    pp_format_csv_field(one->file, out);
    fputc(',', out);
    pp_format_csv_field(one->room ? one->room : "", out);
    for (size_t k = 0; k < sizeof numbers / sizeof numbers[0]; k++)
        pp_format_csv_number(numbers[k], out);
    fputc(',', out);
    pp_format_csv_field(one->why ? one->why : "", out);
}

void pp_validate_known_csv(const struct pp_known_result *result, FILE *out)
{
    bool of_rooms = result->suite->of_rooms;
    fprintf(out,
            "what,by,answer,expected,difference,tolerance,std_error,right,group%s\r\n",
            of_rooms ? ",file,room,tolerance_below,assumption,formula,why" : "");
    for (int i = 0; i < result->cases.count; i++) {
        const struct pp_known_case *one = &result->cases.list[i];
        const double numbers[] = {one->answer, one->expected,
                                  one->answer - one->expected, one->limit,
                                  one->std_error};
        pp_format_csv_field(one->what, out);
        fprintf(out, ",%s", one->by);
        for (size_t k = 0; k < sizeof numbers / sizeof numbers[0]; k++)
            pp_format_csv_number(numbers[k], out);
        fprintf(out, ",%s,",
                !pp_known_case_is_judged(one) ? ""
                : pp_known_case_is_right(one) ? "yes"
                                              : "no");
        pp_format_csv_field(one->group, out);
        if (of_rooms)
            put_csv_of_room(one, out);
        fputs("\r\n", out);
    }
}
