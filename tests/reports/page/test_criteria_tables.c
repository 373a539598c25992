/* test_criteria_tables.c - a short report has a row for each room, and says once what
 * rooms have in common. */
#include <stdio.h>
#include <string.h>

#include "model/room/world.h"
#include "reports/page/basis_clauses.h"
#include "reports/page/criteria_tables.h"
#include "tests/lib/near.h"

static const struct pp_criterion provision = {
    .name = "provision", .title = "Provision", .source = "EN"};

static struct pp_finding finding(const char *what, double figure, double wanted,
                                 const char *note)
{
    struct pp_finding made =
        pp_finding_of(PP_FIGURE_FACTOR, figure, wanted, false, "%s", what);
    pp_finding_note(&made, "%s", note);
    pp_finding_sampled(&made, 1e-4, figure > wanted ? 1.0 : 0.0);
    return made;
}

/* Two rooms with the same findings but for the figures of the second column. */
struct two_rooms {
    struct pp_world worlds[2];
    struct pp_study_room rooms[2];
    struct pp_finding findings[2][3];
    struct pp_answer answers[2];
    struct pp_assessment list[2];
    struct pp_document document;
};

static void make_rooms(struct two_rooms *two)
{
    static char names[2][16] = {"Parlour", "Scullery"};
    *two = (struct two_rooms){0};
    for (int i = 0; i < 2; i++) {
        two->worlds[i].name = names[i];
        two->rooms[i].world = &two->worlds[i];
        two->findings[i][0] = finding("median", 0.0107, 0.0213, "a shared note");
        two->findings[i][1] = finding("minimum", i ? 0.0091 : 0.0051, 0.00709, "");
        two->findings[i][2] = finding("high median", 0.0107, 0.0532, "");
        two->findings[i][2].is_optional = true;
        two->answers[i] =
            (struct pp_answer){&provision, {.list = two->findings[i], .count = 3}};
        snprintf(two->answers[i].findings.basis, sizeof two->answers[i].findings.basis,
                 "by simulation; on %d points; level reached: none", 150 + 10 * i);
        two->list[i].room = &two->rooms[i];
        two->list[i].answers = (struct pp_answer_list){&two->answers[i], 1};
    }
}

static const struct pp_document_table *table_of(struct two_rooms *two, int number)
{
    const struct pp_assessments all = {.list = two->list, .count = 2};
    assert_int_equal(pp_criteria_tables(&two->document, &all, NULL), PP_OK);
    for (int i = 0; i < two->document.block_count; i++)
        if (two->document.blocks[i].kind == PP_BLOCK_TABLE && number-- == 0)
            return &two->document.blocks[i].table;
    return NULL;
}

static void each_room_has_one_row_with_all_its_figures(void **state)
{
    (void)state;
    struct two_rooms two;
    make_rooms(&two);
    const struct pp_document_table *table = table_of(&two, 0);
    assert_int_equal(table->row_count, 2);
    assert_string_equal(table->columns[1].heading, "median (≥ 2.13 %)");
    assert_string_equal(table->rows[0].cells[0].text, "Parlour");
    assert_string_equal(table->rows[0].cells[1].text, "1.07 ±0.01 % not met¹");
    assert_string_equal(table->rows[1].cells[2].text, "0.91 ±0.01 % met");
    assert_string_equal(table->rows[1].cells[4].text, "none");
    pp_document_clear(&two.document);
}

static void a_median_is_printed_once_for_all_levels(void **state)
{
    (void)state;
    struct two_rooms two;
    make_rooms(&two);
    assert_string_equal(table_of(&two, 0)->rows[0].cells[3].text, "not reached");
    pp_document_clear(&two.document);
}

static void rooms_with_different_grids_are_listed_with_them(void **state)
{
    (void)state;
    struct two_rooms two;
    make_rooms(&two);
    const struct pp_document_table *table = table_of(&two, 1);
    assert_int_equal(table->row_count, 2);
    assert_string_equal(table->rows[1].cells[0].text, "Scullery");
    assert_string_equal(table->rows[1].cells[1].text, "on 160 points");
    pp_document_clear(&two.document);
}

static void different_targets_stand_beside_their_figures(void **state)
{
    (void)state;
    struct two_rooms two;
    make_rooms(&two);
    two.findings[1][1].wanted = 0.0142;
    two.findings[1][1].verdict = PP_NOT_MET;
    const struct pp_document_table *table = table_of(&two, 0);
    assert_string_equal(table->columns[2].heading, "minimum");
    assert_string_equal(table->rows[1].cells[2].text,
                        "0.91 ±0.01 % (≥ 1.42 %) not met");
    pp_document_clear(&two.document);
}

/* Each room has a figure of its own use, so columns would be half empty. */
static void figures_that_few_rooms_have_are_rows(void **state)
{
    (void)state;
    struct two_rooms two;
    make_rooms(&two);
    two.answers[0].findings.count = two.answers[1].findings.count = 1;
    strcpy(two.findings[0][0].what, "kitchen");
    strcpy(two.findings[1][0].what, "bedroom");
    const struct pp_document_table *table = table_of(&two, 0);
    assert_int_equal(table->row_count, 2);
    assert_string_equal(table->rows[1].cells[1].text, "bedroom¹");
    assert_string_equal(table->rows[1].cells[3].text, "≥ 2.13 %");
    pp_document_clear(&two.document);
}

static void clauses_are_common_only_if_all_bases_have_them(void **state)
{
    (void)state;
    static const char *const bases[] = {"by hand; on 3 points; level reached: high",
                                        "by hand; on 33 points"};
    char text[PP_BASIS_CLAUSES];
    pp_basis_clauses_common(text, bases, 2);
    assert_string_equal(text, "by hand");
    pp_basis_clauses_own(text, bases, 2, 0);
    assert_string_equal(text, "on 3 points");
    assert_true(pp_basis_clauses_level(text, bases[0]));
    assert_string_equal(text, "high");
    assert_false(pp_basis_clauses_level(text, bases[1]));
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_room_has_one_row_with_all_its_figures),
        cmocka_unit_test(a_median_is_printed_once_for_all_levels),
        cmocka_unit_test(rooms_with_different_grids_are_listed_with_them),
        cmocka_unit_test(different_targets_stand_beside_their_figures),
        cmocka_unit_test(figures_that_few_rooms_have_are_rows),
        cmocka_unit_test(clauses_are_common_only_if_all_bases_have_them),
    };
    add_tests(tests, NULL, NULL);
}
