/* long_photons.c - photons and paths differ by as many standard errors as two
 * independent simulations of the same value: in every room of examples/ and in 200
 * random rooms. Photons are within their standard errors as often as Student's t
 * predicts, over 60 seeds of 12 rooms. */
#include <glob.h>

#include "tests/lib/photons_of.h"
#include "tests/lib/random_rooms.h"

enum { MOST_POINTS = 6 };

/* Differences in units of their common standard error. */
struct differences {
    int count, beyond_2, beyond_5;
    double sum, squares;
};

static void compare(struct differences *all, const struct pp_world *world,
                    const struct pp_outside_light *light, double error, uint64_t seed)
{
    int points =
        world->receiver_count < MOST_POINTS ? world->receiver_count : (int)MOST_POINTS;
    bool average = world->plane.count > 0;
    struct pp_tracer_options paths = {.error = error, .seed = seed, .average = average};
    struct pp_photons_options forwards = {
        .error = error, .seed = seed, .average = average};
    struct pp_reading(*traced)[4] =
        pp_test_trace(world, light, world->receivers, points, &paths, NULL);
    struct pp_reading(*found)[4] =
        pp_test_photons(world, light, world->receivers, points, &forwards, NULL);
    for (int i = 0; i < points + average; i++) {
        double z = (found[i][PP_DF].value - traced[i][PP_DF].value)
                   / hypot(found[i][PP_DF].std_error, traced[i][PP_DF].std_error);
        all->count++;
        all->sum += z;
        all->squares += z * z;
        all->beyond_2 += fabs(z) > 2.0;
        all->beyond_5 += fabs(z) > 5.0;
    }
    free(traced);
    free(found);
}

/* Student's t with 31 degrees of freedom is approximated by a normal distribution with
 * its variance: 4.5 % are beyond two, within three standard deviations of the count.
 * Paths to points of one room are correlated, so the mean has a tolerance of four. */
static void assert_normal(const struct differences *all)
{
    double n = all->count, mean = all->sum / n;
    double variance = all->squares / n - mean * mean;
    print_message("# %d differences: mean %.3f, variance %.3f, %.1f %% beyond 2\n",
                  all->count, mean, variance, 100.0 * all->beyond_2 / n);
    assert_near(mean, 0.0, 4.0 / sqrt(n));
    assert_near(variance, 1.0, 4.0 * sqrt(2.0 / n));
    assert_near(all->beyond_2 / n, 0.045, 3.0 * sqrt(0.045 / n) + 0.005);
    assert_int_equal(all->beyond_5, 0);
}

static void photons_and_paths_agree_in_200_random_rooms(void **state)
{
    (void)state;
    struct differences all = {.count = 0};
    for (uint64_t room = 3000; room < 3200; room++) {
        struct pp_outside_light light;
        struct pp_world *world = pp_test_random_room(&light, room, 4);
        compare(&all, world, &light, 0.005, room);
        pp_world_destroy(world);
    }
    assert_normal(&all);
}

static void compare_file(struct differences *all, const char *file)
{
    struct pp_building *building = NULL;
    struct pp_mistakes mistakes;
    pp_mistakes_init(&mistakes, file);
    assert_int_equal(pp_building_read(&building, file, &mistakes, NULL), PP_OK);
    for (int i = 0; i < pp_building_room_count(building); i++) {
        struct pp_world *world = NULL;
        struct pp_outside_light light;
        pp_world_create(&world, pp_building_room(building, i), &mistakes, NULL);
        assert_non_null(world);
        assert_int_equal(pp_room_light(&light, pp_building_room(building, i), NULL),
                         PP_OK);
        compare(all, world, &light, 0.01, (uint64_t)i);
        pp_world_destroy(world);
    }
    pp_mistakes_clear(&mistakes);
    pp_building_destroy(building);
}

static void photons_and_paths_agree_in_the_examples(void **state)
{
    (void)state;
    static const char *const folders[] = {"", "/situations", "/sites"};
    const char *top = getenv("srcdir");
    struct differences all = {.count = 0};
    for (size_t i = 0; i < sizeof folders / sizeof *folders; i++) {
        char pattern[4096];
        glob_t files;
        snprintf(pattern, sizeof pattern, "%s/examples%s/*.xml", top ? top : ".",
                 folders[i]);
        assert_int_equal(glob(pattern, 0, NULL, &files), 0);
        for (size_t k = 0; k < files.gl_pathc; k++)
            compare_file(&all, files.gl_pathv[k]);
        globfree(&files);
    }
    assert_normal(&all);
}

enum { SEEDS = 60, POINTS = 4 };

/* Compares each daylight factor with the mean over all seeds. Its error is corrected for
 * the mean's dependence on it. */
static void cover(struct pp_coverage *coverage, struct pp_reading (*all)[POINTS + 1])
{
    for (int i = 0; i <= POINTS; i++) {
        double mean = 0.0;
        for (int seed = 0; seed < SEEDS; seed++)
            mean += all[seed][i].value / SEEDS;
        for (int seed = 0; seed < SEEDS; seed++) {
            all[seed][i].std_error *= sqrt(1.0 - 1.0 / SEEDS);
            pp_coverage_add(coverage, all[seed][i], mean);
        }
    }
}

static void daylight_factors_lie_within_their_errors_over_seeds(void **state)
{
    (void)state;
    struct pp_coverage c = {0, 0, 0, 0};
    for (uint64_t room = 2000; room < 2012; room++) {
        struct pp_reading all[SEEDS][POINTS + 1];
        struct pp_outside_light light;
        struct pp_world *world = pp_test_random_room(&light, room, POINTS);
        for (int seed = 0; seed < SEEDS; seed++) {
            struct pp_photons_options options = {
                .error = 0.03, .seed = (uint64_t)seed, .average = true};
            struct pp_reading(*found)[4] = pp_test_photons(
                world, &light, world->receivers, POINTS, &options, NULL);
            for (int i = 0; i <= POINTS; i++)
                all[seed][i] = found[i][PP_DF];
            free(found);
        }
        cover(&c, all);
        pp_world_destroy(world);
    }
    print_message("# %d values: %.1f %% within 1, %.1f %% within 2, %.2f %% beyond 4\n",
                  c.count, 100.0 * c.within_1 / c.count, 100.0 * c.within_2 / c.count,
                  100.0 * c.beyond_4 / c.count);
    assert_in_range(1000 * c.within_1 / c.count, 660, 730);
    assert_in_range(1000 * c.within_2 / c.count, 935, 970);
    assert_in_range(1000 * c.beyond_4, 0, 3 * c.count);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(photons_and_paths_agree_in_200_random_rooms),
        cmocka_unit_test(photons_and_paths_agree_in_the_examples),
        cmocka_unit_test(daylight_factors_lie_within_their_errors_over_seeds),
    };
    return cmocka_run_group_tests_name("long_photons", tests, NULL, NULL);
}
