/* test_options.c - the arguments of a command line, parsed by the tables of options. */
#include "tests/lib/near.h"

#include "cli/options.h"
#include "cli/room_options.h"

struct words {
    const char *name;
    bool flag;
    double error, seconds;
    long samples;
    int threads;
    uint64_t seed;
};

static const struct pp_option table[] = {
    {"name", 'n', "NAME", "A name.", pp_options_read_text,
     offsetof(struct words, name)},
    {"flag", 'x', NULL, "A flag.", NULL, offsetof(struct words, flag)},
    {"error", 0, "E", "An error.", pp_options_read_per_cent,
     offsetof(struct words, error)},
    {"time", 0, "T", "A time.", pp_options_read_seconds,
     offsetof(struct words, seconds)},
    {"samples", 0, "N", "A count.", pp_options_read_count,
     offsetof(struct words, samples)},
    {"threads", 0, "N", "Threads.", pp_options_read_threads,
     offsetof(struct words, threads)},
    {"seed", 0, "N", "A seed.", pp_options_read_seed, offsetof(struct words, seed)},
    {0},
};

enum { MOST = 12 };

/* Parses words (ended by NULL) after the command; the operands remain in them. */
static enum pp_status read_words(struct words *values, const char *words[MOST],
                                 int *operands, bool *help, struct pp_error *err)
{
    const struct pp_option_group groups[] = {{"Options", table, 0}, {0}};
    const struct pp_command_line line = {"try", "FILE", "Tries.", groups, NULL, values};
    int count = 0;
    while (words[count])
        count++;
    *values = (struct words){0};
    return pp_options_read(&line, count, (char **)words, operands, help, err);
}

static void accept(struct words *values, const char *words[MOST])
{
    struct pp_error err = {0};
    int operands;
    bool help;
    if (read_words(values, words, &operands, &help, &err) != PP_OK)
        fail_msg("%s", err.message);
    assert_int_equal(operands, 0);
    assert_false(help);
}

/* Asserts that the words are rejected with a message that contains `said`. */
static void refuse(const char *words[MOST], const char *said)
{
    struct words values;
    struct pp_error err = {0};
    int operands;
    bool help;
    assert_int_equal(read_words(&values, words, &operands, &help, &err), PP_BAD_INPUT);
    if (!strstr(err.message, said))
        fail_msg("\"%s\" does not say \"%s\"", err.message, said);
}

#define WORDS(...)                                                                     \
    (const char *[MOST])                                                               \
    {                                                                                  \
        "try", __VA_ARGS__, NULL                                                       \
    }

static void a_value_stands_behind_an_equals_sign_or_is_the_next_word(void **state)
{
    (void)state;
    struct words values;
    accept(&values, WORDS("--name=a=b", "--seed", "7"));
    assert_string_equal(values.name, "a=b");
    assert_int_equal(values.seed, 7);
    accept(&values, WORDS("-n", "-x"));
    assert_string_equal(values.name, "-x");
    assert_false(values.flag);
    accept(&values, WORDS("-nname", "-x"));
    assert_string_equal(values.name, "name");
    assert_true(values.flag);
}

static void operands_keep_their_order_between_options(void **state)
{
    (void)state;
    struct words values;
    int operands;
    bool help;
    const char **words = WORDS("one", "--flag", "-", "--", "--name", "-x");
    assert_int_equal(read_words(&values, words, &operands, &help, NULL), PP_OK);
    assert_int_equal(operands, 4);
    assert_string_equal(words[0], "one");
    assert_string_equal(words[1], "-");
    assert_string_equal(words[2], "--name");
    assert_string_equal(words[3], "-x");
    assert_null(values.name);
}

static void help_is_given_with_any_further_arguments(void **state)
{
    (void)state;
    struct words values;
    int operands;
    bool help;
    assert_int_equal(
        read_words(&values, WORDS("-h", "--nonsense"), &operands, &help, NULL), PP_OK);
    assert_true(help);
}

static void an_unknown_option_suggests_the_nearest(void **state)
{
    (void)state;
    refuse(WORDS("--sampels=3"), "did you mean --samples?");
    refuse(WORDS("--zzzzzz"), "there is no option --zzzzzz");
    refuse(WORDS("-z"), "there is no option -z");
    refuse(WORDS("-\xc3\xa9"), "there is no option -\xc3\xa9");
}

static void switches_take_no_value_and_others_need_one(void **state)
{
    (void)state;
    refuse(WORDS("--flag=yes"), "--flag takes no value");
    refuse(WORDS("-xyes"), "-x takes no value");
    refuse(WORDS("--name"), "--name needs a value");
    refuse(WORDS("--name="), "not empty");
}

static void per_cent_become_fractions(void **state)
{
    (void)state;
    struct words values;
    accept(&values, WORDS("--error", "1%"));
    assert_near(values.error, 0.01, 0.0);
    accept(&values, WORDS("--error", "0.5"));
    assert_near(values.error, 0.005, 0.0);
    const char *wrong[] = {"0%",  "-1%",   "101%", "1,5%", "nan",
                           "inf", "0x1p3", "%",    "1%%",  "1e999"};
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++)
        refuse(WORDS("--error", wrong[i]), "expected a percentage");
}

static void times_have_their_units(void **state)
{
    (void)state;
    struct words values;
    const struct {
        const char *typed;
        double seconds;
    } times[] = {
        {"10s", 10.0}, {"500ms", 0.5}, {"2m", 120.0}, {"1.5h", 5400.0}, {"3", 3.0}};
    for (size_t i = 0; i < sizeof times / sizeof times[0]; i++) {
        accept(&values, WORDS("--time", times[i].typed));
        assert_relative(values.seconds, times[i].seconds, 1e-15);
    }
    const char *wrong[] = {"0s", "-3s", "s", "10 days", "1e300h", "1:30"};
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++)
        refuse(WORDS("--time", wrong[i]), "such as 10s");
}

static void counts_are_whole_and_in_range(void **state)
{
    (void)state;
    struct words values;
    accept(&values, WORDS("--samples", "1000000000000000", "--threads=1024",
                          "--seed=18446744073709551615"));
    assert_true(values.samples == 1000000000000000);
    assert_int_equal(values.threads, 1024);
    assert_true(values.seed == UINT64_MAX);
    const char *wrong[] = {"0", "-1", "1.5", "1e3", "+3", "99999999999999999999999",
                           ""};
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        refuse(WORDS("--samples", wrong[i]), "a whole number from 1");
        refuse(WORDS("--threads", wrong[i]), "a whole number from 1 to 1024");
    }
    refuse(WORDS("--threads", "1025"), "to 1024");
    refuse(WORDS("--seed", "18446744073709551616"), "a whole number from 0");
}

/* ---- options shared by all commands on a room ---- */

static void illuminances_are_sensible(void **state)
{
    (void)state;
    static const char *const wrong[] = {"0", "-5000", "1e9", "nan", "bright", ""};
    double lux = 7.0;
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++)
        assert_int_equal(pp_options_read_lux(wrong[i], &lux, NULL), PP_BAD_INPUT);
    assert_near(lux, 7.0, 0.0);
    assert_int_equal(pp_options_read_lux("5000", &lux, NULL), PP_OK);
    assert_near(lux, 5000.0, 0.0);
    assert_int_equal(pp_options_read_lux("14.1e3 lx", &lux, NULL), PP_OK);
    assert_near(lux, 14100.0, 0.0);
}

static enum pp_status read_points(struct pp_room_options *options, const char *text)
{
    const struct pp_option_group groups[] = {{"", pp_room_points_option, 0}, {0}};
    const struct pp_command_line line = {"try", "", "", groups, NULL, options};
    int operands;
    bool help;
    const char *words[] = {"try", "--points", text, NULL};
    return pp_options_read(&line, 3, (char **)words, &operands, &help, NULL);
}

static void points_add_up_and_may_leave_out_their_height(void **state)
{
    (void)state;
    struct pp_room_options options = pp_room_options_none;
    assert_int_equal(read_points(&options, "1.5,-.5  2,3,0.7;4,5"), PP_OK);
    assert_int_equal(read_points(&options, "6,7"), PP_OK);
    assert_int_equal(options.study.points.count, 4);
    assert_near(options.study.points.list[0].y, -0.5, 0.0);
    assert_true(isnan(options.study.points.list[0].z));
    assert_near(options.study.points.list[1].z, 0.7, 0.0);
    assert_near(options.study.points.list[3].x, 6.0, 0.0);
    pp_room_options_clear(&options);
}

static void invalid_points_are_rejected(void **state)
{
    (void)state;
    const char *wrong[] = {"",        " ",     "1",   "1,",    ",1",
                           "1,2,3,4", "1,2 3", "a,b", "nan,1", "1e9,1"};
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        struct pp_room_options options = pp_room_options_none;
        assert_int_equal(read_points(&options, wrong[i]), PP_BAD_INPUT);
        pp_room_options_clear(&options);
    }
}

static void limits_of_the_simulation_need_a_simulation(void **state)
{
    (void)state;
    struct pp_room_options options = pp_room_options_none;
    options.study.error = 0.01;
    assert_int_equal(pp_room_options_settle(&options, NULL), PP_BAD_INPUT);
    options.study.simulate = true;
    assert_int_equal(pp_room_options_settle(&options, NULL), PP_OK);
    assert_near(options.study.error, 0.01, 0.0);
    options.study.samples = 64;
    assert_int_equal(pp_room_options_settle(&options, NULL), PP_BAD_INPUT);
    pp_room_options_clear(&options);
}

static void a_simulation_without_an_end_stops_at_one_per_cent(void **state)
{
    (void)state;
    struct pp_room_options options = pp_room_options_none;
    options.study.simulate = true;
    assert_int_equal(pp_room_options_settle(&options, NULL), PP_OK);
    assert_near(options.study.error, 0.01, 0.0);
    pp_room_options_clear(&options);
    options = pp_room_options_none;
    options.study.simulate = true;
    options.study.seconds = 2.5;
    assert_int_equal(pp_room_options_settle(&options, NULL), PP_OK);
    assert_near(options.study.error, 0.0, 0.0);
    pp_room_options_clear(&options);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_value_stands_behind_an_equals_sign_or_is_the_next_word),
        cmocka_unit_test(operands_keep_their_order_between_options),
        cmocka_unit_test(help_is_given_with_any_further_arguments),
        cmocka_unit_test(an_unknown_option_suggests_the_nearest),
        cmocka_unit_test(switches_take_no_value_and_others_need_one),
        cmocka_unit_test(per_cent_become_fractions),
        cmocka_unit_test(illuminances_are_sensible),
        cmocka_unit_test(times_have_their_units),
        cmocka_unit_test(counts_are_whole_and_in_range),
        cmocka_unit_test(points_add_up_and_may_leave_out_their_height),
        cmocka_unit_test(invalid_points_are_rejected),
        cmocka_unit_test(a_simulation_without_an_end_stops_at_one_per_cent),
        cmocka_unit_test(limits_of_the_simulation_need_a_simulation),
    };
    add_tests(tests, NULL, NULL);
}
