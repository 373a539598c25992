/* test_compare.c - cases with known causes, simulated with another seed: causes and
 * their shares are found. */
#include "studies/research/compare/compare.h"
#include "tests/studies/research/compare/compared_room.h"

static const char small[] =
    "<room version='1'><site ground-reflectance='0'/><plan width='3.1' depth='4.3' "
    "height='2.7'/>"
    "<finishes floor='0.15' walls='0.35' ceiling='0.6'/>"
    "<window wall='south' left='0.7' sill='0.9' width='1.9' height='1.3' "
    "glazing='clear-double' maintenance='0.8'/>"
    "<working-plane height='0.8'/><grid spacing='1.5' margin='0.4'/></room>";

/* Noise of about 1 %, without a spatial pattern. */
static double noise(int i)
{
    static const double even[] = {0.3, -1.2, 0.9, 0.1, -0.4, 1.4, -0.8, -0.1};
    return 0.01 * even[i % 8];
}

struct fixture {
    struct pp_test_compared room;
    struct pp_compare *compare;
};

static int set_up(void **state)
{
    static struct fixture fixture;
    const struct pp_compare_options options = {
        .variant = pp_room_variant_nothing(),
        .tracing = {.error = 0.02, .seed = 1, .threads = 1},
        .noise = 0.03}; /* 1 % in the other program's values, both simulated to 2 % */
    pp_test_compared_init(&fixture.room, small);
    const struct pp_compare_subject subject =
        pp_compare_subject_of_room(&fixture.room.study);
    assert_int_equal(pp_compare_create(&fixture.compare, &subject, &options, NULL),
                     PP_OK);
    *state = &fixture;
    return 0;
}

static int tear_down(void **state)
{
    struct fixture *fixture = *state;
    pp_compare_destroy(fixture->compare);
    pp_test_compared_clear(&fixture->room);
    return 0;
}

static void explain(struct pp_compared *compared, struct fixture *fixture,
                    const char *words)
{
    double theirs[PP_COMPARE_POINTS_MOST], errors[PP_COMPARE_POINTS_MOST];
    struct pp_error err = {0};
    pp_test_compared_values(theirs, errors, &fixture->room, words, 0.02, 7);
    for (int i = 0; i < fixture->room.study.receiver_count; i++)
        theirs[i] *= exp(noise(i));
    if (pp_compare_explain(compared, fixture->compare, theirs, &err) != PP_OK)
        fail_msg("%s", err.message);
}

/* True if the set contains the cause with this word. */
static bool has(const struct fixture *fixture, const struct pp_cause_set *set,
                const char *word)
{
    const struct pp_cause *const *list;
    pp_compare_causes(fixture->compare, &list);
    for (int i = 0; i < set->count; i++)
        if (strcmp(list[set->causes[i]]->word, word) == 0)
            return true;
    return false;
}

static void the_same_room_has_nothing_to_explain(void **state)
{
    struct pp_compared compared;
    explain(&compared, *state, NULL);
    assert_int_equal(compared.search.sets[0].count, 0);
    assert_true(fabs(compared.gap) < 0.02);
    pp_compare_clear(&compared);
}

/* True if the cause with this word is certain. */
static bool is_sure(const struct fixture *fixture, const struct pp_compared *compared,
                    const char *word)
{
    const struct pp_cause *const *list;
    int count = pp_compare_causes(fixture->compare, &list);
    for (int i = 0; i < count; i++)
        if (strcmp(list[i]->word, word) == 0)
            return pp_compare_is_sure(compared, i);
    return false;
}

static void reflections_cut_off_are_named_and_close_the_gap(void **state)
{
    struct pp_compared compared;
    explain(&compared, *state, "bounces=1");
    assert_int_equal(compared.search.sets[0].count, 1);
    assert_true(has(*state, &compared.search.sets[0], "bounces=1"));
    assert_true(compared.left_rms < 0.2 * compared.gap_rms);
    assert_near(compared.shares[0], 1.0, 0.05);
    pp_compare_clear(&compared);
}

static void two_causes_are_named_with_shares_that_sum_up(void **state)
{
    struct pp_compared compared;
    explain(&compared, *state, "plane=0,sky=uniform");
    const struct pp_cause_set *set = &compared.search.sets[0];
    assert_int_equal(set->count, 2);
    assert_true(has(*state, set, "plane=0") && has(*state, set, "sky=uniform"));
    assert_near(compared.shares[0] + compared.shares[1],
                1.0
                    - compared.left_rms * compared.left_rms
                          / (compared.gap_rms * compared.gap_rms),
                1e-9);
    assert_near(compared.effects[0] + compared.effects[1] + compared.left, compared.gap,
                1e-9);
    pp_compare_clear(&compared);
}

/* Light from the ground reaches the back via the ceiling. Five standard errors: 2 % for
 * values at 6 points that increase by 0.9 times the reflectance. */
static void the_reflectance_of_the_ground_is_found(void **state)
{
    struct pp_compared compared;
    explain(&compared, *state, "ground=0.43");
    const struct pp_cause_set *set = &compared.search.sets[0];
    assert_int_equal(set->count, 1);
    assert_true(has(*state, set, "ground"));
    assert_near(set->value, 0.43, 0.05);
    pp_compare_clear(&compared);
}

/* Walls of 0.2 instead of 0.35 are not in any list of causes. */
static void a_mistake_that_is_on_no_list_leaves_nothing_sure(void **state)
{
    struct fixture *fixture = *state;
    struct pp_test_compared darker;
    struct pp_compared compared;
    double theirs[PP_COMPARE_POINTS_MOST], errors[PP_COMPARE_POINTS_MOST];
    char xml[1024];
    const char *at = strstr(small, "walls='0.35'");
    snprintf(xml, sizeof xml, "%.*swalls='0.2'%s", (int)(at - small), small,
             at + strlen("walls='0.35'"));
    pp_test_compared_init(&darker, xml);
    pp_test_compared_values(theirs, errors, &darker, NULL, 0.01, 7);
    assert_int_equal(pp_compare_explain(&compared, fixture->compare, theirs, NULL),
                     PP_OK);
    const struct pp_cause *const *list;
    int count = pp_compare_causes(fixture->compare, &list);
    assert_true(compared.gap < -0.05);
    for (int i = 0; i < count; i++)
        assert_false(pp_compare_is_sure(&compared, i));
    pp_compare_clear(&compared);
    pp_test_compared_clear(&darker);
}

/* The same cause and the same set, but the stated scatter of the other values is
 * smaller than the unexplained rest. */
static void nothing_is_sure_beside_more_than_noise(void **state)
{
    struct fixture *fixture = *state;
    struct pp_compare *strict;
    struct pp_compared compared;
    const struct pp_compare_subject subject =
        pp_compare_subject_of_room(&fixture->room.study);
    const struct pp_compare_options options = {
        .variant = pp_room_variant_nothing(),
        .tracing = {.error = 0.02, .seed = 1, .threads = 1},
        .noise = 0.002};
    explain(&compared, fixture, "plane=0");
    assert_true(is_sure(fixture, &compared, "plane=0"));
    pp_compare_clear(&compared);
    assert_int_equal(pp_compare_create(&strict, &subject, &options, NULL), PP_OK);
    struct fixture own = {fixture->room, strict};
    explain(&compared, &own, "plane=0");
    assert_true(has(&own, &compared.search.sets[0], "plane=0"));
    assert_true(pp_left_over_exceeds(&compared.over));
    assert_false(is_sure(&own, &compared, "plane=0"));
    pp_compare_clear(&compared);
    pp_compare_destroy(strict);
}

/* Without light from the sky all values are 0, which no other cause produces. */
static void values_of_nothing_are_of_no_light_at_all(void **state)
{
    struct pp_compared compared;
    explain(&compared, *state, "ab=0");
    assert_int_equal(compared.search.sets[0].count, 1);
    assert_true(has(*state, &compared.search.sets[0], "ab=0"));
    assert_true(isfinite(compared.gap) && isfinite(compared.left_rms));
    pp_compare_clear(&compared);
}

static void only_what_the_room_has_is_listed(void **state)
{
    struct fixture *fixture = *state;
    const struct pp_cause *const *list;
    int count = pp_compare_causes(fixture->compare, &list);
    for (int i = 0; i < count; i++) {
        assert_string_not_equal(list[i]->word, "frame=none");
        assert_string_not_equal(list[i]->word, "outside=none");
        assert_string_not_equal(list[i]->word, "ground=open");
    }
    assert_true(count > 10);
}

static void words_of_all_causes_are_switches(void **state)
{
    (void)state;
    const struct pp_cause *cause;
    int count = 0;
    for (; (cause = pp_causes_at(count)) != NULL; count++) {
        struct pp_room_variant variant = pp_room_variant_nothing();
        if (!cause->is_factor)
            assert_int_equal(pp_causes_set_variant(&variant, cause, 0.37, NULL), PP_OK);
        if (pp_causes_is_fitted(cause))
            assert_near(variant.ground, 0.37, 1e-9);
    }
    assert_true(count <= PP_CAUSES_MOST);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_same_room_has_nothing_to_explain),
        cmocka_unit_test(reflections_cut_off_are_named_and_close_the_gap),
        cmocka_unit_test(two_causes_are_named_with_shares_that_sum_up),
        cmocka_unit_test(the_reflectance_of_the_ground_is_found),
        cmocka_unit_test(a_mistake_that_is_on_no_list_leaves_nothing_sure),
        cmocka_unit_test(nothing_is_sure_beside_more_than_noise),
        cmocka_unit_test(values_of_nothing_are_of_no_light_at_all),
        cmocka_unit_test(only_what_the_room_has_is_listed),
        cmocka_unit_test(words_of_all_causes_are_switches),
    };
    add_tests(tests, set_up, tear_down);
}
