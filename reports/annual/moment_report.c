/* moment_report.c - see moment_report.h. */
#include "reports/annual/moment_report.h"

#include <math.h>
#include <stddef.h>

#include "reports/parts/format.h"
#include "reports/parts/json.h"
#include "reports/parts/print.h"

#define FIGURE(name)                                                                   \
    ((int)(offsetof(struct pp_annual_figures, name) / sizeof(struct pp_annual_value)))

/* Components of the illuminance at one moment. The moment is stored as a year with one
 * hour. */
static const struct {
    const char *name;
    int index;
} parts[] = {{"sky", FIGURE(sky_lxh)},
             {"sun", FIGURE(sun_lxh)},
             {"sun-reflected", FIGURE(sun_reflected_lxh)},
             {"illuminance", FIGURE(year_lxh)}};
enum { PARTS = sizeof parts / sizeof *parts };

static const char why_no_factor[] = "a moment has illuminances, not daylight factors";

static struct pp_annual_value part_of(const struct pp_annual_figures *of, int part)
{
    struct pp_annual_figures figures = *of;
    return *pp_annual_sheet_figure(&figures, parts[part].index);
}

static void print_moment_line(const struct pp_annual_figures *figures, FILE *out)
{
    for (int i = 0; i < PARTS; i++)
        fprintf(out, "  %13.0f", part_of(figures, i).value);
    fprintf(out, "  %7.1f\n", part_of(figures, PARTS - 1).std_error);
}

enum pp_status pp_moment_report_text(const struct pp_annual_results *results,
                                     const char *when, int width, FILE *out,
                                     struct pp_error *err)
{
    (void)err;
    for (int i = 0; i < results->count; i++) {
        const struct pp_annual_sheet *sheet = &results->list[i].sheet;
        const struct pp_annual_hour *hour = &sheet->hours[0];
        fprintf(out, "%s", i > 0 ? "\n" : "");
        pp_print_title(sheet->world, results->list[i].file, out);
        if (isnan(hour->sun_altitude_rad))
            fprintf(out,
                    "  Given sky, without sun: illuminances in lux;\n  outside %.0f lx "
                    "diffuse horizontal.\n",
                    hour->diffuse_lx);
        else
            fprintf(out,
                    "  %s%s: illuminances in lux;\n  sun %.1f degrees high, bearing "
                    "%.1f; outside %.0f lx diffuse horizontal, %.0f lx direct "
                    "normal.\n",
                    when ? when : "Given sky and sun", when ? ", standard time" : "",
                    hour->sun_altitude_rad / PP_RAD, hour->sun_bearing_rad / PP_RAD,
                    hour->diffuse_lx, hour->direct_lx);
        fputs("  ", out);
        pp_print_wrapped(sheet->weather, 2, 2, width, out);
        for (int k = 0; k < sheet->warning_count; k++) {
            fputs("  Warning: ", out);
            pp_print_wrapped(sheet->warnings[k], 11, 2, width, out);
        }
        fputs(
            "\n        x        y        z            sky            sun  sun-reflected"
            "    illuminance       se\n",
            out);
        for (int x = 0; x < sheet->receiver_count; x++) {
            struct pp_vec3 at = sheet->receivers[x].position;
            fprintf(out, "  %7.3f  %7.3f  %7.3f", at.x, at.y, at.z);
            print_moment_line(&sheet->points[x], out);
        }
        fprintf(out, "  %-25s", "mean of the points");
        print_moment_line(&sheet->mean, out);
    }
    return PP_OK;
}

static bool add_moment_parts(struct json_object *to,
                             const struct pp_annual_figures *figures)
{
    bool good = true;
    for (int i = 0; i < PARTS && good; i++) {
        struct pp_annual_value value = part_of(figures, i);
        struct json_object *line = json_object_new_object();
        good = pp_json_add(to, parts[i].name, line);
        if (!good)
            break;
        pp_json_on_one_line(line);
        good = pp_json_number(line, "value", value.value)
               && pp_json_number(line, "se", value.std_error);
    }
    struct json_object *df = json_object_new_object();
    if (!pp_json_add(to, "df", df))
        return false;
    pp_json_on_one_line(df);
    return good && pp_json_number(df, "value", NAN)
           && pp_json_text(df, "why", why_no_factor);
}

/* Results of the rooms, and the time as typed by the user. */
struct moment_rooms {
    const struct pp_annual_results *results;
    const char *when;
};

static struct json_object *moment_room(const void *all, int index)
{
    const struct moment_rooms *rooms = all;
    const struct pp_annual_sheet *sheet = &rooms->results->list[index].sheet;
    const struct pp_annual_hour *hour = &sheet->hours[0];
    struct json_object *object = json_object_new_object();
    struct json_object *points = json_object_new_array();
    struct json_object *mean = json_object_new_object();
    struct json_object *warnings = json_object_new_array();
    bool good =
        object && pp_json_text(object, "format", "pepperpot-df-1")
        && pp_json_text(object, "room", sheet->world->name)
        && pp_json_text(object, "sky", sheet->sky_name)
        && (!rooms->when || pp_json_text(object, "when", rooms->when))
        && pp_json_text(object, "unit", "lx")
        && pp_json_text(object, "weather", sheet->weather)
        && pp_json_number(object, "sun_altitude_deg", hour->sun_altitude_rad / PP_RAD)
        && pp_json_number(object, "sun_bearing_deg", hour->sun_bearing_rad / PP_RAD)
        && pp_json_number(object, "diffuse_horizontal_lux", hour->diffuse_lx)
        && pp_json_number(object, "direct_normal_lux", hour->direct_lx);
    good = pp_json_add(object, "warnings", warnings) && good;
    for (int i = 0; i < sheet->warning_count && good; i++)
        good = pp_json_append(warnings, json_object_new_string(sheet->warnings[i]));
    good = pp_json_add(object, "points", points) && good;
    for (int x = 0; x < sheet->receiver_count && good; x++) {
        struct pp_vec3 at = sheet->receivers[x].position;
        struct json_object *point = json_object_new_object();
        good = pp_json_append(points, point) && pp_json_number(point, "x", at.x)
               && pp_json_number(point, "y", at.y) && pp_json_number(point, "z", at.z)
               && add_moment_parts(point, &sheet->points[x]);
    }
    good = pp_json_add(object, "mean_of_points", mean) && good
           && add_moment_parts(mean, &sheet->mean);
    return pp_json_whole(object, good);
}

enum pp_status pp_moment_report_json(const struct pp_annual_results *results,
                                     const char *when, FILE *out, struct pp_error *err)
{
    const struct moment_rooms rooms = {results, when};
    return pp_json_print_rooms(out, moment_room, &rooms, results->count,
                               results->several, err);
}

enum pp_status pp_moment_report_csv(const struct pp_annual_results *results,
                                    const char *when, FILE *out, struct pp_error *err)
{
    (void)err;
    fputs("file,room,when,x,y,z", out);
    for (int i = 0; i < PARTS; i++)
        fprintf(out, ",%s_lx,%s_se_lx", parts[i].name, parts[i].name);
    fputs("\r\n", out);
    for (int i = 0; i < results->count; i++) {
        const struct pp_annual_sheet *sheet = &results->list[i].sheet;
        for (int x = 0; x < sheet->receiver_count; x++) {
            struct pp_vec3 at = sheet->receivers[x].position;
            pp_format_csv_field(results->list[i].file, out);
            fputc(',', out);
            pp_format_csv_field(sheet->world->name, out);
            fprintf(out, ",%s", when ? when : "");
            pp_format_csv_number(at.x, out);
            pp_format_csv_number(at.y, out);
            pp_format_csv_number(at.z, out);
            for (int k = 0; k < PARTS; k++) {
                struct pp_annual_value value = part_of(&sheet->points[x], k);
                pp_format_csv_number(value.value, out);
                pp_format_csv_number(value.std_error, out);
            }
            fputs("\r\n", out);
        }
    }
    return PP_OK;
}
