/* block_height_report.c - see block_height_report.h. */
#include "reports/block_height_report.h"

#include "model/base/text.h"
#include "reports/parts/json.h"
#include "reports/parts/print.h"
#include "reports/parts/table.h"
#include "reports/retained_sky_table.h"

static const char *const verdicts[] = {[PP_BLOCK_HEIGHT_FOUND] = "found",
                                       [PP_BLOCK_HEIGHT_ANY] = "any",
                                       [PP_BLOCK_HEIGHT_NONE] = "none"};

static void say_verdict(char *text, size_t size, const struct pp_block_height *found,
                        const struct pp_block_height_task *task)
{
    char name[64], due[80] = "";
    const char *who = task->rule.of == PP_RETAINED_SKY_VSC ? "window" : "room";
    pp_text_excerpt(name, sizeof name, task->block);
    pp_retained_sky_table_say(due, sizeof due, &task->rule);
    pp_text_append(text, size, "\"%s\" is %.2f m high; ", name, found->now_m);
    switch (found->verdict) {
    case PP_BLOCK_HEIGHT_FOUND:
        pp_text_append(text, size,
                       "up to a height of %.2f m, every %s keeps %s; above that "
                       "height, the marked one keeps less.",
                       found->height_m, who, due);
        break;
    case PP_BLOCK_HEIGHT_ANY:
        pp_text_append(text, size, "even at a height of %g m, every %s keeps %s.",
                       task->most_m, who, due);
        break;
    case PP_BLOCK_HEIGHT_NONE:
        pp_text_append(text, size,
                       "even without the block, a %s keeps less than %s, so no height "
                       "meets the criterion.",
                       who, due);
    }
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
    pp_table_init(&table, found->retained.count);
    bool good = pp_retained_sky_table_fill(&table, &found->retained, task->rule.of,
                                           found->deciding, NULL);
    if (good)
        pp_table_print(&table, width, out);
    pp_table_clear(&table);
    fputs("\n  ", out);
    pp_print_wrapped(pp_building_has_states(task->building)
                         ? "before: existing site; now: proposal; then: with the block "
                           "at the calculated height [BR209]"
                         : "before: site without the block; now: site as in the file; "
                           "then: with the block at the calculated height [BR209]",
                     2, 2, width, out);
    pp_retained_sky_table_point(&task->rule, width, out);
    return good ? PP_OK : pp_fail_memory(err);
}

enum pp_status pp_block_height_report_json(const struct pp_block_height *found,
                                           const struct pp_block_height_task *task,
                                           FILE *out, struct pp_error *err)
{
    struct json_object *object = json_object_new_object();
    bool good = object && pp_json_text(object, "format", "pepperpot-height-1")
                && pp_json_text(object, "block", task->block)
                && pp_json_text(object, "of", pp_retained_sky_words[task->rule.of])
                && pp_json_text(object, "verdict", verdicts[found->verdict])
                && pp_json_number(object, "keep", task->rule.keep)
                && pp_json_number(object, "enough", 100.0 * task->rule.enough)
                && (!(task->rule.french_m > 0.0)
                    || pp_json_number(object, "vsc_point_french", task->rule.french_m))
                && pp_json_number(object, "now", found->now_m)
                && pp_json_number(object, "height", found->height_m)
                && pp_retained_sky_table_json(object, &found->retained, task->rule.of,
                                              found->deciding, NULL);
    return pp_json_print(out, pp_json_whole(object, good), err);
}
