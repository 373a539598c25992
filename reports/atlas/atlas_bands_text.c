/* atlas_bands_text.c - prints the tests of bands, column by column. */
#include "reports/atlas/atlas_bands_text.h"

#include <math.h>

#include "studies/bands/band_words.h"

enum { WORDS = 400 };

static void put_trial(const struct pp_band_trial *trial, FILE *out)
{
    const struct pp_band_regime *regime = &trial->entry.regime;
    char words[WORDS];
    pp_band_words_regime(words, sizeof words, regime);
    fprintf(out, "  %6d %6d  %5.1f %%  95 +- %3.1f  %-7s %5.2f %5.2f %5.2f  %s\n",
            regime->rooms, trial->rooms, 100.0 * trial->inside, 100.0 * trial->limit,
            pp_atlas_bands_is_outside(trial) ? "OUTSIDE" : "inside", regime->ratio.low,
            regime->ratio.median, regime->ratio.high, words);
}

/* Numbers of regimes, of regimes outside their tolerance, and of columns. inside: sum
 * over the columns of the fraction of figures inside their bands. */
struct sum {
    int regimes, outside, columns;
    double inside;
};

static void put_column(const struct pp_atlas_column *column, struct sum *sum, FILE *out)
{
    fprintf(out, "\n%s by %s: %.1f %% of the test figures were inside their bands\n",
            column->component, column->name, 100.0 * column->inside);
    fprintf(out, "  %s\n",
            column->place == PP_BAND_AVERAGE ? "averages over the working plane"
                                             : "at points");
    fputs("  fitted tested   inside       may be  verdict   2.5 %  50 %  97.5 %\n",
          out);
    for (int i = 0; i < column->trial_count; i++) {
        put_trial(&column->trials[i], out);
        sum->outside += pp_atlas_bands_is_outside(&column->trials[i]);
    }
    sum->regimes += column->trial_count;
    sum->columns++;
    sum->inside += column->inside;
}

void pp_atlas_bands_text(const struct pp_atlas_bands *bands, FILE *out)
{
    struct sum sum = {0};
    fprintf(out,
            "Bands from one half of %d rooms, tested on the other half; ratios of "
            "simulated to hand values\n",
            bands->rooms);
    for (int i = 0; i < bands->column_count; i++)
        if (bands->columns[i].trial_count > 0)
            put_column(&bands->columns[i], &sum, out);
    fprintf(
        out,
        "\n%d columns, %d regimes, %d outside; %.1f %% of figures inside their bands\n",
        sum.columns, sum.regimes, sum.outside,
        sum.columns > 0 ? 100.0 * sum.inside / sum.columns : NAN);
}
