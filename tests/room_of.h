/* room_of.h - a world out of a string, for tests. */
#ifndef PP_TESTS_ROOM_OF_H
#define PP_TESTS_ROOM_OF_H

#include "model/room.h"
#include "tests/near.h"

/* The world of the first room in the file's text; the test fails, with the mistakes
 * printed, where there is none. The caller destroys it. */
static inline struct pp_world *pp_test_world(const char *xml)
{
    struct pp_building *building = NULL;
    struct pp_world *world = NULL;
    struct pp_mistakes mistakes;
    struct pp_error err = {0};
    pp_mistakes_init(&mistakes, "test");
    enum pp_status status =
        pp_building_parse(&building, xml, strlen(xml), &mistakes, &err);
    if (status == PP_OK)
        status =
            pp_world_create(&world, pp_building_room(building, 0), &mistakes, &err);
    for (int i = 0; i < mistakes.count; i++)
        print_message("# line %d: %s\n", mistakes.list[i].line, mistakes.list[i].text);
    pp_mistakes_clear(&mistakes);
    pp_building_destroy(building);
    if (status != PP_OK)
        fail_msg("no world: %s", err.message);
    return world;
}

#endif
