/* test_tone.c - mapping of luminances to the range of a display. */
#include "tests/lib/near.h"

#include "model/pictures/tone.h"

/* A picture of one row with the given luminances. */
static struct pp_picture row_of(const double *luminances, int count)
{
    struct pp_picture picture;
    assert_int_equal(pp_picture_init(&picture, count, 1, NULL), PP_OK);
    for (int i = 0; i < 3 * count; i++)
        picture.rgb[i] = (float)luminances[i / 3];
    return picture;
}

static struct pp_tone tone_of(const struct pp_picture *picture, enum pp_tone_way way,
                              double white)
{
    struct pp_tone tone;
    const struct pp_tone_options options = {way, white, 1.0, 1.0};
    assert_int_equal(pp_tone_prepare(&tone, picture, &options, NULL), PP_OK);
    return tone;
}

/* The pieces of the published curve meet within the rounding of their constants; for
 * bright light they follow Weber's law: 10^-1.255, 5.6 %. */
static void an_eye_in_bright_light_sees_a_difference_of_five_per_cent(void **state)
{
    (void)state;
    assert_relative(pp_tone_threshold(1000.0), 55.59, 1e-4);
    assert_relative(pp_tone_threshold(1e-5), 1.380e-3, 1e-3);
    static const double joints[] = {-3.94, -1.44, -0.0184, 1.9};
    for (int i = 0; i < 4; i++) {
        double under = pp_tone_threshold(pow(10.0, joints[i] - 1e-9));
        double over = pp_tone_threshold(pow(10.0, joints[i] + 1e-9));
        assert_relative(over, under, 0.03);
    }
}

/* sRGB of 0.18 is 0.4614: 118. */
static void the_mean_is_a_middle_grey_and_white_is_where_one_says(void **state)
{
    (void)state;
    static const double luminances[] = {2.0, 50.0, 1250.0, 0.0, NAN};
    struct pp_picture picture = row_of(luminances, 5);
    struct pp_tone tone = tone_of(&picture, PP_TONE_AUTOMATIC, 0.0);
    unsigned char shown[3];
    pp_tone_apply(&tone, pp_rgb_grey(50.0), shown);
    assert_int_equal(shown[0], 118);
    tone = tone_of(&picture, PP_TONE_BY_HAND, 400.0);
    assert_near(pp_tone_shown(&tone, 100.0), 0.25, 1e-15);
    pp_tone_apply(&tone, pp_rgb(400.0, 100.0, 1e9), shown);
    assert_int_equal(shown[2], 255);
    pp_tone_apply(&tone, pp_rgb_grey(400.0), shown);
    assert_int_equal(shown[1], 255);
    pp_tone_apply(&tone, pp_rgb_grey(NAN), shown);
    assert_int_equal(shown[0], 0);
    pp_picture_clear(&picture);
}

/* The eye averages over a degree: of alternate pixels of 1 and 99 cd/m2 it sees 50,
 * which becomes the middle grey, 18 % of white. The same picture in radiances, 1/179 of
 * these values, gives the same result. */
static void a_degree_is_seen_at_once(void **state)
{
    (void)state;
    static const double pairs[] = {1.0, 99.0, 99.0, 1.0,
                                   50.0}; /* the last pixel is incomplete */
    struct pp_picture picture = row_of(pairs, 5);
    struct pp_tone tone;
    struct pp_tone_options options = {PP_TONE_AUTOMATIC, 0.0, 1.0, 2.0};
    assert_int_equal(pp_tone_prepare(&tone, &picture, &options, NULL), PP_OK);
    assert_near(pp_tone_shown(&tone, 50.0), 0.18, 1e-12);
    for (int i = 0; i < 15; i++)
        picture.rgb[i] /= 179.0f;
    options.unit = 179.0;
    assert_int_equal(pp_tone_prepare(&tone, &picture, &options, NULL), PP_OK);
    assert_near(pp_tone_shown(&tone, 50.0), 0.18, 1e-7); /* floats */
    unsigned char shown[3];
    pp_tone_apply(&tone, pp_rgb_grey(50.0 / 179.0), shown);
    assert_int_equal(shown[0], 118);
    pp_picture_clear(&picture);
}

/* Inverse of [IEC61966]: half a step is 1.1 % of the darkest channel here. */
static double decoded(unsigned char byte)
{
    double v = byte / 255.0;
    return v <= 0.04045 ? v / 12.92 : pow((v + 0.055) / 1.055, 2.4);
}

static void a_colour_keeps_its_channels_shares(void **state)
{
    (void)state;
    static const double one[] = {1.0};
    struct pp_picture picture = row_of(one, 1);
    struct pp_tone tone = tone_of(&picture, PP_TONE_BY_HAND, 100.0);
    unsigned char shown[3];
    pp_tone_apply(&tone, pp_rgb(60.0, 30.0, 12.0), shown);
    assert_relative(decoded(shown[0]), 0.60, 0.011);
    assert_relative(decoded(shown[1]), 0.30, 0.011);
    assert_relative(decoded(shown[2]), 0.12, 0.011);
    pp_tone_apply(&tone, pp_rgb_grey(0.2), shown); /* where sRGB is linear */
    assert_int_equal(shown[0], 7);                 /* 0.002 * 12.92 * 255 = 6.6 */
    pp_picture_clear(&picture);
}

static void a_black_picture_is_shown_black(void **state)
{
    (void)state;
    static const double dark[] = {0.0, 0.0, -1.0};
    struct pp_picture picture = row_of(dark, 3);
    for (int way = PP_TONE_AUTOMATIC; way <= PP_TONE_HUMAN; way++) {
        struct pp_tone tone = tone_of(&picture, way, 0.0);
        unsigned char shown[3] = {9, 9, 9};
        pp_tone_apply(&tone, pp_picture_rgb(&picture, 0, 0), shown);
        assert_int_equal(shown[0], 0);
    }
    pp_picture_clear(&picture);
}

/* A room of 5 to 60 cd/m2 around a window of 2,000 to 6,000: with a single exposure
 * either the room is nearly black or the window white. */
static void room_and_window_are_both_seen(void **state)
{
    (void)state;
    double luminances[1200];
    for (int i = 0; i < 1000; i++)
        luminances[i] = 5.0 * pow(12.0, i / 999.0);
    for (int i = 1000; i < 1200; i++)
        luminances[i] = 2000.0 * pow(3.0, (i - 1000) / 199.0);
    struct pp_picture picture = row_of(luminances, 1200);
    struct pp_tone tone = tone_of(&picture, PP_TONE_HUMAN, 0.0);
    double before = -1.0;
    for (double l = 0.01; l < 1e5; l *= 1.1) {
        double shown = pp_tone_shown(&tone, l);
        assert_true(shown >= before && shown <= 1.0 + 1e-12);
        before = shown;
    }
    assert_true(pp_tone_shown(&tone, 20.0) > 0.03);
    assert_true(pp_tone_shown(&tone, 6000.0) - pp_tone_shown(&tone, 2000.0) > 0.05);
    assert_near(pp_tone_shown(&tone, 6000.0), 1.0, 1e-6);

    /* The contrast is never higher than visible in the scene: a step that is just
     * visible in the scene is at most just visible on the screen, except for the limits
     * of trimming (2.5 %) and the width of a bin. */
    for (double l = 5.0; l < 60.0; l *= 1.3) {
        double d = 1e-3, shown = 100.0 * pp_tone_shown(&tone, l);
        double next = 100.0 * pp_tone_shown(&tone, l * (1.0 + d));
        double steps_shown = (next - shown) / pp_tone_threshold(shown);
        double steps_seen = l * d / pp_tone_threshold(l);
        assert_true(steps_shown <= 1.06 * steps_seen);
        assert_true(next / shown <= 1.0 + 1.06 * d);
    }
    pp_picture_clear(&picture);
}

/* An attic of 55 to 170 cd/m2 with some sky in its rooflight, which has 140 times the
 * luminance of the floor. No luminance is shown with a higher ratio to the corner of
 * the floor than it has, and the corner is not black. Tolerance: 5 % over the decade,
 * from trimming. */
static void contrast_is_never_added(void **state)
{
    (void)state;
    double luminances[1100];
    for (int i = 0; i < 1000; i++)
        luminances[i] = 55.0 + 115.0 * i / 999.0;
    for (int i = 1000; i < 1100; i++)
        luminances[i] = 5000.0 + 30.0 * (i - 1000);
    struct pp_picture picture = row_of(luminances, 1100);
    struct pp_tone tone = tone_of(&picture, PP_TONE_HUMAN, 0.0);
    for (double l = 56.0; l < 6000.0; l *= 1.07)
        assert_true(pp_tone_shown(&tone, l) / pp_tone_shown(&tone, 55.0)
                    <= 1.05 * l / 55.0);
    assert_true(pp_tone_shown(&tone, 55.0) > 0.005);
    assert_near(pp_tone_shown(&tone, 7970.0), 1.0, 0.02);
    pp_picture_clear(&picture);
}

/* Bright light distributed uniformly on a logarithmic scale from 100 to 1e6 cd/m2,
 * twice the two decades of the display. The eye sees steps of 5.6 % everywhere, also on
 * the display, where the same step is half as large, so nothing is trimmed. The curve
 * is the range of the display times the share of darker pixels, 100^(log10(L/100)/4)
 * cd/m2, by [LRP97]. The last bin and rounding contribute less than 0.2 %. */
static void evenly_spread_light_is_shown_by_the_closed_form(void **state)
{
    (void)state;
    enum { COUNT = 20000 };
    static double luminances[COUNT];
    for (int i = 0; i < COUNT; i++)
        luminances[i] = 100.0 * pow(1e4, i / (COUNT - 1.0));
    struct pp_picture picture = row_of(luminances, COUNT);
    struct pp_tone tone = tone_of(&picture, PP_TONE_HUMAN, 0.0);
    for (double l = 137.0; l < 1e6; l *= 2.3) {
        double display = pow(100.0, log10(l / 100.0) / 4.0);
        assert_relative(PP_TONE_DISPLAY_MOST * pp_tone_shown(&tone, l), display, 2e-3);
    }
    assert_near(pp_tone_shown(&tone, 100.0), 0.01, 1e-6); /* black, and white */
    assert_near(pp_tone_shown(&tone, 1e6), 1.0, 1e-6);
    assert_near(pp_tone_shown(&tone, 1e9), 1.0, 1e-12);
    pp_picture_clear(&picture);
}

/* The same without luminances between 10^3.6 and 10^4.4 cd/m2, a fifth of the range.
 * The gap only receives its fifth of the hundredth of all pixels that is distributed
 * uniformly, 100^(0.2/101) of the two decades. The pixels at its borders contribute 0.1
 * %. */
static void a_gap_in_the_light_is_passed_over_in_a_small_step(void **state)
{
    (void)state;
    enum { COUNT = 20000 };
    static double luminances[COUNT];
    for (int i = 0; i < COUNT; i++) {
        double decades = i % (COUNT / 2) * 1.6 / (COUNT / 2 - 1.0);
        luminances[i] = pow(10.0, (i < COUNT / 2 ? 2.0 : 4.4) + decades);
    }
    struct pp_picture picture = row_of(luminances, COUNT);
    struct pp_tone tone = tone_of(&picture, PP_TONE_HUMAN, 0.0);
    double under = pp_tone_shown(&tone, pow(10.0, 3.6));
    double over = pp_tone_shown(&tone, pow(10.0, 4.4));
    assert_relative(over / under, pow(100.0, 0.2 / 101.0), 1e-3);
    assert_relative(under, 0.1 * pow(100.0, -0.1 / 101.0), 2e-3);
    pp_picture_clear(&picture);
}

/* A scene with less contrast than the display is not stretched: it is shown in
 * proportion, its brightest value as white ([LRP97], the linear case). */
static void little_contrast_is_not_stretched(void **state)
{
    (void)state;
    static const double luminances[] = {1000.0, 1020.0, 1050.0, 1010.0};
    struct pp_picture picture = row_of(luminances, 4);
    struct pp_tone tone = tone_of(&picture, PP_TONE_HUMAN, 0.0);
    assert_near(pp_tone_shown(&tone, 1050.0), 1.0, 1e-6);
    assert_near(pp_tone_shown(&tone, 1000.0), 1000.0 / 1050.0, 1e-6);
    assert_near(pp_tone_shown(&tone, 525.0), 0.5, 1e-6);
    pp_picture_clear(&picture);
}

static void a_picture_of_one_brightness_is_a_middle_grey(void **state)
{
    (void)state;
    static const double even[] = {37.0, 37.0, 37.0, 37.0};
    struct pp_picture picture = row_of(even, 4);
    struct pp_tone tone = tone_of(&picture, PP_TONE_HUMAN, 0.0);
    assert_near(pp_tone_shown(&tone, 37.0), PP_TONE_MIDDLE, 1e-12);
    pp_picture_clear(&picture);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_eye_in_bright_light_sees_a_difference_of_five_per_cent),
        cmocka_unit_test(the_mean_is_a_middle_grey_and_white_is_where_one_says),
        cmocka_unit_test(a_degree_is_seen_at_once),
        cmocka_unit_test(a_colour_keeps_its_channels_shares),
        cmocka_unit_test(a_black_picture_is_shown_black),
        cmocka_unit_test(room_and_window_are_both_seen),
        cmocka_unit_test(contrast_is_never_added),
        cmocka_unit_test(evenly_spread_light_is_shown_by_the_closed_form),
        cmocka_unit_test(a_gap_in_the_light_is_passed_over_in_a_small_step),
        cmocka_unit_test(little_contrast_is_not_stretched),
        cmocka_unit_test(a_picture_of_one_brightness_is_a_middle_grey),
    };
    add_tests(tests, NULL, NULL);
}
