/* band_pages.c - prints the regimes of each column as rows of a table. */
#include "reports/atlas/band_pages.h"

#include <math.h>
#include <string.h>

#include "model/base/text.h"
#include "studies/bands/band_table.h"
#include "studies/bands/band_words.h"

enum { CELL = 64, REGIME = 400 };

static const char *const titles[PP_COMPONENT_COUNT] = {
    [PP_SC] = "sky component",
    [PP_ERC] = "externally reflected component",
    [PP_IRC] = "internally reflected component",
    [PP_DF] = "daylight factor",
};

static void put_introduction(FILE *out)
{
    fprintf(
        out,
        "# Accuracy of the hand methods\n\nResults of the shipped runs of the atlas: "
        "%d designed rooms under an overcast sky and\n%d under the other skies of ISO "
        "15469. Tables show the ratio of the simulated value to\nthat of a method, by "
        "regime. `pepperpot atlas --accuracy` prints these pages. `df`,\n`assess` and "
        "`size` take their bands from the same tables.\n\n- *rooms*: rooms with points "
        "in the regime.\n- *bias*: median error of the method, relative to the "
        "simulated value.\n- *spread*: half the distance between the ratio's quantiles "
        "of 16 and 84 %%.\n- *band*: 95 %% of the simulated values lie between these "
        "multiples of the method's value.\n- *formula*, *assumption*: the two parts of "
        "the band. *formula* compares the figure with the\n  value simulated in the "
        "world that the method assumes. *assumption* compares that value with\n  the "
        "one simulated in the room (see docs/accuracy.md).\n\nA ratio is (simulated + "
        "%g %%) / (figure + %g %%), which widens the bands of small figures.\nEach "
        "room counts once, however many of its points are in a regime.\n",
        pp_band_table_rooms(&pp_band_table_overcast),
        pp_band_table_rooms(&pp_band_table_iso), 100.0 * PP_BAND_OFFSET,
        100.0 * PP_BAND_OFFSET);
}

/* Writes a band, such as "0.85 to 1.02", or a dash. */
static void write_band(char cell[CELL], const struct pp_band_quantiles *ratio)
{
    if (isfinite(ratio->low))
        snprintf(cell, CELL, "%.2f to %.2f", ratio->low, ratio->high);
    else
        snprintf(cell, CELL, "-");
}

static void put_band_row(const struct pp_band_entry *entry, FILE *out)
{
    char words[REGIME], band[CELL], formula[CELL], assumption[CELL];
    pp_band_words_regime(words, sizeof words, &entry->regime);
    write_band(band, &entry->regime.ratio);
    write_band(formula, &entry->formula);
    write_band(assumption, &entry->assumption);
    fprintf(out, "| %s | %d | %+.0f %% | %.2f | %s | %s | %s |\n", words,
            entry->regime.rooms, 100.0 / entry->regime.ratio.median - 100.0,
            entry->spread, band, formula, assumption);
}

static void put_head(const struct pp_band_record *record, FILE *out)
{
    fprintf(out,
            "\n### %s: %s %s\n\n"
            "| regime | rooms | bias | spread | band | formula | assumption |\n"
            "| --- | --- | --- | --- | --- | --- | --- |\n",
            record->column, titles[record->component],
            record->place == PP_BAND_AVERAGE ? "on average" : "at points");
}

static bool same_band_entry(const struct pp_band_record *a,
                            const struct pp_band_record *b)
{
    return a->place == b->place && a->component == b->component
           && strcmp(a->column, b->column) == 0;
}

/* Prints the bands of one component. skies: description of the skies in the atlas of
 * the table. */
static void put_component(enum pp_component component,
                          const struct pp_band_table *table, const char *skies,
                          FILE *out)
{
    struct pp_band_record record, last = {.column = ""};
    fprintf(out, "\n## %c%s, %s\n", titles[component][0] - 'a' + 'A',
            titles[component] + 1, skies);
    for (int i = 0; pp_band_table_at(&record, table, i); i++) {
        if (record.component != component)
            continue;
        if (!same_band_entry(&record, &last))
            put_head(&record, out);
        put_band_row(&record.entry, out);
        last = record;
    }
}

void pp_band_pages(FILE *out)
{
    static const enum pp_component order[] = {PP_DF, PP_SC, PP_ERC, PP_IRC};
    put_introduction(out);
    for (int i = 0; i < PP_COMPONENT_COUNT; i++)
        put_component(order[i], &pp_band_table_overcast, "overcast sky", out);
    for (int i = 0; i < PP_COMPONENT_COUNT; i++)
        put_component(order[i], &pp_band_table_iso, "skies of ISO 15469", out);
}
