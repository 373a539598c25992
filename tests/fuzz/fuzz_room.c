/* fuzz_room.c - a room file with any bytes is read and resolved safely.
 *
 * For clang's libFuzzer (make fuzz). The sanitizers report errors. A file must also be
 * rejected with a reason, or accepted.
 */
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>

#include "model/room/building.h"
#include "model/room/room_light.h"
#include "tests/fuzz/must.h"

/* Creates the worlds of the building's rooms. */
static void make_worlds(struct pp_building *building, struct pp_mistakes *mistakes)
{
    struct pp_error err = {PP_OK, ""};
    for (int i = 0; i < pp_building_room_count(building); i++) {
        struct pp_world *world = NULL;
        enum pp_status status =
            pp_world_create(&world, pp_building_room(building, i), mistakes, &err);
        must((status == PP_OK) == (world != NULL));
        must(status != PP_BAD_INPUT || mistakes->count > 0);
        struct pp_outside_light light;
        must(pp_room_light(&light, pp_building_room(building, i), &err) == PP_OK);
        pp_world_destroy(world);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t length)
{
    struct pp_mistakes mistakes;
    struct pp_error err = {PP_OK, ""};
    struct pp_building *building = NULL;
    pp_mistakes_init(&mistakes, "fuzz.xml");

    enum pp_status status =
        pp_building_parse(&building, (const char *)bytes, length, &mistakes, &err);
    must(status == PP_OK || err.message[0] != '\0');
    must((status == PP_BAD_INPUT) == (mistakes.count > 0 || mistakes.truncated));

    if (building)
        make_worlds(building, &mistakes);
    if (building && pp_building_has_states(building)
        && pp_building_set_state(building, PP_STATE_EXISTING, &err) == PP_OK)
        make_worlds(building, &mistakes);
    pp_building_destroy(building);
    pp_mistakes_clear(&mistakes);
    return 0;
}
