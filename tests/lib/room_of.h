/* room_of.h - the world and light of a room file given as a string, for tests. */
#ifndef PP_TESTS_LIB_ROOM_OF_H
#define PP_TESTS_LIB_ROOM_OF_H

#include <stdio.h>

#include "model/room/building.h"
#include "model/room/room_light.h"
#include "tests/lib/near.h"

/* World of the first room in the file's text, and its mistakes; NULL if there are any.
 * The caller clears the mistakes and destroys the world. */
static inline struct pp_world *pp_test_resolve(const char *xml,
                                               struct pp_mistakes *mistakes)
{
    struct pp_building *building = NULL;
    struct pp_world *world = NULL;
    pp_mistakes_init(mistakes, "test");
    if (pp_building_parse(&building, xml, strlen(xml), mistakes, NULL) == PP_OK)
        pp_world_create(&world, pp_building_room(building, 0), mistakes, NULL);
    pp_building_destroy(building);
    return world;
}

/* World of a valid room; mistakes are printed and fail the test. */
static inline struct pp_world *pp_test_world(const char *xml)
{
    struct pp_mistakes mistakes;
    struct pp_world *world = pp_test_resolve(xml, &mistakes);
    for (int i = 0; i < mistakes.count; i++)
        print_message("# line %d: %s\n", mistakes.list[i].line, mistakes.list[i].text);
    pp_mistakes_clear(&mistakes);
    assert_non_null(world);
    return world;
}

/* Outdoor light of the file's room. */
static inline struct pp_outside_light pp_test_light(const char *xml)
{
    struct pp_building *building = NULL;
    struct pp_mistakes mistakes;
    struct pp_outside_light light;
    pp_mistakes_init(&mistakes, "test");
    assert_int_equal(pp_building_parse(&building, xml, strlen(xml), &mistakes, NULL),
                     PP_OK);
    assert_int_equal(pp_room_light(&light, pp_building_room(building, 0), NULL), PP_OK);
    pp_mistakes_clear(&mistakes);
    pp_building_destroy(building);
    return light;
}

/* World and outdoor light of a valid room. */
static inline struct pp_world *pp_test_lit_world(struct pp_outside_light *light,
                                                 const char *xml)
{
    struct pp_world *world = pp_test_world(xml);
    *light = pp_test_light(xml);
    return world;
}

#endif
