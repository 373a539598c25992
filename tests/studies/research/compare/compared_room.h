/* compared_room.h - a room given as text, with its points, for tests of comparisons. */
#ifndef PP_TESTS_STUDIES_RESEARCH_COMPARE_COMPARED_ROOM_H
#define PP_TESTS_STUDIES_RESEARCH_COMPARE_COMPARED_ROOM_H

#include "studies/research/compare/variant_values.h"
#include "tests/lib/room_of.h"

struct pp_test_compared {
    struct pp_building *building;
    struct pp_study_room study;
};

static inline void pp_test_compared_init(struct pp_test_compared *room, const char *xml)
{
    struct pp_mistakes mistakes;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(&light, xml);
    pp_mistakes_init(&mistakes, "test");
    assert_int_equal(
        pp_building_parse(&room->building, xml, strlen(xml), &mistakes, NULL), PP_OK);
    pp_mistakes_clear(&mistakes);
    pp_study_room_init(&room->study, "test", room->building, 0,
                       pp_building_room(room->building, 0), world, &light);
}

static inline void pp_test_compared_clear(struct pp_test_compared *room)
{
    pp_study_room_clear(&room->study);
    pp_building_destroy(room->building);
}

/* Values of a variant, with this standard error. */
static inline void pp_test_compared_values(double *values, double *errors,
                                           const struct pp_test_compared *room,
                                           const char *words, double error,
                                           uint64_t seed)
{
    struct pp_room_variant variant = pp_room_variant_nothing();
    struct pp_error err = {0};
    const struct pp_variant_tracing tracing = {
        .error = error, .seed = seed, .threads = 1};
    if ((words && pp_room_variant_add(&variant, words, &err) != PP_OK)
        || pp_variant_values(values, errors, &room->study, &variant, &tracing, &err)
               != PP_OK)
        fail_msg("%s", err.message);
}

#endif
