/* fit_formulae.c - finds and fits the formulae of methods/fitted/ to traced rooms.
 *
 *     fit_formulae FILE           fits the shipped forms, with the uncertainty of every
 *                                 constant, and their errors on held-out rooms
 *     fit_formulae FILE search    searches among sources, shapes, ranges and terms
 *
 * FILE has the format of tests/lib/traced_rooms.h. Rooms with even numbers are used for
 * fit and search, with four-fold cross-validation by room. Rooms with odd numbers are
 * held out and only used for the printed errors. Uncertainties are half the difference
 * between the 16th and 84th percentiles of refits to rooms drawn with replacement.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/fit_forms.h"
#include "bench/fit_model.h"
#include "bench/fit_rooms.h"
#include "simulate/sampling/hash.h"

enum { FOLDS = 4, REFITS = 100 };

/* Selects the rows of a fit that leaves out one fold. */
static void leave_out(int fold, const struct pp_fit_rooms *rooms, int *times)
{
    for (int i = 0; i < rooms->count; i++) {
        int room = rooms->rows[i].room;
        times[i] = room % 2 == 0 && room / 2 % FOLDS != fold;
    }
}

/* RMS of ln(fitted/traced) in the left-out folds, weighted as in the fit. The search
 * minimises this value. */
static double held_out(struct pp_fit_model *model, const struct pp_fit_rooms *rooms,
                       int *times)
{
    double sum = 0.0, weight = 0.0;
    bool averages = model->shape == PP_FIT_EVEN && model->side == PP_FIT_ALIKE;
    for (int fold = 0; fold < FOLDS; fold++) {
        struct pp_fit_model tried = *model;
        leave_out(fold, rooms, times);
        pp_fit_model_fit(&tried, rooms, times);
        for (int i = 0; i < rooms->count; i++) {
            const struct pp_fit_row *row = rooms->rows + i;
            double truth = model->of_df ? row->df : row->irc;
            if (row->room % 2 || times[i] || row->average != averages)
                continue;
            double off = log(pp_fit_model_value(&tried, row) / truth);
            double w = row->weight * row->weight * (row->dark ? 2.25 : 1.0);
            if (!isfinite(off))
                continue;
            sum += w * off * off;
            weight += w;
        }
        *model = tried;
    }
    return sqrt(sum / weight);
}

static void print_model(const struct pp_fit_model *model)
{
    const double *value = model->value;
    if (model->shape != PP_FIT_EVEN)
        printf("  k %.3f", value[PP_FIT_DEPTH_K]);
    if (model->side != PP_FIT_ALIKE)
        printf("  s %.3f", value[PP_FIT_SIDE_S]);
    if (model->source >= PP_FIT_SPHERE_NOW)
        printf("  c %.3f  b %.3f  g %.3f", value[PP_FIT_START_C], value[PP_FIT_SHADE_B],
               value[PP_FIT_SHADE_G]);
    if (model->upward)
        printf("  u %.3f", value[PP_FIT_UPWARD_U]);
    for (int j = 0; j < model->count; j++)
        printf("  %s %.3f", pp_fit_forms_terms[model->terms[j]],
               value[PP_FIT_FIRST_TERM + j]);
    puts("");
}

/* ---- the search ---- */

/* Compares sources and shapes. Each source gets a fitted scale factor, so that only its
 * form matters. */
static void search_shapes(const struct pp_fit_rooms *rooms, int *times)
{
    for (int source = 0; source < PP_FIT_SOURCES; source++)
        for (int shape = 1; shape < PP_FIT_SHAPES; shape++)
            for (int side = 0; side < PP_FIT_SIDES; side++) {
                if (source == PP_FIT_DF || source == PP_FIT_DF_NOW)
                    continue;
                struct pp_fit_model model = {.source = source,
                                             .shape = shape,
                                             .power = 0.5,
                                             .side = side,
                                             .count = 1,
                                             .terms = {PP_FIT_ONE},
                                             .value = {1.3, 0.4, 0.8, 0.5, 0.4}};
                double error = held_out(&model, rooms, times);
                printf("%.4f  %s, %s, %s:", error, pp_fit_forms_sources[source],
                       pp_fit_forms_shapes[shape], pp_fit_forms_sides[side]);
                print_model(&model);
            }
}

static void search_ranges(const struct pp_fit_rooms *rooms, int *times)
{
    static const double powers[] = {0.0, 0.25, 0.5, 1.0};
    for (int range = 0; range < PP_FIT_RANGES; range++)
        for (int k = 0; k < 4; k++) {
            struct pp_fit_model model = pp_fit_forms_shipped[0].model;
            model.range = range;
            model.power = powers[k];
            double error = held_out(&model, rooms, times);
            printf("%.4f  irc-atlas with the range %s, (1 - R)^%.2f:", error,
                   pp_fit_forms_ranges[range], powers[k]);
            print_model(&model);
        }
}

enum { DARK, ELSEWHERE, AVERAGES, PLACES };
static const char *const place_names[PLACES] = {"darkest quarter", "elsewhere",
                                                "averages"};

static int place_of(const struct pp_fit_row *row)
{
    return row->average ? AVERAGES : row->dark ? DARK : ELSEWHERE;
}

/* Fits the model with each fold left out. Adds its errors on the left-out rooms, and
 * those of a printed formula. `first`: a model that is fitted before and supplies the
 * position factors of `model`; may be NULL. */
static void note_left_out(struct pp_fit_error ours[PLACES],
                          struct pp_fit_error theirs[PLACES],
                          struct pp_fit_model *model, struct pp_fit_model *first,
                          enum pp_fit_source printed, const struct pp_fit_rooms *rooms,
                          int *times)
{
    const struct pp_fit_model print = {.source = printed};
    for (int fold = 0; fold < FOLDS; fold++) {
        leave_out(fold, rooms, times);
        if (first) {
            pp_fit_model_fit(first, rooms, times);
            memcpy(model->value, first->value, PP_FIT_UPWARD_U * sizeof(double));
            model->held = true;
        }
        pp_fit_model_fit(model, rooms, times);
        struct pp_fit_model placed = *model;
        if (first) {
            placed.shape = first->shape;
            placed.side = first->side;
            placed.power = first->power;
        }
        for (int i = 0; i < rooms->count; i++) {
            const struct pp_fit_row *row = rooms->rows + i;
            if (row->room % 2 || times[i])
                continue;
            int place = place_of(row);
            pp_fit_model_note(ours + place, pp_fit_model_value(&placed, row), row->irc);
            pp_fit_model_note(theirs + place, pp_fit_model_value(&print, row),
                              row->irc);
        }
    }
}

/* Prints three errors on left-out rooms, each divided by the error of a printed
 * formula: of the log ratio, of the relative deviation, and of the daylight factor. */
static void print_against(struct pp_fit_model *model, struct pp_fit_model *first,
                          enum pp_fit_source printed, const struct pp_fit_rooms *rooms,
                          int *times)
{
    struct pp_fit_error ours[PLACES] = {{0}}, theirs[PLACES] = {{0}};
    note_left_out(ours, theirs, model, first, printed, rooms, times);
    for (int i = 0; i < PLACES; i++)
        printf("%.3f %.3f %.3f  ", sqrt(ours[i].log / theirs[i].log),
               sqrt(ours[i].relative / theirs[i].relative),
               sqrt(ours[i].absolute / theirs[i].absolute));
}

/* Tries alternatives to parts of `irc-atlas`: other sets of terms, shapes of the
 * decrease, shading of the ground, and the width beside the opening. */
static void search_exchanges(const struct pp_fit_rooms *rooms, int *times)
{
    static const struct {
        int count;
        enum pp_fit_term terms[3];
    } sets[] = {{2, {PP_FIT_PARTS, PP_FIT_REVEAL}},
                {2, {PP_FIT_PARTS, PP_FIT_PLACE_LOST}},
                {2, {PP_FIT_REVEAL, PP_FIT_PLACE_LOST}},
                {3, {PP_FIT_PARTS, PP_FIT_REVEAL, PP_FIT_PLACE_LOST}}};
    for (int shape = PP_FIT_EXPONENTIAL; shape < PP_FIT_SHAPES; shape++)
        for (int set = 0; set < (int)(sizeof sets / sizeof *sets); set++)
            for (int shade = 0; shade < PP_FIT_SHADES; shade++) {
                struct pp_fit_model model = pp_fit_forms_shipped[0].model;
                model.shape = shape;
                model.shade = shade;
                model.count = sets[set].count;
                memcpy(model.terms, sets[set].terms, sizeof sets[set].terms);
                for (int j = 0; j < 3; j++)
                    model.value[PP_FIT_FIRST_TERM + j] = 0.4;
                print_against(&model, NULL, PP_FIT_BRE, rooms, times);
                printf("%d constants, %s, %s:",
                       3 + (shape == PP_FIT_INSIDE) + (shade == PP_FIT_OWN_SHADE)
                           + model.count,
                       pp_fit_forms_shapes[shape], pp_fit_forms_shades[shade]);
                print_model(&model);
                fflush(stdout);
            }
    for (int side = 0; side < PP_FIT_SIDES; side++) {
        struct pp_fit_model model = pp_fit_forms_shipped[0].model;
        model.side = side;
        print_against(&model, NULL, PP_FIT_BRE, rooms, times);
        printf("irc-atlas, %s:", pp_fit_forms_sides[side]);
        print_model(&model);
    }
}

/* Tries corrections of the level of `bre` and `split-flux`: other sources, with various
 * terms. At points, the position factors are those of `irc-atlas`. */
static void search_levels(const struct pp_fit_rooms *rooms, int *times)
{
    static const struct {
        enum pp_fit_source source;
        bool upward, fading;
        int count;
        enum pp_fit_term terms[3];
    } forms[] = {
        {PP_FIT_BRE_NOW, true, false, 2, {PP_FIT_ONE, PP_FIT_PARTS}},
        {PP_FIT_BRE_NOW, true, true, 2, {PP_FIT_LOSS, PP_FIT_PARTS}},
        {PP_FIT_BRE_NOW, true, true, 2, {PP_FIT_MEAN, PP_FIT_PARTS}},
        {PP_FIT_BRE_NOW, true, true, 2, {PP_FIT_UPPER, PP_FIT_PARTS}},
        {PP_FIT_BRE_DOWN, false, false, 1, {PP_FIT_UPPER}},
        {PP_FIT_BRE_DOWN, false, false, 2, {PP_FIT_UPPER, PP_FIT_PARTS}},
        {PP_FIT_BRE_DOWN, true, true, 2, {PP_FIT_UPPER, PP_FIT_PARTS}},
        {PP_FIT_BRE_DOWN, false, false, 2, {PP_FIT_UPPER, PP_FIT_REVEAL}},
        {PP_FIT_BRE_DOWN, false, false, 2, {PP_FIT_UPPER, PP_FIT_LOW_LOST}},
        {PP_FIT_BRE_DOWN, false, false, 3, {PP_FIT_UPPER, PP_FIT_PARTS, PP_FIT_REVEAL}},
        {PP_FIT_BRE_DOWN,
         false,
         false,
         3,
         {PP_FIT_UPPER, PP_FIT_PARTS, PP_FIT_SHALLOW}},
        {PP_FIT_BRE_DOWN, false, false, 3, {PP_FIT_UPPER, PP_FIT_PARTS, PP_FIT_DEEP}},
        {PP_FIT_BRE_DOWN, false, false, 3, {PP_FIT_UPPER, PP_FIT_PARTS, PP_FIT_LOSS}},
        {PP_FIT_BRE_DOWN, false, false, 3, {PP_FIT_UPPER, PP_FIT_PARTS, PP_FIT_GROUND}},
        {PP_FIT_BRE_DOWN, false, false, 3, {PP_FIT_UPPER, PP_FIT_PARTS, PP_FIT_GLASS}},
        {PP_FIT_BRE_DOWN,
         false,
         false,
         3,
         {PP_FIT_UPPER, PP_FIT_PARTS, PP_FIT_FLOOR_AREA}},
        {PP_FIT_FLUX_NOW, false, false, 2, {PP_FIT_ONE, PP_FIT_LOW}},
        {PP_FIT_FLUX_NOW, false, false, 2, {PP_FIT_GLASS, PP_FIT_LOW}},
        {PP_FIT_FLUX_ALL, false, false, 0, {PP_FIT_ONE}},
        {PP_FIT_FLUX_ALL, false, false, 1, {PP_FIT_LOW_LOST}},
        {PP_FIT_FLUX_ALL, false, false, 1, {PP_FIT_LOW}},
        {PP_FIT_FLUX_ALL, false, false, 1, {PP_FIT_PARTS}},
        {PP_FIT_FLUX_ALL, true, true, 1, {PP_FIT_LOW_LOST}},
        {PP_FIT_FLUX_ALL, false, false, 2, {PP_FIT_LOW_LOST, PP_FIT_SHALLOW}},
        {PP_FIT_FLUX_ALL, false, false, 2, {PP_FIT_LOW_LOST, PP_FIT_REVEAL}}};
    for (int i = 0; i < (int)(sizeof forms / sizeof *forms); i++)
        for (int differ = 0; differ < 2; differ++) {
            struct pp_fit_model first = pp_fit_forms_shipped[0].model;
            struct pp_fit_model model = {.source = forms[i].source,
                                         .shade = PP_FIT_HALF_SHADE,
                                         .upward = forms[i].upward,
                                         .fading = forms[i].fading,
                                         .differ = 0.7 * differ,
                                         .count = forms[i].count,
                                         .value = {[PP_FIT_UPWARD_U] = 1.5}};
            bool flux =
                model.source == PP_FIT_FLUX_NOW || model.source == PP_FIT_FLUX_ALL;
            memcpy(model.terms, forms[i].terms, sizeof forms[i].terms);
            print_against(&model, &first, flux ? PP_FIT_FLUX : PP_FIT_BRE, rooms,
                          times);
            printf("%s%s%s:", pp_fit_forms_sources[model.source],
                   model.fading ? ", u^(1-R)" : "",
                   differ ? ", differences fitted too" : "");
            print_model(&model);
            fflush(stdout);
        }
}

static bool has_term(const struct pp_fit_model *model, int term)
{
    for (int j = 0; j < model->count; j++)
        if ((int)model->terms[j] == term)
            return true;
    return false;
}

/* Repeatedly adds the term that reduces the error on left-out rooms most. `all`: prints
 * the error for every candidate of the last step. */
static void search_terms(struct pp_fit_model model, const struct pp_fit_rooms *rooms,
                         int *times, int most, bool all)
{
    double least = held_out(&model, rooms, times);
    printf("%.4f  before:", least);
    print_model(&model);
    while (model.count < most) {
        struct pp_fit_model best = model;
        double found = least;
        for (int term = 0; term < PP_FIT_TERMS; term++) {
            struct pp_fit_model next = model;
            if (has_term(&model, term))
                continue;
            next.terms[next.count] = term;
            next.value[PP_FIT_FIRST_TERM + next.count++] = 0.0;
            double error = held_out(&next, rooms, times);
            if (all)
                printf("        with %s: %.4f\n", pp_fit_forms_terms[term], error);
            if (error < found) {
                found = error;
                best = next;
            }
        }
        if (found >= least)
            return;
        model = best;
        least = found;
        printf("%.4f  and %s:", least,
               pp_fit_forms_terms[model.terms[model.count - 1]]);
        print_model(&model);
    }
}

static void search(const struct pp_fit_rooms *rooms, int *times)
{
    puts("RMS of ln(figure/traced) on rooms left out, points, the darkest quarter half "
         "as important again\n\nSources and shapes:");
    search_shapes(rooms, times);
    puts("\nRanges:");
    search_ranges(rooms, times);
    puts(
        "\nExchanges; errors over those of the printed formula at the darkest quarter, "
        "elsewhere and in averages, each by the ratio, relatively and by daylight "
        "factor:");
    search_exchanges(rooms, times);
    puts("\nLevels of bre and split-flux, the same:");
    search_levels(rooms, times);
    puts("\nTerms, from the balance of the sphere with the light outside:");
    struct pp_fit_model model = pp_fit_forms_shipped[0].model;
    model.count = 0;
    search_terms(model, rooms, times, 4, false);
    puts("\nWhat a seventh term would do:");
    model = pp_fit_forms_shipped[0].model;
    search_terms(model, rooms, times, model.count + 1, true);
    for (int i = 1; i < pp_fit_forms_count; i++) {
        printf("\nTerms of %s:\n", pp_fit_forms_shipped[i].name);
        model = pp_fit_forms_shipped[i].model;
        model.count = 1;
        search_terms(model, rooms, times, 5, false);
    }
}

/* ---- the shipped forms ---- */

static int by_value(const void *a, const void *b)
{
    double off = *(const double *)a - *(const double *)b;
    return (off > 0.0) - (off < 0.0);
}

/* Finds the uncertainty of each parameter by refits to rooms drawn with replacement:
 * half the difference between the 16th and 84th percentiles. */
static void find_spread(const struct pp_fit_model *model,
                        const struct pp_fit_rooms *rooms, int *times,
                        double spread[PP_FIT_PARAMETERS])
{
    static double values[PP_FIT_PARAMETERS][REFITS];
    int most = rooms->count > 0 ? rooms->rows[rooms->count - 1].room : 0;
    int *drawn = malloc(((size_t)most + 1) * sizeof *drawn);
    if (!drawn)
        exit(3);
    for (int refit = 0; refit < REFITS; refit++) {
        struct pp_fit_model again = *model;
        memset(drawn, 0, ((size_t)most + 1) * sizeof *drawn);
        for (int i = 0; i <= most / 2; i++)
            drawn[2 * (pp_hash((uint64_t)refit, (uint64_t)i) % (most / 2 + 1))]++;
        for (int i = 0; i < rooms->count; i++)
            times[i] = rooms->rows[i].room % 2 ? 0 : drawn[rooms->rows[i].room];
        pp_fit_model_fit(&again, rooms, times);
        for (int j = 0; j < PP_FIT_PARAMETERS; j++)
            values[j][refit] = again.value[j];
    }
    free(drawn);
    for (int j = 0; j < PP_FIT_PARAMETERS; j++) {
        qsort(values[j], REFITS, sizeof(double), by_value);
        spread[j] = (values[j][REFITS * 84 / 100] - values[j][REFITS * 16 / 100]) / 2.0;
    }
}

static void print_errors(const char *name, const struct pp_fit_error errors[PLACES])
{
    for (int i = 0; i < PLACES; i++) {
        double n = errors[i].count;
        if (n > 0)
            printf("  %-18s %-16s %5.0f values  ln %.3f  relative %.3f  "
                   "absolute %.3f %%  bias %+.3f\n",
                   name, place_names[i], n, sqrt(errors[i].log / n),
                   sqrt(errors[i].relative / n), sqrt(errors[i].absolute / n),
                   errors[i].bias / n);
    }
}

/* Prints errors on rooms with odd numbers. The printed formula gives one value for all
 * points of a room. */
static void print_held_out(const char *name, const struct pp_fit_model *model,
                           const struct pp_fit_rooms *rooms)
{
    struct pp_fit_error errors[PLACES] = {{0}};
    for (int i = 0; i < rooms->count; i++) {
        const struct pp_fit_row *row = rooms->rows + i;
        double truth = model->of_df ? row->df : row->irc,
               figure = pp_fit_model_value(model, row);
        if (row->room % 2 && (row->average || !model->of_df) && figure > 0.0)
            pp_fit_model_note(errors + place_of(row), figure, truth);
    }
    print_errors(name, errors);
}

static void print_constants(const struct pp_fit_form *form,
                            const struct pp_fit_model *model, const double *spread,
                            bool all)
{
    static const char *const common[PP_FIT_SHADE_G] = {
        "PP_FITTED_DEPTH", "PP_FITTED_SIDE", "PP_FITTED_START", "PP_FITTED_SHADE"};
    for (int j = 0; j < PP_FIT_SHADE_G && all; j++)
        printf("  %s \"%.3f\"  +- %.3f\n", common[j], model->value[j], spread[j]);
    for (int j = 0; j < model->count; j++) {
        double value = model->value[PP_FIT_FIRST_TERM + j],
               off = spread[PP_FIT_FIRST_TERM + j];
        bool factor = model->terms[j] == PP_FIT_ONE;
        printf("  %s \"%.3f\"  +- %.3f\n", form->constants[j],
               factor ? exp(value) : value, factor ? exp(value) * off : off);
    }
}

static void fit_shipped(const struct pp_fit_rooms *rooms, int *times)
{
    struct pp_fit_model first = pp_fit_forms_shipped[0].model;
    for (int i = 0; i < pp_fit_forms_count; i++) {
        const struct pp_fit_form *form = pp_fit_forms_shipped + i;
        struct pp_fit_model model = form->model, printed = {.source = form->printed};
        double spread[PP_FIT_PARAMETERS];
        printed.of_df = model.of_df;
        if (i > 0) {
            model.held = true;
            memcpy(model.value, first.value, PP_FIT_UPWARD_U * sizeof(double));
        }
        for (int k = 0; k < rooms->count; k++)
            times[k] = rooms->rows[k].room % 2 == 0;
        pp_fit_model_fit(&model, rooms, times);
        find_spread(&model, rooms, times, spread);
        printf("%s\n", form->name);
        print_constants(form, &model, spread, i == 0);
        if (i == 0)
            first = model;
        print_held_out(form->name, &model, rooms);
        if (!model.of_df && i > 0) { /* at points: with the position factors of
                                      * irc-atlas */
            struct pp_fit_model placed = model;
            placed.shape = first.shape;
            placed.side = first.side;
            placed.power = first.power;
            print_held_out("  by position", &placed, rooms);
        }
        print_held_out(pp_fit_forms_sources[form->printed], &printed, rooms);
    }
}

int main(int argc, char **argv)
{
    if (argc < 2) {
        fputs("fit_formulae: expected a file of traced rooms\n", stderr);
        return 2;
    }
    struct pp_fit_rooms rooms = pp_fit_rooms_read(argv[1]);
    int *times = calloc((size_t)rooms.count + 1, sizeof *times), number = 0, last = -1;
    if (!times)
        return 3;
    for (int i = 0; i < rooms.count; i++) {
        number += rooms.rows[i].room != last;
        last = rooms.rows[i].room;
    }
    printf("%d rooms, %d points and averages\n", number, rooms.count);
    if (argc > 2 && strcmp(argv[2], "search") == 0)
        search(&rooms, times);
    else
        fit_shipped(&rooms, times);
    free(times);
    free(rooms.rows);
    return 0;
}
