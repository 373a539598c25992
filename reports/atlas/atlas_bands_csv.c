/* atlas_bands_csv.c - writes the bands of an atlas, one per line, to four digits. */
#include "reports/atlas/atlas_bands_csv.h"

#include <math.h>

/* Number of conditions at the end of each row. */
enum { CONDITIONS = PP_BAND_CONDITIONS };

static void put_number(double value, FILE *out)
{
    if (isfinite(value))
        fprintf(out, ",%.4g", value + 0.0);
    else
        fputc(',', out);
}

static void put_quantiles(const struct pp_band_quantiles *quantiles, FILE *out)
{
    put_number(quantiles->low, out);
    put_number(quantiles->median, out);
    put_number(quantiles->high, out);
}

static void put_head(const struct pp_atlas_bands *bands, FILE *out)
{
    fprintf(
        out,
        "# atlas_bands%s.csv - accuracy of the hand methods by regimes of rooms:\n#   "
        "quantiles of (simulated + %g) / (hand + %g), daylight factors as "
        "fractions\n# source: own, `pepperpot atlas FILE --bands` over %d rooms of "
        "the atlas under %s\n# place: the figures are at points, or are averages; "
        "span: this line shows the lowest\n#   (low) and the highest (high) value of "
        "the feature that is named under column\n# component, column: component and "
        "method of the figure; rooms: number in the regime\n# low, median, high: "
        "quantiles of 2.5, 50 and 97.5 %%; spread: half the distance between\n#   "
        "those of 16 and 84 %%; formula: the value simulated in the room that the "
        "method\n#   assumes, divided by the hand value; assumption: the value "
        "simulated in the real\n#   room, divided by the value simulated in the "
        "assumed room\n# feature1 to 5: the regime is from <= feature < to; empty: no "
        "bound\n",
        bands->iso ? "_iso" : "", PP_BAND_OFFSET, PP_BAND_OFFSET, bands->rooms,
        bands->iso ? "the skies of ISO 15469" : "the overcast sky");
    fputs("place,component,column,rooms,low,median,high,spread,formula_low,"
          "formula_median,formula_high,assumption_low,assumption_median,"
          "assumption_high",
          out);
    for (int i = 1; i <= CONDITIONS; i++)
        fprintf(out, ",feature%d,from%d,to%d", i, i, i);
    fputc('\n', out);
}

static void put_conditions(const struct pp_band_regime *regime, FILE *out)
{
    for (int i = 0; i < CONDITIONS; i++) {
        if (i >= regime->condition_count) {
            fputs(",-,,", out);
            continue;
        }
        const struct pp_band_condition *condition = &regime->conditions[i];
        fprintf(out, ",%s", pp_band_features_name(condition->feature));
        put_number(condition->from, out);
        put_number(condition->to, out);
    }
    fputc('\n', out);
}

/* Writes the span of a feature; writes nothing if the atlas does not contain the
 * feature. */
static void put_span(int feature, const struct pp_atlas_bands *bands, FILE *out)
{
    const struct pp_atlas_span *span = &bands->spans[feature];
    if (!isfinite(span->from))
        return;
    const struct pp_band_regime none = {.condition_count = 0};
    fprintf(out, "span,-,%s,%d", pp_band_features_name(feature), bands->rooms);
    put_number(span->from, out);
    fputc(',', out);
    put_number(span->to, out);
    fputs(",,,,,,,", out);
    put_conditions(&none, out);
}

static void put_entry(const struct pp_atlas_column *column,
                      const struct pp_band_entry *entry, FILE *out)
{
    fprintf(out, "%s,%s,%s,%d", pp_band_figures_places[column->place],
            column->component, column->name, entry->regime.rooms);
    put_quantiles(&entry->regime.ratio, out);
    put_number(entry->spread, out);
    put_quantiles(&entry->formula, out);
    put_quantiles(&entry->assumption, out);
    put_conditions(&entry->regime, out);
}

void pp_atlas_bands_csv(const struct pp_atlas_bands *bands, FILE *out)
{
    put_head(bands, out);
    for (int f = 0; f < PP_ROOM_FEATURES; f++)
        put_span(f, bands, out);
    for (int i = 0; i < bands->column_count; i++)
        for (int k = 0; k < bands->columns[i].entry_count; k++)
            put_entry(&bands->columns[i], &bands->columns[i].entries[k], out);
}
