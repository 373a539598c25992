/* year_section.c - see year_section.h. */
#include "reports/page/year_section.h"

#include <math.h>
#include <stdio.h>

#include "studies/lighting/lighting_control.h"

#include "model/room/world.h"

/* Adds a row with a value and its standard error. format, error_format: printf formats
 * of both. */
static void put_value(struct pp_document *document, const char *name, double value,
                      double std_error, const char *format, const char *error_format,
                      const char *unit)
{
    pp_document_row(document, PP_ROW_CELLS);
    pp_document_cell(document, PP_TONE_PLAIN, "%s", name);
    if (isnan(value)) {
        pp_document_cell(document, PP_TONE_PLAIN, "–");
        return;
    }
    pp_document_cell(document, PP_TONE_PLAIN, format, value);
    pp_document_cell(document, PP_TONE_PLAIN, error_format, std_error);
    pp_document_cell(document, PP_TONE_PLAIN, "%s", unit);
}

static void put_year_share(struct pp_document *document, const char *name,
                           const struct pp_annual_value *value)
{
    put_value(document, name, 100.0 * value->value, 100.0 * value->std_error, "%.1f",
              "%.2f", "%");
}

static void put_group(struct pp_document *document, const char *words)
{
    pp_document_row(document, PP_ROW_GROUP);
    pp_document_cell(document, PP_TONE_PLAIN, "%s", words);
}

static void put_plane(struct pp_document *document, const struct pp_annual_sheet *year)
{
    static const char *const levels[PP_ANNUAL_LEVELS] = {
        "EN 17037, method 2: 100 lx", "EN 17037, method 2: 300 lx",
        "EN 17037, method 2: 500 lx", "EN 17037, method 2: 750 lx"};
    put_group(document, "Shares of the points");
    put_year_share(document, "sDA300/50, with blinds", &year->plane.sda);
    put_year_share(document, "DA300/50 area, without blinds", &year->plane.autonomous);
    put_year_share(document, "ASE1000,250", &year->plane.ase);
    for (int i = 0; i < PP_ANNUAL_LEVELS; i++)
        put_year_share(document, levels[i], &year->plane.level[i]);
}

static void put_means(struct pp_document *document, const struct pp_annual_sheet *year)
{
    const struct pp_annual_figures *mean = &year->mean;
    put_group(document, "Means of the points, without blinds");
    put_year_share(document, "DA300, share of the hours with 300 lx",
                   &mean->autonomy_300);
    put_year_share(document, "UDI, 300 to 3000 lx", &mean->udi_good);
    put_year_share(document, "UDI, above 3000 lx", &mean->udi_above);
    put_value(document, "hours with more than 1000 lx of direct sun", mean->sun_h.value,
              mean->sun_h.std_error, "%.0f", "%.0f", "h");
    put_value(document, "mean illuminance in these hours", mean->mean_lx.value,
              mean->mean_lx.std_error, "%.0f", "%.1f", "lx");
    put_value(document, "light exposure of the year", mean->year_lxh.value / 1000.0,
              mean->year_lxh.std_error / 1000.0, "%.0f", "%.1f", "klx h");
}

static void put_groups(struct pp_document *document, const struct pp_annual_sheet *year)
{
    put_group(document, "Hours with closed blinds");
    for (int g = 0; g < year->group_count; g++)
        put_value(document, year->groups[g].name, year->groups[g].closed_h, 0.0, "%.0f",
                  "%.0f", "h");
}

/* Adds the electric light with ideal controls. */
static void put_year_lighting(struct pp_document *document,
                              const struct pp_annual_sheet *year)
{
    char group[120];
    snprintf(group, sizeof group,
             "Electric light saved in these hours, for %g lx at the darkest point, "
             "without blinds",
             year->lighting[0].control.target_lx);
    put_group(document, group);
    for (int k = 0; k < year->lighting_count; k++) {
        const struct pp_lighting_sheet *of = &year->lighting[k];
        char name[80];
        enum pp_lighting_kind kind = of->control.kind;
        snprintf(name, sizeof name, "%s%s", pp_lighting_control_name(kind),
                 kind == PP_LIGHTING_MANUAL ? ", on at arrival as observed by Hunt"
                                            : "");
        put_year_share(document, name, &of->figures.saved);
        if (kind != PP_LIGHTING_DIMMED)
            continue;
        put_year_share(document, "dimmed, separate lamps at all points", &of->mean);
    }
}

static void put_assumption(struct pp_document *document, const char *name,
                           const char *words)
{
    if (!words[0])
        return;
    pp_document_row(document, PP_ROW_CELLS);
    pp_document_cell(document, PP_TONE_PLAIN, "%s", name);
    pp_document_cell(document, PP_TONE_PLAIN, "%s", words);
}

static void begin_assumptions(struct pp_document *document)
{
    pp_document_table(document);
    pp_document_column(document, PP_COLUMN_LABELS, "%s", "");
    pp_document_column(document, PP_COLUMN_WORDS, "%s", "");
}

void pp_year_section(struct pp_document *document, const struct pp_annual_sheet *year)
{
    pp_document_heading(document, 3, "Daylight in every hour of a year, simulated");
    pp_document_table(document);
    pp_document_column(document, PP_COLUMN_LABELS, "%s", "");
    pp_document_column(document, PP_COLUMN_NUMBERS, "figure");
    pp_document_column(document, PP_COLUMN_NUMBERS, "standard error");
    pp_document_column(document, PP_COLUMN_WORDS, "%s", "");
    if (year->is_grid)
        put_plane(document, year);
    put_means(document, year);
    if (year->has_blinds)
        put_groups(document, year);
    if (year->lighting_count > 0)
        put_year_lighting(document, year);
    if (!year->is_grid)
        pp_document_paragraph(
            document, PP_TONE_SOFT,
            "The points do not form a grid, so there are no shares of "
            "the plane.");
    begin_assumptions(document);
    put_assumption(document, "weather", year->weather);
    put_assumption(document, "hours", year->period);
    put_assumption(document, "records", year->notes);
    put_assumption(document, "calculation", year->method);
    put_assumption(document, "blinds", year->blinds);
    for (int i = 0; i < year->warning_count; i++)
        put_assumption(document, "warning", year->warnings[i]);
}

/* ---- all rooms of a short report ---- */

/* Adds a cell such as "83.3 ± 0.42"; a dash for NAN. */
static void put_figure(struct pp_document *document,
                       const struct pp_annual_value *figure, double factor,
                       int decimals)
{
    if (isnan(figure->value))
        pp_document_cell(document, PP_TONE_PLAIN, "–");
    else
        pp_document_cell(document, PP_TONE_PLAIN, "%.*f ± %.*f", decimals,
                         factor * figure->value, decimals + 1,
                         factor * figure->std_error);
}

static void put_year_row(struct pp_document *document,
                         const struct pp_annual_sheet *year)
{
    static const struct pp_annual_value none = {NAN, NAN};
    const struct pp_annual_value *shares[] = {year->is_grid ? &year->plane.sda : &none,
                                              year->is_grid ? &year->plane.ase : &none,
                                              &year->mean.autonomy_300,
                                              &year->mean.udi_good};
    const char *name = year->world ? year->world->name : NULL;
    pp_document_row(document, PP_ROW_CELLS);
    pp_document_cell(document, PP_TONE_PLAIN, "%s", name ? name : "Room");
    for (size_t i = 0; i < sizeof shares / sizeof *shares; i++)
        put_figure(document, year->finished ? shares[i] : &none, 100.0, 1);
    put_figure(document, year->finished ? &year->mean.sun_h : &none, 1.0, 0);
    put_figure(document, year->finished ? &year->mean.mean_lx : &none, 1.0, 0);
}

void pp_year_section_rooms(struct pp_document *document,
                           const struct pp_annual_sheet *const *years, int count)
{
    static const char *const heads[] = {"sDA300/50, %", "ASE1000,250, %", "DA300, %",
                                        "UDI, %",       "sun, h",         "mean, lx"};
    pp_document_heading(document, 2, "Daylight in every hour of a year, simulated");
    pp_document_table(document);
    pp_document_column(document, PP_COLUMN_WORDS, "room");
    for (size_t i = 0; i < sizeof heads / sizeof *heads; i++)
        pp_document_column(document, PP_COLUMN_NUMBERS, "%s", heads[i]);
    for (int i = 0; i < count; i++)
        put_year_row(document, years[i]);
    pp_document_paragraph(document, PP_TONE_SOFT,
                          "sDA, ASE: shares of the points, sDA with blinds. The other "
                          "figures are means of "
                          "the points without blinds: DA300: share of the hours with "
                          "300 lx; UDI: with 300 "
                          "to 3000 lx; sun: hours with more than 1000 lx of direct "
                          "sun. ±: standard error.");
    begin_assumptions(document);
    put_assumption(document, "weather", years[0]->weather);
    put_assumption(document, "hours", years[0]->period);
    put_assumption(document, "records", years[0]->notes);
    put_assumption(document, "blinds", years[0]->blinds);
    for (int i = 0; i < count; i++)
        for (int k = 0; k < years[i]->warning_count; k++)
            put_assumption(document,
                           years[i]->world && years[i]->world->name
                               ? years[i]->world->name
                               : "warning",
                           years[i]->warnings[k]);
}
