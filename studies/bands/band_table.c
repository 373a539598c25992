/* band_table.c - rows of the printed table, turned into records. */
#include "studies/bands/band_table.h"

#include <math.h>
#include <string.h>

/* As the CSV file has them. */
struct row {
    const char *place, *component, *column; /* place "span": of the feature `column` */
    int rooms;
    double low, median, high, spread;
    double formula_low, formula_median, formula_high;
    double assumption_low, assumption_median, assumption_high;
    const char *feature1;
    double from1, to1;
    const char *feature2;
    double from2, to2;
    const char *feature3;
    double from3, to3;
    const char *feature4;
    double from4, to4;
    const char *feature5;
    double from5, to5;
};

static const struct row rows[] = {
#include "tables/atlas_bands.inc"
};

enum { ROWS = sizeof rows / sizeof *rows };

/* ---- records ---- */

static bool is_record(const struct row *row)
{
    return strcmp(row->place, "span") != 0;
}

static void add_condition(struct pp_band_regime *regime, const char *feature,
                          double from, double to)
{
    if (strcmp(feature, "-") != 0)
        regime->conditions[regime->condition_count++] = (struct pp_band_condition){
            pp_band_features_find(feature), isnan(from) ? -INFINITY : from,
            isnan(to) ? INFINITY : to};
}

static struct pp_band_record record_of(const struct row *row)
{
    struct pp_band_record record = {
        .place = strcmp(row->place, pp_band_figures_places[PP_BAND_AVERAGE]) == 0
                     ? PP_BAND_AVERAGE
                     : PP_BAND_POINT,
        .column = row->column,
        .entry = {.regime = {.ratio = {row->low, row->median, row->high},
                             .rooms = row->rooms},
                  .spread = row->spread,
                  .formula = {row->formula_low, row->formula_median, row->formula_high},
                  .assumption = {row->assumption_low, row->assumption_median,
                                 row->assumption_high}}};
    for (int i = 0; i < PP_COMPONENT_COUNT; i++)
        if (strcmp(row->component, pp_band_features_components[i]) == 0)
            record.component = (enum pp_component)i;
    struct pp_band_regime *regime = &record.entry.regime;
    add_condition(regime, row->feature1, row->from1, row->to1);
    add_condition(regime, row->feature2, row->from2, row->to2);
    add_condition(regime, row->feature3, row->from3, row->to3);
    add_condition(regime, row->feature4, row->from4, row->to4);
    add_condition(regime, row->feature5, row->from5, row->to5);
    return record;
}

bool pp_band_table_at(struct pp_band_record *record, int index)
{
    for (int i = 0; i < ROWS; i++)
        if (is_record(&rows[i]) && index-- == 0) {
            *record = record_of(&rows[i]);
            return true;
        }
    return false;
}

int pp_band_table_find(struct pp_band_record records[PP_BAND_REGIMES],
                       enum pp_band_place place, enum pp_component component,
                       const char *column)
{
    int count = 0;
    for (int i = 0; i < ROWS && count < PP_BAND_REGIMES; i++)
        if (strcmp(rows[i].column, column) == 0
            && strcmp(rows[i].place, pp_band_figures_places[place]) == 0
            && strcmp(rows[i].component, pp_band_features_components[component]) == 0)
            records[count++] = record_of(&rows[i]);
    return count;
}

const struct pp_band_record *pp_band_table_regime(const struct pp_band_record *records,
                                                  int count, const double *features)
{
    for (int i = 0; i < count; i++)
        if (pp_band_regime_holds(&records[i].entry.regime, features))
            return &records[i];
    return NULL;
}

/* ---- the run ---- */

bool pp_band_table_span(double *from, double *to, int feature)
{
    for (int i = 0; i < ROWS; i++)
        if (!is_record(&rows[i])
            && strcmp(rows[i].column, pp_band_features_name(feature)) == 0) {
            *from = rows[i].low;
            *to = rows[i].high;
            return true;
        }
    return false;
}

int pp_band_table_rooms(void)
{
    int most = 0;
    for (int i = 0; i < ROWS; i++)
        most = rows[i].rooms > most ? rows[i].rooms : most;
    return most;
}
