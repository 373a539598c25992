/* rules_list.c - see rules_list.h. */
#include "reports/assess/rules_list.h"

#include <math.h>
#include <string.h>

#include "model/base/text.h"
#include "reports/parts/format.h"
#include "reports/parts/json.h"
#include "reports/parts/print.h"
#include "studies/criteria/rules/rule_set.h"
#include "studies/criteria/rules/rule_table.h"

enum { NAME_WIDTH = 26, ROW_INDENT = 4, NOTE_INDENT = 6 };

static const char *state_of(const struct pp_rule *rule)
{
    bool only_stated = strcmp(rule->quantity, "share-df") == 0 && isnan(rule->share);
    return pp_rule_table_is_judged(rule)          ? only_stated ? "stated" : "judged"
           : strcmp(rule->quantity, "other") == 0 ? "not calculated"
                                                  : "not established";
}

/* Text of a cell in the table of rules; NULL if the cell is empty. */
static const char *text_of(const char *text)
{
    return pp_rule_table_has(text) ? text : NULL;
}

static void put_row(const struct pp_rule *rule, int width, FILE *out)
{
    char words[PP_RULE_WORDS], bound[PP_RULE_WORDS], line[640] = "";
    pp_rule_table_words(words, rule);
    pp_rule_table_bound(bound, rule);
    pp_text_append(line, sizeof line, "%s%s%s", words, bound[0] ? " " : "", bound);
    if (strcmp(rule->use, "any") != 0)
        pp_text_append(line, sizeof line, "; rooms: %s", rule->use);
    if (strcmp(rule->openings, "any") != 0)
        pp_text_append(line, sizeof line, "; %s", rule->openings);
    if (strncmp(rule->kind, "or", 2) == 0)
        pp_text_append(line, sizeof line, "; alternative %s", rule->kind + 2);
    if (strcmp(rule->kind, "level") == 0)
        pp_text_append(line, sizeof line, "; higher level");
    fprintf(out, "%*s", ROW_INDENT, "");
    pp_print_wrapped(line, ROW_INDENT, NOTE_INDENT, width, out);
    snprintf(line, sizeof line, "%s; %s: %s%s%s", state_of(rule), rule->certainty,
             rule->source, pp_rule_table_has(rule->note) ? "; " : "",
             pp_rule_table_has(rule->note) ? rule->note : "");
    fprintf(out, "%*s", NOTE_INDENT, "");
    pp_print_wrapped(line, NOTE_INDENT, NOTE_INDENT, width, out);
}

/* True if assess --for accepts the rules of this name. */
static bool has_verdict(const char *name)
{
    struct pp_rule_set set;
    return pp_rule_set_init(&set, name) && set.is_judged;
}

void pp_rules_list_text(int width, FILE *out)
{
    const char *last = "";
    const struct pp_rule *rule;
    for (int i = 0; (rule = pp_rule_table_at(i)) != NULL; i++) {
        if (strcmp(rule->name, last) != 0) {
            char title[PP_RULE_WORDS + 32];
            snprintf(title, sizeof title, "%s%s%s, %s%s",
                     pp_rule_table_has(rule->country) ? rule->country : "",
                     pp_rule_table_has(rule->country) ? ": " : "", rule->scheme,
                     rule->edition,
                     has_verdict(rule->name) ? "" : " (listed only: no verdict)");
            fprintf(out, "%s%-*s  ", i > 0 ? "\n" : "", NAME_WIDTH, rule->name);
            pp_print_wrapped(title, NAME_WIDTH + 2, NAME_WIDTH + 2, width, out);
        }
        last = rule->name;
        put_row(rule, width, out);
    }
}

void pp_rules_list_csv(FILE *out)
{
    const struct pp_rule *rule;
    fputs(
        "name,country,scheme,edition,use,kind,openings,quantity,bound,threshold,share,"
        "lux,sky,plane_m,point,from,to,altitude_deg,certainty,state,source,note,"
        "above_m,sill_m,from_h,to_h,plan_angle_deg,obstruction_deg,breaks\r\n",
        out);
    for (int i = 0; (rule = pp_rule_table_at(i)) != NULL; i++) {
        const char *const before[] = {rule->name,     rule->country,  rule->scheme,
                                      rule->edition,  rule->use,      rule->kind,
                                      rule->openings, rule->quantity, rule->bound};
        const char *const after[] = {rule->point, rule->from, rule->to};
        const char *const last[] = {rule->certainty, state_of(rule), rule->source,
                                    rule->note};
        for (size_t k = 0; k < sizeof before / sizeof *before; k++) {
            fputs(k > 0 ? "," : "", out);
            pp_format_csv_field(text_of(before[k]), out);
        }
        pp_format_csv_number(rule->threshold, out);
        pp_format_csv_number(rule->share, out);
        pp_format_csv_number(rule->lux, out);
        fputc(',', out);
        pp_format_csv_field(text_of(rule->sky), out);
        pp_format_csv_number(rule->plane_m, out);
        for (size_t k = 0; k < sizeof after / sizeof *after; k++) {
            fputc(',', out);
            pp_format_csv_field(text_of(after[k]), out);
        }
        pp_format_csv_number(rule->altitude_deg, out);
        for (size_t k = 0; k < sizeof last / sizeof *last; k++) {
            fputc(',', out);
            pp_format_csv_field(text_of(last[k]), out);
        }
        pp_format_csv_number(rule->above_m, out);
        pp_format_csv_number(rule->sill_m, out);
        pp_format_csv_number(rule->from_h, out);
        pp_format_csv_number(rule->to_h, out);
        pp_format_csv_number(rule->plan_angle_deg, out);
        pp_format_csv_number(rule->obstruction_deg, out);
        pp_format_csv_number(rule->breaks, out);
        fputs("\r\n", out);
    }
}

static struct json_object *row_object(const struct pp_rule *rule)
{
    char words[PP_RULE_WORDS];
    pp_rule_table_words(words, rule);
    struct json_object *object = json_object_new_object();
    bool good = object && pp_json_text(object, "name", rule->name)
                && pp_json_text(object, "country", text_of(rule->country))
                && pp_json_text(object, "scheme", rule->scheme)
                && pp_json_text(object, "edition", rule->edition)
                && pp_json_text(object, "use", rule->use)
                && pp_json_text(object, "kind", rule->kind)
                && pp_json_text(object, "quantity", rule->quantity)
                && pp_json_text(object, "words", words)
                && pp_json_text(object, "bound", rule->bound)
                && pp_json_number(object, "threshold", rule->threshold)
                && pp_json_number(object, "share", rule->share)
                && pp_json_number(object, "lux", rule->lux)
                && pp_json_text(object, "sky", text_of(rule->sky))
                && pp_json_number(object, "plane_m", rule->plane_m)
                && pp_json_text(object, "openings", rule->openings)
                && pp_json_text(object, "point", text_of(rule->point))
                && pp_json_text(object, "from", text_of(rule->from))
                && pp_json_text(object, "to", text_of(rule->to))
                && pp_json_number(object, "above_m", rule->above_m)
                && pp_json_number(object, "sill_m", rule->sill_m)
                && pp_json_number(object, "from_h", rule->from_h)
                && pp_json_number(object, "to_h", rule->to_h)
                && pp_json_number(object, "altitude_deg", rule->altitude_deg)
                && pp_json_number(object, "plan_angle_deg", rule->plan_angle_deg)
                && pp_json_number(object, "obstruction_deg", rule->obstruction_deg)
                && pp_json_number(object, "breaks", rule->breaks)
                && pp_json_text(object, "certainty", rule->certainty)
                && pp_json_text(object, "state", state_of(rule))
                && pp_json_text(object, "source", rule->source)
                && pp_json_text(object, "note", text_of(rule->note));
    return pp_json_whole(object, good);
}

enum pp_status pp_rules_list_json(FILE *out, struct pp_error *err)
{
    const struct pp_rule *rule;
    struct json_object *object = json_object_new_object();
    struct json_object *list = json_object_new_array();
    bool good = pp_json_text(object, "format", "pepperpot-rules-1")
                && pp_json_add(object, "rules", list);
    for (int i = 0; good && (rule = pp_rule_table_at(i)) != NULL; i++)
        good = pp_json_append(list, row_object(rule));
    return pp_json_print(out, pp_json_whole(object, good), err);
}
