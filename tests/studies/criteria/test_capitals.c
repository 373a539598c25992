/* test_capitals.c - the nearest capital in the standard's table, and its
 * illuminance. */
#include "studies/criteria/capitals.h"
#include "model/geometry/vec.h"
#include "tests/lib/near.h"

static struct pp_median at(double latitude_deg, double longitude_deg)
{
    return pp_capitals_median(latitude_deg * PP_RAD, longitude_deg * PP_RAD, "");
}

static void capitals_have_their_own_illuminance(void **state)
{
    (void)state;
    assert_int_equal(pp_capitals_count(), 33);
    for (int i = 0; i < pp_capitals_count(); i++) {
        const struct pp_capital *capital = pp_capitals_at(i);
        struct pp_median median = at(capital->latitude_deg, capital->longitude_deg);
        assert_near(median.lux, capital->median_lux, 0.0);
        assert_non_null(strstr(median.how, capital->name));
        assert_ptr_equal(pp_capitals_find(capital->name), capital);
    }
    assert_near(pp_capitals_find("LONDON")->median_lux, 14100.0, 0.0);
    assert_null(pp_capitals_find("Londinium"));
}

/* The table prints the target daylight factor for 300 lx to a tenth of a per cent. */
static void illuminances_agree_with_the_printed_targets(void **state)
{
    (void)state;
    for (int i = 0; i < pp_capitals_count(); i++)
        assert_near(100.0 * 300.0 / pp_capitals_at(i)->median_lux,
                    pp_capitals_at(i)->target_300_percent, 0.05 + 1e-9);
}

/* The distance is along the great circle: Cambridge is 78 km from London, although
 * Warsaw's latitude is closer. */
static void nearness_goes_by_the_great_circle(void **state)
{
    (void)state;
    assert_non_null(strstr(at(52.2, 0.1).how, "London, the nearest capital, 78 km"));
    struct pp_median by_latitude = at(52.2, NAN);
    assert_non_null(
        strstr(by_latitude.how, "Warsaw, the capital at the nearest latitude"));
    assert_near(by_latitude.lux, 14700.0, 0.0);

    assert_true(isnan(at(64.13, 179.0).lux));
}

/* Milan and Marseille are closer to Bern, Munich to Prague. 300 lx in Milan require a
 * daylight factor of 1.5625 % with Rome's 19,200 lx, and 1.875 % with Bern's 16,000
 * lx. */
static void the_table_goes_by_nation(void **state)
{
    (void)state;
    double latitude = 45.46 * PP_RAD, longitude = 9.19 * PP_RAD;
    struct pp_median milan = pp_capitals_median(latitude, longitude, "IT");
    assert_near(milan.lux, 19200.0, 0.0);
    assert_non_null(strstr(milan.how, "Rome, the capital of IT"));
    struct pp_median nearest = pp_capitals_median(latitude, longitude, "");
    assert_near(nearest.lux, 16000.0, 0.0);
    assert_non_null(strstr(nearest.how, "site has no country"));
    assert_near(pp_capitals_median(NAN, NAN, "SE").lux, 12100.0, 0.0);
    assert_non_null(
        strstr(pp_capitals_median(NAN, NAN, "RO").how, "not checked against"));
    assert_non_null(
        strstr(pp_capitals_median(latitude, longitude, "SM").how, "no capital for"));
    for (int i = 0; i < pp_capitals_count(); i++)
        assert_ptr_equal(pp_capitals_of_country(pp_capitals_at(i)->country),
                         pp_capitals_at(i));
}

/* North of Reykjavik, the nearest capital. */
static void a_capital_is_used_up_to_a_thousand_kilometres_away(void **state)
{
    (void)state;
    const struct pp_capital *capital = pp_capitals_find("Reykjavik");
    double degree_km = 6371.0 * PP_RAD;
    double near = capital->latitude_deg + 990.0 / degree_km;
    double far = capital->latitude_deg + 1010.0 / degree_km;
    assert_near(at(near, capital->longitude_deg).lux, capital->median_lux, 0.0);
    assert_true(isnan(at(far, capital->longitude_deg).lux));
}

static void no_suggestion_is_made_far_from_all_names(void **state)
{
    (void)state;
    static const struct {
        double latitude, longitude;
        const char *why;
    } cases[] = {
        {NAN, NAN, "--place"},
        {NAN, 12.0, "no latitude"},
        {-34.6, -58.4, "km away"},
        {40.7, -74.0, "km away"},
        {-34.6, NAN, "degrees of latitude"},
        {10.0, NAN, "Nicosia"},
        {89.9, 0.0, "Reykjavik"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct pp_median median = at(cases[i].latitude, cases[i].longitude);
        assert_true(isnan(median.lux));
        assert_non_null(strstr(median.how, cases[i].why));
    }
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(capitals_have_their_own_illuminance),
        cmocka_unit_test(illuminances_agree_with_the_printed_targets),
        cmocka_unit_test(nearness_goes_by_the_great_circle),
        cmocka_unit_test(the_table_goes_by_nation),
        cmocka_unit_test(no_suggestion_is_made_far_from_all_names),
        cmocka_unit_test(a_capital_is_used_up_to_a_thousand_kilometres_away),
    };
    add_tests(tests, NULL, NULL);
}
