/* test_path.c - gathered light and its correction along paths, with correct and wrong
 * estimates of radiosity. */
#include "simulate/fast/path.h"

#include <math.h>

#include "tests/lib/guessed_room.h"

/* Most of its light comes from the wall beside the window and the sides of its niche;
 * the point is at the back. */
#define ROOM                                                                           \
    "<room version='1'><plan width='3.7' depth='9.1' height='3.2'/>"                   \
    "<finishes floor='0.3' walls='0.8' ceiling='0.6'/>"                                \
    "<window wall='south' left='0.6' sill='0.7' width='1.3' height='1.4' "             \
    "reveal='0.25'/><point x='2.9' y='8.2' z='0.85'/></room>"

static struct pp_path_state state_of(const struct pp_test_guessed_room *room)
{
    return pp_path_state(room->scene, room->environment, room->guess);
}

static struct pp_start start_of(const struct pp_test_guessed_room *room)
{
    const struct pp_receiver *receiver = &room->world->receivers[0];
    return (struct pp_start){.position =
                                 pp_vec_sub(receiver->position, room->scene->centre),
                             .normal = receiver->normal};
}

/* Light of the room's surfaces at the point, including direct light on the sides of the
 * niche, and its standard deviation over nets of paths. niches: true if paths are aimed
 * at the mouths of niches. */
enum { NETS = 64 };

struct found_light {
    double mean, deviation;
};

static struct found_light reflected(const struct pp_test_guessed_room *room,
                                    uint32_t paths, bool niches)
{
    struct pp_path_state state = state_of(room);
    assert_non_null(state.niches);
    if (!niches)
        state.niches = NULL;
    const struct pp_start start = start_of(room);
    double sum = 0.0, squares = 0.0;
    for (uint64_t net = 0; net < NETS; net++) {
        double light = 0.0;
        struct pp_light direct = {{0.0, 0.0, 0.0}};
        pp_sobol_sequence_init(&state.light.sequence, &room->sobol, 3 * net);
        state.light.index = 0;
        pp_path_gather(&state, &start, paths, &light);
        pp_sobol_sequence_init(&state.light.sequence, &room->sobol, 3 * net + 1);
        state.light.index = 0;
        pp_path_correction(&state, &start, paths, &light);
        pp_sobol_sequence_init(&state.light.sequence, &room->sobol, 3 * net + 2);
        state.light.index = 0;
        pp_path_direct(&state, &start, paths, &direct);
        light = (light + direct.part[PP_IRC]) / paths;
        sum += light;
        squares += light * light;
    }
    double mean = sum / NETS;
    return (struct found_light){mean, sqrt((squares - sum * mean) / (NETS - 1))};
}

/* An estimate that is too low in some places, too high in others and zero elsewhere
 * aims paths at the wrong places, but the result is the same. */
static void light_does_not_depend_on_the_guess(void **state)
{
    (void)state;
    static const double wrong[] = {0.3, 2.9, 0.0, 1.0, 0.1};
    struct pp_test_guessed_room room;
    pp_test_guessed_room_init(&room, ROOM);
    struct found_light right = reflected(&room, 512, true);
    for (int i = 0; i < room.guess->count; i++)
        room.guess->values[i] *= wrong[i * 7 / 3 % 5];
    struct found_light other = reflected(&room, 512, true);
    double both = hypot(right.deviation, other.deviation) / sqrt(NETS);
    assert_near(other.mean, right.mean, 3.0 * both);
    assert_near(both / right.mean, 0.0, 0.03);
    for (int i = 0; i < room.guess->count; i++)
        room.guess->values[i] = 0.0;
    other = reflected(&room, 512, true);
    both = hypot(right.deviation, other.deviation) / sqrt(NETS);
    assert_near(other.mean, right.mean, 3.0 * both);
    pp_test_guessed_room_clear(&room);
}

/* A path continues in one of several directions, chosen by estimated light: the
 * deviation of 64 paths is 5.5 %. A choice without the estimate gives 6.4 %. */
static void paths_go_to_where_there_is_light(void **state)
{
    (void)state;
    struct pp_test_guessed_room room;
    pp_test_guessed_room_init(&room, ROOM);
    struct found_light found = reflected(&room, 64, true);
    assert_near(found.deviation / found.mean, 0.0, 0.06);
    pp_test_guessed_room_clear(&room);
}

/* Next-event estimation of the mouth includes the light of the niche's sides, and rays
 * that reach these sides directly omit it. The sum equals that of rays alone, with less
 * noise. */
static void aiming_at_the_mouth_finds_the_sides_of_the_niche(void **state)
{
    (void)state;
    struct pp_test_guessed_room room;
    pp_test_guessed_room_init(&room, ROOM);
    struct found_light aimed = reflected(&room, 512, true);
    struct found_light by_rays = reflected(&room, 512, false);
    double both = hypot(aimed.deviation, by_rays.deviation) / sqrt(NETS);
    assert_near(aimed.mean, by_rays.mean, 3.0 * both);
    assert_near(aimed.deviation / by_rays.deviation, 0.0, 0.6);
    pp_test_guessed_room_clear(&room);
}

/* Sums of all three estimators for the paths up to `end`, in steps of `step`. */
struct path_sums {
    struct pp_light direct;
    double gathered, correction;
};

static uint32_t nearer(uint32_t a, uint32_t b)
{
    return a < b ? a : b;
}

static struct path_sums sums_of(const struct pp_test_guessed_room *room, uint32_t end,
                                uint32_t step)
{
    struct pp_path_state state = state_of(room);
    const struct pp_start start = start_of(room);
    struct path_sums sums = {.direct = {{0.0, 0.0, 0.0}}};
    uint32_t *index = &state.light.index;
    pp_sobol_sequence_init(&state.light.sequence, &room->sobol, 17);
    for (*index = 0; *index < end;)
        pp_path_direct(&state, &start, nearer(*index + step, end), &sums.direct);
    for (*index = 0; *index < end;)
        pp_path_gather(&state, &start, nearer(*index + step, end), &sums.gathered);
    for (*index = 0; *index < end;)
        pp_path_correction(&state, &start, nearer(*index + step, end),
                           &sums.correction);
    return sums;
}

/* Paths are calculated in runs of up to sixteen; the sums are identical to those of
 * single paths. */
static void paths_in_runs_are_those_one_by_one(void **state)
{
    (void)state;
    struct pp_test_guessed_room room;
    pp_test_guessed_room_init(&room, ROOM);
    struct path_sums one_by_one = sums_of(&room, 117, 1);
    assert_true(one_by_one.direct.part[PP_IRC] > 0.0 && one_by_one.gathered > 0.0);
    assert_true(one_by_one.correction != 0.0);
    static const uint32_t steps[] = {3, 8, 32, 117};
    for (int i = 0; i < 4; i++) {
        struct path_sums sums = sums_of(&room, 117, steps[i]);
        assert_memory_equal(&sums, &one_by_one, sizeof sums);
    }
    pp_test_guessed_room_clear(&room);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(light_does_not_depend_on_the_guess),
        cmocka_unit_test(paths_go_to_where_there_is_light),
        cmocka_unit_test(aiming_at_the_mouth_finds_the_sides_of_the_niche),
        cmocka_unit_test(paths_in_runs_are_those_one_by_one),
    };
    add_tests(tests, NULL, NULL);
}
