/* glare_report.c - see glare_report.h. */
#include "reports/glare/glare_report.h"

#include <math.h>

#include "formats/epw/month_day.h"
#include "reports/parts/format.h"
#include "reports/parts/print.h"

/* ---- text ---- */

static const char formula_words[] =
    "DGP = 5.87e-5 Ev + 0.0918 lg(1 + sum of L^2 omega / (Ev^1.87 P^2)) + 0.16, at "
    "most "
    "1; below 1000 lx times evalglare's correction for low light. The formula was "
    "derived for DGP of 0.2 to 0.8 and Ev above 380 lx.";

static void print_sentence(const char *text, int width, FILE *out)
{
    if (!text[0])
        return;
    fputs("  ", out);
    pp_print_wrapped(text, 2, 2, width, out);
}

static void print_labelled(const char *label, const char *text, int width, FILE *out)
{
    char line[2 * PP_ANNUAL_WORDS + 32];
    if (!text[0])
        return;
    snprintf(line, sizeof line, "%s%s.", label, text);
    print_sentence(line, width, out);
}

static void print_sun(const struct pp_annual_hour *hour, FILE *out)
{
    if (hour->direct_lx > 0.0)
        fprintf(out,
                "  Sun %.1f degrees high, bearing %.1f, %.0f lx direct normal;\n  ",
                hour->sun_altitude_rad / PP_RAD, hour->sun_bearing_rad / PP_RAD,
                hour->direct_lx);
    else
        fputs("  No direct sun; ", out);
    fprintf(out, "%.0f lx diffuse horizontal.\n", hour->diffuse_lx);
}

static void print_view_title(const struct pp_world_view *view, int number, FILE *out)
{
    fputs("\n  View ", out);
    if (view->name)
        pp_format_utf8_put(out, view->name);
    else
        fprintf(out, "%d", number);
    fprintf(out, ": eye at (%g, %g, %g) m, looking towards bearing %g\n", view->eye.x,
            view->eye.y, view->eye.z, view->bearing_rad / PP_RAD);
}

static void print_source(const char *name, double omega_sr, double cd_m2, double index,
                         double share, FILE *out)
{
    fprintf(out, "    %-22s  %11.3g  %14.0f  %14.2f  %8.1f\n", name, omega_sr, cd_m2,
            index, 100.0 * share);
}

static void print_sources(const struct pp_glare_sheet *sheet,
                          const struct pp_glare_moment *moment, FILE *out)
{
    const struct pp_glare_sun *sun = &moment->sun;
    if (!(moment->sum > 0.0)) {
        fprintf(out, "    no source of %g cd/m2 or more\n", sheet->threshold_cd_m2);
        return;
    }
    fputs("    source                  omega in sr  mean L in cd/m2  position index  "
          "per cent\n",
          out);
    for (int k = 0; k < moment->part_count; k++) {
        const struct pp_glare_part *part = &moment->parts[k];
        if (part->omega_sr > 0.0)
            print_source(k < sheet->world->opening_count
                             ? sheet->world->openings[k].label
                             : "surfaces of the room",
                         part->omega_sr, pp_glare_sheet_luminance(part),
                         pp_glare_sheet_index(part), part->sum / moment->sum, out);
    }
    if (sun->visible)
        print_source("sun", sun->omega_sr, sun->cd_m2, sun->index,
                     sun->sum / moment->sum, out);
}

static void print_moment_views(const struct pp_glare_sheet *sheet, FILE *out)
{
    for (int v = 0; v < sheet->view_count; v++) {
        const struct pp_glare_moment *moment = &sheet->moments[v];
        print_view_title(&sheet->views[v], v + 1, out);
        fprintf(out, "    DGP %.3f (se %.4f): %s. Ev %.0f lx (se %.1f).\n",
                moment->dgp.value, moment->dgp.std_error,
                pp_glare_sheet_class(moment->dgp.value), moment->eye_lx.value,
                moment->eye_lx.std_error);
        print_sources(sheet, moment, out);
    }
}

static void print_year_views(const struct pp_glare_sheet *sheet, FILE *out)
{
    double occupied_h = sheet->annual.occupied_h;
    for (int v = 0; v < sheet->view_count; v++) {
        const struct pp_glare_year *year = &sheet->years[v];
        print_view_title(&sheet->views[v], v + 1, out);
        fputs("    DGP above  hours   se  per cent of the occupied hours\n", out);
        for (int k = 0; k < PP_GLARE_LIMITS; k++)
            fprintf(out, "    %-9.2f  %5.0f  %3.0f  %8.1f\n", pp_glare_sheet_limits[k],
                    year->above_h[k].value, year->above_h[k].std_error,
                    100.0 * year->above_h[k].value / occupied_h);
        fprintf(out,
                "    EN 17037: level %s; DGP exceeded in 5 %% of the hours: %.2f\n",
                pp_glare_sheet_level(year, occupied_h), year->exceeded_in_5);
        if (year->most_hour >= 0) {
            const struct pp_annual_hour *hour = &sheet->annual.hours[year->most_hour];
            char date[24];
            fprintf(
                out, "    highest DGP: %.2f, first on %s at %02.0f:%02.0f", year->most,
                pp_month_day_words(date, sizeof date,
                                   (struct pp_month_day){hour->month, hour->day}),
                floor(hour->start_h), 60.0 * (hour->start_h - floor(hour->start_h)));
            fprintf(out, "; sun in view: %.0f h\n", year->sun_h);
        }
    }
}

static void print_notes(const struct pp_glare_sheet *sheet, int width, FILE *out)
{
    char text[320];
    fputc('\n', out);
    print_sentence(formula_words, width, out);
    snprintf(
        text, sizeof text,
        "Sources have %g cd/m2 or more. %s. Surfaces are matt, without reflections of "
        "the sun.",
        sheet->threshold_cd_m2, pp_glare_sheet_devices(sheet));
    print_sentence(text, width, out);
    if (!sheet->is_year)
        return;
    print_sentence(
        "Levels of EN 17037: the limit of DGP, 0.35 (high), 0.40 (medium) or "
        "0.45 (minimum), is exceeded in at most 5 % of the occupied hours. "
        "Occupied hours after dark are included.",
        width, out);
    print_labelled("Simulation: ", sheet->annual.method, width, out);
    print_labelled("Weather file: ", sheet->annual.notes, width, out);
}

enum pp_status pp_glare_report_text(const struct pp_glare_results *results, int width,
                                    FILE *out, struct pp_error *err)
{
    (void)err;
    for (int i = 0; i < results->count; i++) {
        const struct pp_glare_sheet *sheet = &results->list[i].sheet;
        const struct pp_annual_sheet *annual = &sheet->annual;
        fputs(i > 0 ? "\n" : "", out);
        pp_print_title(sheet->world, results->list[i].file, out);
        fprintf(out, "  Daylight glare probability (DGP), %s.\n",
                sheet->is_year  ? "in the occupied hours of a year"
                : results->when ? results->when
                                : "under the given sky and sun");
        if (!sheet->is_year)
            print_sun(&annual->hours[0], out);
        print_labelled("", annual->weather, width, out);
        if (sheet->is_year)
            print_labelled("", annual->period, width, out);
        for (int k = 0; k < annual->warning_count; k++) {
            fputs("  Warning: ", out);
            pp_print_wrapped(annual->warnings[k], 11, 2, width, out);
        }
        if (sheet->is_year)
            print_year_views(sheet, out);
        else
            print_moment_views(sheet, out);
        print_notes(sheet, width, out);
    }
    return PP_OK;
}

/* ---- CSV ---- */

static void put_csv_view(const struct pp_glare_result *result, int view, FILE *out)
{
    const struct pp_world_view *of = &result->sheet.views[view];
    pp_format_csv_field(result->file, out);
    fputc(',', out);
    pp_format_csv_field(result->sheet.world->name, out);
    fputc(',', out);
    pp_format_csv_field(of->name, out);
    pp_format_csv_number(of->eye.x, out);
    pp_format_csv_number(of->eye.y, out);
    pp_format_csv_number(of->eye.z, out);
    pp_format_csv_number(of->bearing_rad / PP_RAD, out);
}

static void put_csv_moment(const struct pp_glare_moment *moment, const char *when,
                           FILE *out)
{
    double omega_sr = 0.0;
    for (int k = 0; k < moment->part_count; k++)
        omega_sr += moment->parts[k].omega_sr;
    fprintf(out, ",%s", when ? when : "");
    pp_format_csv_number(moment->eye_lx.value, out);
    pp_format_csv_number(moment->eye_lx.std_error, out);
    pp_format_csv_number(moment->dgp.value, out);
    pp_format_csv_number(moment->dgp.std_error, out);
    fprintf(out, ",%s", pp_glare_sheet_class(moment->dgp.value));
    pp_format_csv_number(moment->sum - moment->sun.sum, out);
    pp_format_csv_number(omega_sr, out);
    fprintf(out, ",%s", moment->sun.visible ? "yes" : "no");
    pp_format_csv_number(moment->sun.visible ? moment->sun.cd_m2 : NAN, out);
    pp_format_csv_number(moment->sun.visible ? moment->sun.index : NAN, out);
    fputs("\r\n", out);
}

static void put_csv_year(const struct pp_glare_year *year, double occupied_h, FILE *out)
{
    pp_format_csv_number(occupied_h, out);
    for (int i = 0; i < PP_GLARE_LIMITS; i++) {
        pp_format_csv_number(year->above_h[i].value, out);
        pp_format_csv_number(year->above_h[i].std_error, out);
    }
    pp_format_csv_number(year->exceeded_in_5, out);
    pp_format_csv_number(year->most, out);
    pp_format_csv_number(year->sun_h, out);
    fprintf(out, ",%s\r\n", pp_glare_sheet_level(year, occupied_h));
}

enum pp_status pp_glare_report_csv(const struct pp_glare_results *results, FILE *out,
                                   struct pp_error *err)
{
    (void)err;
    bool is_year = results->count > 0 && results->list[0].sheet.is_year;
    fputs("file,room,view,x,y,z,bearing_deg,", out);
    fputs(is_year ? "occupied_h,above_0.35_h,above_0.35_se_h,above_0.40_h,"
                    "above_0.40_se_h,above_0.45_h,above_0.45_se_h,dgp_exceeded_in_5,"
                    "dgp_max,sun_h,level\r\n"
                  : "when,eye_lx,eye_se_lx,dgp,dgp_se,class,sum_without_sun,"
                    "omega_without_sun_sr,sun_visible,sun_cd_m2,sun_position_index\r\n",
          out);
    for (int i = 0; i < results->count; i++) {
        const struct pp_glare_sheet *sheet = &results->list[i].sheet;
        for (int v = 0; v < sheet->view_count; v++) {
            put_csv_view(&results->list[i], v, out);
            if (is_year)
                put_csv_year(&sheet->years[v], sheet->annual.occupied_h, out);
            else
                put_csv_moment(&sheet->moments[v], results->when, out);
        }
    }
    return PP_OK;
}
