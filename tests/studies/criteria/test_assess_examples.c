/* test_assess_examples.c - the findings of `pepperpot assess` for the examples compared
 * with rays tested against every polygon (sight.h), formulae with the dimensions
 * entered below, and areas of points. Runs ./pepperpot. */
#include <json.h>
#include <stdio.h>
#include <stdlib.h>

#include "methods/evaluate.h"
#include "model/light/sun.h"
#include "model/results/sheets/point_areas.h"
#include "model/room/building.h"
#include "model/room/room_light.h"
#include "studies/criteria/grid/plane_grid.h"
#include "tests/lib/laid_grid.h"
#include "tests/lib/near.h"
#include "tests/lib/sight.h"
#include "tests/lib/sized.h"

/* Dimensions of the examples, as in their files; depth is from the window wall. */
struct facts {
    const char *file, *room, *capital;
    double median_lux;
    double opening_m2, glass_m2, floor_m2;
    /* Dimensions of boxes with windows in one wall; depth 0: any other room. */
    double width, depth, height, head, floor, walls, ceiling, back;
};

static const struct facts facts[] = {
    {"deep-office", "Deep office", "London", 14100, 2.6 * 1.5, 2.6 * 1.5, 27.0, 3.0,
     9.0, 2.7, 2.3, 0.2, 0.5, 0.7, 0.5},
    {"deep-office-obstructed", "Deep office, obstructed", "London", 14100, 3.9, 3.9,
     27.0, 3.0, 9.0, 2.7, 2.3, 0.2, 0.5, 0.7, 0.5},
    {"office", "Office for two", "London", 14100, 2 * 1.3 * 1.6, 2 * 1.3 * 1.6 * 0.75,
     4.2 * 5.4, 4.2, 5.4, 2.8, 2.5, 0.25, 0.6, 0.8, 0.4},
    {"classroom", "Classroom", "Prague", 14900, 3 * 2.4 * 1.7 + 7.8 * 0.7,
     3 * 2.4 * 1.7 * 0.8 + 7.8 * 0.7 * 0.85, 9.0 * 7.2, .depth = 0},
    {"l-shaped", "Living room", "Brussels", 15000, 2.8 * 1.7 + 0.9 * 2.1,
     2.8 * 1.7 * 0.8 + 0.9 * 2.1 * 0.7, 5.4 * 3.6 + 3.0 * 3.0, .depth = 0},
    {"studio", "Studio", "Paris", 15900, 2 * 1.8 * 1.9386593306 + 1.2 * 1.2,
     2 * 1.8 * 1.9386593306 * 0.85 + 1.2 * 1.2 * 0.75, 7.0 * 5.5, .depth = 0},
    {"workshop", "Workshop", "Amsterdam", 14400, 3 * 14 * 1.3, 3 * 14 * 1.3 * 0.8,
     15.0 * 12.0, .depth = 0},
    {"building", "Living room", "Berlin", 13900, 2 * 1.4 * 1.9, 2 * 1.4 * 1.9 * 0.72,
     4.8 * 5.2, 4.8, 5.2, 2.9, 2.5, 0.3, 0.6, 0.8, 0.6},
    {"building", "Study", "Berlin", 13900, 1.4 * 1.9, 1.4 * 1.9 * 0.72, 2.6 * 5.2, 2.6,
     5.2, 2.9, 2.5, 0.3, 0.6, 0.8, 0.6},
    {"building", "Bedroom", "Berlin", 13900, 1.8 * 1.5, 1.8 * 1.5 * 0.7, 4.2 * 3.9, 4.2,
     3.9, 2.9, 2.4, 0.25, 0.7, 0.8, 0.7},
    {"building", "Kitchen", "Berlin", 13900, 1.2 * 1.3 + 0.8 * 2.3,
     1.2 * 1.3 * 0.7 + 0.8 * 2.3 * 0.65, 3.2 * 3.9, 3.2, 3.9, 2.9, 2.3, 0.35, 0.65, 0.8,
     0.65},
};
enum { ROOMS = sizeof facts / sizeof *facts };

struct room {
    struct pp_world *world;
    struct pp_outside_light light;
    struct json_object *said;
};

static struct room rooms[ROOMS];
static int room_count; /* all rooms, or the first few */

/* ---- output of the program ---- */

static struct json_object *said_of(const char *file, const char *room)
{
    char *command;
    const char *source = getenv("srcdir");
    assert_true(asprintf(&command,
                         "./pepperpot assess --withdrawn --by-hand --spacing largest "
                         "--least-altitude 0.001 --format json "
                         "--room '%s' %s/examples/%s.xml",
                         room, source ? source : ".", file)
                > 0);
    FILE *out = popen(command, "r");
    char *text = NULL;
    size_t size = 0;
    assert_true(getdelim(&text, &size, EOF, out) > 0);
    assert_int_equal(pclose(out), 0);
    struct json_object *said = json_tokener_parse(text);
    assert_non_null(said);
    if (json_object_is_type(said, json_type_array)) {
        assert_int_equal(json_object_array_length(said), 1);
        struct json_object *all = said;
        said = json_object_get(json_object_array_get_idx(all, 0));
        json_object_put(all);
    }
    free(text);
    free(command);
    return said;
}

static struct json_object *field(struct json_object *object, const char *key)
{
    struct json_object *value = NULL;
    json_object_object_get_ex(object, key, &value);
    return value;
}

/* The finding of this criterion whose name begins with `of`; NULL: none. */
static struct json_object *finding(const struct room *room, const char *criterion,
                                   const char *of)
{
    struct json_object *criteria = field(room->said, "criteria");
    for (size_t i = 0; i < json_object_array_length(criteria); i++) {
        struct json_object *one = json_object_array_get_idx(criteria, i);
        if (strcmp(json_object_get_string(field(one, "criterion")), criterion) != 0)
            continue;
        struct json_object *list = field(one, "findings");
        for (size_t k = 0; k < json_object_array_length(list); k++) {
            struct json_object *found = json_object_array_get_idx(list, k);
            if (strncmp(json_object_get_string(field(found, "of")), of, strlen(of))
                == 0)
                return found;
        }
    }
    return NULL;
}

static int verdicts_held;
static int steep; /* windows with an obstruction of more than 25 degrees */

/* Asserts that figure and bound are as expected, and that the verdict follows from our
 * figure: in the examples no figure is within the tolerance of its bound. */
static void assert_finding(const struct room *room, const char *criterion,
                           const char *of, double figure, double tolerance,
                           double wanted, bool at_most)
{
    struct json_object *found = finding(room, criterion, of);
    if (!found)
        fail_msg("no %s of %s", criterion, of);
    double said = json_object_get_double(field(found, "figure"));
    if (!(fabs(said - figure) <= tolerance))
        fail_msg("%s, %s: %s is %g, by another route %g +- %g",
                 json_object_get_string(field(room->said, "room")), criterion, of, said,
                 figure, tolerance);
    assert_near(json_object_get_double(field(found, "wanted")), wanted,
                1e-6 * fabs(wanted));
    bool same = fabs(figure - wanted) < 1e-9; /* a bound given in the file is met */
    if (!same && !(fabs(figure - wanted) > tolerance))
        fail_msg("%s: %s of %g is too near to %g", criterion, of, figure, wanted);
    bool met = same || (at_most ? figure < wanted : figure > wanted);
    /* Undecided: an open figure, or one closer to its bound than the grid's error. */
    double grid_error = json_object_get_double(field(found, "grid-error"));
    bool close = fabs(said - wanted) < grid_error
                 || json_object_get_boolean(field(found, "open"));
    assert_string_equal(json_object_get_string(field(found, "verdict")),
                        close ? "undecided"
                        : met ? "met"
                              : "not met");
    verdicts_held++;
}

/* The same for a figure without a verdict. */
static void assert_stated(const struct room *room, const char *criterion,
                          const char *of, double figure, double tolerance)
{
    struct json_object *found = finding(room, criterion, of);
    assert_non_null(found);
    assert_near(json_object_get_double(field(found, "figure")), figure, tolerance);
    assert_null(field(found, "verdict"));
}

static void assert_not_judged(const struct room *room, const char *criterion,
                              const char *of)
{
    struct json_object *found = finding(room, criterion, of);
    assert_non_null(found);
    assert_null(field(found, "figure"));
    assert_non_null(field(found, "why"));
    assert_string_equal(json_object_get_string(field(found, "verdict")), "not judged");
}

/* ---- the rooms ---- */

static struct pp_world *world_of(struct pp_outside_light *light, const char *file,
                                 const char *name)
{
    char *path;
    const char *source = getenv("srcdir");
    assert_true(asprintf(&path, "%s/examples/%s.xml", source ? source : ".", file) > 0);
    struct pp_mistakes mistakes;
    pp_mistakes_init(&mistakes, path);
    struct pp_building *building;
    assert_int_equal(pp_building_read(&building, path, &mistakes, NULL), PP_OK);
    struct pp_world *found = NULL;
    for (int i = 0; i < pp_building_room_count(building); i++) {
        struct pp_world *world;
        assert_int_equal(
            pp_world_create(&world, pp_building_room(building, i), &mistakes, NULL),
            PP_OK);
        if (!found && strcmp(world->name, name) == 0) {
            found = world;
            assert_int_equal(pp_room_light(light, pp_building_room(building, i), NULL),
                             PP_OK);
        } else {
            pp_world_destroy(world);
        }
    }
    assert_non_null(found);
    pp_building_destroy(building);
    pp_mistakes_clear(&mistakes);
    free(path);
    return found;
}

static int load(void **state)
{
    (void)state;
    room_count = PP_SIZED(ROOMS, ROOMS, 4);
    for (int i = 0; i < room_count; i++) {
        rooms[i].world = world_of(&rooms[i].light, facts[i].file, facts[i].room);
        rooms[i].said = said_of(facts[i].file, facts[i].room);
    }
    return 0;
}

static int unload(void **state)
{
    (void)state;
    for (int i = 0; i < room_count; i++) {
        pp_world_destroy(rooms[i].world);
        json_object_put(rooms[i].said);
    }
    return 0;
}

/* The program's name for an opening. */
static const char *words_of(char words[80], const struct pp_world *world, int opening)
{
    const struct pp_opening *of = &world->openings[opening];
    const char *name = world->surfaces[of->face].name;
    snprintf(words, 80, "%s, %s", of->label, name ? name : "ceiling");
    return words;
}

static bool is_upright(const struct pp_opening *opening)
{
    return fabs(opening->inner.normal.z) < 0.01;
}

static struct pp_vec3 middle_outside(const struct pp_opening *opening)
{
    struct pp_vec3 sum = {0, 0, 0};
    for (int i = 0; i < opening->outer.count; i++)
        sum = pp_vec_along(sum, 1.0 / opening->outer.count, opening->outer.vertices[i]);
    return sum;
}

/* ---- the tests ---- */

/* VSC(alpha) = 3/14 (1 - sin alpha) + 4/(7 pi) cos^2 alpha behind an infinitely long
 * skyline, with alpha from the middle of the pane. The part hidden by blocks and roofs
 * is counted in 80,000 directions; an outline crosses about 300 of them: 0.3 %. */
static void vertical_sky_components_agree(void **state)
{
    (void)state;
    char words[80];
    for (int i = 0; i < room_count; i++) {
        const struct pp_world *world = rooms[i].world;
        for (int k = 0; k < world->opening_count; k++) {
            const struct pp_opening *opening = &world->openings[k];
            words_of(words, world, k);
            if (!is_upright(opening)) {
                assert_not_judged(&rooms[i], "vertical-sky", words);
                continue;
            }
            struct pp_vec3 eye = middle_outside(opening);
            double vsc = 0.0, tolerance = 0.3;
            const struct pp_skyline *line = NULL;
            for (int s = 0; s < world->skyline_count; s++)
                if (world->skylines[s].face == opening->face)
                    line = &world->skylines[s];
            if (line) {
                double head =
                    line->middle_z_m + line->distance_m * tan(line->angle_rad);
                double alpha =
                    isinf(line->distance_m)
                        ? line->angle_rad
                        : atan((head - eye.z) / (line->distance_m - opening->reveal_m));
                vsc = 300.0 / 14.0 * (1.0 - sin(alpha))
                      + 400.0 / (7.0 * PP_PI) * cos(alpha) * cos(alpha);
                /* A skyline with a distance is 200 times as long as its distance. */
                tolerance = isinf(line->distance_m) ? 1e-6 : 1e-5 * vsc;
            } else {
                vsc = 100.0
                      * sight_vertical_sky(world, eye,
                                           pp_vec_scale(opening->inner.normal, -1.0),
                                           opening->face, 200);
            }
            assert_finding(&rooms[i], "vertical-sky", words, vsc, tolerance, 27.0,
                           false);
        }
    }
}

/* The angle of the highest of directions 0.05 degrees apart in which a ray meets an
 * obstruction; for a skyline the angle in the file. */
static void angles_in_section_agree(void **state)
{
    (void)state;
    char words[80];
    for (int i = 0; i < room_count; i++) {
        const struct pp_world *world = rooms[i].world;
        for (int k = 0; k < world->opening_count; k++) {
            const struct pp_opening *opening = &world->openings[k];
            if (!is_upright(opening))
                continue;
            double typed = 0.0;
            for (int s = 0; s < world->skyline_count; s++)
                if (world->skylines[s].face == opening->face)
                    typed = world->skylines[s].angle_rad / PP_RAD;
            double highest = typed;
            for (double angle = 0.025; angle < 90.0; angle += 0.05) {
                struct pp_vec3 u =
                    pp_vec_scale(opening->inner.normal, -cos(angle * PP_RAD));
                u.z = sin(angle * PP_RAD);
                bool sees_sky =
                    sight_sees_sky(world, middle_outside(opening), u, opening->face);
                if (!sees_sky && angle > typed + 0.5)
                    highest = angle;
            }
            words_of(words, world, k);
            if (highest > 25.0)
                assert_stated(&rooms[i], "obstruction", words, highest, 0.06);
            else
                assert_finding(&rooms[i], "obstruction", words, highest, 0.06, 25.0,
                               true);
            steep += highest > 25.0;
        }
    }
}

/* Areas by counting 40 x 40 points of the plan's extent. The line crosses about 50 of
 * their cells: 1 % of the plane. */
static void areas_that_see_sky_agree(void **state)
{
    (void)state;
    enum { N = 40 };
    for (int i = 0; i < room_count; i++) {
        const struct pp_world *world = rooms[i].world;
        double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
        for (int f = 0; f < world->face_count; f++)
            for (int k = 0; k < world->surfaces[f].outline.count; k++) {
                struct pp_vec3 v = world->surfaces[f].outline.vertices[k];
                low[0] = fmin(low[0], v.x), high[0] = fmax(high[0], v.x);
                low[1] = fmin(low[1], v.y), high[1] = fmax(high[1], v.y);
            }
        int points = 0, see = 0, lit = 0;
        for (int k = 0; k < N * N; k++) {
            double x = low[0] + (k % N + 0.5) / N * (high[0] - low[0]);
            double y = low[1] + (k / N + 0.5) / N * (high[1] - low[1]);
            if (!pp_region_contains(&world->plane, x, y))
                continue;
            struct pp_vec3 eye = {x, y, world->working_plane_m};
            points++;
            see += sight_sky_factor(world, eye, 4, true) > 0.0
                   || sight_sky_factor(world, eye, 24, true) > 0.0;
            eye.z = 0.85;
            lit += sight_sky_factor(world, eye, 8, false) > 0.002;
        }
        double area = facts[i].floor_m2; /* all walls are vertical */
        struct json_object *beyond = finding(&rooms[i], "no-sky-line", "area without");
        assert_near(json_object_get_double(field(beyond, "figure")),
                    (1.0 - (double)see / points) * area, 0.015 * area);
        assert_null(field(beyond, "verdict"));
        assert_finding(&rooms[i], "sky-line", "working plane", 100.0 * see / points,
                       1.5, 80.0, false);
        struct json_object *enclosed = finding(&rooms[i], "rights-of-light", "adequ");
        assert_near(json_object_get_double(field(enclosed, "figure")),
                    (double)lit / points * area, 0.015 * area);
        assert_finding(&rooms[i], "rights-of-light", "share", 100.0 * lit / points, 1.5,
                       50.0, false);
    }
}

static void limiting_depths_agree(void **state)
{
    (void)state;
    for (int i = 0; i < room_count; i++) {
        const struct facts *f = &facts[i];
        if (!(f->depth > 0.0)) {
            assert_not_judged(&rooms[i], "limiting-depth", "d/w");
            continue;
        }
        double rear = f->depth / 2.0;
        double reflecting = rear * f->width * (f->floor + f->ceiling)
                            + 2.0 * rear * f->height * f->walls
                            + f->width * f->height * f->back;
        double area = 2.0 * rear * (f->width + f->height) + f->width * f->height;
        assert_finding(&rooms[i], "limiting-depth", "d/w",
                       f->depth / f->width + f->depth / f->head, 1e-9,
                       2.0 / (1.0 - reflecting / area), true);
    }
}

static void glazing_over_floor_agrees(void **state)
{
    (void)state;
    for (int i = 0; i < room_count; i++) {
        const struct facts *f = &facts[i];
        assert_finding(&rooms[i], "glazing-ratio", "glass",
                       100.0 * f->glass_m2 / f->floor_m2, 1e-6, 8.0, false);
        assert_finding(&rooms[i], "glazing-ratio", "openings",
                       100.0 * f->opening_m2 / f->floor_m2, 1e-6, 12.5, false);
    }
}

/* ---- daylight factors by the program's methods, at points laid out here ---- */

enum { POINTS_MOST = 400 };

struct points {
    struct pp_receiver list[POINTS_MOST];
    int count;
    struct {
        double value, share;
    } values[POINTS_MOST]; /* in descending order; with shares of the plane */
    double mean, average;  /* mean of the points; average over the whole plane */
};

static int falling(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b; /* the first members */
    return (x < y) - (x > y);
}

static void fill(struct points *points, const struct pp_world *world,
                 const struct pp_outside_light *light)
{
    points->count = lay_out_largest_grid(points->list, world);
    struct pp_report report = {.world = world,
                               .light = *light,
                               .receivers = points->list,
                               .receiver_count = points->count};
    assert_int_equal(
        pp_methods_evaluate(&report, "average-df,exact+bre,exact+split-flux", NULL),
        PP_OK);
    const struct pp_column *pair = pp_report_find(&report, PP_DF, "exact+bre");
    const struct pp_column *formula = pp_report_find(&report, PP_DF, "average-df");
    if (isnan(pair->average.value))
        pair = pp_report_find(&report, PP_DF, "exact+split-flux");
    points->average =
        isnan(formula->average.value) ? pair->average.value : formula->average.value;
    struct pp_receiver *grid; /* for the areas of points, as in test_plane_areas.c */
    int count;
    assert_int_equal(pp_plane_grid_largest(&grid, &count, world, NULL), PP_OK);
    assert_int_equal(count, points->count);
    double area_m2 = pp_point_areas_sum(grid, count);
    points->mean = 0.0;
    for (int i = 0; i < points->count; i++) {
        points->values[i].value = pair->points[i].value;
        points->values[i].share = grid[i].area_m2 / area_m2;
        points->mean += points->values[i].value * points->values[i].share;
    }
    qsort(points->values, (size_t)points->count, sizeof *points->values, falling);
    free(grid);
    pp_report_clear(&report);
}

/* The daylight factor that this share of the plane reaches, in per cent. */
static double reached_by(const struct points *points, int per_cent)
{
    int i = 0;
    double sum = points->values[0].share, part = 0.01 * per_cent;
    while (sum < part - 1e-9)
        sum += points->values[++i].share;
    bool half_way = per_cent == 50 && sum < part + 1e-9;
    return 100.0 * 0.5
           * (points->values[i].value + points->values[half_way ? i + 1 : i].value);
}

static void daylight_provision_agrees(void **state)
{
    (void)state;
    static const struct {
        const char *criterion, *of;
        double lux;
        int per_cent;
    } targets[] = {
        {"en17037", "minimum: 300 lx", 300, 50},
        {"en17037", "minimum: 100 lx", 100, 95},
        {"en17037", "medium: 500 lx", 500, 50},
        {"en17037", "medium: 300 lx", 300, 95},
        {"en17037", "high: 750 lx", 750, 50},
        {"en17037", "high: 500 lx", 500, 95},
        {"uk-annex", "bedroom: 100 lx", 100, 50},
        {"uk-annex", "living room: 150 lx", 150, 50},
        {"uk-annex", "kitchen: 200 lx", 200, 50},
    };
    for (int i = 0; i < room_count; i++) {
        struct points points;
        fill(&points, rooms[i].world, &rooms[i].light);
        assert_near(json_object_get_double(field(rooms[i].said, "median_diffuse")),
                    facts[i].median_lux, 0.0);
        assert_non_null(
            strstr(json_object_get_string(field(rooms[i].said, "median_diffuse_by")),
                   facts[i].capital));
        for (size_t t = 0; t < sizeof targets / sizeof *targets; t++) {
            double wanted = 100.0 * targets[t].lux / facts[i].median_lux;
            assert_finding(&rooms[i], targets[t].criterion, targets[t].of,
                           reached_by(&points, targets[t].per_cent), 1e-6, wanted,
                           false);
            double reach = 0.0;
            for (int k = 0; k < points.count; k++)
                if (100.0 * points.values[k].value >= wanted)
                    reach += points.values[k].share;
            assert_near(json_object_get_double(field(
                            finding(&rooms[i], targets[t].criterion, targets[t].of),
                            "reached_over")),
                        100.0 * reach, 1e-6);
        }
    }
}

static void averages_and_uniformity_agree(void **state)
{
    (void)state;
    for (int i = 0; i < room_count; i++) {
        struct points points;
        fill(&points, rooms[i].world, &rooms[i].light);
        double average = 100.0 * points.average;
        assert_finding(&rooms[i], "average", "bedroom", average, 1e-6, 1.0, false);
        assert_finding(&rooms[i], "average", "living room", average, 1e-6, 1.5, false);
        assert_finding(&rooms[i], "average", "kitchen", average, 1e-6, 2.0, false);
        bool roof = strcmp(facts[i].file, "studio") == 0;
        assert_finding(&rooms[i], "uniformity", "minimum",
                       points.values[points.count - 1].value / points.mean, 1e-6,
                       roof ? 0.7 : 0.3, false);
    }
}

/* Direction of the sun, in the axes of the room. */
static struct pp_vec3 sun_at(const struct pp_world *world, double days)
{
    struct pp_sun sun = pp_sun_at(days, world->latitude_rad, 0.0);
    double level = cos(sun.altitude_rad), azimuth = sun.bearing_rad - world->north_rad;
    return pp_vec(level * sin(azimuth), level * cos(azimuth), sin(sun.altitude_rad));
}

/* True if the window faces within 90 degrees of south, due east and west included. */
static bool faces_south(const struct pp_world *world, const struct pp_opening *opening)
{
    struct pp_vec3 n = opening->inner.normal;
    return n.y * cos(world->north_rad) - n.x * sin(world->north_rad) > -1e-9;
}

static bool shines_on(const struct pp_world *world, struct pp_vec3 eye,
                      const struct pp_opening *opening, struct pp_vec3 u)
{
    return u.z > 0.0 && pp_vec_dot(u, opening->inner.normal) < 0.0
           && sight_sees_sky(world, eye, u, opening->face);
}

/* Hours of sun in the year and in winter, in per cent of the year's hours with the sun
 * above the horizon, counted every ten minutes. About a thousand ends of sun periods,
 * each with an error of 3 minutes, are 1.5 of 4400 hours. */
static void sunlight_hours_agree(void **state)
{
    (void)state;
    double start = pp_sun_days_since_2000(2025, 1, 1, 0.0);
    char words[80], of[96];
    for (int i = 0; i < room_count; i++) {
        const struct pp_world *world = rooms[i].world;
        for (int k = 0; k < world->opening_count; k++) {
            const struct pp_opening *opening = &world->openings[k];
            struct pp_vec3 eye = middle_outside(opening);
            words_of(words, world, k);
            if (!faces_south(world, opening)) {
                assert_not_judged(&rooms[i], "sunlight", words);
                continue;
            }
            int up = 0, year = 0, winter = 0;
            for (int minute = 0; minute < 365 * 1440; minute += 10) {
                struct pp_vec3 u = sun_at(world, start + minute / 1440.0);
                bool shines = shines_on(world, eye, opening, u);
                up += u.z > 0.0;
                year += shines;
                /* Days 0 to 79 end on 21 March; days from 263 on begin on 21
                 * September. */
                winter += shines && (minute / 1440 < 80 || minute / 1440 >= 263);
            }
            snprintf(of, sizeof of, "%s, year", words);
            assert_stated(&rooms[i], "sunlight", of, 100.0 * year / up, 0.1);
            snprintf(of, sizeof of, "%s, winter", words);
            assert_stated(&rooms[i], "sunlight", of, 100.0 * winter / up, 0.1);
        }
    }
}

/* True if the sun reaches the reference point of the opening. */
static bool comes_in(const struct pp_world *world, int index, struct pp_vec3 u)
{
    const struct pp_opening *opening = &world->openings[index];
    const struct pp_polygon *outline = &opening->inner;
    struct pp_vec3 eye = {0, 0, 0};
    double sill = INFINITY;
    for (int i = 0; i < outline->count; i++) {
        eye = pp_vec_along(eye, 1.0 / outline->count, outline->vertices[i]);
        sill = fmin(sill, outline->vertices[i].z);
    }
    if (is_upright(opening))
        eye.z = fmax(1.2, sill + 0.3);
    for (int i = 0; i < world->surface_count; i++)
        if (world->surfaces[i].role == PP_REVEAL && world->surfaces[i].owner == index
            && sight_meets(&world->surfaces[i].outline, eye, u) > 0.0)
            return false;
    return shines_on(world, eye, opening, u);
}

/* Hours on 21 March, counted every 20 seconds while the sun is above the horizon. */
static void hours_of_exposure_agree(void **state)
{
    (void)state;
    double start = pp_sun_days_since_2000(2025, 3, 21, 0.0);
    static const struct {
        const char *of;
        double hours;
    } levels[] = {{"minimum", 1.5}, {"medium", 3.0}, {"high", 4.0}};
    for (int i = 0; i < room_count; i++) {
        double hours = 0.0;
        for (int step = 0; step < 4320; step++) {
            struct pp_vec3 u = sun_at(rooms[i].world, start + step / 4320.0);
            bool in = false;
            for (int k = 0; k < rooms[i].world->opening_count && !in; k++)
                in = comes_in(rooms[i].world, k, u);
            hours += in / 180.0;
        }
        for (int k = 0; k < 3; k++) {
            struct json_object *found =
                finding(&rooms[i], "sun-exposure", levels[k].of);
            assert_non_null(found);
            assert_near(json_object_get_double(field(found, "figure")), hours, 0.03);
            assert_string_equal(json_object_get_string(field(found, "verdict")),
                                hours < levels[k].hours ? "not met" : "met");
            verdicts_held++;
        }
    }
}

/* One verdict per window for two criteria (none for an obstruction above 25 degrees),
 * 20 per room and one per box-shaped room; test_view_out.c tests the view out. */
static void every_verdict_was_held_against_another_route(void **state)
{
    (void)state;
    int windows = 0, boxes = 0, said = 0;
    for (int i = 0; i < room_count; i++) {
        boxes += facts[i].depth > 0.0;
        for (int k = 0; k < rooms[i].world->opening_count; k++)
            windows += is_upright(&rooms[i].world->openings[k]);
        struct json_object *criteria = field(rooms[i].said, "criteria");
        for (size_t c = 0; c < json_object_array_length(criteria); c++) {
            struct json_object *one = json_object_array_get_idx(criteria, c);
            struct json_object *list = field(one, "findings");
            const char *by = json_object_get_string(field(one, "criterion"));
            for (size_t k = 0; k < json_object_array_length(list); k++) {
                one = json_object_array_get_idx(list, k);
                const char *is = json_object_get_string(field(one, "verdict"));
                said += is && strcmp(is, "not judged") && strcmp(by, "view-out");
            }
        }
    }
    assert_int_equal(verdicts_held, 2 * windows - steep + 20 * room_count + boxes);
    assert_int_equal(verdicts_held, said);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(vertical_sky_components_agree),
        cmocka_unit_test(angles_in_section_agree),
        cmocka_unit_test(areas_that_see_sky_agree),
        cmocka_unit_test(limiting_depths_agree),
        cmocka_unit_test(glazing_over_floor_agrees),
        cmocka_unit_test(daylight_provision_agrees),
        cmocka_unit_test(averages_and_uniformity_agree),
        cmocka_unit_test(sunlight_hours_agree),
        cmocka_unit_test(hours_of_exposure_agree),
        cmocka_unit_test(every_verdict_was_held_against_another_route),
    };
    add_tests(tests, load, unload);
}
