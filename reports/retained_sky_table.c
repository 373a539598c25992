/* retained_sky_table.c - see retained_sky_table.h. */
#include "reports/retained_sky_table.h"

#include <math.h>
#include <stdio.h>

#include "model/base/text.h"
#include "model/geometry/vec.h"
#include "reports/parts/print.h"

void pp_retained_sky_table_say(char *text, size_t size,
                               const struct pp_retained_sky_rule *rule)
{
    bool vsc = rule->of == PP_RETAINED_SKY_VSC;
    pp_text_append(text, size, "%.3g of its %s", rule->keep,
                   vsc ? "vertical sky component" : "lit area");
    if (isfinite(rule->enough))
        pp_text_append(text, size, ", or %.3g %%", 100.0 * rule->enough);
}

/* Factor for printing: 100 for the vertical sky component (per cent), 1 for areas
 * (m2). */
static double unit_of(enum pp_retained_sky_of of)
{
    return of == PP_RETAINED_SKY_VSC ? 100.0 : 1.0;
}

static double ratio_of(const struct pp_retained_sky_place *due)
{
    return due->before > 0.0 ? due->after / due->before : NAN;
}

/* Adds the names of room and window, or, in a table of rooms, only the name of the
 * room. */
static bool fill_names(struct pp_table *table, const struct pp_retained_sky *dues,
                       enum pp_retained_sky_of of)
{
    static const char *const headings[] = {"room", "window"};
    table->key_count = of == PP_RETAINED_SKY_VSC ? 2 : 1;
    for (int c = 0; c < table->key_count; c++) {
        struct pp_table_column *column = pp_table_add(table, NULL, NULL, headings[c]);
        if (!column)
            return false;
        for (int i = 0; i < dues->count; i++)
            pp_text_excerpt(column->cells[i], PP_CELL_BYTES,
                            c ? dues->list[i].label : dues->list[i].room);
        column->is_words = true;
    }
    return true;
}

static bool fill_marks(struct pp_table *table, const char *group, int count,
                       int deciding)
{
    struct pp_table_column *column = pp_table_add(table, group, group, "decides");
    if (!column)
        return false;
    for (int i = 0; i < count; i++)
        snprintf(column->cells[i], PP_CELL_BYTES, "%s", i == deciding ? "*" : "");
    column->is_words = true;
    return true;
}

bool pp_retained_sky_table_fill(struct pp_table *table,
                                const struct pp_retained_sky *dues,
                                enum pp_retained_sky_of of, int deciding,
                                const double *altitudes_rad)
{
    static const char *const headings[] = {"before", "now", "then", "ratio", "plane"};
    const char *group = of == PP_RETAINED_SKY_VSC ? "vertical sky component, %"
                                                  : "area with a view of the sky, m2";
    double unit = unit_of(of);
    bool good = fill_names(table, dues, of);
    for (int c = 0; c < (altitudes_rad ? 5 : 4) && good; c++) {
        struct pp_table_column *column = pp_table_add(table, group, group, headings[c]);
        good = column != NULL;
        for (int i = 0; i < dues->count && good; i++) {
            const struct pp_retained_sky_place *due = &dues->list[i];
            const double values[] = {unit * due->before, unit * due->now,
                                     unit * due->after, ratio_of(due),
                                     altitudes_rad ? altitudes_rad[i] / PP_RAD : NAN};
            static const char *const formats[] = {"%.2f", "%.2f", "%.2f", "%.4f",
                                                  "%.1f"};
            if (isfinite(values[c]))
                snprintf(column->cells[i], PP_CELL_BYTES, formats[c], values[c]);
            else
                snprintf(column->cells[i], PP_CELL_BYTES, "-");
        }
    }
    return good && fill_marks(table, group, dues->count, deciding);
}

static struct json_object *due_object(const struct pp_retained_sky_place *due,
                                      enum pp_retained_sky_of of,
                                      const double *altitude_rad, bool decides)
{
    struct json_object *object = json_object_new_object();
    double unit = unit_of(of);
    bool good = object && pp_json_text(object, "room", due->room);
    if (of == PP_RETAINED_SKY_VSC)
        good = good
               && pp_json_text(object, "window", due->window[0] ? due->window : NULL)
               && pp_json_text(object, "label", due->label)
               && pp_json_add(object, "line", json_object_new_int(due->line));
    good = good && pp_json_number(object, "before", unit * due->before)
           && pp_json_number(object, "now", unit * due->now)
           && pp_json_number(object, "then", unit * due->after)
           && pp_json_number(object, "ratio", ratio_of(due));
    if (altitude_rad)
        good = good && pp_json_number(object, "plane", *altitude_rad / PP_RAD);
    good = good && pp_json_add(object, "decides", json_object_new_boolean(decides));
    if (good)
        pp_json_on_one_line(object);
    return pp_json_whole(object, good);
}

bool pp_retained_sky_table_json(struct json_object *object,
                                const struct pp_retained_sky *dues,
                                enum pp_retained_sky_of of, int deciding,
                                const double *altitudes_rad)
{
    struct json_object *list = json_object_new_array();
    bool good =
        pp_json_add(object, of == PP_RETAINED_SKY_VSC ? "windows" : "rooms", list);
    for (int i = 0; i < dues->count && good; i++)
        good = pp_json_append(list, due_object(&dues->list[i], of,
                                               altitudes_rad ? &altitudes_rad[i] : NULL,
                                               i == deciding));
    return good;
}

void pp_retained_sky_table_point(const struct pp_retained_sky_rule *rule, int width,
                                 FILE *out)
{
    char text[128];
    if (!(rule->french_m > 0.0))
        return;
    snprintf(text, sizeof text,
             "vertical sky component of full-height windows: at %g m above the floor",
             rule->french_m);
    fputs("  ", out);
    pp_print_wrapped(text, 2, 2, width, out);
}
