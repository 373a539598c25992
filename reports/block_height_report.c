/* block_height_report.c - see block_height_report.h. */
#include "reports/block_height_report.h"

#include <math.h>

#include "model/base/text.h"
#include "reports/parts/format.h"
#include "reports/parts/json.h"
#include "reports/parts/print.h"
#include "reports/parts/table.h"

static const char *const verdicts[] = {[PP_BLOCK_HEIGHT_FOUND] = "found",
                                       [PP_BLOCK_HEIGHT_ANY] = "any",
                                       [PP_BLOCK_HEIGHT_NONE] = "none"};

/* "0.8 of its vertical sky component, or 27 %" */
static void say_due(char *text, size_t size, const struct pp_sky_dues_rule *rule)
{
    bool vsc = rule->of == PP_SKY_DUES_VSC;
    pp_text_append(text, size, "%.3g of its %s", rule->keep,
                   vsc ? "vertical sky component" : "lit area");
    if (isfinite(rule->enough))
        pp_text_append(text, size, ", or %.3g %%", 100.0 * rule->enough);
}

static void say_verdict(char *text, size_t size, const struct pp_block_height *found,
                        const struct pp_block_height_task *task)
{
    char name[64], due[80] = "";
    const char *who = task->rule.of == PP_SKY_DUES_VSC ? "window" : "room";
    pp_text_excerpt(name, sizeof name, task->block);
    say_due(due, sizeof due, &task->rule);
    pp_text_append(text, size, "\"%s\" is %.2f m high; ", name, found->now_m);
    switch (found->verdict) {
    case PP_BLOCK_HEIGHT_FOUND:
        pp_text_append(text, size,
                       "at up to %.2f m every %s keeps %s, and above that the one "
                       "marked keeps less.",
                       found->height_m, who, due);
        break;
    case PP_BLOCK_HEIGHT_ANY:
        pp_text_append(text, size, "even at %g m every %s keeps %s.", task->most_m, who,
                       due);
        break;
    case PP_BLOCK_HEIGHT_NONE:
        pp_text_append(text, size,
                       "without it, too, a %s keeps less than %s: no height of it "
                       "changes that.",
                       who, due);
    }
}

static double ratio_of(const struct pp_sky_due *due)
{
    return due->before > 0.0 ? due->after / due->before : NAN;
}

/* Room, window and line; of rooms, the room alone. */
static bool fill_names(struct pp_table *table, const struct pp_sky_dues *dues, bool vsc)
{
    static const char *const headings[] = {"room", "window", "line"};
    table->key_count = vsc ? 3 : 1;
    for (int c = 0; c < table->key_count; c++) {
        struct pp_table_column *column = pp_table_add(table, NULL, NULL, headings[c]);
        if (!column)
            return false;
        for (int i = 0; i < dues->count; i++)
            if (c == 2)
                snprintf(column->cells[i], PP_CELL_BYTES, "%d", dues->list[i].line);
            else
                pp_text_excerpt(column->cells[i], PP_CELL_BYTES,
                                c ? dues->list[i].window : dues->list[i].room);
        column->is_words = c < 2;
    }
    return true;
}

static bool fill(struct pp_table *table, const struct pp_block_height *found, bool vsc)
{
    static const char *const headings[] = {"before", "now", "then", "ratio", "decides"};
    const char *group = vsc ? "vertical sky component, %" : "area that sees sky, m2";
    double unit = vsc ? 100.0 : 1.0;
    bool good = fill_names(table, &found->dues, vsc);
    for (int c = 0; c < 5 && good; c++) {
        struct pp_table_column *column = pp_table_add(table, group, group, headings[c]);
        good = column != NULL;
        for (int i = 0; i < found->dues.count && good; i++) {
            const struct pp_sky_due *due = &found->dues.list[i];
            const double values[] = {unit * due->before, unit * due->now,
                                     unit * due->after, ratio_of(due)};
            char *cell = column->cells[i];
            if (c == 4)
                snprintf(cell, PP_CELL_BYTES, "%s", i == found->deciding ? "*" : "");
            else if (isfinite(values[c]))
                snprintf(cell, PP_CELL_BYTES, "%.*f", c == 3 ? 4 : 2, values[c]);
            else
                snprintf(cell, PP_CELL_BYTES, "-");
        }
        if (good)
            column->is_words = c == 4;
    }
    return good;
}

enum pp_status pp_block_height_report(const struct pp_block_height *found,
                                      const struct pp_block_height_task *task,
                                      int width, FILE *out, struct pp_error *err)
{
    char text[512] = "";
    struct pp_table table;
    say_verdict(text, sizeof text, found, task);
    fputs("\n  ", out);
    pp_print_wrapped(text, 2, 2, width, out);
    fputc('\n', out);
    pp_table_init(&table, found->dues.count);
    bool good = fill(&table, found, task->rule.of == PP_SKY_DUES_VSC);
    if (good)
        pp_table_print(&table, width, out);
    pp_table_clear(&table);
    fputs("\n  ", out);
    pp_print_wrapped(
        pp_building_has_states(task->building)
            ? "before: the site as existing; now: as proposed; then: with "
              "the block at the height found [BR209]"
            : "before: the site without the block; now: as the file has it; "
              "then: with the block at the height found [BR209]",
        2, 2, width, out);
    return good ? PP_OK : pp_fail_memory(err);
}

static struct json_object *due_object(const struct pp_sky_due *due, bool vsc,
                                      bool decides)
{
    struct json_object *object = json_object_new_object();
    double unit = vsc ? 100.0 : 1.0;
    bool good = object && pp_json_text(object, "room", due->room);
    if (vsc)
        good = good
               && pp_json_text(object, "window", due->window[0] ? due->window : NULL)
               && pp_json_add(object, "line", json_object_new_int(due->line));
    good = good && pp_json_number(object, "before", unit * due->before)
           && pp_json_number(object, "now", unit * due->now)
           && pp_json_number(object, "then", unit * due->after)
           && pp_json_number(object, "ratio", ratio_of(due))
           && pp_json_add(object, "decides", json_object_new_boolean(decides));
    if (good)
        pp_json_on_one_line(object);
    return pp_json_whole(object, good);
}

enum pp_status pp_block_height_report_json(const struct pp_block_height *found,
                                           const struct pp_block_height_task *task,
                                           FILE *out, struct pp_error *err)
{
    struct json_object *object = json_object_new_object();
    struct json_object *list = json_object_new_array();
    bool vsc = task->rule.of == PP_SKY_DUES_VSC;
    bool good = object && pp_json_text(object, "format", "pepperpot-height-1")
                && pp_json_text(object, "block", task->block)
                && pp_json_text(object, "of", pp_sky_dues_words[task->rule.of])
                && pp_json_text(object, "verdict", verdicts[found->verdict])
                && pp_json_number(object, "keep", task->rule.keep)
                && pp_json_number(object, "enough", 100.0 * task->rule.enough)
                && pp_json_number(object, "now", found->now_m)
                && pp_json_number(object, "height", found->height_m);
    if (good)
        good = pp_json_add(object, vsc ? "windows" : "rooms", list);
    else
        json_object_put(list);
    for (int i = 0; i < found->dues.count && good; i++)
        good = pp_json_append(
            list, due_object(&found->dues.list[i], vsc, i == found->deciding));
    return pp_json_print(out, pp_json_whole(object, good), err);
}
