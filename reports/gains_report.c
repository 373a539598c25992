/* gains_report.c - prints the gains of a room as text and as a JSON object. */
#include "reports/gains_report.h"

#include <math.h>
#include <string.h>

#include "reports/parts/json.h"
#include "reports/parts/print.h"
#include "reports/parts/format.h"

enum { INDENT = 4, FIGURES = 30, SENTENCE = 256 };

/* Prints a daylight factor, "2.38 %", or blanks if there is none. */
static void put_factor(double factor, FILE *out)
{
    if (isfinite(factor))
        fprintf(out, "  %6.2f %%", 100.0 * factor);
    else
        fprintf(out, "  %8s", "");
}

/* Prints a change, wrapped in its column, with the values at the end of the first
 * line. */
static void print_gain(const struct pp_gain *gain, const struct pp_gains *gains,
                       int width, FILE *out)
{
    int columns = width - INDENT - FIGURES, used = 0;
    const char *rest = gain->change;
    bool figures = false;
    fprintf(out, "%*s", INDENT, "");
    while (*rest) {
        char word[64];
        int length = (int)strcspn(rest, " ");
        snprintf(word, sizeof word, "%.*s", length, rest);
        int wide = pp_format_utf8_width(word);
        if (used > 0 && used + 1 + wide > columns) {
            if (!figures)
                break;
            fprintf(out, "\n%*s", INDENT + 2, "");
            used = 2;
        } else if (used > 0 && (used > 2 || !figures)) {
            fputc(' ', out);
            used++;
        }
        pp_format_utf8_put(out, word);
        used += wide;
        rest += length;
        rest += strspn(rest, " ");
    }
    fprintf(out, "%*s", columns - used, "");
    put_factor(gain->values.average, out);
    double gained = gain->values.average / gains->now.average - 1.0;
    if (gained > 0.0)
        fprintf(out, "  %+6.0f %%", 100.0 * gained);
    else
        fprintf(out, "  %8s", "");
    put_factor(gain->values.darkest, out);
    fputc('\n', out);
    if (*rest) {
        fprintf(out, "%*s", INDENT + 2, "");
        pp_print_wrapped(rest, INDENT + 2, INDENT + 2, width - FIGURES, out);
    }
}

static void print_kind(const struct pp_gains *gains, bool of_design, int width,
                       FILE *out)
{
    for (int i = 0; i < gains->count; i++)
        if (gains->list[i].of_design == of_design)
            print_gain(&gains->list[i], gains, width, out);
}

void pp_gains_report(const struct pp_gains *gains, int width, FILE *out)
{
    char sentence[SENTENCE];
    if (!gains->method)
        return;
    int across = width < 100 ? width : 100;
    fputs("\n  Effect of changes to the room\n", out);
    pp_gains_sentence(gains, sentence, sizeof sentence);
    fprintf(out, "%*s", INDENT, "");
    pp_print_wrapped(
        gains->count > 0 ? sentence : "None of the tested changes raises the average.",
        INDENT, INDENT, width, out);
    struct pp_gain now = {.values = gains->now};
    bool simulated = strcmp(gains->method, "traced") == 0;
    snprintf(now.change, sizeof now.change,
             simulated ? "as it is, %s" : "as it is, by %s",
             simulated ? "simulated" : gains->method);
    fprintf(out, "%*s%10s%10s%10s\n", across - FIGURES, "", "average", "gain",
            "darkest");
    print_gain(&now, gains, across, out);
    print_kind(gains, true, across, out);
    print_kind(gains, false, across, out);
    fprintf(out, "%*s", INDENT, "");
    pp_print_wrapped(isnan(gains->now.darkest)
                         ? "Each change is tested alone. There is no darkest point, "
                           "because no point of the EN 17037 grid is in this room."
                     : simulated
                         ? "Each change is tested alone and simulated. The darkest "
                           "point has the lowest value on the EN 17037 grid."
                         : "Each change is tested alone. The darkest point has the "
                           "lowest value on the EN 17037 grid. The method adds the "
                           "room's average reflected light at every point.",
                     INDENT, INDENT, across, out);
}

/* ---- JSON ---- */

static bool add_values(struct json_object *object, const struct pp_gain_values *values)
{
    return pp_json_number(object, "average", 100.0 * values->average)
           && pp_json_number(object, "darkest", 100.0 * values->darkest);
}

static bool add_changes(struct json_object *object, const struct pp_gains *gains)
{
    struct json_object *list = json_object_new_array();
    if (!pp_json_add(object, "changes", list))
        return false;
    for (int i = 0; i < gains->count; i++) {
        const struct pp_gain *gain = &gains->list[i];
        struct json_object *one = json_object_new_object();
        if (!pp_json_append(list, one))
            return false;
        pp_json_on_one_line(one);
        if (!pp_json_text(one, "change", gain->change)
            || !pp_json_text(one, "lacks", gain->lacks)
            || !pp_json_add(one, "of_design", json_object_new_boolean(gain->of_design))
            || !add_values(one, &gain->values))
            return false;
    }
    return true;
}

bool pp_gains_report_json(struct json_object *object, const struct pp_gains *gains)
{
    char sentence[SENTENCE];
    struct json_object *own = json_object_new_object();
    pp_gains_sentence(gains, sentence, sizeof sentence);
    return pp_json_add(object, "gains", own)
           && pp_json_text(own, "method", gains->method) && add_values(own, &gains->now)
           && pp_json_text(own, "holds_back", gains->count > 0 ? sentence : NULL)
           && add_changes(own, gains);
}
