/* validate_parts.c - prints the two parts of each difference as tables, JSON members
 * and CSV fields. */
#include "reports/validate/validate_parts.h"

#include <math.h>

#include "reports/parts/format.h"

enum { NAME_WIDTH = 20 };

const char pp_validate_parts_note[] =
    "Causes of differences. assumption: difference between the room and the room that "
    "the method assumes, both simulated. formula: difference between that assumed "
    "room and the method. Assumption and formula add up to off for the average, and "
    "to bias at the points. noise: standard error of assumption. In the assumed room "
    "the ground is open and as bright as the method assumes. An endless skyline "
    "replaces all obstructions, unless the method is for the direct component alone.";

/* ---- text ---- */

/* Prints the headings of two groups of columns. */
static void print_heads(const char *title, const char *average, const char *bias,
                        int noise_width, FILE *out)
{
    int width = 22 + noise_width;
    const char *noise = noise_width > 0 ? "noise" : "";
    fprintf(out, "\n  %-*s%*s%*s\n  %*s", NAME_WIDTH + 2, title, width, average, width,
            bias, NAME_WIDTH + 2, "");
    for (int i = 0; i < 2; i++)
        fprintf(out, "%13s%9s%*s", "assumption", "formula", noise_width, noise);
    fputc('\n', out);
}

static void print_parts(const struct pp_error_parts *parts, double scale,
                        const char *format, FILE *out)
{
    pp_format_cell(scale * parts->assumption, format, 13, out);
    pp_format_cell(scale * parts->formula, format, 9, out);
    pp_format_cell(scale * parts->assumption_error, "%.2f", 6, out);
}

static bool is_shown(const struct pp_comparison *one, enum pp_component component)
{
    return one->component == component && !one->why;
}

static void print_component(const struct pp_comparison *list, int count,
                            enum pp_component component, FILE *out)
{
    fprintf(out, "\n  %s\n", pp_component_titles[component]);
    for (int i = 0; i < count; i++) {
        const struct pp_comparison *one = &list[i];
        if (!is_shown(one, component))
            continue;
        fprintf(out, "    %-*s", NAME_WIDTH, one->name);
        print_parts(&one->of_average, 100.0 / one->traced_average, "%+.1f", out);
        if (one->points > 0)
            print_parts(&one->of_bias, 100.0, "%+.2f", out);
        fputc('\n', out);
    }
}

bool pp_validate_parts_print(const struct pp_comparison *list, int count, FILE *out)
{
    bool begun = false;
    for (int component = PP_SC; component < PP_COMPONENT_COUNT; component++) {
        bool elsewhere = false, something = false;
        for (int i = 0; i < count; i++) {
            bool shown = is_shown(&list[i], component);
            elsewhere |= shown && list[i].own_world;
            something |=
                shown && (list[i].traced_average > 0.0 || list[i].traced > 0.0);
        }
        if (!elsewhere || !something)
            continue;
        if (!begun)
            print_heads("causes", "of off, %", "of bias", 6, out);
        begun = true;
        print_component(list, count, component, out);
    }
    return begun;
}

static void print_component_of_all(const struct pp_overall *list, int count,
                                   enum pp_component component, FILE *out)
{
    fprintf(out, "\n  %s\n", pp_component_titles[component]);
    for (int i = 0; i < count; i++) {
        const struct pp_overall *one = &list[i];
        if (one->component != component || (one->averages == 0 && one->points == 0))
            continue;
        const double parts[] = {one->averages ? one->average_assumption : NAN,
                                one->averages ? one->average_formula : NAN,
                                one->points ? one->assumption : NAN,
                                one->points ? one->formula : NAN};
        fprintf(out, "    %-*s", NAME_WIDTH, one->name);
        for (int k = 0; k < 4; k++)
            pp_format_cell(100.0 * parts[k], "%+.1f", k % 2 ? 9 : 13, out);
        fputc('\n', out);
    }
}

void pp_validate_parts_print_all(const struct pp_overall *list, int count, FILE *out)
{
    bool begun = false;
    for (int component = PP_SC; component < PP_COMPONENT_COUNT; component++) {
        bool elsewhere = false;
        for (int i = 0; i < count; i++)
            elsewhere |= (int)list[i].component == component && list[i].own_world;
        if (!elsewhere)
            continue;
        if (!begun)
            print_heads("Causes", "of the average", "at the points", 0, out);
        begun = true;
        print_component_of_all(list, count, component, out);
    }
}

/* ---- JSON and CSV ---- */

/* Adds the known parts. begin: start of the keys, "average-" or "", as in
 * "average-assumption". */
static bool add_parts(struct json_object *object, const char *begin,
                      const struct pp_error_parts *parts)
{
    const struct {
        const char *name;
        double value;
    } list[] = {{"assumption", parts->assumption},
                {"assumption-se", parts->assumption_error},
                {"formula", parts->formula},
                {"formula-se", parts->formula_error}};
    bool good = true;
    for (size_t i = 0; i < sizeof list / sizeof list[0] && good; i++) {
        char key[40];
        snprintf(key, sizeof key, "%s%s", begin, list[i].name);
        if (isfinite(list[i].value))
            good = pp_json_number(object, key, 100.0 * list[i].value);
    }
    return good;
}

/* Returns parts without standard errors, which are not calculated over several
 * rooms. */
static struct pp_error_parts without_errors(double assumption, double formula)
{
    return (struct pp_error_parts){assumption, NAN, formula, NAN};
}

bool pp_validate_parts_json(struct json_object *object, const struct pp_comparison *one)
{
    bool good = true;
    if (isfinite(one->average))
        good = add_parts(object, "average-", &one->of_average);
    if (one->points > 0)
        good = good && add_parts(object, "", &one->of_bias);
    return good;
}

bool pp_validate_parts_json_all(struct json_object *object,
                                const struct pp_overall *one)
{
    struct pp_error_parts average =
        without_errors(one->average_assumption, one->average_formula);
    struct pp_error_parts bias = without_errors(one->assumption, one->formula);
    bool good = true;
    if (one->averages > 0)
        good = add_parts(object, "average-", &average);
    if (one->points > 0)
        good = good && add_parts(object, "", &bias);
    return good;
}

const char pp_validate_parts_csv_names[] =
    ",assumption_percent,assumption_se_percent,formula_percent,formula_se_percent,"
    "average_assumption_percent,average_assumption_se_percent,average_formula_percent,"
    "average_formula_se_percent";

static void put_fields(const struct pp_error_parts *parts, bool any, FILE *out)
{
    const double fields[] = {parts->assumption, parts->assumption_error, parts->formula,
                             parts->formula_error};
    for (size_t i = 0; i < sizeof fields / sizeof fields[0]; i++)
        pp_format_csv_number(any ? 100.0 * fields[i] : NAN, out);
}

void pp_validate_parts_csv(const struct pp_comparison *one, FILE *out)
{
    put_fields(&one->of_bias, one->points > 0, out);
    put_fields(&one->of_average, isfinite(one->average), out);
}
