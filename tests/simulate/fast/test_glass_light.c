/* test_glass_light.c - openings mirrored in the glass of other openings. */
#include <math.h>

#include "simulate/scene/light_scene_parts.h"
#include "simulate/fast/control_variate_solve.h"
#include "simulate/fast/path.h"
#include "tests/lib/room_of.h"
#include "tests/lib/traced.h"

/* All surfaces are black except the glass of two windows in walls at right angles, so
 * light is mirrored only once. */
#define BLACK_ROOM                                                                     \
    "<room version='1'><sky type='overcast'/><plan width='4.3' depth='5.1' "           \
    "height='3.2'/><finishes floor='0' walls='0' ceiling='0'/>"                        \
    "<window wall='south' left='0.4' sill='0.7' width='2.3' height='1.9' "             \
    "glazing='clear-double'/>"                                                         \
    "<window wall='east' left='0.5' sill='0.9' width='3.1' height='1.7' "              \
    "glazing='clear-single'/>"                                                         \
    "<point x='2.9' y='1.3' z='0.6'/><point x='1.2' y='2.7' z='0.2'/>"                 \
    "<point x='2.3' y='2.2' z='0.85'/></room>"

/* A room of the same size with niches, one opening without glass, and reflecting
 * surfaces. */
#define NICHED_ROOM                                                                    \
    "<room version='1'><plan width='4.3' depth='5.1' height='3.2'/>"                   \
    "<finishes floor='0.02' walls='0.05' ceiling='0.03'/>"                             \
    "<window wall='south' left='0.4' sill='0.7' width='2.3' height='1.9' "             \
    "reveal='0.2' glazing='clear-double'/>"                                            \
    "<window wall='north' left='0.9' sill='0.5' width='2.9' height='2.1' "             \
    "reveal='0.1' glazing='clear-single'/>"                                            \
    "<window wall='east' left='0.5' sill='0.9' width='3.1' height='1.7' "              \
    "glazing='none'/>"                                                                 \
    "<point x='2.1' y='3.7' z='0.6'/></room>"

/* Glass with a normal transmittance of 1 reflects no light from directly opposite,
 * where the middle of the other window is, and only a little from its sides. */
#define CLEAREST_ROOM                                                                  \
    "<room version='1'><plan width='8.4' depth='3' height='3.2'/>"                     \
    "<finishes floor='0.02' walls='0.05' ceiling='0.03'/>"                             \
    "<window wall='south' left='0.2' sill='0.4' width='8' height='2.4' "               \
    "transmittance='1'/>"                                                              \
    "<window wall='north' left='0.2' sill='0.4' width='8' height='2.4' "               \
    "transmittance='1'/>"                                                              \
    "<point x='4.2' y='1.5' z='1.6'/></room>"

/* True if the point in the plane of the glass is within the rectangle of the glass. */
static bool is_in(const struct pp_opening *opening, struct pp_vec3 point)
{
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    const struct pp_vec3 axes[2] = {opening->along, opening->up};
    bool in = true;
    for (int k = 0; k < 2; k++) {
        for (int i = 0; i < opening->outer.count; i++) {
            double x = pp_vec_dot(opening->outer.vertices[i], axes[k]);
            low[k] = fmin(low[k], x);
            high[k] = fmax(high[k], x);
        }
        double x = pp_vec_dot(point, axes[k]);
        in = in && x > low[k] && x < high[k];
    }
    return in;
}

/* Light per square metre from a point of the other opening that the glass of the first
 * one mirrors to the receiver: as seen from the receiver's mirror image, through the
 * glass. */
static double mirrored_from(const struct pp_outside_light *light,
                            const struct pp_opening *glass,
                            const struct pp_opening *window,
                            const struct pp_receiver *receiver, struct pp_vec3 place)
{
    struct pp_vec3 n = glass->outer.normal;
    double over =
        pp_vec_dot(n, pp_vec_sub(receiver->position, glass->outer.vertices[0]));
    double there = pp_vec_dot(n, pp_vec_sub(place, glass->outer.vertices[0]));
    struct pp_vec3 image = pp_vec_along(receiver->position, -2.0 * over, n);
    struct pp_vec3 v = pp_vec_sub(place, image);
    if (!is_in(glass, pp_vec_along(image, over / (over + there), v)))
        return 0.0;
    double r = pp_vec_length(v);
    struct pp_vec3 u = pp_vec_scale(v, 1.0 / r);
    double facing = pp_vec_dot(pp_vec_mirrored(receiver->normal, n), u);
    double cosine = -pp_vec_dot(window->outer.normal, u);
    if (!(facing > 0.0 && cosine > 0.0))
        return 0.0;
    return pp_sky_luminance(&light->sky, u) * facing * cosine / (r * r)
           * pp_glass_transmittance(&window->glass, cosine) * window->frame_factor
           * window->maintenance * window->curtains
           * pp_glass_reflectance(&glass->glass, pp_vec_dot(n, u))
           * glass->frame_factor;
}

/* The same for the whole rectangular opening, by the midpoints of 800 x 800 cells. The
 * edge of the mirror image passes through 1 cell in 400. */
static double mirrored(const struct pp_outside_light *light,
                       const struct pp_opening *glass, const struct pp_opening *window,
                       const struct pp_receiver *receiver)
{
    enum { SIDE = 800 };
    struct pp_vec3 corner = window->outer.vertices[0];
    for (int i = 1; i < window->outer.count; i++) {
        struct pp_vec3 v = pp_vec_sub(window->outer.vertices[i], corner);
        corner = pp_vec_along(corner, fmin(0.0, pp_vec_dot(v, window->along)),
                              window->along);
        corner = pp_vec_along(corner, fmin(0.0, pp_vec_dot(v, window->up)), window->up);
    }
    double sum = 0.0, area = window->width_m * window->height_m / (SIDE * SIDE);
    for (int i = 0; i < SIDE; i++)
        for (int k = 0; k < SIDE; k++) {
            double x = (i + 0.5) / SIDE * window->width_m;
            double y = (k + 0.5) / SIDE * window->height_m;
            struct pp_vec3 place =
                pp_vec_along(pp_vec_along(corner, x, window->along), y, window->up);
            sum += area * mirrored_from(light, glass, window, receiver, place);
        }
    return sum;
}

/* The standard errors are at most 0.2 % of the light at these points. */
static void black_room_reflects_one_window_in_the_glass_of_the_other(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(&light, BLACK_ROOM);
    struct pp_tracer_options options = pp_test_paths(2048);
    struct pp_reading(*traced)[4] =
        pp_test_trace(world, &light, world->receivers, 3, &options, NULL);
    const struct pp_opening *south = &world->openings[0], *east = &world->openings[1];
    for (int i = 0; i < 3; i++) {
        double expected = mirrored(&light, south, east, &world->receivers[i])
                          + mirrored(&light, east, south, &world->receivers[i]);
        assert_traced(traced[i][PP_IRC], expected, 0.002 * expected);
    }
    free(traced);
    pp_world_destroy(world);
}

/* Reflected light at the point, and its standard deviation over nets of paths. glass:
 * true if mirror images in glass are sampled. */
struct found_light {
    double mean, deviation;
};
enum { NETS = 64, PATHS = 512 };

static struct found_light reflected(struct pp_path_state *state,
                                    const struct pp_sobol *sobol,
                                    const struct pp_receiver *receiver, bool glass)
{
    const struct pp_start start = {
        .position = pp_vec_sub(receiver->position, state->light.scene->centre),
        .normal = receiver->normal};
    double sum = 0.0, squares = 0.0;
    uint32_t *index = &state->light.index;
    state->glass = glass;
    for (uint64_t net = 0; net < NETS; net++) {
        struct pp_light direct = {{0.0, 0.0, 0.0}};
        double light = 0.0;
        pp_sobol_sequence_init(&state->light.sequence, sobol, 2 * net);
        *index = 0;
        pp_path_correction(state, &start, PATHS, &light);
        pp_sobol_sequence_init(&state->light.sequence, sobol, 2 * net + 1);
        *index = 0;
        pp_path_direct(state, &start, PATHS, &direct);
        light = (light + direct.part[PP_IRC]) / PATHS;
        sum += light;
        squares += light * light;
    }
    return (struct found_light){sum / NETS,
                                sqrt((squares - sum * sum / NETS) / (NETS - 1))};
}

/* Sampling by mirror images, with rays that omit this light, gives the same mean; its
 * noise is at most `noise` times that of rays alone. */
static void images_are_what_rays_find(const char *room, double noise)
{
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(&light, room);
    struct pp_light_scene *scene = pp_test_matt_scene(world);
    struct pp_environment *environment = pp_test_light_on(scene, &light);
    struct pp_sobol sobol;
    struct pp_control_variate *guess;
    pp_sobol_init(&sobol);
    assert_int_equal(
        pp_control_variate_solve(&guess, scene, environment, &sobol, 3, 1, NULL),
        PP_OK);
    struct pp_path_state paths = pp_path_state(scene, environment, guess);
    assert_true(paths.glass);
    struct found_light aimed = reflected(&paths, &sobol, &world->receivers[0], true);
    struct found_light by_rays = reflected(&paths, &sobol, &world->receivers[0], false);
    double both = hypot(aimed.deviation, by_rays.deviation) / sqrt(NETS);
    assert_near(aimed.mean, by_rays.mean, 3.0 * both);
    assert_near(aimed.deviation / by_rays.deviation, 0.0, noise);
    pp_control_variate_destroy(guess);
    pp_environment_destroy(environment);
    pp_light_scene_destroy(scene);
    pp_world_destroy(world);
}

static void images_in_glass_are_what_rays_find_there(void **state)
{
    (void)state;
    images_are_what_rays_find(NICHED_ROOM, 0.7);
}

static void the_clearest_glass_mirrors_at_its_sides(void **state)
{
    (void)state;
    images_are_what_rays_find(CLEAREST_ROOM, 1.0);
}

/* Windows in three walls: the south window's glass shows only the rear parts of the
 * other two. */
#define THREE_SIDES                                                                    \
    "<room version='1'><plan width='4.3' depth='5.1' height='3.2'/>"                   \
    "<window wall='south' left='0.4' sill='0.7' width='2.3' height='1.9'/>"            \
    "<window wall='east' left='0.5' sill='0.9' width='3.1' height='1.7'/>"             \
    "<window wall='west' left='1.5' sill='0.9' width='3.1' height='1.7'/>"             \
    "<point x='1.7' y='2.7' z='0.2'/></room>"

/* Mirrored back at the glass, each sampled direction passes through the opening that it
 * is aimed at; 1e-6 m for the rounding of the scene's coordinates. */
static void every_direction_to_an_image_ends_in_its_opening(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(&light, THREE_SIDES);
    struct pp_light_scene *scene = pp_test_matt_scene(world);
    struct pp_environment *environment = pp_test_light_on(scene, &light);
    struct pp_glass_view view = {0};
    const struct pp_receiver *at = &world->receivers[0];
    struct pp_vec3 point = pp_vec_sub(at->position, scene->centre);
    for (int i = 0; i < 1000; i++) {
        const double u[3] = {(i % 10 + 0.5) / 10, (i / 10 % 10 + 0.5) / 10,
                             (i / 100 + 0.5) / 10};
        struct pp_vec3 to;
        double pdf;
        int image = pp_glass_images_sample(scene, &view, point, at->normal,
                                           &environment->brightness, u, &to, &pdf);
        assert_true(image >= 0 && pdf > 0.0);
        const struct pp_target *glass =
            &scene->panes[scene->glass_images[image].glass].target;
        const struct pp_target *window =
            &scene->panes[scene->glass_images[image].window].target;
        struct pp_vec3 from =
            pp_vec_along(point, -2.0 * pp_target_height(glass, point), glass->normal);
        struct pp_vec3 ahead = pp_vec_mirrored(to, glass->normal);
        double distance =
            -pp_target_height(window, from) / pp_vec_dot(ahead, window->normal);
        struct pp_vec3 end =
            pp_vec_sub(pp_vec_along(from, distance, ahead), window->corner);
        double x = pp_vec_dot(end, window->along), y = pp_vec_dot(end, window->up);
        assert_true(x > -1e-6 && x < window->width_m + 1e-6);
        assert_true(y > -1e-6 && y < window->height_m + 1e-6);
    }
    pp_environment_destroy(environment);
    pp_light_scene_destroy(scene);
    pp_world_destroy(world);
}

/* Only the windows are mirrors, not the six unglazed openings among them. Of 72 pairs
 * of windows the 32 with the largest contribution are kept, in the glass of both
 * walls. */
static void pairs_are_of_glass_and_those_that_have_most_of_each_other(void **state)
{
    (void)state;
    static const char *const glazings[2] = {"none", "clear-double"};
    for (int glazed = 0; glazed < 2; glazed++) {
        struct pp_outside_light light;
        char room[4096];
        int length =
            snprintf(room, sizeof room,
                     "<room version='1'><plan width='9' depth='5' height='3'/>");
        for (int i = 0; i < 12; i++)
            length += snprintf(
                room + length, sizeof room - (size_t)length,
                "<window wall='%s' left='%g' sill='0.9' width='0.9' height='1.5' "
                "glazing='%s'/>",
                i < 6 ? "south" : "north", 0.3 + 1.4 * (i % 6),
                i < 6 ? glazings[glazed] : "clear-double");
        snprintf(room + length, sizeof room - (size_t)length,
                 "<point x='2' y='2'/></room>");
        struct pp_world *world = pp_test_lit_world(&light, room);
        struct pp_light_scene *scene = pp_test_matt_scene(world);
        int in_wall[2] = {0, 0};
        for (int i = 0; i < scene->glass_image_count; i++)
            in_wall[scene->glass_images[i].glass / 6]++;
        assert_int_equal(scene->glass_image_count, PP_GLASS_IMAGES_MOST);
        assert_int_equal(in_wall[0], glazed ? PP_GLASS_IMAGES_MOST / 2 : 0);
        assert_true(pp_glass_images_has(scene, 6, 5));
        assert_int_equal(pp_glass_images_has(scene, 5, 6), glazed);
        pp_light_scene_destroy(scene);
        pp_world_destroy(world);
    }
}

/* Openings of one wall are not mirrored in the glass of the same wall. */
static void windows_in_one_plane_have_no_images(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light, "<room version='1'><plan width='4.3' depth='5.1' height='3.2'/>"
                "<window wall='south' left='0.4' sill='0.7' width='1.1' height='1.9'/>"
                "<window wall='south' left='2.4' sill='0.9' width='1.3' height='1.7'/>"
                "<point x='2.1' y='3.7' z='0.6'/></room>");
    struct pp_light_scene *scene = pp_test_matt_scene(world);
    assert_int_equal(scene->glass_image_count, 0);
    pp_light_scene_destroy(scene);
    pp_world_destroy(world);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(black_room_reflects_one_window_in_the_glass_of_the_other),
        cmocka_unit_test(images_in_glass_are_what_rays_find_there),
        cmocka_unit_test(the_clearest_glass_mirrors_at_its_sides),
        cmocka_unit_test(every_direction_to_an_image_ends_in_its_opening),
        cmocka_unit_test(pairs_are_of_glass_and_those_that_have_most_of_each_other),
        cmocka_unit_test(windows_in_one_plane_have_no_images),
    };
    add_tests(tests, NULL, NULL);
}
