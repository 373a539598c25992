/* self_test.c - the cases: closed forms of sky components on paper, limits that hold in
 * any room, and small rooms worked by hand or by independent quadrature. Expected values
 * are right to the digits that stand here.
 */
#include "studies/validation/self_test.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "methods/evaluate.h"
#include "methods/protractor/protractor_scale.h"
#include "model/light/graded_sky.h"
#include "model/room/building.h"
#include "model/room/room_light.h"
#include "simulate/tracer/tracer.h"

static void add(struct pp_self_test_cases *cases, const char *what, const char *by,
                double answer, double expected, double tolerance)
{
    if (cases->count == PP_SELF_TEST_CASES_MOST)
        return;
    struct pp_self_test_case *one = &cases->list[cases->count++];
    *one = (struct pp_self_test_case){.by = by,
                                      .expected = expected,
                                      .tolerance = tolerance,
                                      .answer = answer,
                                      .std_error = NAN};
    snprintf(one->what, sizeof one->what, "%s", what);
}

/* A case whose expected value is in per cent, rounded to that number of decimals. */
static void add_per_cent(struct pp_self_test_cases *cases, const char *what,
                         const char *by, double answer, double per_cent, int decimals)
{
    add(cases, what, by, answer, per_cent / 100.0, 0.5001 * pow(10.0, -decimals - 2));
}

bool pp_self_test_passes(const struct pp_self_test_case *one)
{
    return fabs(one->answer - one->expected) <= one->tolerance;
}

/* ---- rooms ---- */

static enum pp_status world_of(struct pp_world **world, struct pp_outside_light *light,
                               const char *xml, struct pp_error *err)
{
    struct pp_building *building = NULL;
    struct pp_mistakes mistakes;
    pp_mistakes_init(&mistakes, "a room of known answer");
    enum pp_status status =
        pp_building_parse(&building, xml, strlen(xml), &mistakes, err);
    if (status == PP_OK)
        status = pp_world_create(world, pp_building_room(building, 0), &mistakes, err);
    if (status == PP_OK)
        status = pp_room_light(light, pp_building_room(building, 0), err);
    if (status == PP_BAD_INPUT && mistakes.count > 0)
        pp_fail(err, status, "a room of known answer: %s", mistakes.list[0].text);
    pp_building_destroy(building);
    pp_mistakes_clear(&mistakes);
    return status;
}

/* A room and what methods say of its first point and its average. */
struct answers {
    struct pp_world *world;
    struct pp_outside_light light;
    struct pp_report report;
};

static void clear(struct answers *answers)
{
    pp_report_clear(&answers->report);
    pp_world_destroy(answers->world);
}

static enum pp_status evaluate(struct answers *answers, const char *xml,
                               const char *methods, struct pp_error *err)
{
    *answers = (struct answers){0};
    enum pp_status status = world_of(&answers->world, &answers->light, xml, err);
    if (status != PP_OK)
        return status;
    answers->report = (struct pp_report){.world = answers->world,
                                         .light = answers->light,
                                         .receivers = answers->world->receivers,
                                         .receiver_count = 1};
    status = pp_methods_evaluate(&answers->report, methods, err);
    if (status != PP_OK)
        clear(answers);
    return status;
}

static double at_point(const struct answers *answers, enum pp_component component,
                       const char *name)
{
    const struct pp_column *column = pp_report_find(&answers->report, component, name);
    return column && column->points ? column->points[0].value : NAN;
}

/* ---- by hand ---- */

/* Rectangles seen from a point one metre off, one corner on the perpendicular. */
static enum pp_status check_rectangles(struct pp_self_test_cases *cases,
                                       struct pp_error *err)
{
    static const struct {
        bool overhead;
        double a, b, per_cent[2]; /* upright: height, width; overhead: both sides */
    } list[] = {
        {false, 0.5, 0.5, {1.3928, 0.9430}},  {false, 1.0, 1.0, {5.5734, 4.5251}},
        {false, 1.0, 2.0, {6.8697, 5.4586}},  {false, 2.0, 1.0, {9.5068, 8.8164}},
        {false, 0.5, 2.0, {2.5164, 1.6457}},  {true, 1.0, 1.0, {13.8532, 15.9497}},
        {true, 0.5, 2.0, {10.6838, 12.2905}},
    };
    static const char *const skies[] = {"uniform", "overcast"};
    for (size_t i = 0; i < sizeof list / sizeof list[0]; i++)
        for (int sky = 0; sky < 2; sky++) {
            char xml[640], opening[160], what[80];
            snprintf(opening, sizeof opening,
                     list[i].overhead ? "<rooflight x='1' y='1' width='%g' depth='%g' "
                                        "glazing='none'/>"
                                      : "<window wall='south' left='1' sill='1' "
                                        "height='%g' width='%g' glazing='none'/>",
                     list[i].a, list[i].b);
            snprintf(xml, sizeof xml,
                     "<room version='1'><sky type='%s'/><plan width='4' depth='4' "
                     "height='%d'/>%s<working-plane height='1'/><point x='1' y='1'/>"
                     "</room>",
                     skies[sky], list[i].overhead ? 2 : 4, opening);
            snprintf(what, sizeof what, "%s %g x %g m, 1 m off, %s sky",
                     list[i].overhead ? "level" : "upright", list[i].a, list[i].b,
                     skies[sky]);
            struct answers answers;
            enum pp_status status = evaluate(&answers, xml, "exact", err);
            if (status != PP_OK)
                return status;
            add_per_cent(cases, what, "exact", at_point(&answers, PP_SC, "exact"),
                         list[i].per_cent[sky], 4);
            clear(&answers);
        }
    return PP_OK;
}

#define HALL                                                                           \
    "<room version='1'><plan width='9' depth='8' height='4'/>"                         \
    "<window wall='south' left='3' sill='1.45' width='3' height='1.8'/>"               \
    "<point x='5.1' y='3'/>"

/* A window through clear glass, by quadrature in azimuth and altitude. */
static enum pp_status check_glass(struct pp_self_test_cases *cases,
                                  struct pp_error *err)
{
    struct answers answers;
    enum pp_status status = evaluate(&answers, HALL "</room>", "exact", err);
    if (status != PP_OK)
        return status;
    add_per_cent(cases, "window 3 x 1.8 m, 3 m off, clear single glass", "exact",
                 at_point(&answers, PP_SC, "exact"), 3.424, 3);
    clear(&answers);
    return PP_OK;
}

static void check_skies(struct pp_self_test_cases *cases)
{
    struct pp_sky overcast = pp_sky_overcast(), uniform = pp_sky_uniform();
    struct pp_vec3 up = {0.0, 0.0, 1.0}, south = {0.0, -1.0, 0.0};
    add(cases, "open sky on a level plane, overcast", "sky",
        pp_sky_on_plane(&overcast, up), 1.0, 1e-9);
    add(cases, "open sky on a level plane, uniform", "sky",
        pp_sky_on_plane(&uniform, up), 1.0, 1e-9);
    add_per_cent(cases, "open sky on an upright plane, overcast", "sky",
                 pp_sky_on_plane(&overcast, south), 39.6177, 4);
    add_per_cent(cases, "above an endless skyline of 25 degrees, overcast", "sky",
                 pp_graded_sky_over_skyline(PP_GRADED_SKY_OVERCAST, 25.0 * PP_RAD),
                 27.31, 2);
    add_per_cent(cases, "above an endless skyline of 25 degrees, uniform", "sky",
                 pp_graded_sky_over_skyline(PP_GRADED_SKY_UNIFORM, 25.0 * PP_RAD),
                 28.87, 2);
    struct pp_glass glass = pp_glass_clear_single();
    add(cases, "clear single glass, normal incidence", "glass", glass.normal, 0.900,
        5.001e-4);
    add(cases, "clear single glass, diffuse light", "glass", glass.diffuse, 0.827,
        5.001e-4);
}

static enum pp_status check_protractors(struct pp_self_test_cases *cases,
                                        struct pp_error *err)
{
    static const struct {
        int number;
        double altitude_deg, per_cent;
        int decimals;
        const char *what;
    } list[] = {
        {9, 30.0, 6.6987, 4, "no. 9, endless strip to 30 degrees"},
        {10, 30.0, 4.519, 3, "no. 10, endless strip to 30 degrees"},
        {9, 60.0, 25.0, 3, "no. 9, endless strip to 60 degrees"},
        {10, 60.0, 21.886, 3, "no. 10, endless strip to 60 degrees"},
    };
    struct pp_protractor protractor;
    for (size_t i = 0; i < sizeof list / sizeof list[0]; i++) {
        enum pp_status status =
            pp_protractor_scale_published(&protractor, list[i].number, err);
        if (status != PP_OK)
            return status;
        add_per_cent(
            cases, list[i].what, "protractor",
            pp_protractor_scale_primary(&protractor, list[i].altitude_deg * PP_RAD),
            list[i].per_cent, list[i].decimals);
    }
    return PP_OK;
}

#define SCHOOLROOM                                                                     \
    "<room version='1'><site ground-reflectance='0.1'/>"                               \
    "<plan width='4' depth='6' height='3'/>"                                           \
    "<finishes floor='0.2' walls='0.5' ceiling='0.7'/><point x='2' y='3'/>"            \
    "<window wall='south' left='0.2' sill='0.9' width='3.6' height='1.5' "

/* The reflected component of a room 4 x 6 x 3 m, and a window read off the table. */
static enum pp_status check_rooms(struct pp_self_test_cases *cases,
                                  struct pp_error *err)
{
    struct answers answers;
    enum pp_status status =
        evaluate(&answers, SCHOOLROOM "/></room>", "bre,split-flux", err);
    if (status != PP_OK)
        return status;
    add_per_cent(cases, "room 4 x 6 x 3 m, window 3.6 x 1.5 m", "bre",
                 at_point(&answers, PP_IRC, "bre"), 1.3289, 4);
    add_per_cent(cases, "room 4 x 6 x 3 m, window 3.6 x 1.5 m", "split-flux",
                 at_point(&answers, PP_IRC, "split-flux"), 1.2610, 4);
    clear(&answers);

    status =
        evaluate(&answers,
                 SCHOOLROOM "diffusing='yes' transmittance='0.68' maintenance='0.9'/>"
                            "<skyline wall='south' angle='25'/></room>",
                 "average-df", err);
    if (status != PP_OK)
        return status;
    const struct pp_column *column =
        pp_report_find(&answers.report, PP_DF, "average-df");
    add_per_cent(cases, "the same room, T 0.68, M 0.9, theta 65 degrees", "average-df",
                 column ? column->average.value : NAN, 2.5163, 4);
    clear(&answers);

    status = evaluate(&answers, HALL "</room>", "brs-table", err);
    if (status != PP_OK)
        return status;
    add_per_cent(cases, "window 3 x 1.8 m, 3 m off", "brs-table",
                 at_point(&answers, PP_SC, "brs-table"), 3.35, 2);
    clear(&answers);

    status = evaluate(&answers,
                      HALL "<skyline wall='south' angle='26.565051177078'/></room>",
                      "brs-table", err);
    if (status != PP_OK)
        return status;
    add_per_cent(cases, "the same, a skyline to h/d 0.5: sky", "brs-table",
                 at_point(&answers, PP_SC, "brs-table"), 2.08, 2);
    add_per_cent(cases, "the same: what the skyline reflects", "brs-table",
                 at_point(&answers, PP_ERC, "brs-table"), 0.254, 3);
    clear(&answers);
    return PP_OK;
}

/* ---- traced ---- */

static enum pp_status trace(struct pp_reading readings[PP_COMPONENT_COUNT],
                            const struct pp_world *world,
                            const struct pp_outside_light *light,
                            struct pp_receiver receiver, uint64_t seed, int threads,
                            struct pp_error *err)
{
    struct pp_tracer_options options = {
        .samples = 512, .seed = seed, .threads = threads};
    struct pp_light_scene *scene = NULL;
    struct pp_environment *environment = NULL;
    struct pp_tracer *tracer = NULL;
    enum pp_status status = pp_light_scene_of_world_matt(&scene, world, err);
    if (status == PP_OK)
        status = pp_light_scene_under(&environment, scene, light, err);
    if (status == PP_OK)
        status =
            pp_tracer_create(&tracer, scene, environment, &receiver, 1, &options, err);
    while (status == PP_OK && !pp_tracer_done(tracer))
        status = pp_tracer_advance(tracer, 1.0, err);
    if (status == PP_OK)
        pp_tracer_read(tracer, 0, readings);
    pp_tracer_destroy(tracer);
    pp_environment_destroy(environment);
    pp_light_scene_destroy(scene);
    return status;
}

static void add_traced(struct pp_self_test_cases *cases, const char *what,
                       struct pp_reading reading, double expected)
{
    add(cases, what, "traced", reading.value, expected,
        4.0 * reading.std_error + 1e-12);
    cases->list[cases->count - 1].std_error = reading.std_error;
}

static const struct pp_receiver facing_up = {.position = {1.0, 1.0, 1.0},
                                             .normal = {0.0, 0.0, 1.0}};

/* A point under the open sky: no surface at all. */
static enum pp_status check_traced_open_sky(struct pp_self_test_cases *cases,
                                            uint64_t seed, int threads,
                                            struct pp_error *err)
{
    const struct pp_world world = {0};
    const struct pp_outside_light light = {.sky = pp_sky_overcast()};
    struct pp_receiver upright = facing_up;
    upright.normal = pp_vec(0.0, -1.0, 0.0);
    struct pp_reading readings[PP_COMPONENT_COUNT];
    enum pp_status status =
        trace(readings, &world, &light, facing_up, seed, threads, err);
    if (status != PP_OK)
        return status;
    add_traced(cases, "open sky on a level plane, overcast", readings[PP_SC], 1.0);
    status = trace(readings, &world, &light, upright, seed, threads, err);
    if (status == PP_OK)
        add_traced(cases, "open sky on an upright plane, overcast", readings[PP_SC],
                   0.39617706);
    return status;
}

/* In a closed room whose every surface has exitance 1 and reflectance rho, illuminance
 * is 1 + rho + rho^2 + ... = 1/(1 - rho) everywhere, whatever the room's form: the
 * integrating sphere. */
static enum pp_status check_traced_closed_cube(struct pp_self_test_cases *cases,
                                               uint64_t seed, int threads,
                                               struct pp_error *err)
{
    static const double reflectances[] = {0.2, 0.5, 0.8};
    struct pp_world *world = NULL;
    struct pp_outside_light light;
    enum pp_status status = world_of(
        &world, &light,
        "<room version='1'><plan width='2' depth='2' height='2'/><point x='1' y='1'/>"
        "</room>",
        err);
    for (int i = 0; i < 3 && status == PP_OK; i++) {
        char what[80];
        for (int k = 0; k < world->surface_count; k++) {
            world->surfaces[k].exitance = 1.0;
            world->surfaces[k].front = reflectances[i];
        }
        struct pp_reading readings[PP_COMPONENT_COUNT];
        struct pp_receiver oblique = facing_up;
        oblique.position = pp_vec(0.6, 1.3, 0.7);
        oblique.normal = pp_vec_unit(pp_vec(0.2, 0.3, 1.0));
        status = trace(readings, world, &light, oblique, seed, threads, err);
        snprintf(what, sizeof what, "closed glowing cube, 1/(1 - rho), rho %g",
                 reflectances[i]);
        if (status == PP_OK)
            add_traced(cases, what, readings[PP_IRC], 1.0 / (1.0 - reflectances[i]));
    }
    pp_world_destroy(world);
    return status;
}

/* Windows whose sky component is known in closed form or by quadrature; a dark room. */
static enum pp_status check_traced_windows(struct pp_self_test_cases *cases,
                                           uint64_t seed, int threads,
                                           struct pp_error *err)
{
    static const struct {
        const char *what, *xml;
        double per_cent;
        enum pp_component component;
    } list[] = {
        {"upright 1 x 1 m, 1 m off, overcast sky",
         "<room version='1'><plan width='4' depth='4' height='4'/><window wall='south' "
         "left='1' sill='1' height='1' width='1' glazing='none'/>"
         "<working-plane height='1'/><point x='1' y='1'/></room>",
         4.52508, PP_SC},
        {"level 1 x 1 m, 1 m off, overcast sky",
         "<room version='1'><plan width='4' depth='4' height='2'/><rooflight x='1' "
         "y='1' width='1' depth='1' glazing='none'/><working-plane height='1'/>"
         "<point x='1' y='1'/></room>",
         15.94970, PP_SC},
        {"a closed dark room",
         "<room version='1'><plan width='4' depth='4' height='4'/><point x='1' y='1'/>"
         "</room>",
         0.0, PP_DF},
    };
    for (size_t i = 0; i < sizeof list / sizeof list[0]; i++) {
        struct pp_world *world = NULL;
        struct pp_outside_light light;
        struct pp_reading readings[PP_COMPONENT_COUNT];
        enum pp_status status = world_of(&world, &light, list[i].xml, err);
        if (status == PP_OK)
            status =
                trace(readings, world, &light, world->receivers[0], seed, threads, err);
        pp_world_destroy(world);
        if (status != PP_OK)
            return status;
        add_traced(cases, list[i].what, readings[list[i].component],
                   list[i].per_cent / 100.0);
    }
    return PP_OK;
}

/* Sky component of the hall's window through glass, traced and by `exact`, which share
 * no way of finding it. */
static enum pp_status check_traced_and_exact(struct pp_self_test_cases *cases,
                                             uint64_t seed, int threads,
                                             struct pp_error *err)
{
    struct answers answers;
    struct pp_reading readings[PP_COMPONENT_COUNT];
    enum pp_status status = evaluate(&answers, HALL "</room>", "exact", err);
    if (status != PP_OK)
        return status;
    status = trace(readings, answers.world, &answers.light, answers.world->receivers[0],
                   seed, threads, err);
    if (status == PP_OK)
        add_traced(cases, "window 3 x 1.8 m, 3 m off, glazed, against exact",
                   readings[PP_SC], at_point(&answers, PP_SC, "exact"));
    clear(&answers);
    return status;
}

enum pp_status pp_self_test_run(struct pp_self_test_cases *cases, uint64_t seed,
                                int threads, struct pp_error *err)
{
    cases->count = 0;
    check_skies(cases);
    enum pp_status status = check_rectangles(cases, err);
    if (status == PP_OK)
        status = check_glass(cases, err);
    if (status == PP_OK)
        status = check_protractors(cases, err);
    if (status == PP_OK)
        status = check_rooms(cases, err);
    if (status == PP_OK)
        status = check_traced_open_sky(cases, seed, threads, err);
    if (status == PP_OK)
        status = check_traced_closed_cube(cases, seed, threads, err);
    if (status == PP_OK)
        status = check_traced_windows(cases, seed, threads, err);
    if (status == PP_OK)
        status = check_traced_and_exact(cases, seed, threads, err);
    return status;
}
