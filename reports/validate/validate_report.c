/* validate_report.c - prints comparisons of rooms as text, JSON and CSV. */
#include "reports/validate/validate_report.h"

#include <math.h>
#include <string.h>

#include "reports/df_result.h"
#include "reports/validate/validate_parts.h"
#include "reports/parts/print.h"
#include "reports/parts/format.h"
#include "reports/parts/json.h"

/* ---- text for each room ---- */

enum { NAME_WIDTH = 20 };

/* Writes the position of a point, "1.50, 8.50", and its height if the point is not on
 * the working plane. */
static void write_place(char text[64], const struct pp_report *report, int point)
{
    struct pp_vec3 at = report->receivers[point].position;
    if (fabs(at.z - report->world->working_plane_m) < 1e-9)
        snprintf(text, 64, "%.2f, %.2f", at.x, at.y);
    else
        snprintf(text, 64, "%.2f, %.2f, %.2f", at.x, at.y, at.z);
}

static void print_comparison(const struct pp_comparison *one,
                             const struct pp_report *report, FILE *out)
{
    fprintf(out, "    %-*s", NAME_WIDTH, one->name);
    pp_format_cell(100.0 * one->average, "%.2f", 8, out);
    pp_format_cell(100.0 * (one->average / one->traced_average - 1.0), "%+.1f", 8, out);
    if (one->points > 0) {
        char place[64];
        write_place(place, report, one->worst_point);
        pp_format_cell(100.0 * one->bias, "%+.2f", 7, out);
        pp_format_cell(100.0 * one->spread, "%.2f", 8, out);
        pp_format_cell(100.0 * one->worst, "%+.2f", 8, out);
        fprintf(out, "  %s", place);
        if (one->points < report->receiver_count)
            fprintf(out, " (%d points)", one->points);
    }
    fputc('\n', out);
}

/* True if a component is zero by all methods and by simulation, for example because
 * there are no obstructions outside. */
static bool is_nothing(const struct pp_comparison *list, int count,
                       enum pp_component component)
{
    for (int i = 0; i < count; i++) {
        const struct pp_comparison *one = &list[i];
        bool something = one->traced_average != 0.0 || one->bias != 0.0
                         || one->spread != 0.0 || one->worst != 0.0
                         || (isfinite(one->average) && one->average != 0.0);
        if (one->component == component && !one->why && something)
            return false;
    }
    return component != PP_DF;
}

static void print_component(const struct pp_comparison *list, int count,
                            const struct pp_report *report, enum pp_component component,
                            FILE *out)
{
    bool first = true;
    for (int i = 0; i < count; i++) {
        const struct pp_comparison *one = &list[i];
        if (one->component != component || one->why)
            continue;
        if (first) {
            fprintf(out, "\n  %s\n", pp_component_titles[component]);
            fprintf(out, "    %-*s%8s%8s%7s%8s%8s  %s\n", NAME_WIDTH, "", "average",
                    "off, %", "bias", "spread", "worst", "at x, y");
            fprintf(out, "    %-*s", NAME_WIDTH, "traced");
            pp_format_cell(100.0 * one->traced_average, "%.2f", 8, out);
            fputc('\n', out);
        }
        first = false;
        print_comparison(one, report, out);
    }
}

/* Prints each reason for missing values once, as "- bre: why". The method's name is not
 * repeated if the reason begins with the name. */
static void print_refusals(const struct pp_comparison *list, int count, int width,
                           FILE *out)
{
    bool any = false;
    for (int i = 0; i < count; i++) {
        const struct pp_comparison *one = &list[i];
        bool said = !one->why;
        for (int k = 0; k < i && !said; k++)
            said = list[k].why && strcmp(list[k].why, one->why) == 0;
        if (said)
            continue;
        char text[640];
        bool named = strchr(one->why, ':') && !strchr(one->name, ':')
                     && strncmp(one->why, one->name, strcspn(one->why, ":")) == 0;
        snprintf(text, sizeof text, named ? "%s%s" : "%s: %s", named ? "" : one->name,
                 one->why);
        fputs(any ? "  - " : "\n  - ", out);
        pp_print_wrapped(text, 4, 4, width, out);
        any = true;
    }
}

/* Prints one room. Returns true if it printed parts of the differences. */
static bool print_compared_room(const struct pp_result *result,
                                const struct pp_comparison *list, int count, int width,
                                FILE *out)
{
    const struct pp_report *report = &result->report;
    const char *name = report->world->name;
    if (name && *name) {
        pp_format_utf8_put(out, name);
        fputs("  (", out);
    }
    pp_format_utf8_put(out, strcmp(result->file, "-") == 0 ? "standard input"
                                                           : result->file);
    fputs(name && *name ? ")\n" : "\n", out);
    char text[160];
    double bias_error = 0.0;
    for (int i = 0; i < count; i++)
        if (list[i].component == PP_DF && list[i].points > 0)
            bias_error = list[i].bias_error;
    snprintf(text, sizeof text,
             "%d point%s; the noise of the simulation makes the bias of the daylight "
             "factor uncertain by %.3f%s",
             report->receiver_count, report->receiver_count == 1 ? "" : "s",
             100.0 * bias_error, report->finished ? "" : "; NOT FINISHED, interrupted");
    fputs("  ", out);
    pp_print_wrapped(text, 2, 2, width, out);
    for (int component = PP_SC; component < PP_COMPONENT_COUNT; component++)
        if (!is_nothing(list, count, component))
            print_component(list, count, report, component, out);
    bool parts = pp_validate_parts_print(list, count, out);
    print_refusals(list, count, width, out);
    return parts;
}

static void print_overall(const struct pp_validation *validation, FILE *out)
{
    int rooms = validation->results->count;
    fprintf(out, "\n\nAll %d rooms, in per cent of the simulated value\n", rooms);
    fprintf(out, "\n  %-22s%-17s%-22s%s\n", "", "   the average", "  at the points",
            "the worst of all points");
    fprintf(out, "  %-22s%7s%8s  %7s%8s%8s  %s\n", "", "bias", "spread", "bias",
            "spread", "worst", "room, and x, y");
    for (int component = PP_SC; component < PP_COMPONENT_COUNT; component++) {
        bool first = true;
        for (int i = 0; i < validation->overall_count; i++) {
            const struct pp_overall *one = &validation->overall[i];
            bool any = one->averages > 0 || one->points > 0;
            if ((int)one->component != component || !any)
                continue;
            if (first)
                fprintf(out, "\n  %s\n", pp_component_titles[component]);
            first = false;
            fprintf(out, "    %-20s", one->name);
            pp_format_cell(one->averages ? 100.0 * one->average_bias : NAN, "%+.1f", 7,
                           out);
            pp_format_cell(one->averages ? 100.0 * one->average_spread : NAN, "%.1f", 8,
                           out);
            fputs("  ", out);
            pp_format_cell(one->points ? 100.0 * one->bias : NAN, "%+.1f", 7, out);
            pp_format_cell(one->points ? 100.0 * one->spread : NAN, "%.1f", 8, out);
            if (one->points > 0) {
                const struct pp_report *report =
                    &validation->results->list[one->worst_room].report;
                char place[64];
                write_place(place, report, one->worst_comparison->worst_point);
                pp_format_cell(100.0 * one->worst, "%+.0f", 8, out);
                fputs("  ", out);
                pp_format_utf8_put(out, report->world->name ? report->world->name : "");
                fprintf(out, ", %s", place);
            }
            fputc('\n', out);
        }
    }
}

void pp_validate_report_rooms(const struct pp_validation *validation, int width,
                              FILE *out)
{
    const struct pp_results *results = validation->results;
    bool parts = false;
    for (int i = 0; i < results->count; i++) {
        if (i > 0)
            fputs("\n\n", out);
        parts |= print_compared_room(&results->list[i], validation->rooms[i],
                                     validation->counts[i], width, out);
    }
    if (results->count > 1) {
        print_overall(validation, out);
        pp_validate_parts_print_all(validation->overall, validation->overall_count,
                                    out);
    }
    fputs("\n  ", out);
    pp_print_wrapped(
        "Figures are in per cent of the illuminance under the open sky unless stated "
        "otherwise. off: difference of the average over the working plane from the "
        "simulated average, in per cent of the latter. bias: mean difference, method "
        "minus simulation, at the points. spread: root mean square of this difference, "
        "after subtraction of the simulation noise. worst: the largest difference and "
        "its point.",
        2, 2, width, out);
    if (parts) {
        fputs("  ", out);
        pp_print_wrapped(pp_validate_parts_note, 2, 2, width, out);
    }
    if (results->count > 1) {
        fputs("  ", out);
        pp_print_wrapped("For all rooms together, differences at points are in per "
                         "cent of the room's mean simulated value.",
                         2, 2, width, out);
    }
}

/* ---- JSON and CSV for rooms ---- */

static struct json_object *comparison_object(const struct pp_comparison *one,
                                             const struct pp_report *report)
{
    struct json_object *object = json_object_new_object();
    bool good = object
                && pp_json_text(object, "component", pp_component_names[one->component])
                && pp_json_text(object, "method", one->name);
    if (good && one->why)
        good = pp_json_text(object, "why", one->why);
    if (good && isfinite(one->average))
        good = pp_json_number(object, "average", 100.0 * one->average)
               && pp_json_number(object, "traced-average", 100.0 * one->traced_average)
               && pp_json_number(object, "traced-average-se",
                                 100.0 * one->traced_average_error);
    if (good && one->points > 0) {
        struct pp_vec3 at = report->receivers[one->worst_point].position;
        good = pp_json_add(object, "points", json_object_new_int(one->points))
               && pp_json_number(object, "traced", 100.0 * one->traced)
               && pp_json_number(object, "bias", 100.0 * one->bias)
               && pp_json_number(object, "bias-se", 100.0 * one->bias_error)
               && pp_json_number(object, "spread", 100.0 * one->spread)
               && pp_json_number(object, "worst", 100.0 * one->worst)
               && pp_json_number(object, "worst-se", 100.0 * one->worst_error)
               && pp_json_number(object, "worst-x", at.x)
               && pp_json_number(object, "worst-y", at.y)
               && pp_json_number(object, "worst-z", at.z);
    }
    good = good && pp_validate_parts_json(object, one);
    if (good)
        pp_json_on_one_line(object);
    return pp_json_whole(object, good);
}

static struct json_object *room_object(const struct pp_result *result,
                                       const struct pp_comparison *list, int count)
{
    struct json_object *object = json_object_new_object();
    struct json_object *methods = json_object_new_array();
    bool good = object && pp_json_text(object, "file", result->file)
                && pp_json_text(object, "room", result->report.world->name);
    if (good && !result->report.finished)
        good = pp_json_add(object, "finished", json_object_new_boolean(false));
    good = good && pp_json_add(object, "methods", methods);
    for (int i = 0; i < count && good; i++)
        good = pp_json_append(methods, comparison_object(&list[i], &result->report));
    return pp_json_whole(object, good);
}

static struct json_object *overall_object(const struct pp_overall *one)
{
    struct json_object *object = json_object_new_object();
    bool good = object
                && pp_json_text(object, "component", pp_component_names[one->component])
                && pp_json_text(object, "method", one->name);
    if (good && one->averages > 0)
        good = pp_json_add(object, "averages", json_object_new_int(one->averages))
               && pp_json_number(object, "average-bias", 100.0 * one->average_bias)
               && pp_json_number(object, "average-spread", 100.0 * one->average_spread);
    if (good && one->points > 0)
        good = pp_json_add(object, "rooms", json_object_new_int(one->rooms))
               && pp_json_add(object, "points", json_object_new_int(one->points))
               && pp_json_number(object, "bias", 100.0 * one->bias)
               && pp_json_number(object, "spread", 100.0 * one->spread)
               && pp_json_number(object, "worst", 100.0 * one->worst);
    good = good && pp_validate_parts_json_all(object, one);
    if (good)
        pp_json_on_one_line(object);
    return pp_json_whole(object, good);
}

enum pp_status pp_validate_report_rooms_json(const struct pp_validation *validation,
                                             FILE *out, struct pp_error *err)
{
    const struct pp_results *results = validation->results;
    struct json_object *object = json_object_new_object();
    struct json_object *rooms = json_object_new_array(), *all = NULL;
    bool good = object && pp_json_text(object, "format", "pepperpot-validate-1")
                && pp_json_add(object, "rooms", rooms);
    for (int i = 0; i < results->count && good; i++)
        good =
            pp_json_append(rooms, room_object(&results->list[i], validation->rooms[i],
                                              validation->counts[i]));
    good = good && pp_json_add(object, "all", all = json_object_new_array());
    for (int i = 0; i < validation->overall_count && good; i++)
        good = pp_json_append(all, overall_object(&validation->overall[i]));
    return pp_json_print(out, pp_json_whole(object, good), err);
}

void pp_validate_report_rooms_csv(const struct pp_validation *validation, FILE *out)
{
    fputs("file,room,component,method,average_percent,traced_average_percent,"
          "traced_average_se_percent,points,traced_percent,bias_percent,"
          "bias_se_percent,spread_percent,worst_percent,worst_se_percent,worst_x,"
          "worst_y,worst_z,why",
          out);
    fputs(pp_validate_parts_csv_names, out);
    fputs("\r\n", out);
    for (int i = 0; i < validation->results->count; i++) {
        const struct pp_result *result = &validation->results->list[i];
        for (int k = 0; k < validation->counts[i]; k++) {
            const struct pp_comparison *one = &validation->rooms[i][k];
            bool any = one->points > 0;
            struct pp_vec3 at =
                any ? result->report.receivers[one->worst_point].position
                    : pp_vec(NAN, NAN, NAN);
            const double fields[] = {any ? 100.0 * one->traced : NAN,
                                     any ? 100.0 * one->bias : NAN,
                                     any ? 100.0 * one->bias_error : NAN,
                                     any ? 100.0 * one->spread : NAN,
                                     any ? 100.0 * one->worst : NAN,
                                     any ? 100.0 * one->worst_error : NAN,
                                     at.x,
                                     at.y,
                                     at.z};
            pp_format_csv_field(result->file, out);
            fputc(',', out);
            pp_format_csv_field(result->report.world->name, out);
            fprintf(out, ",%s,%s", pp_component_names[one->component], one->name);
            pp_format_csv_number(100.0 * one->average, out);
            pp_format_csv_number(100.0 * one->traced_average, out);
            pp_format_csv_number(100.0 * one->traced_average_error, out);
            fprintf(out, ",%d", one->points);
            for (size_t f = 0; f < sizeof fields / sizeof fields[0]; f++)
                pp_format_csv_number(fields[f], out);
            fputc(',', out);
            pp_format_csv_field(one->why, out);
            pp_validate_parts_csv(one, out);
            fputs("\r\n", out);
        }
    }
}
