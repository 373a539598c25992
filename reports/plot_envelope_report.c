/* plot_envelope_report.c - see plot_envelope_report.h. */
#include "reports/plot_envelope_report.h"

#include <math.h>

#include "model/base/text.h"
#include "reports/parts/format.h"
#include "reports/parts/json.h"
#include "reports/parts/print.h"
#include "reports/retained_sky_table.h"

static const char *const verdicts[] = {[PP_PLOT_ENVELOPE_FOUND] = "found",
                                       [PP_PLOT_ENVELOPE_ANY] = "any",
                                       [PP_PLOT_ENVELOPE_NONE] = "none"};

static void say_verdict(char *text, size_t size, const struct pp_plot_envelope *found,
                        const struct pp_plot_envelope_task *task)
{
    char name[64], due[80] = "";
    pp_text_excerpt(name, sizeof name, task->block);
    pp_retained_sky_table_say(due, sizeof due, &task->rule);
    pp_text_append(text, size, "On the plot of \"%s\" ", name);
    switch (found->verdict) {
    case PP_PLOT_ENVELOPE_FOUND:
        pp_text_append(text, size,
                       "up to %.1f m3 can be built while every window keeps %s; the "
                       "marked window keeps exactly that.",
                       found->volume_m3, due);
        break;
    case PP_PLOT_ENVELOPE_ANY:
        pp_text_append(text, size,
                       "even with a height of %g m everywhere, every window keeps %s.",
                       task->most_m, due);
        break;
    case PP_PLOT_ENVELOPE_NONE:
        pp_text_append(text, size,
                       "nothing can be built: even with an empty plot, a window keeps "
                       "less than %s.",
                       due);
    }
}

/* Prints the heights arranged like the plan, with the first row at the bottom. */
static void print_plan(const struct pp_plot_cells *cells, FILE *out)
{
    int last = cells->count;
    for (int row = cells->rows - 1; row >= 0; row--) {
        int first = last;
        while (first > 0 && cells->rows_of[first - 1] == row)
            first--;
        int columns = first < last ? cells->columns_of[last - 1] + 1 : 0;
        fputs(" ", out);
        for (int column = 0, c = first; column < columns; column++)
            if (cells->columns_of[c] == column)
                fprintf(out, "%6.1f", cells->list[c++].height_m);
            else
                fprintf(out, "%6s", "");
        fputc('\n', out);
        last = first;
    }
}

static void say_plan(const struct pp_plot_cells *cells, int width, FILE *out)
{
    char text[300] = "";
    const struct pp_building_cell *cell = &cells->list[0];
    double rotate_deg = cell->rotate_rad / PP_RAD;
    pp_text_append(text, sizeof text,
                   "Heights (m) of cells of %.2f m by %.2f m. Rows are parallel to the "
                   "longest side of the plot, %s; the first row is at the bottom.",
                   cell->width_m, cell->depth_m,
                   fabs(rotate_deg) < 0.05 ? "along +x" : "turned with the plot");
    fputs("\n  ", out);
    pp_print_wrapped(text, 2, 2, width, out);
    fputc('\n', out);
}

enum pp_status pp_plot_envelope_report(const struct pp_plot_envelope *found,
                                       const struct pp_plot_envelope_task *task,
                                       int width, FILE *out, struct pp_error *err)
{
    char text[512] = "";
    struct pp_table table;
    say_verdict(text, sizeof text, found, task);
    fputs("\n  ", out);
    pp_print_wrapped(text, 2, 2, width, out);
    if (found->verdict == PP_PLOT_ENVELOPE_FOUND) {
        say_plan(&found->cells, width, out);
        print_plan(&found->cells, out);
    }
    fputc('\n', out);
    pp_table_init(&table, found->retained.count);
    bool good = pp_retained_sky_table_fill(&table, &found->retained, task->rule.of,
                                           found->deciding, found->altitudes_rad);
    if (good)
        pp_table_print(&table, width, out);
    pp_table_clear(&table);
    fputs("\n  ", out);
    pp_print_wrapped(pp_building_has_states(task->building)
                         ? "before: existing site; now: proposal; then: with the "
                           "envelope [BR209]; plane: altitude in degrees of the plane "
                           "that limits the envelope, if one does"
                         : "before: empty plot; now: site as in the file; then: with "
                           "the envelope [BR209]; plane: altitude in degrees of the "
                           "plane that limits the envelope, if one does",
                     2, 2, width, out);
    pp_retained_sky_table_point(&task->rule, width, out);
    return good ? PP_OK : pp_fail_memory(err);
}

enum pp_status pp_plot_envelope_report_csv(const struct pp_plot_envelope *found,
                                           const struct pp_plot_envelope_task *task,
                                           FILE *out, struct pp_error *err)
{
    (void)err;
    fputs("name,x,y,base,width,depth,rotate,height", out);
    for (int i = 0; i < found->cells.count; i++) {
        const struct pp_building_cell *cell = &found->cells.list[i];
        const double numbers[] = {cell->corner.x, cell->corner.y,
                                  cell->corner.z, cell->width_m,
                                  cell->depth_m,  cell->rotate_rad / PP_RAD,
                                  cell->height_m};
        fputs("\r\n", out);
        pp_format_csv_field(task->block, out);
        for (int k = 0; k < 7; k++)
            pp_format_csv_number(numbers[k], out);
    }
    fputs("\r\n", out);
    return PP_OK;
}

static struct json_object *cell_object(const struct pp_building_cell *cell)
{
    struct json_object *object = json_object_new_object();
    bool good = object && pp_json_number(object, "x", cell->corner.x)
                && pp_json_number(object, "y", cell->corner.y)
                && pp_json_number(object, "base", cell->corner.z)
                && pp_json_number(object, "width", cell->width_m)
                && pp_json_number(object, "depth", cell->depth_m)
                && pp_json_number(object, "rotate", cell->rotate_rad / PP_RAD)
                && pp_json_number(object, "height", cell->height_m);
    if (good)
        pp_json_on_one_line(object);
    return pp_json_whole(object, good);
}

enum pp_status pp_plot_envelope_report_json(const struct pp_plot_envelope *found,
                                            const struct pp_plot_envelope_task *task,
                                            FILE *out, struct pp_error *err)
{
    struct json_object *object = json_object_new_object();
    struct json_object *list = json_object_new_array();
    bool good = object && pp_json_text(object, "format", "pepperpot-envelope-1")
                && pp_json_text(object, "block", task->block)
                && pp_json_text(object, "verdict", verdicts[found->verdict])
                && pp_json_number(object, "keep", task->rule.keep)
                && pp_json_number(object, "enough", 100.0 * task->rule.enough)
                && (!(task->rule.french_m > 0.0)
                    || pp_json_number(object, "vsc_point_french", task->rule.french_m))
                && pp_json_number(object, "volume", found->volume_m3)
                && pp_json_number(object, "factor", found->factor)
                && pp_retained_sky_table_json(object, &found->retained, task->rule.of,
                                              found->deciding, found->altitudes_rad);
    if (good)
        good = pp_json_add(object, "cells", list);
    else
        json_object_put(list);
    for (int i = 0; i < found->cells.count && good; i++)
        good = pp_json_append(list, cell_object(&found->cells.list[i]));
    return pp_json_print(out, pp_json_whole(object, good), err);
}
