/* test_lumen.c - the lumen method: its calculation, its points, its two forms, and the
 * rooms that it covers. */
#include "methods/evaluate.h"
#include "methods/method.h"
#include "tests/lib/room_of.h"

/* Elements of a test room whose dimensions are on lines of the table: two window
 * heights wide, four deep. */
struct parts {
    const char *before, *finishes, *window, *after;
};

static const struct parts usual = {
    "<site ground-reflectance='0.2'/>",
    "<finishes floor='0.3' walls='0.5' ceiling='0.7'/>",
    "<window wall='south' left='0.3' sill='0.85' width='2.4' height='1.5' "
    "glazing='clear-single' frame-factor='0.8' maintenance='0.9'/>",
    "<point x='1' y='1.8'/>"};

static struct pp_world *world;
static struct pp_report report;

static void evaluate(const struct parts *parts, const char *methods)
{
    char xml[2000];
    snprintf(xml, sizeof xml,
             "<room version='1'>%s<plan width='3' depth='6' height='2.35'/>%s\n%s\n%s"
             "</room>",
             parts->before, parts->finishes, parts->window, parts->after);
    struct pp_outside_light light;
    world = pp_test_lit_world(&light, xml);
    report = (struct pp_report){.world = world,
                                .light = light,
                                .receivers = world->receivers,
                                .receiver_count = world->receiver_count};
    struct pp_error err = {0};
    if (pp_methods_evaluate(&report, methods, &err) != PP_OK)
        fail_msg("%s", err.message);
}

static void done(void)
{
    pp_report_clear(&report);
    pp_world_destroy(world);
}

static const struct pp_column *column(const char *name)
{
    const struct pp_column *found = pp_report_find(&report, PP_DF, name);
    assert_non_null(found);
    return found;
}

/* Calculated by hand with cells of tables/lumen_sidelight.csv (ceiling 0.7, walls 0.5,
 * depth 4, width 2, at 30 %): overcast 0.1963, ground 0.137. The window receives
 * 0.39618 from the sky and 0.1 from the ground; tau = 0.8269 x 2.4 x 1.5 x 0.8 / (3 x
 * 1.5) x 0.9 = 0.47629, so DF = 0.47629 (0.39618 x 0.1963 + 0.1 x 0.137) = 4.357 %. */
static void sum_is_as_worked_by_hand(void **state)
{
    (void)state;
    evaluate(&usual, "lumen,lumen-one");
    assert_null(column("lumen")->points[0].why);
    assert_near(100.0 * column("lumen")->points[0].value, 4.357, 2e-3);
    /* For a ground reflectance of 0.2 the two forms give the same value. */
    assert_relative(column("lumen-one")->points[0].value,
                    column("lumen")->points[0].value, 1e-12);
    assert_relative(column("lumen-one")->average.value, column("lumen")->average.value,
                    1e-12);
    done();
}

/* The form with one coefficient treats light from a brighter ground like skylight. */
static void forms_differ_over_another_ground(void **state)
{
    (void)state;
    struct parts bright = usual;
    bright.before = "<site ground-reflectance='0.6'/>";
    bright.after = "<point x='1' y='0.6'/><point x='1' y='5.4'/>";
    evaluate(&bright, "lumen,lumen-one");
    assert_true(column("lumen-one")->points[0].value
                > column("lumen")->points[0].value);
    assert_true(column("lumen-one")->points[1].value
                < column("lumen")->points[1].value);
    done();
}

static void points_are_read_by_their_depth_alone(void **state)
{
    (void)state;
    struct parts parts = usual;
    parts.after = "<point x='0.2' y='1.8'/><point x='2.7' y='1.8'/>"
                  "<point x='1.5' y='0.59'/><point x='1.5' y='0.6'/>"
                  "<point x='1.5' y='5.4'/><point x='1.5' y='5.41'/>"
                  "<point x='1.5' y='3' z='0.5'/>";
    evaluate(&parts, "lumen");
    const struct pp_reading *points = column("lumen")->points;
    assert_near(points[0].value, points[1].value, 1e-15);
    assert_non_null(strstr(points[2].why, "too close to this point or too far"));
    assert_true(points[3].value > points[0].value);
    assert_true(points[4].value < points[0].value);
    assert_non_null(points[5].why);
    assert_non_null(strstr(points[6].why, "points on the working plane"));
    assert_null(column("lumen")->average.why);
    done();
}

/* Frame, dirt and width of the window each count once. */
static void allowances_are_counted_once(void **state)
{
    (void)state;
    evaluate(&usual, "lumen");
    double framed = column("lumen")->average.value;
    done();
    struct parts bare = usual;
    bare.window =
        "<window wall='south' left='0.9' sill='0.85' width='1.2' height='1.5'/>";
    evaluate(&bare, "lumen");
    assert_relative(framed, 2.0 * 0.8 * 0.9 * column("lumen")->average.value, 1e-12);
    done();
}

static void windows_side_by_side_and_opposite_add_up(void **state)
{
    (void)state;
    evaluate(&usual, "lumen");
    double one = column("lumen")->average.value;
    done();
    struct parts two = usual;
    two.window = "<window wall='south' left='0.3' sill='0.85' width='1.2' height='1.5' "
                 "glazing='clear-single' frame-factor='0.8' maintenance='0.9'/>"
                 "<window wall='south' left='1.5' sill='0.85' width='1.2' height='1.5' "
                 "glazing='clear-single' frame-factor='0.8' maintenance='0.9'/>";
    two.after = "<point x='1' y='3'/>";
    evaluate(&two, "lumen");
    double middle = column("lumen")->points[0].value;
    assert_relative(column("lumen")->average.value, one, 1e-12);
    done();
    two.window = "<window wall='south' left='0.3' sill='0.85' width='2.4' height='1.5' "
                 "glazing='clear-single' frame-factor='0.8' maintenance='0.9'/>"
                 "<window wall='north' left='0.3' sill='0.85' width='2.4' height='1.5' "
                 "glazing='clear-single' frame-factor='0.8' maintenance='0.9'/>";
    evaluate(&two, "lumen");
    assert_relative(column("lumen")->average.value, 2.0 * one, 1e-12);
    assert_relative(column("lumen")->points[0].value, 2.0 * middle, 1e-12);
    done();
}

/* A_s/A_w T B M CU: 4 rooflights of 0.5 m2 over 18 m2; h = 1.5, RCR = 5 x 1.5 x 9 / 18
 * = 3.75; clear glass 0.8269. CU(3.75, 0.7, 0.5) is between 0.50 and 0.75. */
static void rooflights_have_an_average_only(void **state)
{
    (void)state;
    struct parts top = usual;
    top.window = "<rooflight x='0.5' y='1' width='0.5' depth='1' maintenance='0.7'/>"
                 "<rooflight x='2' y='1' width='0.5' depth='1' maintenance='0.7'/>"
                 "<rooflight x='0.5' y='4' width='0.5' depth='1' maintenance='0.7'/>"
                 "<rooflight x='2' y='4' width='0.5' depth='1' maintenance='0.7'/>";
    evaluate(&top, "lumen");
    assert_non_null(strstr(column("lumen")->points[0].why, "only an average"));
    double df = column("lumen")->average.value;
    double cu = df / (0.8269 * 0.7 * 2.0 / 18.0);
    assert_in_range((int)(100.0 * cu), 50, 75);
    done();
    top.before =
        "<sky type='uniform'/>"; /* the horizontal pane receives Eh under any sky */
    evaluate(&top, "lumen");
    assert_relative(column("lumen")->average.value, df, 1e-12);
    done();
    top.window = "<rooflight x='0.5' y='1' width='0.5' depth='1'/>";
    evaluate(&top, "lumen");
    assert_non_null(strstr(column("lumen")->average.why, "spread"));
    done();
}

/* An infinitely long wall a kilometre away that rises to 45 degrees leaves horizontal
 * glass (1 + cos 45)/2 of the uniform sky. */
static void top_light_loses_what_an_obstruction_hides(void **state)
{
    (void)state;
    struct parts top = usual;
    top.before = "<sky type='uniform'/>";
    top.window = "<rooflight x='0.5' y='1' width='0.5' depth='1'/>"
                 "<rooflight x='2' y='1' width='0.5' depth='1'/>"
                 "<rooflight x='0.5' y='4' width='0.5' depth='1'/>"
                 "<rooflight x='2' y='4' width='0.5' depth='1'/>";
    evaluate(&top, "lumen");
    double open = column("lumen")->average.value;
    done();
    top.after =
        "<block x='-40000' y='-1015' width='80000' depth='10' height='1007.35'/>"
        "<point x='1' y='1.8'/>";
    evaluate(&top, "lumen");
    /* 1005 m above the glass, 1006 to 1010 m away. */
    assert_relative(column("lumen")->average.value,
                    open * (1.0 + cos(PP_PI / 4.0)) / 2.0, 2e-3);
    done();
}

static void refused(struct parts parts, const char *words)
{
    evaluate(&parts, "lumen");
    const char *why = column("lumen")->average.why;
    if (!why || !strstr(why, words) || !isnan(column("lumen")->average.value))
        fail_msg("%s, expected %s", why ? why : "a value", words);
    done();
}

#define WINDOW(left, sill, width, height, more)                                        \
    "<window wall='south' left='" left "' sill='" sill "' width='" width               \
    "' height='" height "' " more "/>"

static void what_the_tables_do_not_hold_is_refused(void **state)
{
    (void)state;
    struct parts p = usual;
    p.before = "<sky type='uniform'/>";
    refused(p, "Ev/Eh is 0.5; the table covers 0.75 to 1.75");
    p.before =
        "<sky type='iso-12' sun-altitude='40' sun-bearing='0'/>"; /* behind the window */
    refused(p, "a sky whose Ev/Eh");
    p = usual;
    p.finishes = "<finishes floor='0.3' walls='0.2' ceiling='0.7'/>";
    refused(p, "wall reflectance is 0.2; the table covers 0.3 to 0.9");
    p.finishes = "<finishes floor='0.3' walls='0.5' ceiling='0.4'/>";
    refused(p, "ceiling reflectance is 0.4");
    p.finishes = "<finishes floor='0.05' walls='0.5' ceiling='0.7'/>";
    refused(p, "floor reflectance");
    p = usual;
    p.window = WINDOW("0.3", "1.2", "2.4", "1.0", "");
    refused(p, "0.30 m above or below");
    p.window = WINDOW("0.3", "0.85", "2.4", "0.5", "");
    refused(p, "ratio of depth to window height is 12; the table covers 1 to 10");
    p.window = WINDOW("0.1", "0.85", "0.8", "1.5", "");
    refused(p, "too much wall without glass");
    p.window = WINDOW("0.3", "0.85", "2.4", "1.5", "reveal='0.4'");
    refused(p, "reveal");
    p.window =
        WINDOW("0.3", "0.85", "2.4", "1.5", "transmittance='0.5' diffusing='yes'");
    refused(p, "diffusing");
    p.window =
        WINDOW("0.2", "0.85", "1.2", "1.5", "") WINDOW("1.6", "0.85", "1.2", "1.3", "");
    refused(p, "a sill or head at a different height");
    p = usual;
    p.after = "<skyline wall='south' angle='10'/>";
    refused(p, "an unobstructed sky");
    p.after = "<block x='-5' y='-9' width='12' depth='4' height='9'/>";
    refused(p, "an unobstructed sky");
    p.after = "<surface reflectance='0.4'><vertex x='1' y='2' z='0.3'/>"
              "<vertex x='2' y='2' z='0.3'/><vertex x='2' y='3' z='0.3'/></surface>";
    refused(p, "empty rooms");
    p.after = "<window wall='east' left='1' sill='0.85' width='4' height='1.5'/>";
    refused(p, "nor in the opposite wall");
}

/* A clear sky with the sun in front of the window: brighter than the overcast sky. */
static void clear_skies_are_read_by_their_ratio(void **state)
{
    (void)state;
    struct parts p = usual;
    p.before = "<sky type='iso-13' sun-altitude='45.6733' sun-bearing='180'/>";
    evaluate(&p, "lumen");
    double clear = column("lumen")->points[0].value;
    done();
    evaluate(&usual, "lumen");
    assert_true(clear > 1.5 * column("lumen")->points[0].value);
    done();
    p.before = "<sky type='iso-1'/>"; /* the other definition of the overcast sky */
    evaluate(&p, "lumen");
    assert_null(column("lumen")->points[0].why);
    done();
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sum_is_as_worked_by_hand),
        cmocka_unit_test(forms_differ_over_another_ground),
        cmocka_unit_test(points_are_read_by_their_depth_alone),
        cmocka_unit_test(allowances_are_counted_once),
        cmocka_unit_test(windows_side_by_side_and_opposite_add_up),
        cmocka_unit_test(rooflights_have_an_average_only),
        cmocka_unit_test(top_light_loses_what_an_obstruction_hides),
        cmocka_unit_test(what_the_tables_do_not_hold_is_refused),
        cmocka_unit_test(clear_skies_are_read_by_their_ratio),
    };
    add_tests(tests, NULL, NULL);
}
