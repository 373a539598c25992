/* annual_text.c - prints the figures of the plane, a table of the points, and the
 * assumptions. */
#include "reports/annual/annual_text.h"

#include <math.h>
#include <string.h>

#include "model/results/sheets/lm83_grid.h"
#include "model/results/sheets/point_areas.h"
#include "reports/annual/hand_year_report.h"
#include "reports/annual/lighting_report.h"
#include "reports/annual/lighting_text.h"
#include "reports/parts/print.h"
#include "reports/parts/table.h"

struct text_page {
    const struct pp_annual_sheet *sheet;
    int width;
    bool utf8;
    FILE *out;
};

static void print_annual_fact(const struct text_page *page, const char *label,
                              const char *text)
{
    enum { LABEL = 16 };
    if (!text[0])
        return;
    fprintf(page->out, "  %-*s", LABEL, label);
    pp_print_wrapped(text, LABEL + 2, LABEL + 2, page->width, page->out);
}

/* Writes a fraction in per cent with its standard error: "74.5 % ± 0.3". */
static void put_share(char *text, size_t room, const struct pp_annual_value *share,
                      bool utf8)
{
    if (isnan(share->value))
        snprintf(text, room, "-");
    else
        snprintf(text, room, "%.1f %% %s %.1f", 100.0 * share->value,
                 utf8 ? "\xC2\xB1" : "+-", 100.0 * share->std_error);
}

static void print_share(const struct text_page *page, const char *label,
                        const struct pp_annual_value *share, const char *of,
                        const char *verb, const char *meaning)
{
    char text[320], value[48];
    put_share(value, sizeof value, share, page->utf8);
    snprintf(text, sizeof text, "%s  of the %s %s %s", value, of, verb, meaning);
    print_annual_fact(page, label, text);
}

/* Prints the level reached in EN 17037, method 2. Targets apply to half of the plane,
 * minimum targets to 95 % of the plane. */
static void print_levels(const struct text_page *page)
{
    const struct pp_annual_sheet *sheet = page->sheet;
    char text[400];
    double share[PP_ANNUAL_LEVELS];
    for (int i = 0; i < PP_ANNUAL_LEVELS; i++)
        share[i] = sheet->plane.level[i].value;
    const char *level = share[3] >= 0.5 && share[2] >= 0.95   ? "high"
                        : share[2] >= 0.5 && share[1] >= 0.95 ? "medium"
                        : share[1] >= 0.5 && share[0] >= 0.95 ? "minimum"
                                                              : "none";
    snprintf(
        text, sizeof text,
        "share of the %s 100, 300, 500, 750 lx in half of the 4380 "
        "brightest hours: %.1f, %.1f, %.1f, %.1f %%; level for a side-lit room: %s",
        pp_point_areas_differ(sheet->receivers, sheet->receiver_count)
            ? "plane that reaches"
            : "points that reach",
        100.0 * share[0], 100.0 * share[1], 100.0 * share[2], 100.0 * share[3], level);
    print_annual_fact(page, "EN 17037", text);
}

static void print_leed(const struct text_page *page)
{
    struct pp_annual_leed leed = pp_annual_sheet_leed(page->sheet);
    char text[240], grid[PP_LM83_GRID_WORDS];
    if (leed.why_not) {
        snprintf(text, sizeof text, "option 1: no result, because %s", leed.why_not);
        print_annual_fact(page, "LEED v4.1", text);
        return;
    }
    snprintf(text, sizeof text,
             "option 1: %d point%s, if this room represents all regularly occupied "
             "floor area (mean sDA 40, 55, 75 %%: 1, 2, 3 points)%s",
             leed.points, leed.points == 1 ? "" : "s",
             leed.ase_to_explain
                 ? "; ASE is above 10 %: explain how the space is protected from glare"
                 : "");
    print_annual_fact(page, "LEED v4.1", text);
    pp_lm83_grid_words(grid, page->sheet);
    if (grid[0])
        print_annual_fact(page, "grid", grid);
}

static void print_plane(const struct text_page *page)
{
    const struct pp_annual_sheet *sheet = page->sheet;
    const struct pp_annual_plane *plane = &sheet->plane;
    char text[200];
    bool differ = pp_point_areas_differ(sheet->receivers, sheet->receiver_count);
    double area_m2 = pp_point_areas_sum(sheet->receivers, sheet->receiver_count);
    snprintf(
        text, sizeof text, "%d %s", sheet->receiver_count,
        !sheet->is_grid ? "(no grid: shares refer to these points, not to the plane)"
        : differ ? "in a grid, weighted by the part of the plane that each represents"
                 : "in a grid; each represents an equal part of the plane");
    print_annual_fact(page, "points", text);
    const char *of = differ ? "plane" : "points";
    if (sheet->has_blinds)
        print_share(page, sheet->blinds_of_lm83 ? "sDA300/50" : "with blinds",
                    &plane->sda, of, differ ? "reaches" : "reach",
                    "300 lx in at least half of the hours, with blinds");
    print_share(page, "DA300/50 area", &plane->autonomous, of,
                differ ? "reaches" : "reach",
                "300 lx in at least half of the hours, without blinds");
    print_share(page, "ASE1000,250", &plane->ase, of, differ ? "receives" : "receive",
                "more than 1000 lx of direct sun for over 250 h");
    if (!isnan(area_m2)) {
        double sun_h = sheet->mean.sun_h.value;
        if (pp_annual_sheet_has_sun(sheet))
            snprintf(text, sizeof text,
                     "mean over the plane %.0f h; sum over its area %.0f m2 h (%.4g "
                     "m2, hours with more than 1000 lx of direct sun)",
                     sun_h, sun_h * area_m2, area_m2);
        else
            snprintf(text, sizeof text, "not known: the weather has no direct sun");
        print_annual_fact(page, "sun hours", text);
    }
    print_levels(page);
    print_leed(page);
    if (sheet->near_half > 0) {
        snprintf(
            text, sizeof text,
            "at %d point%s the share of hours with 300 lx, without blinds, is within "
            "two standard errors of 50 %%; increase --samples to decide",
            sheet->near_half, sheet->near_half == 1 ? "" : "s");
        print_annual_fact(page, "undecided", text);
    }
}

/* ---- points ---- */

static bool put_column(struct pp_table *table, const struct pp_annual_sheet *sheet,
                       const char *group, const char *heading, int index, double unit,
                       int digits)
{
    struct pp_table_column *column = pp_table_add(table, group, "%", heading);
    if (!column)
        return false;
    for (int x = 0; x <= sheet->receiver_count; x++) {
        struct pp_annual_figures figures =
            x < sheet->receiver_count ? sheet->points[x] : sheet->mean;
        double value = pp_annual_sheet_figure(&figures, index)->value;
        if (isfinite(value))
            snprintf(column->cells[x], PP_CELL_BYTES, "%.*f", digits, unit * value);
        else
            snprintf(column->cells[x], PP_CELL_BYTES, "-");
    }
    return true;
}

static bool put_place(struct pp_table *table, const struct pp_annual_sheet *sheet,
                      int axis)
{
    static const char *const axes[] = {"x", "y", "z"};
    struct pp_table_column *column = pp_table_add(table, NULL, NULL, axes[axis]);
    for (int x = 0; column && x < sheet->receiver_count; x++) {
        struct pp_vec3 at = sheet->receivers[x].position;
        snprintf(column->cells[x], PP_CELL_BYTES, "%.3f",
                 axis == 0   ? at.x
                 : axis == 1 ? at.y
                             : at.z);
    }
    return column != NULL;
}

static bool print_points(const struct text_page *page)
{
    static const char autonomy[] = "autonomy %", useful[] = "useful lx %",
                      light[] = "light";
    const struct pp_annual_sheet *sheet = page->sheet;
    struct pp_table table;
    bool good = true;
    pp_table_init(&table, sheet->receiver_count + 1);
    for (int axis = 0; axis < 3; axis++)
        good = good && put_place(&table, sheet, axis);
    table.key_count = 3;
    table.last_label = "mean";
    for (int i = 0; i < 2 * sheet->illuminance_count && good; i++) {
        char heading[32];
        bool continuous = i % 2 == 1;
        snprintf(heading, sizeof heading, "%s %g", continuous ? "cDA" : "DA",
                 sheet->illuminances_lx[i / 2]);
        good = put_column(&table, sheet, autonomy, heading,
                          pp_annual_result_autonomy(i / 2, continuous), 100.0, 1);
    }
    for (const struct pp_annual_figure_name *n = pp_annual_result_names;
         n->name && good; n++) {
        bool blinds = strcmp(n->name, "blinds-da300") == 0;
        if (!n->title || (blinds && !sheet->has_blinds))
            continue;
        good = put_column(&table, sheet,
                          strncmp(n->name, "udi", 3) == 0 ? useful
                          : blinds                        ? "DA 300 %"
                                                          : light,
                          n->title, n->index, n->unit, n->digits);
    }
    good = good && pp_lighting_text_points(&table, sheet);
    if (good)
        pp_table_print(&table, page->width, page->out);
    pp_table_clear(&table);
    return good;
}

/* Prints the largest standard errors at points, and the standard error of the mean
 * autonomy. */
static void print_errors(const struct text_page *page)
{
    const struct pp_annual_sheet *sheet = page->sheet;
    double autonomy = 0.0, light = 0.0;
    char text[240];
    for (int x = 0; x < sheet->receiver_count; x++) {
        const struct pp_annual_figures *f = &sheet->points[x];
        autonomy = fmax(autonomy, f->autonomy_300.std_error);
        if (f->year_lxh.value > 0.0)
            light = fmax(light, f->year_lxh.std_error / f->year_lxh.value);
    }
    snprintf(text, sizeof text,
             "at most %.2f percentage points of autonomy and %.2f %% of the year's "
             "light at a point; mean autonomy at 300 lx %.2f %% %s %.2f",
             100.0 * autonomy, 100.0 * light, 100.0 * sheet->mean.autonomy_300.value,
             page->utf8 ? "\xC2\xB1" : "+-",
             100.0 * sheet->mean.autonomy_300.std_error);
    print_annual_fact(page, "standard errors", text);
}

static void print_discretisation(const struct text_page *page)
{
    const struct pp_annual_discretisation *d = &page->sheet->discretisation;
    const char *sign = page->utf8 ? "\xC2\xB1" : "+-";
    char text[320];
    if (d->points == 0)
        return;
    snprintf(text, sizeof text,
             "compared with paths under the true sky and sun, for %d point%s in %d "
             "hours: patches change the light from the sky by %+.2f %% %s %.2f (rms "
             "over hours %.2f %%). Patches and cells change all light except direct "
             "sun by %+.1f %% %s %.1f",
             d->points, d->points == 1 ? "" : "s", d->hours, 100.0 * d->sky.value, sign,
             100.0 * d->sky.std_error, 100.0 * d->sky_rms, 100.0 * d->all.value, sign,
             100.0 * d->all.std_error);
    print_annual_fact(page, "discretisation", text);
}

static void print_groups(const struct text_page *page)
{
    const struct pp_annual_sheet *sheet = page->sheet;
    double all = 0.0;
    for (int g = 0; g < sheet->group_count; g++)
        all += sheet->groups[g].light_lxh.value;
    for (int g = 0; g < sheet->group_count && all > 0.0; g++) {
        const struct pp_annual_group *group = &sheet->groups[g];
        char text[320];
        int used = snprintf(text, sizeof text, "%s: %.0f %% of the year's light",
                            group->name, 100.0 * group->light_lxh.value / all);
        if (sheet->has_blinds && used > 0 && used < (int)sizeof text)
            used += snprintf(text + used, sizeof text - (size_t)used,
                             ", %ss closed in %.0f of %.0f h",
                             group->device ? group->device : "blind", group->closed_h,
                             sheet->occupied_h);
        if (group->unmet_h > 0.0 && used > 0 && used < (int)sizeof text)
            snprintf(text + used, sizeof text - (size_t)used,
                     ", but in %.0f h more than 2 %% of the %s 1000 lx of direct sun",
                     group->unmet_h,
                     pp_point_areas_differ(sheet->receivers, sheet->receiver_count)
                         ? "plane still receives"
                         : "points still receive");
        print_annual_fact(page, g == 0 ? "window groups" : "", text);
    }
}

/* Prints the settings of the electric-lighting controls. */
static void print_controls(const struct text_page *page)
{
    for (int k = 0; k < page->sheet->lighting_count; k++) {
        char label[32], text[400];
        snprintf(label, sizeof label, "control %d", k + 1);
        print_annual_fact(page, label,
                          pp_lighting_report_words(text, sizeof text, page->sheet, k));
    }
    char standard[1200];
    if (page->sheet->lighting_count > 0)
        print_annual_fact(
            page, "EN 15193",
            pp_lighting_report_standard(standard, sizeof standard, page->sheet));
}

static bool print_annual_room(const struct pp_annual_result *result, int width,
                              bool utf8, FILE *out)
{
    struct text_page page = {&result->sheet, width, utf8, out};
    const struct pp_annual_sheet *sheet = &result->sheet;
    char text[120];
    pp_print_title(sheet->world, result->file, out);
    print_annual_fact(&page, "weather", sheet->weather);
    print_annual_fact(&page, "hours", sheet->period);
    snprintf(
        text, sizeof text,
        "%.0f h with daylight; median of the 4380 brightest hours: %.0f lx diffuse",
        sheet->daylit_h, sheet->diffuse_median_lx);
    print_annual_fact(&page, "daylight", text);
    print_annual_fact(&page, "records", sheet->notes);
    print_annual_fact(&page, "calculation", sheet->method);
    print_annual_fact(&page, "blinds", sheet->blinds);
    for (int i = 0; i < sheet->warning_count; i++)
        print_annual_fact(&page, "warning", sheet->warnings[i]);
    if (!sheet->finished) {
        print_annual_fact(&page, "unfinished", "interrupted: no figures are available");
        return true;
    }
    fputc('\n', out);
    print_plane(&page);
    print_errors(&page);
    print_discretisation(&page);
    print_groups(&page);
    print_controls(&page);
    fputc('\n', out);
    if (sheet->lighting_count > 0) {
        if (!pp_lighting_text_table(sheet, width, out))
            return false;
        fputc('\n', out);
    }
    return print_points(&page)
           && pp_hand_year_report_text(&result->hand, sheet, width, utf8, out);
}

enum pp_status pp_annual_text(const struct pp_annual_results *results, int width,
                              bool utf8, FILE *out, struct pp_error *err)
{
    for (int i = 0; i < results->count; i++) {
        if (i > 0)
            fputc('\n', out);
        if (!print_annual_room(&results->list[i], width, utf8, out))
            return pp_fail_memory(err);
    }
    return PP_OK;
}
