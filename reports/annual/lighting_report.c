/* lighting_report.c - see lighting_report.h. */
#include "reports/annual/lighting_report.h"

#include <math.h>
#include <string.h>

#include "model/base/text.h"
#include "reports/annual/annual_figure.h"
#include "reports/parts/format.h"
#include "reports/parts/json.h"
#include "studies/lighting/lighting_control.h"
#include "studies/lighting/lighting_year.h"

double pp_lighting_report_kwh(const struct pp_annual_sheet *sheet, int k)
{
    return sheet->lighting[k].control.power_w * sheet->occupied_h / 1000.0;
}

bool pp_lighting_report_short_records(const struct pp_annual_sheet *sheet)
{
    return sheet->hour_count > 0 && sheet->hours[0].length_h < 1.0;
}

const char *pp_lighting_report_words(char *text, size_t room,
                                     const struct pp_annual_sheet *sheet, int k)
{
    const struct pp_lighting_control *control = &sheet->lighting[k].control;
    pp_lighting_control_words(text, room, control);
    if (isfinite(control->power_w))
        pp_text_append(text, room, "; %.4g W/m2, %.4g W", control->power_w_m2,
                       control->power_w);
    return text;
}

static const char *const standard_classes[] = {"none", "weak", "medium", "strong"};

const char *pp_lighting_report_standard(char *text, size_t room,
                                        const struct pp_annual_sheet *sheet)
{
    const struct pp_lighting_standard *zone = &sheet->lighting[0].standard;
    if (!(zone->depth_m > 0.0)) { /* the reason is the same for all controls */
        snprintf(text, room, "no figure, because %s", zone->why);
        return text;
    }
    snprintf(text, room,
             "edition of 2007: zone %.2f m deep and %.2f m wide, D_C %.1f %%, daylight "
             "%s",
             zone->depth_m, zone->width_m, 100.0 * zone->factor,
             standard_classes[zone->class]);
    for (int k = 0; k < sheet->lighting_count; k++) {
        const struct pp_lighting_standard *standard = &sheet->lighting[k].standard;
        if (standard->why)
            pp_text_append(text, room, "; control %d: no figure, because %s", k + 1,
                           standard->why);
        else if (standard->class > 0)
            pp_text_append(text, room, "; control %d: F_D,S %.3f, F_D,C %.2f", k + 1,
                           standard->supply, standard->control);
    }
    return text;
}

/* Fraction of the energy used, from the fraction saved. */
static struct pp_annual_value used_share(const struct pp_annual_value *saved)
{
    return (struct pp_annual_value){1.0 - saved->value, saved->std_error};
}

/* ---- JSON ---- */

static bool add_settings(struct json_object *object,
                         const struct pp_lighting_control *control)
{
    char words[320];
    struct json_object *point = NULL;
    pp_lighting_control_words(words, sizeof words, control);
    if (control->point > 0 && !(point = json_object_new_int(control->point)))
        return false;
    bool good = pp_json_text(object, "control", pp_lighting_control_name(control->kind))
                && pp_json_text(object, "settings", words)
                && pp_json_number(object, "target_lux", control->target_lx);
    if (!good) {
        json_object_put(point);
        return false;
    }
    return (point ? pp_json_add(object, "point", point)
                  : pp_json_text(object, "point", "darkest"))
           && pp_json_text(object, "blinds", control->with_blinds ? "lm83" : "open")
           && pp_json_number(object, "installed_w", control->power_w)
           && pp_json_number(object, "installed_w_m2", control->power_w_m2);
}

static bool add_control(struct json_object *object, const struct pp_annual_sheet *sheet,
                        int k)
{
    static const char no_power[] = "no installed power given";
    const struct pp_lighting_sheet *of = &sheet->lighting[k];
    const struct pp_lighting_figures *figures = &of->figures;
    struct pp_annual_value used = used_share(&figures->saved);
    double kwh = pp_lighting_report_kwh(sheet, k);
    bool good =
        add_settings(object, &of->control)
        && pp_annual_figure_json(object, "saved", &figures->saved, 100.0, NULL)
        && pp_annual_figure_json(object, "saved-mean-of-points", &of->mean, 100.0, NULL)
        && pp_annual_figure_json(object, "used-h", &figures->used_h, 1.0, NULL)
        && pp_annual_figure_json(object, "on-h", &figures->on_h, 1.0, NULL)
        && pp_annual_figure_json(object, "used-kwh", &used, kwh, no_power)
        && pp_annual_figure_json(object, "saved-kwh", &figures->saved, kwh, no_power);
    if (good && pp_lighting_report_short_records(sheet))
        good = pp_annual_figure_json(object, "saved-by-hourly-means",
                                     &figures->saved_by_means, 100.0, NULL)
               && pp_annual_figure_json(object, "misjudged-by-hourly-means",
                                        &figures->misjudged, 100.0, NULL);
    return good;
}

static bool add_standard(struct json_object *object,
                         const struct pp_lighting_standard *standard)
{
    struct json_object *to = json_object_new_object();
    if (!pp_json_add(object, "en15193-2007", to))
        return false;
    pp_json_on_one_line(to);
    if (standard->why)
        return pp_json_number(to, "saved", NAN)
               && pp_json_text(to, "why", standard->why);
    return pp_json_number(to, "saved", 100.0 * standard->saved)
           && pp_json_number(to, "dc", 100.0 * standard->factor)
           && pp_json_text(to, "class", standard_classes[standard->class])
           && pp_json_number(to, "fds", standard->supply)
           && pp_json_number(to, "fdc", standard->control)
           && pp_json_number(to, "zone_depth_m", standard->depth_m)
           && pp_json_number(to, "zone_width_m", standard->width_m);
}

bool pp_lighting_report_json(struct json_object *object,
                             const struct pp_annual_sheet *sheet)
{
    if (sheet->lighting_count == 0)
        return true;
    struct json_object *list = json_object_new_array();
    bool good = pp_json_add(object, "lighting", list);
    for (int k = 0; k < sheet->lighting_count && good; k++) {
        struct json_object *to = json_object_new_object();
        good = pp_json_append(list, to) && add_control(to, sheet, k)
               && add_standard(to, &sheet->lighting[k].standard);
    }
    return good;
}

bool pp_lighting_report_json_point(struct json_object *object,
                                   const struct pp_annual_sheet *sheet, int point)
{
    bool good = true;
    for (int k = 0; k < sheet->lighting_count && good; k++) {
        const struct pp_lighting_sheet *of = &sheet->lighting[k];
        char key[32];
        snprintf(key, sizeof key, "lighting%d-saved", k + 1);
        good = pp_annual_figure_json(
            object, key, point < 0 ? &of->mean : &of->points[point], 100.0, NULL);
    }
    return good;
}

/* ---- CSV ---- */

void pp_lighting_report_csv_names(const struct pp_annual_sheet *sheet, FILE *out)
{
    for (int k = 1; k <= sheet->lighting_count; k++)
        fprintf(out,
                ",lighting%d-saved,lighting%d-saved_se,lighting%d-used-h,"
                "lighting%d-used-h_se,lighting%d-used-kwh,lighting%d-used-kwh_se",
                k, k, k, k, k, k);
}

static void put_saved(const struct pp_annual_sheet *sheet, int k,
                      const struct pp_annual_value *saved, FILE *out)
{
    struct pp_annual_value used = used_share(saved);
    double kwh = pp_lighting_report_kwh(sheet, k);
    pp_format_csv_number(100.0 * saved->value, out);
    pp_format_csv_number(100.0 * saved->std_error, out);
    pp_format_csv_number(sheet->occupied_h * used.value, out);
    pp_format_csv_number(sheet->occupied_h * used.std_error, out);
    pp_format_csv_number(kwh * used.value, out);
    pp_format_csv_number(kwh * used.std_error, out);
}

void pp_lighting_report_csv_point(const struct pp_annual_sheet *sheet, int point,
                                  FILE *out)
{
    for (int k = 0; k < sheet->lighting_count; k++)
        put_saved(sheet, k,
                  point < 0 ? &sheet->lighting[k].mean
                            : &sheet->lighting[k].points[point],
                  out);
}

void pp_lighting_report_csv_control(const struct pp_annual_sheet *sheet, int k,
                                    FILE *out)
{
    for (int i = 0; i < sheet->lighting_count; i++)
        if (i == k)
            put_saved(sheet, k, &sheet->lighting[k].figures.saved, out);
        else
            fputs(",,,,,,", out);
}

/* ---- the schedule ---- */

void pp_lighting_report_schedule(const struct pp_annual_sheet *sheet, FILE *out)
{
    for (int k = 0; k < sheet->lighting_count; k++) {
        char words[320], heading[1200];
        pp_lighting_control_words(words, sizeof words, &sheet->lighting[k].control);
        snprintf(
            heading, sizeof heading,
            "lighting %d: fraction of the installed power in each hour of standard "
            "time, occupied %.*s; %s",
            k + 1, (int)strcspn(sheet->period, ","), sheet->period, words);
        fputs(k > 0 ? "," : "", out);
        pp_format_csv_field(heading, out);
    }
    fputs("\r\n", out);
    for (int first = 0, count; first < sheet->hour_count; first += count) {
        count =
            pp_lighting_year_records_of_hour(sheet->hours, sheet->hour_count, first);
        for (int k = 0; k < sheet->lighting_count; k++) {
            double sum = 0.0;
            for (int i = first; i < first + count; i++)
                sum += (double)sheet->lighting[k].fraction[i] / count;
            fprintf(out, "%s%.6g", k > 0 ? "," : "", sum);
        }
        fputs("\r\n", out);
    }
}
