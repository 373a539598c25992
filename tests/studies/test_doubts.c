/* test_doubts.c - valid input that is probably not intended. */
#include "studies/doubts.h"

#include "tests/lib/room_of.h"

#define PLAN "<plan width='4.2' depth='5.3' height='2.7'/>"
#define WINDOW "<window wall='south' left='1' sill='0.9' width='2' height='1.5'/>"
#define LONE(parts) "<room version='1'>" parts "</room>"

/* Warnings for a file with one room, joined by "; ". */
static const char *doubts_of(const char *xml, bool alone)
{
    static char text[1024];
    struct pp_mistakes doubts;
    struct pp_world *world = pp_test_world(xml);
    pp_mistakes_init(&doubts, "test");
    pp_doubts_find(&doubts, world, alone);
    text[0] = '\0';
    for (int i = 0; i < doubts.count; i++)
        snprintf(text + strlen(text), sizeof text - strlen(text), "%s%s",
                 i > 0 ? "; " : "", doubts.list[i].text);
    pp_mistakes_clear(&doubts);
    pp_world_destroy(world);
    return text;
}

static void assert_doubt(const char *xml, const char *text)
{
    const char *doubts = doubts_of(xml, true);
    if (!strstr(doubts, text))
        print_message("# \"%s\"\n", doubts);
    assert_non_null(strstr(doubts, text));
}

static void an_ordinary_room_gives_no_warning(void **state)
{
    (void)state;
    assert_string_equal(
        doubts_of(
            LONE("<site latitude='51.5' longitude='-0.1' country='GB'/>" PLAN
                 "<window wall='south' left='1' sill='0.9' width='2' height='1.5' "
                 "frame-factor='0.75' maintenance='auto'/>"
                 "<block name='Opposite' x='0' y='-20' width='9' depth='8' "
                 "height='12'/><skyline wall='south' angle='20'/>"),
            true),
        "");
}

static void lengths_in_millimetres_are_noticed(void **state)
{
    (void)state;
    assert_doubt(LONE("<plan width='4200' depth='5400' height='2700'/>"
                      "<window wall='south' left='1000' sill='900' width='2000' "
                      "height='1500'/><point x='2100' y='2700'/>"),
                 "the room is 5400 m wide; is units=\"mm\" missing?");
    assert_doubt("<room version='1' units='mm'><plan width='42' depth='54' "
                 "height='27'/><point x='21' y='27' z='8'/>"
                 "<working-plane height='8'/></room>",
                 "measures only 0.027 m");
}

static void a_hall_of_100_by_300_m_is_no_mistake(void **state)
{
    (void)state;
    assert_string_equal(
        doubts_of(LONE("<plan width='100' depth='300' height='20'/>" WINDOW
                       "<point x='50' y='50'/>"),
                  true),
        "");
}

static void a_room_without_a_window_is_dark(void **state)
{
    (void)state;
    assert_doubt(LONE(PLAN), "the room has no window");
    assert_doubt("<room version='1' name='Store'>" PLAN "</room>",
                 "room \"Store\" has no window");
}

static void a_factor_that_is_a_loss_names_what_it_would_be(void **state)
{
    (void)state;
    assert_doubt(LONE(PLAN "<window wall='south' left='1' sill='0.9' width='2' "
                           "height='1.5' frame-factor='0.2' maintenance='0.08'/>"),
                 "0.2 looks like the share of the frame (frame-factor would be 0.8)");
    assert_doubt(LONE(PLAN "<window wall='south' left='1' sill='0.9' width='2' "
                           "height='1.5' maintenance='0.08'/>"),
                 "0.08 looks like the loss (maintenance would be 0.92)");
}

#define METAL(shape) "<material name='metal' n='1' k='6' " shape "/>"

/* Roughness divided by correlation length is first 0.2, then 0.6. */
static void a_material_is_too_steep_if_it_loses_much_light(void **state)
{
    (void)state;
    assert_string_equal(
        doubts_of(LONE(METAL("roughness='3' correlation-length='15'") PLAN WINDOW),
                  true),
        "");
    assert_doubt(LONE(METAL("roughness='3' correlation-length='5'") PLAN WINDOW),
                 "material \"metal\": roughness divided by correlation-length is too "
                 "large for the model, which loses ");
}

static void swapped_coordinates_are_far_from_the_country(void **state)
{
    (void)state;
    assert_doubt(
        LONE("<site latitude='-0.1' longitude='51.5' country='GB'/>" PLAN WINDOW),
        "latitude -0.1 and longitude 51.5 are far from GB; are they swapped?");
    /* A French island in the Indian Ocean belongs to France. */
    assert_string_equal(
        doubts_of(
            LONE("<site latitude='-21' longitude='55.5' country='FR'/>" PLAN WINDOW),
            true),
        "");
}

static void a_block_behind_every_window_hides_no_sky(void **state)
{
    (void)state;
    static const char behind[] =
        LONE(PLAN WINDOW "<block name='Opposite' x='0' y='20' width='9' depth='8' "
                         "height='12'/>");
    assert_doubt(behind, "no part of the block \"Opposite\" is in front of a window");
    assert_string_equal(doubts_of(behind, false), "");
    /* A block that touches the room is part of its own building. */
    assert_string_equal(
        doubts_of(LONE(PLAN WINDOW "<block x='0' y='5.3' width='9' depth='8' "
                                   "height='12'/>"),
                  true),
        "");
    /* Any block that rises above a rooflight can hide sky from it. */
    assert_string_equal(
        doubts_of(LONE(PLAN "<rooflight x='1' y='1' width='1' depth='1'/>"
                            "<block x='0' y='20' width='9' depth='8' height='12'/>"),
                  true),
        "");
}

static void a_skyline_needs_a_window_in_its_wall(void **state)
{
    (void)state;
    assert_doubt(LONE(PLAN WINDOW "<skyline wall='north' angle='30'/>"),
                 "the wall \"north\", which has no window");
}

static void a_block_of_5_km_is_in_millimetres(void **state)
{
    (void)state;
    assert_doubt(LONE(PLAN WINDOW "<block name='B' x='0' y='-9000' width='9' depth='8' "
                                  "height='5000'/>"),
                 "the block \"B\" is 5000 m high");
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_ordinary_room_gives_no_warning),
        cmocka_unit_test(lengths_in_millimetres_are_noticed),
        cmocka_unit_test(a_hall_of_100_by_300_m_is_no_mistake),
        cmocka_unit_test(a_room_without_a_window_is_dark),
        cmocka_unit_test(a_factor_that_is_a_loss_names_what_it_would_be),
        cmocka_unit_test(a_material_is_too_steep_if_it_loses_much_light),
        cmocka_unit_test(swapped_coordinates_are_far_from_the_country),
        cmocka_unit_test(a_block_behind_every_window_hides_no_sky),
        cmocka_unit_test(a_skyline_needs_a_window_in_its_wall),
        cmocka_unit_test(a_block_of_5_km_is_in_millimetres),
    };
    add_tests(tests, NULL, NULL);
}
