/* band_table.c - converts rows of the compiled-in tables to records. */
#include "studies/bands/band_table.h"

#include <assert.h>
#include <math.h>
#include <string.h>

#include "model/base/text.h"

/* Row of the CSV file of a band table. Texts are arrays, because pointers would require
 * 12,000 relocations at every start of the program. */
struct row {
    char place[8], component[4], column[28]; /* place "span": the row has the range of
                                              * the feature `column` */
    int rooms;
    double low, median, high, spread;
    double formula_low, formula_median, formula_high;
    double assumption_low, assumption_median, assumption_high;
    char feature1[16];
    double from1, to1;
    char feature2[16];
    double from2, to2;
    char feature3[16];
    double from3, to3;
    char feature4[16];
    double from4, to4;
    char feature5[16];
    double from5, to5;
};

static const struct row overcast_rows[] = {
#include "tables/atlas_bands.inc"
};
static const struct row iso_rows[] = {
#include "tables/atlas_bands_iso.inc"
};

struct pp_band_table {
    const struct row *rows;
    int count;
};
const struct pp_band_table pp_band_table_overcast = {
    overcast_rows, sizeof overcast_rows / sizeof *overcast_rows};
const struct pp_band_table pp_band_table_iso = {iso_rows,
                                                sizeof iso_rows / sizeof *iso_rows};

/* Type 1 of ISO 15469 is the overcast sky. */
const struct pp_band_table *pp_band_table_under(const struct pp_sky *sky)
{
    switch (sky->kind) {
    case PP_SKY_OVERCAST:
        return &pp_band_table_overcast;
    case PP_SKY_ISO:
        return sky->iso == 1  ? &pp_band_table_overcast
               : sky->iso > 1 ? &pp_band_table_iso
                              : NULL;
    default:
        return NULL;
    }
}

/* ---- records ---- */

static bool is_record(const struct row *row)
{
    return strcmp(row->place, "span") != 0;
}

/* Adds the next condition to a regime. The condition at the same position in an earlier
 * row usually has the same feature, which is tried first. */
static void add_condition(struct pp_band_regime *regime,
                          const struct pp_band_regime *before, const char *name,
                          double from, double to)
{
    if (pp_text_is_same(name, "-"))
        return;
    int place = regime->condition_count++;
    int feature =
        place < before->condition_count ? before->conditions[place].feature : -1;
    if (feature < 0 || !pp_text_is_same(pp_band_features_name(feature), name))
        feature = pp_band_features_find(name);
    regime->conditions[place] = (struct pp_band_condition){
        feature, isnan(from) ? -INFINITY : from, isnan(to) ? INFINITY : to};
}

/* Converts a row to a record. before: the record of an earlier row, or zeros. */
static struct pp_band_record record_of(const struct row *row,
                                       const struct pp_band_record *before)
{
    const struct pp_band_regime *other = &before->entry.regime;
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
    add_condition(regime, other, row->feature1, row->from1, row->to1);
    add_condition(regime, other, row->feature2, row->from2, row->to2);
    add_condition(regime, other, row->feature3, row->from3, row->to3);
    add_condition(regime, other, row->feature4, row->from4, row->to4);
    add_condition(regime, other, row->feature5, row->from5, row->to5);
    return record;
}

bool pp_band_table_at(struct pp_band_record *record, const struct pp_band_table *table,
                      int index)
{
    for (int i = 0; i < table->count; i++)
        if (is_record(&table->rows[i]) && index-- == 0) {
            static const struct pp_band_record none;
            *record = record_of(&table->rows[i], &none);
            return true;
        }
    return false;
}

static bool is_of(const struct row *row, enum pp_component component,
                  const char *column)
{
    return pp_text_is_same(row->column, column)
           && strcmp(row->component, pp_band_features_components[component]) == 0;
}

/* Uses the fact that the rows of a column are adjacent. */
void pp_band_table_index(struct pp_band_index *index, const struct pp_band_table *table)
{
    const struct row *last = NULL;
    *index = (struct pp_band_index){.table = table};
    for (int i = 0; i < table->count; i++) {
        const struct row *row = &table->rows[i];
        if (!is_record(row)
            || (last && strcmp(row->column, last->column) == 0
                && strcmp(row->component, last->component) == 0))
            continue;
        assert(index->count < PP_BAND_COLUMNS);
        index->first[index->count++] = i;
        last = row;
    }
}

void pp_band_table_find(struct pp_band_regimes *regimes,
                        const struct pp_band_index *index, enum pp_component component,
                        const char *column)
{
    const struct row *rows = index->table->rows;
    int i = 0, end = index->table->count;
    memset(regimes->count, 0, sizeof regimes->count);
    while (i < index->count && !is_of(&rows[index->first[i]], component, column))
        i++;
    int first = i < index->count ? index->first[i] : end;
    struct pp_band_record record = {0};
    for (int k = first; k < end && is_of(&rows[k], component, column); k++) {
        record = record_of(&rows[k], &record);
        int *count = &regimes->count[record.place];
        if (*count < PP_BAND_REGIMES)
            regimes->records[record.place][(*count)++] = record;
    }
}

const struct pp_band_record *pp_band_table_regime(const struct pp_band_regimes *regimes,
                                                  enum pp_band_place place,
                                                  const double *features)
{
    const struct pp_band_record *records = regimes->records[place];
    for (int i = 0; i < regimes->count[place]; i++)
        if (pp_band_regime_holds(&records[i].entry.regime, features))
            return &records[i];
    return NULL;
}

/* ---- properties of the atlas ---- */

bool pp_band_table_span(double *from, double *to, const struct pp_band_table *table,
                        int feature)
{
    for (int i = 0; i < table->count; i++) {
        const struct row *row = &table->rows[i];
        if (!is_record(row)
            && strcmp(row->column, pp_band_features_name(feature)) == 0) {
            *from = row->low;
            *to = row->high;
            return true;
        }
    }
    return false;
}

int pp_band_table_rooms(const struct pp_band_table *table)
{
    int most = 0;
    for (int i = 0; i < table->count; i++)
        most = table->rows[i].rooms > most ? table->rows[i].rooms : most;
    return most;
}
