/* test_view_out_criterion.c - levels of the view out in rooms with known results. */
#include "studies/criteria/criteria.h"
#include "tests/lib/room_of.h"

/* Finding number `index` for a room given by the content of its element. */
static struct pp_finding found(int index, const char *body)
{
    char text[2048];
    snprintf(text, sizeof text, "<room version=\"1\">%s</room>", body);
    struct pp_world *world = pp_test_world(text);
    const struct pp_inquiry inquiry = {.world = world};
    struct pp_finding_list findings = {0};
    assert_int_equal(pp_criterion_view_out.evaluate(&inquiry, &findings, NULL), PP_OK);
    assert_true(index < findings.count);
    struct pp_finding finding = findings.list[index];
    pp_finding_list_clear(&findings);
    pp_world_destroy(world);
    return finding;
}

static void assert_verdict(struct pp_finding finding, double figure,
                           enum pp_verdict verdict)
{
    assert_near(finding.figure, figure, 1e-12);
    assert_int_equal(finding.verdict, verdict);
}

#define VIEW_ROOM                                                                      \
    "<plan width=\"4\" depth=\"6\" height=\"3\"/>"                                     \
    "<window wall=\"south\" left=\"1\" sill=\"0.8\" width=\"2\" height=\"1.5\"/>"

/* Angle of a window 2 m wide from each of 60 points, by definition: all have at least
 * 14 degrees; in the open, landscape and sky are far away. */
static void points_with_28_degrees_have_the_medium_view_in_the_open(void **state)
{
    (void)state;
    int medium = 0;
    for (int i = 0; i < 6; i++)
        for (int j = 0; j < 10; j++) {
            double x = 0.75 + 0.5 * i, y = 0.75 + 0.5 * j;
            double angle_rad = atan((3.0 - x) / y) - atan((1.0 - x) / y);
            assert_true(angle_rad > 14.0 * PP_RAD);
            medium += angle_rad >= 28.0 * PP_RAD;
        }
    assert_verdict(found(3, VIEW_ROOM), 1.0, PP_MET);
    struct pp_finding finding = found(4, VIEW_ROOM);
    assert_verdict(finding, medium / 60.0, PP_NOT_MET);
    assert_true(finding.is_optional);
    /* A line over the sill falls by at least 5 degrees, onto the ground, from points up
     * to 0.4 m/tan 5 degrees = 4.6 m away: 48 of the 60 points see three layers. */
    assert_near(found(2, VIEW_ROOM).figure, 3.0, 0.0);
}

/* With an obstruction nearer than 6 m there is no view, for any width of the window. */
static void a_wall_5_m_away_leaves_no_view(void **state)
{
    (void)state;
    static const char near_wall[] = VIEW_ROOM
        "<block x=\"-30\" y=\"-15\" width=\"64\" depth=\"10\" height=\"40\"/>";
    struct pp_finding distance = found(1, near_wall);
    assert_true(distance.figure >= 5.0 && distance.figure < 6.0);
    assert_int_equal(found(3, near_wall).verdict, PP_NOT_MET);
}

static void a_room_narrower_than_its_margins_is_not_judged(void **state)
{
    (void)state;
    struct pp_finding finding =
        found(0, "<plan width=\"0.9\" depth=\"2\" height=\"3\"/>"
                 "<window wall=\"south\" left=\"0.2\" sill=\"1\" width=\"0.5\" "
                 "height=\"1\"/>");
    assert_int_equal(finding.verdict, PP_NOT_JUDGED);
    assert_non_null(strstr(finding.note, "0.5 m or more from the walls"));
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(points_with_28_degrees_have_the_medium_view_in_the_open),
        cmocka_unit_test(a_wall_5_m_away_leaves_no_view),
        cmocka_unit_test(a_room_narrower_than_its_margins_is_not_judged),
    };
    add_tests(tests, NULL, NULL);
}
