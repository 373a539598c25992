/* guessed_room.h - a room with the radiosity estimate of its tracer, for tests. */
#ifndef PP_TESTS_LIB_GUESSED_ROOM_H
#define PP_TESTS_LIB_GUESSED_ROOM_H

#include "simulate/scene/light_scene_parts.h"
#include "simulate/fast/control_variate_solve.h"
#include "tests/lib/room_of.h"
#include "tests/lib/traced.h"

struct pp_test_guessed_room {
    struct pp_outside_light light;
    struct pp_world *world;
    struct pp_light_scene *scene;
    struct pp_environment *environment;
    struct pp_sobol sobol;
    struct pp_control_variate *guess;
};

static inline void pp_test_guessed_room_init(struct pp_test_guessed_room *room,
                                             const char *xml)
{
    room->world = pp_test_lit_world(&room->light, xml);
    room->scene = pp_test_matt_scene(room->world);
    room->environment = pp_test_light_on(room->scene, &room->light);
    pp_sobol_init(&room->sobol);
    assert_int_equal(pp_control_variate_solve(&room->guess, room->scene,
                                              room->environment, &room->sobol, 3, 1,
                                              NULL),
                     PP_OK);
}

static inline void pp_test_guessed_room_clear(struct pp_test_guessed_room *room)
{
    pp_control_variate_destroy(room->guess);
    pp_environment_destroy(room->environment);
    pp_light_scene_destroy(room->scene);
    pp_world_destroy(room->world);
}

#endif
