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

static void say_verdict(char *text, size_t size, const struct pp_block_height *found,
                        const struct pp_block_height_task *task)
{
    char name[64];
    pp_text_excerpt(name, sizeof name, task->block);
    double keep = task->keep;
    switch (found->verdict) {
    case PP_BLOCK_HEIGHT_FOUND:
        pp_text_append(text, size,
                       "\"%s\" is %.2f m high; at up to %.2f m every window keeps %.3g "
                       "of its vertical sky component, and above that the one marked "
                       "keeps less.",
                       name, found->now_m, found->height_m, keep);
        break;
    case PP_BLOCK_HEIGHT_ANY:
        pp_text_append(text, size,
                       "\"%s\" is %.2f m high; even at %g m every window keeps %.3g of "
                       "its vertical sky component.",
                       name, found->now_m, task->most_m, keep);
        break;
    case PP_BLOCK_HEIGHT_NONE:
        pp_text_append(
            text, size,
            "\"%s\" is %.2f m high; without it, too, a window keeps less than "
            "%.3g of its vertical sky component: no height of it changes "
            "that.",
            name, found->now_m, keep);
    }
}

static double ratio_of(const struct pp_block_height_window *window)
{
    return window->before > 0.0 ? window->after / window->before : NAN;
}

static bool fill(struct pp_table *table, const struct pp_block_height *found)
{
    static const char group[] = "vertical sky component, %";
    static const char *const headings[] = {"room", "window", "line",  "before",
                                           "now",  "then",   "ratio", "decides"};
    bool good = true;
    for (int c = 0; c < 8 && good; c++) {
        struct pp_table_column *column = pp_table_add(
            table, c < 3 ? NULL : group, c < 3 ? NULL : group, headings[c]);
        good = column != NULL;
        for (int i = 0; i < found->window_count && good; i++) {
            const struct pp_block_height_window *window = &found->windows[i];
            const double values[] = {100.0 * window->before, 100.0 * window->now,
                                     100.0 * window->after, ratio_of(window)};
            char *cell = column->cells[i];
            if (c < 2)
                pp_text_excerpt(cell, PP_CELL_BYTES, c ? window->window : window->room);
            else if (c == 2)
                snprintf(cell, PP_CELL_BYTES, "%d", window->line);
            else if (c == 7)
                snprintf(cell, PP_CELL_BYTES, "%s", i == found->deciding ? "*" : "");
            else if (isfinite(values[c - 3]))
                snprintf(cell, PP_CELL_BYTES, "%.*f", c == 6 ? 4 : 2, values[c - 3]);
            else
                snprintf(cell, PP_CELL_BYTES, "-");
        }
        if (good)
            column->is_words = c < 2 || c == 7;
    }
    table->key_count = 3;
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
    pp_table_init(&table, found->window_count);
    bool good = fill(&table, found);
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

static struct json_object *window_object(const struct pp_block_height_window *window,
                                         bool decides)
{
    struct json_object *object = json_object_new_object();
    bool good =
        object && pp_json_text(object, "room", window->room)
        && pp_json_text(object, "window", window->window[0] ? window->window : NULL)
        && pp_json_add(object, "line", json_object_new_int(window->line))
        && pp_json_number(object, "before", 100.0 * window->before)
        && pp_json_number(object, "now", 100.0 * window->now)
        && pp_json_number(object, "then", 100.0 * window->after)
        && pp_json_number(object, "ratio", ratio_of(window))
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
    bool good = object && pp_json_text(object, "format", "pepperpot-height-1")
                && pp_json_text(object, "block", task->block)
                && pp_json_text(object, "verdict", verdicts[found->verdict])
                && pp_json_number(object, "keep", task->keep)
                && pp_json_number(object, "now", found->now_m)
                && pp_json_number(object, "height", found->height_m);
    if (good)
        good = pp_json_add(object, "windows", list);
    else
        json_object_put(list);
    for (int i = 0; i < found->window_count && good; i++)
        good = pp_json_append(list,
                              window_object(&found->windows[i], i == found->deciding));
    return pp_json_print(out, pp_json_whole(object, good), err);
}
