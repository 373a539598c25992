/* Sums set out as on paper: what was read or worked out on the left, its value on the
 * right. */
#include "cli/print.h"

#include <math.h>

#include "model/vec.h"

enum { VALUE_WIDTH = 10, UNIT_WIDTH = 4, LINE_MOST = 100 };

/* The value as people write it in its unit, and the unit. */
static const char *write_value(char *text, size_t room, const struct pp_step *step,
                               bool utf8)
{
    double value = step->value + 0.0; /* no minus before a zero */
    switch (step->unit) {
    case PP_UNIT_SHARE:
        snprintf(text, room, "%.3f", 100.0 * value);
        return " %";
    case PP_UNIT_NUMBER:
        snprintf(text, room, "%.4f", value);
        return "";
    case PP_UNIT_COUNT:
        snprintf(text, room, value == rint(value) ? "%.0f" : "%.1f", value);
        return "";
    case PP_UNIT_ANGLE:
        snprintf(text, room, "%.1f", value / PP_RAD);
        return utf8 ? "\xc2\xb0" : " deg";
    case PP_UNIT_METRE:
        snprintf(text, room, "%.2f", value);
        return " m";
    case PP_UNIT_SQUARE_METRE:
        snprintf(text, room, "%.3f", value);
        return utf8 ? " m\xc2\xb2" : " m2";
    case PP_UNIT_LUX:
        snprintf(text, room, "%.1f", value);
        return " lx";
    }
    return "";
}

static void print_step(const struct pp_step *step, int width, bool utf8, FILE *out)
{
    char value[32];
    const char *unit = write_value(value, sizeof value, step, utf8);
    int room = (width < LINE_MOST ? width : LINE_MOST) - 4 - VALUE_WIDTH - UNIT_WIDTH;
    fprintf(out, "    %-*s%*s%s\n", room, step->what, VALUE_WIDTH, value, unit);
}

void pp_print_steps(const struct pp_report *report, int width, bool utf8, FILE *out)
{
    static const char *const names[PP_COMPONENT_COUNT] = {
        [PP_SC] = "direct component",
        [PP_ERC] = "externally reflected component",
        [PP_IRC] = "internally reflected component",
        [PP_DF] = "daylight factor",
    };
    for (int i = 0; i < report->column_count; i++) {
        const struct pp_column *column = &report->columns[i];
        const struct pp_reading *reading = column->points && report->receiver_count > 0
                                               ? column->points
                                               : &column->average;
        if (!reading->steps)
            continue;
        fprintf(out, "\n  %s by %s\n", names[column->component], column->name);
        for (int j = 0; j < reading->steps->count; j++)
            print_step(&reading->steps->list[j], width, utf8, out);
    }
}
