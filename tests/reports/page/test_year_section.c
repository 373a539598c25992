/* test_year_section.c - annual figures in a report: per cent, with their errors, and no
 * shares of the plane without a grid. */
#include <string.h>

#include "model/room/world.h"
#include "reports/page/year_section.h"
#include "tests/lib/near.h"

static struct pp_annual_group groups[] = {
    {.name = "south: 2 openings", .closed_h = 1785.0}};

static const struct pp_annual_sheet grid_year = {
    .is_grid = true,
    .has_blinds = true,
    .blinds_of_lm83 = true,
    .group_count = 1,
    .groups = groups,
    .plane = {.sda = {0.8333, 0.0042}},
    .mean = {.autonomy_300 = {0.5, 0.00126}, .mean_lx = {3797.4, 1.26}},
    .weather = "Somewhere",
    .blinds = "LM-83-12",
    .warning_count = 1,
    .warnings = {"far away"}};

struct sought {
    const char *words;
    bool found;
};

static void look(void *closure, const char *text)
{
    struct sought *sought = closure;
    sought->found |= strcmp(text, sought->words) == 0;
}

static bool has(const struct pp_annual_sheet *year, const char *words)
{
    struct pp_document document = {0};
    struct sought sought = {words, false};
    pp_year_section(&document, year);
    assert_int_equal(pp_document_status(&document, NULL), PP_OK);
    pp_document_texts(&document, look, &sought);
    pp_document_clear(&document);
    return sought.found;
}

static void shares_are_per_cent_with_their_errors(void **state)
{
    (void)state;
    assert_true(has(&grid_year, "83.3"));
    assert_true(has(&grid_year, "0.42"));
    assert_true(has(&grid_year, "50.0"));
    assert_true(has(&grid_year, "0.13"));
    assert_true(has(&grid_year, "3797"));
}

static void assumptions_and_warnings_are_reported(void **state)
{
    (void)state;
    assert_true(has(&grid_year, "Somewhere"));
    assert_true(has(&grid_year, "far away"));
    assert_true(has(&grid_year, "south: 2 openings"));
    assert_true(has(&grid_year, "1785"));
}

static void points_without_a_grid_have_no_area(void **state)
{
    (void)state;
    struct pp_annual_sheet points = grid_year;
    points.is_grid = false;
    assert_false(has(&points, "ASE1000,250"));
    assert_true(has(&points, "50.0"));
    assert_true(has(&grid_year, "ASE1000,250"));
}

static void electric_light_has_its_shares_if_it_was_studied(void **state)
{
    (void)state;
    struct pp_lighting_sheet dimmed = {
        .control = {.kind = PP_LIGHTING_DIMMED, .target_lx = 350.0},
        .figures = {.saved = {0.617, 0.0031}},
        .mean = {0.743, 0.0012}};
    struct pp_annual_sheet lit = grid_year;
    lit.lighting_count = 1;
    lit.lighting = &dimmed;
    assert_true(has(&lit, "61.7"));
    assert_true(has(&lit, "0.31"));
    assert_true(has(&lit, "74.3"));
    assert_true(has(&lit,
                    "Electric light saved in these hours, for 350 lx at the darkest "
                    "point, without blinds"));
    assert_false(has(&grid_year, "dimmed"));
}

/* A year without a grid, or an interrupted one, has dashes. */
static void a_short_report_has_a_row_for_each_room(void **state)
{
    (void)state;
    char names[2][8] = {"Bedroom", "Hall"};
    struct pp_world worlds[2] = {{.name = names[0]}, {.name = names[1]}};
    struct pp_annual_sheet bedroom = grid_year, hall = grid_year;
    bedroom.world = &worlds[0];
    bedroom.finished = true;
    hall.world = &worlds[1];
    const struct pp_annual_sheet *years[] = {&bedroom, &hall};
    static const char *const words[] = {"Bedroom",     "Hall",    "83.3 ± 0.42",
                                        "50.0 ± 0.13", "–",       "3797 ± 1.3",
                                        "Somewhere",   "far away"};
    struct pp_document document = {0};
    pp_year_section_rooms(&document, years, 2);
    assert_int_equal(pp_document_status(&document, NULL), PP_OK);
    for (size_t i = 0; i < sizeof words / sizeof *words; i++) {
        struct sought sought = {words[i], false};
        pp_document_texts(&document, look, &sought);
        assert_true(sought.found);
    }
    pp_document_clear(&document);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(shares_are_per_cent_with_their_errors),
        cmocka_unit_test(assumptions_and_warnings_are_reported),
        cmocka_unit_test(a_short_report_has_a_row_for_each_room),
        cmocka_unit_test(points_without_a_grid_have_no_area),
        cmocka_unit_test(electric_light_has_its_shares_if_it_was_studied),
    };
    add_tests(tests, NULL, NULL);
}
