/* test_method_list.c - for all methods in the list: every hand figure is near the
 * simulated one, and every method has its own test.
 *
 * Good methods are within some ten per cent of the simulation, crude ones within a
 * factor of two or three. A factor of five allows for these, and detects a formula with
 * a wrong unit: a fraction instead of per cent is a factor of 100.
 */
#include "methods/method.h"

#include <stdio.h>

#include "methods/evaluate.h"
#include "model/base/text.h"
#include "tests/lib/room_of.h"
#include "tests/lib/traced.h"

enum { AT_FRONT, IN_DEPTH, UPRIGHT, POINTS, AVERAGE = POINTS, PLACES };
enum { METHODS_MOST = 100 };

static const char *const places[PLACES] = {"the front", "the depth",
                                           "the upright point", "the average"};

static const double most = 5.0;

/* Fraction of the open sky. Smaller components are within the noise of the simulation
 * and of methods that count dots; a hand figure must then be small too. */
static const double dark = 5e-4;

static const char *const names[PP_COMPONENT_COUNT] = {"sc", "erc", "irc", "df"};

/* ---- the rooms ---- */

#define SIDE_LIT                                                                       \
    "<plan width='3.6' depth='5.4' height='2.7'/>"                                     \
    "<finishes floor='0.25' walls='0.6' ceiling='0.8'/>"                               \
    "<window wall='south' left='0.6' sill='0.9' width='2.4' height='1.5'"              \
    " glazing='clear-double' frame-factor='0.8' maintenance='0.9'/>"

/* Points are below the sill, so that they see no ground, which the diagrams do not
 * include. */
static const struct textbook_room {
    const char *name, *xml;
    struct pp_vec3 point[POINTS];
} rooms[] = {
    {"a side-lit room",
     "<room version='1'>" SIDE_LIT "</room>",
     {{1.8, 1.3, 0.85}, {1.8, 3.1, 0.85}, {1.8, 2.2, 0.85}}},
    {"the same before a row of houses",
     "<room version='1'>" SIDE_LIT
     "<skyline wall='south' angle='25' distance='14' reflectance='0.3'/></room>",
     {{1.8, 1.3, 0.85}, {1.8, 3.1, 0.85}, {1.8, 2.2, 0.85}}},
    {"a top-lit room",
     "<room version='1'><plan width='4.2' depth='5.4' height='3.1'/>"
     "<finishes floor='0.25' walls='0.6' ceiling='0.8'/>"
     "<rooflight x='1.4' y='2.0' width='1.4' depth='1.4' glazing='clear-double'"
     " frame-factor='0.8' maintenance='0.9'/></room>",
     {{2.1, 2.7, 0.85}, {1.1, 1.4, 0.85}, {2.1, 4.1, 1.2}}},
};

/* ---- hand figures and simulation ---- */

struct answers {
    struct pp_world *world;
    struct pp_receiver points[POINTS];
    struct pp_report report;
    struct pp_reading (*traced)[PP_COMPONENT_COUNT];
};

/* Writes all methods, and all pairs of a direct and a reflected method. */
static void write_selection(char *text, size_t room)
{
    text[0] = '\0';
    for (int i = 0; pp_methods[i]; i++)
        pp_text_append(text, room, "%s%s", i ? "," : "", pp_methods[i]->name);
    for (int i = 0; pp_methods[i]; i++)
        for (int k = 0; pp_methods[k]; k++)
            if (pp_methods[i]->gives == PP_GIVES_DIRECT
                && pp_methods[k]->gives == PP_GIVES_INTERNAL)
                pp_text_append(text, room, ",%s+%s", pp_methods[i]->name,
                               pp_methods[k]->name);
}

static struct answers answers_in(const struct textbook_room *room, bool simulated)
{
    struct answers answers = {.traced = NULL};
    struct pp_outside_light light;
    struct pp_error err = {0};
    static char selection[16384];
    write_selection(selection, sizeof selection);
    answers.world = pp_test_lit_world(&light, room->xml);
    for (int i = 0; i < POINTS; i++)
        answers.points[i] =
            (struct pp_receiver){room->point[i], {0.0, 0.0, 1.0}, 0, 0.0};
    /* The receiver faces the window, slightly to one side. */
    answers.points[UPRIGHT].normal = pp_vec(sin(0.3), -cos(0.3), 0.0);
    if (simulated) {
        /* To 2 % of the daylight factor. */
        const struct pp_tracer_options options = {
            .error = 0.02, .seed = 5, .threads = 1, .average = true};
        answers.traced = pp_test_trace(answers.world, &light, answers.points, POINTS,
                                       &options, NULL);
    }
    answers.report = (struct pp_report){.world = answers.world,
                                        .light = light,
                                        .receivers = answers.points,
                                        .receiver_count = POINTS,
                                        .finished = true,
                                        .explain = !simulated};
    if (pp_methods_evaluate(&answers.report, selection, &err) != PP_OK)
        fail_msg("%s: %s", room->name, err.message);
    return answers;
}

static void clear_answers(struct answers *answers)
{
    pp_report_clear(&answers->report);
    free(answers->traced);
    pp_world_destroy(answers->world);
}

/* ---- plausible figures ---- */

/* Compares a column with the simulation at every place; returns the number of figures
 * compared. */
static int compare_column(const struct pp_column *column, const struct answers *answers,
                          const char *room)
{
    int compared = 0;
    for (int i = 0; i < PLACES; i++) {
        double hand = i == AVERAGE     ? column->average.value
                      : column->points ? column->points[i].value
                                       : NAN;
        double traced = answers->traced[i][column->component].value;
        if (isnan(hand))
            continue;
        bool good = traced < dark ? hand < most * dark
                                  : hand > traced / most && hand < traced * most;
        if (!good)
            fail_msg("%s of %s at %s of %s: %.4f %%; simulated: %.4f %%",
                     names[column->component], column->name, places[i], room,
                     100.0 * hand, 100.0 * traced);
        compared += traced >= dark;
    }
    return compared;
}

/* True if the method calculates this component. */
static bool gives(const struct pp_method *method, enum pp_component component)
{
    switch (method->gives) {
    case PP_GIVES_DIRECT:
        return component == PP_SC || component == PP_ERC;
    case PP_GIVES_INTERNAL:
        return component == PP_IRC;
    default:
        return component == PP_DF;
    }
}

/* Every component of every method has a figure in one of the rooms. test_well_window.c
 * compares methods for rooms nested in a well. */
static void every_figure_is_within_a_factor_of_five_of_the_simulated(void **state)
{
    (void)state;
    int compared[METHODS_MOST][PP_COMPONENT_COUNT] = {{0}}, pairs = 0;
    for (size_t r = 0; r < sizeof rooms / sizeof rooms[0]; r++) {
        struct answers answers = answers_in(&rooms[r], true);
        for (int c = 0; c < answers.report.column_count; c++) {
            const struct pp_column *column = &answers.report.columns[c];
            int more = compare_column(column, &answers, rooms[r].name);
            int i = 0;
            while (pp_methods[i] && strcmp(pp_methods[i]->name, column->name) != 0)
                i++;
            if (pp_methods[i])
                compared[i][column->component] += more;
            else
                pairs += more;
        }
        clear_answers(&answers);
    }
    for (int i = 0; pp_methods[i]; i++)
        for (int k = 0; k < PP_COMPONENT_COUNT; k++)
            if (gives(pp_methods[i], k) && compared[i][k] == 0
                && !pp_methods[i]->of_well)
                fail_msg("no room here has %s by %s: add one", names[k],
                         pp_methods[i]->name);
    assert_true(pairs > 0);
}

/* ---- units ---- */

/* Unit of a symbol in the formulae of the method; false if they do not contain the
 * symbol. */
static bool find_unit(enum pp_step_unit *unit, const struct pp_method *method,
                      const char *symbol)
{
    for (int i = 0; method->formulae && method->formulae[i]; i++) {
        const struct pp_formula *formula = method->formulae[i];
        const struct pp_formula_quantity *quantity = formula->quantities;
        while (quantity->symbol && strcmp(quantity->symbol, symbol) != 0)
            quantity++;
        if (!quantity->symbol && strcmp(formula->symbol, symbol) != 0)
            continue;
        *unit = quantity->symbol ? quantity->unit : formula->unit;
        return true;
    }
    return false;
}

/* Otherwise a fraction could be used where the text has per cent, or radians where it
 * has degrees. */
static void a_figure_is_put_down_in_the_unit_of_the_formula_that_names_it(void **state)
{
    (void)state;
    int checked = 0;
    for (size_t r = 0; r < sizeof rooms / sizeof rooms[0]; r++) {
        struct answers answers = answers_in(&rooms[r], false);
        for (int c = 0; c < answers.report.column_count; c++) {
            const struct pp_column *column = &answers.report.columns[c];
            const struct pp_method *method = pp_method_find(column->name);
            for (int i = 0; method && i < PLACES; i++) {
                const struct pp_steps *steps = i == AVERAGE ? column->average.steps
                                               : column->points
                                                   ? column->points[i].steps
                                                   : NULL;
                for (int k = 0; steps && k < steps->count; k++) {
                    const struct pp_calculation_step *step = &steps->list[k];
                    enum pp_step_unit unit;
                    if (!step->symbol[0] || !find_unit(&unit, method, step->symbol))
                        continue;
                    if (unit != step->unit)
                        fail_msg("%s: the unit of %s (%s) is not that of its formula",
                                 method->name, step->symbol, step->what);
                    checked++;
                }
            }
        }
        clear_answers(&answers);
    }
    assert_true(checked > 100);
}

/* ---- tests ---- */

/* File in tests/methods/ that tests the method, with values calculated by hand or
 * independently. */
static const struct method_test {
    const char *method, *file;
} tests[] = {
    {"exact", "exact/test_exact.c"},
    {"brs-table", "brs/test_brs_table.c"},
    {"brs-table-rooflight", "brs/test_brs_rooflight.c"},
    {"waldram", "test_counted_methods.c"},
    {"waldram-overlay", "waldram/test_waldram_overlay.c"},
    {"pepper-pot", "test_counted_methods.c"},
    {"pepper-pot-sky", "pepper_pot/test_pepper_pot_sky.c"},
    {"protractor", "protractor/test_protractor.c"},
    {"protractor-upright", "protractor/test_protractor_upright.c"},
    {"bre", "reflected/test_bre.c"},
    {"bre-min", "reflected/test_irc_minimum.c"},
    {"bre-table", "reflected/test_irc_minimum.c"},
    {"split-flux", "reflected/test_split_flux.c"},
    {"sphere", "reflected/test_sphere.c"},
    {"arndt", "reflected/test_arndt.c"},
    {"dresler", "reflected/test_dresler.c"},
    {"k-factor", "reflected/test_k_factor.c"},
    {"nomogram", "nomogram/test_nomogram.c"},
    {"irc-atlas", "fitted/test_irc_atlas.c"},
    {"bre-atlas", "fitted/test_irc_atlas.c"},
    {"split-flux-atlas", "fitted/test_irc_atlas.c"},
    {"average-df", "test_average_df.c"},
    {"average-df-above", "test_average_df.c"},
    {"average-df-well", "reflected/test_well_window.c"},
    {"average-df-lynes", "test_average_df.c"},
    {"average-df-atlas", "fitted/test_irc_atlas.c"},
    {"efficiency", "reflected/test_efficiency.c"},
    {"lumen", "lumen/test_lumen.c"},
    {"lumen-one", "lumen/test_lumen.c"},
};

/* True if the text contains the word, not as part of a longer word. */
static bool has_word(const char *text, const char *word)
{
    static const char letters[] = "abcdefghijklmnopqrstuvwxyz0123456789_-";
    size_t length = strlen(word);
    for (const char *at = text; (at = strstr(at, word)); at++)
        if ((at == text || !strchr(letters, at[-1]))
            && (!at[length] || !strchr(letters, at[length])))
            return true;
    return false;
}

/* Text of the file; NULL if the file does not exist. The caller frees it. */
static char *text_of(const char *file)
{
    char path[512];
    const char *source = getenv("srcdir");
    snprintf(path, sizeof path, "%s/tests/methods/%s", source ? source : ".", file);
    FILE *stream = fopen(path, "rb");
    if (!stream)
        return NULL;
    enum { LONGEST = 1 << 20 };
    char *text = malloc(LONGEST + 1);
    assert_non_null(text);
    text[fread(text, 1, LONGEST, stream)] = '\0';
    fclose(stream);
    return text;
}

static void every_method_has_a_test_that_names_it(void **state)
{
    (void)state;
    size_t count = sizeof tests / sizeof tests[0];
    for (int i = 0; pp_methods[i]; i++) {
        const char *name = pp_methods[i]->name;
        size_t k = 0;
        while (k < count && strcmp(tests[k].method, name) != 0)
            k++;
        if (k == count)
            fail_msg("%s has no test in the table of %s", name, __FILE__);
        char *text = text_of(tests[k].file), identifier[80] = "pp_method_";
        if (!text)
            fail_msg("tests/methods/%s, the test of %s, is not there", tests[k].file,
                     name);
        pp_text_append(identifier, sizeof identifier, "%s", name);
        for (char *c = identifier; *c; c++)
            *c = *c == '-' ? '_' : *c;
        if (!has_word(text, identifier) && !has_word(text, name))
            fail_msg("tests/methods/%s does not name %s, whose test it is",
                     tests[k].file, name);
        free(text);
    }
}

static void the_table_of_tests_names_methods_only(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof tests / sizeof tests[0]; i++)
        if (!pp_method_find(tests[i].method))
            fail_msg("there is no method %s", tests[i].method);
}

TEST_FILE
{
    const struct CMUnitTest list[] = {
        cmocka_unit_test(every_figure_is_within_a_factor_of_five_of_the_simulated),
        cmocka_unit_test(a_figure_is_put_down_in_the_unit_of_the_formula_that_names_it),
        cmocka_unit_test(every_method_has_a_test_that_names_it),
        cmocka_unit_test(the_table_of_tests_names_methods_only),
    };
    add_tests(list, NULL, NULL);
}
