/* test_atlas_design.c - the rooms of the atlas. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "studies/research/atlas/atlas_drawn.h"
#include "studies/research/atlas/room_features.h"
#include "tests/lib/near.h"
#include "tests/lib/sized.h"

enum { ROOMS = 128 };

static struct pp_atlas_design design;

static int set_up(void **state)
{
    (void)state;
    pp_atlas_design_init(&design, PP_ATLAS_OVERCAST);
    return 0;
}

/* The number after the first `name` in a room's text. */
static double number_of(const char *xml, const char *name)
{
    const char *at = strstr(xml, name);
    assert_non_null(at);
    return strtod(at + strlen(name), NULL);
}

static void a_room_depends_on_its_index_alone(void **state)
{
    (void)state;
    char one[PP_ATLAS_XML], other[PP_ATLAS_XML];
    struct pp_atlas_design again;
    pp_atlas_design_init(&again, PP_ATLAS_OVERCAST);
    pp_atlas_design_room(&again, 9999, other);
    for (uint32_t i = 0; i < 40; i++) {
        pp_atlas_design_room(&design, i, one);
        pp_atlas_design_room(&again, i, other);
        assert_string_equal(one, other);
    }
    pp_atlas_design_room(&design, 41, other);
    assert_string_not_equal(one, other);
}

/* Every room is read without a mistake, with all points: a room that is not closed, or
 * a point in a wall, would be rejected. */
static void every_room_makes_sense(void **state)
{
    (void)state;
    for (int i = 0; i < PP_SIZED(ROOMS, ROOMS / 4, ROOMS / 8); i++) {
        struct pp_atlas_drawn drawn;
        struct pp_error err = {0};
        const struct pp_atlas_trace none = {0};
        if (pp_atlas_drawn_room(&drawn, &design, i, &none, &err) != PP_OK)
            fail_msg("%s", err.message);
        assert_int_equal(drawn.room.receiver_count, PP_ATLAS_POINTS);
        assert_true(drawn.room.world->opening_count > 0);
        pp_atlas_drawn_clear(&drawn);
    }
}

/* 0.8 of the first 2^k rooms have the working plane at 0.85 m, exact to one room: each
 * coordinate is a low-discrepancy net. With random numbers the deviation would be 4 of
 * 128. */
static void a_prefix_is_spread_evenly(void **state)
{
    (void)state;
    int count = 0;
    for (uint32_t i = 0; i < ROOMS; i++) {
        char xml[PP_ATLAS_XML];
        pp_atlas_design_room(&design, i, xml);
        count += number_of(xml, "<working-plane height=\"") > 0.8;
        if (i + 1 == ROOMS / 4 || i + 1 == ROOMS / 2 || i + 1 == ROOMS)
            assert_near(count, 0.8 * (i + 1), 1.0);
    }
}

static int rooms_with(const char *what)
{
    int count = 0;
    for (uint32_t i = 0; i < ROOMS; i++) {
        char xml[PP_ATLAS_XML];
        pp_atlas_design_room(&design, i, xml);
        count += strstr(xml, what) != NULL;
    }
    return count;
}

static void the_sweep_has_every_kind_of_room(void **state)
{
    (void)state;
    static const char *const kinds[] = {
        "<rooflight",    "<envelope",        "<opening",      "<skyline",
        "<block",        "<facade",          "<surface",      "reveal=",
        "wall=\"east\"", "glazing=\"none\"", "transmittance="};
    for (size_t i = 0; i < sizeof kinds / sizeof kinds[0]; i++)
        if (rooms_with(kinds[i]) < ROOMS / 50)
            fail_msg("%d rooms of %d have %s", rooms_with(kinds[i]), (int)ROOMS,
                     kinds[i]);
    assert_int_equal(rooms_with("<sky "), 0);
}

static void points_lie_on_the_plane_away_from_walls(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < ROOMS; i++) {
        char xml[PP_ATLAS_XML];
        pp_atlas_design_room(&design, i, xml);
        if (strstr(xml, "<envelope>"))
            continue;
        double width = number_of(xml, "<plan width=\"");
        const char *at = xml;
        for (int k = 0; k < PP_ATLAS_POINTS; k++) {
            at = strstr(at, "<point x=\"");
            assert_non_null(at);
            double x = number_of(at, "x=\"");
            assert_true(x > 0.249 && x < width - 0.249);
            at++;
        }
    }
}

/* One half is designed as ordinary rooms; the other half also contains some. */
static void half_of_the_rooms_are_ordinary(void **state)
{
    (void)state;
    int ordinary = 0, rooms = PP_SIZED(ROOMS, ROOMS / 2, ROOMS / 4);
    for (int i = 0; i < rooms; i++) {
        struct pp_atlas_drawn drawn;
        struct pp_error err = {0};
        const struct pp_atlas_trace none = {0};
        double features[PP_ROOM_FEATURES];
        if (pp_atlas_drawn_room(&drawn, &design, i, &none, &err) != PP_OK
            || pp_room_features(features, drawn.room.world, &drawn.room.light, &err)
                   != PP_OK)
            fail_msg("%s", err.message);
        ordinary += features[PP_ROOM_ORDINARY] == 1.0;
        pp_atlas_drawn_clear(&drawn);
    }
    assert_in_range(ordinary, rooms * 4 / 10, rooms * 6 / 10);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_room_depends_on_its_index_alone),
        cmocka_unit_test(every_room_makes_sense),
        cmocka_unit_test(a_prefix_is_spread_evenly),
        cmocka_unit_test(the_sweep_has_every_kind_of_room),
        cmocka_unit_test(points_lie_on_the_plane_away_from_walls),
        cmocka_unit_test(half_of_the_rooms_are_ordinary),
    };
    add_tests(tests, set_up, NULL);
}
