/* test_convex_room.c - intersections with the planes of a convex room equal those of
 * the general ray tracer. */
#include "simulate/scene/convex_room.h"

#include <math.h>

#include "simulate/sampling/hash.h"
#include "simulate/scene/light_scene_parts.h"
#include "tests/lib/room_of.h"
#include "tests/lib/traced.h"

#define BOX                                                                            \
    "<room version='1'><plan width='3.1' depth='7.3' height='2.7'/>"                   \
    "<window wall='south' left='0.3' sill='0.8' width='2.3' height='1.4'/>"            \
    "<window wall='south' left='0.3' sill='2.3' width='1.1' height='0.3'/>"            \
    "<window wall='east' left='1.7' sill='0.4' width='2.9' height='1.9'/>"             \
    "<rooflight x='1.1' y='4.2' width='0.9' depth='1.3'/>"

#define TENT                                                                           \
    "<room version='1'><plan height='2.9'><vertex x='0.3' y='0.2'/>"                   \
    "<vertex x='4.9' y='0.9'/><vertex x='6.1' y='3.2'/><vertex x='2.2' y='5.3'/>"      \
    "<vertex x='-0.7' y='2.1'/></plan>"                                                \
    "<window wall='1' left='0.6' sill='0.7' width='3.1' height='1.5'/>"                \
    "<opening><vertex x='1.5' y='2.1' z='2.9'/><vertex x='1.7' y='3.6' z='2.9'/>"      \
    "<vertex x='3.8' y='2.9' z='2.9'/></opening>"

/* Niches of all kinds: deep, shallow, in a ceiling, triangular. */
#define NICHES                                                                         \
    "<room version='1'><plan width='3.1' depth='7.3' height='2.7'/>"                   \
    "<window wall='south' left='0.3' sill='0.8' width='2.3' height='1.4' "             \
    "reveal='0.4'/>"                                                                   \
    "<window wall='east' left='1.7' sill='0.4' width='2.9' height='1.9'/>"             \
    "<window wall='north' left='0.9' sill='1.1' width='0.8' height='0.7' "             \
    "reveal='0.02'/>"                                                                  \
    "<rooflight x='1.1' y='4.2' width='0.9' depth='1.3' reveal='0.9'/>"                \
    "<opening reveal='0.3'><vertex x='0' y='3' z='1'/><vertex x='0' y='4' z='1'/>"     \
    "<vertex x='0' y='3.5' z='2.1'/></opening>"

static double draw(uint64_t *series, double low, double high)
{
    *series = pp_hash(*series, 1);
    return low + (high - low) * (double)(*series >> 11) * 0x1p-53;
}

/* Compares rays between points of an empty convex room, from a surface and from the
 * air. Rays close to edges, about one in some thousands, are excluded. */
static void compare(struct pp_light_scene *scene, struct pp_vec3 middle)
{
    enum { RAYS = 20000 };
    struct pp_convex_room *convex = scene->convex;
    uint64_t series = 5;
    int differ = 0;
    for (int i = 0; i < RAYS; i++) {
        struct pp_light_ray ray = {.from = middle, .space = PP_INDOORS};
        for (int leg = 0; leg < 2; leg++) {
            ray.to =
                pp_vec_unit(pp_vec(draw(&series, -1.0, 1.0), draw(&series, -1.0, 1.0),
                                   draw(&series, -1.0, 1.0)));
            if (pp_vec_dot(ray.to, ray.off) < 0.0)
                ray.to = pp_vec_scale(ray.to, -1.0);
            struct pp_light_hit met = {.part = -1}, kernel = {.part = -1};
            assert_int_equal(pp_light_scene_meet(scene, &ray, &met), PP_MEETS_PART);
            scene->convex = NULL;
            enum pp_meeting meeting = pp_light_scene_meet(scene, &ray, &kernel);
            scene->convex = convex;
            if (meeting != PP_MEETS_PART || kernel.part != met.part) {
                differ++;
                continue;
            }
            /* The general ray tracer starts a ray about 1e-5 m off its surface, which
             * moves its end, especially at grazing incidence. */
            double cosine = -pp_vec_dot(met.normal, ray.to);
            struct pp_vec3 off = pp_vec_sub(met.point, kernel.point);
            assert_near(cosine * (met.distance_m - kernel.distance_m), 0.0, 2e-5);
            assert_near(cosine * pp_vec_length(off), 0.0, 2e-5);
            assert_near(pp_vec_length(pp_vec_sub(met.normal, kernel.normal)), 0.0, 0.0);
            assert_int_equal(met.material, kernel.material);
            assert_int_equal(met.tag, kernel.tag);
            assert_int_equal(met.space, kernel.space);
            assert_true(met.back == kernel.back);
            ray.from = met.point;
            ray.off = met.normal;
        }
    }
    assert_in_range(differ, 0, 2 * RAYS / 2000);
}

static void rays_meet_what_the_kernels_say(void **state)
{
    (void)state;
    const char *const rooms[] = {BOX "</room>", TENT "</room>", NICHES "</room>"};
    for (int i = 0; i < 3; i++) {
        struct pp_world *world = pp_test_world(rooms[i]);
        struct pp_light_scene *scene = pp_test_matt_scene(world);
        assert_true(pp_convex_room_is(world));
        assert_non_null(scene->convex);
        compare(scene,
                pp_vec_sub(i != 1 ? pp_vec(1.3, 3.2, 1.4) : pp_vec(2.3, 2.6, 1.2),
                           scene->centre));
        pp_light_scene_destroy(scene);
        pp_world_destroy(world);
    }
}

/* Exactly: directly above a point of the floor is the ceiling or the rooflight. */
static void straight_up_lie_ceiling_and_rooflight(void **state)
{
    (void)state;
    struct pp_world *world = pp_test_world(BOX "</room>");
    struct pp_light_scene *scene = pp_test_matt_scene(world);
    const struct {
        double x, y;
        bool window;
    } at[] = {{1.09, 4.5, false},  {1.11, 4.5, true},  {1.99, 5.49, true},
              {2.01, 5.49, false}, {1.5, 4.19, false}, {1.5, 4.21, true}};
    for (size_t i = 0; i < sizeof at / sizeof *at; i++) {
        struct pp_light_ray ray = {
            .from = pp_vec_sub(pp_vec(at[i].x, at[i].y, 0.0), scene->centre),
            .off = pp_vec(0.0, 0.0, 1.0),
            .to = pp_vec(0.0, 0.0, 1.0),
            .space = PP_INDOORS};
        struct pp_light_hit hit = {.part = -1};
        assert_int_equal(pp_light_scene_meet(scene, &ray, &hit), PP_MEETS_PART);
        assert_near(hit.distance_m, 2.7, 1e-12);
        assert_true((scene->parts[hit.part].window >= 0) == at[i].window);
    }
    pp_light_scene_destroy(scene);
    pp_world_destroy(world);
}

/* By planes alone: a ray that passes the mouth of a niche 0.4 m deep meets the pane
 * behind it, or one of its sides. Rays that meet a niche of another shape, and all rays
 * that start in a niche, use the general ray tracer. */
static void behind_the_mouth_of_a_niche_are_its_pane_and_its_sides(void **state)
{
    (void)state;
    enum { KERNELS = -1, WALL, PANE, SIDE };
    struct pp_world *world = pp_test_world(NICHES "</room>");
    struct pp_light_scene *scene = pp_test_matt_scene(world);
    const struct {
        struct pp_vec3 from, to;
        int meets;
        double distance_m;
        struct pp_vec3 normal; /* at this point */
    } at[] = {
        {{1.5, 3.2, 1.4}, {0.0, -1.0, 0.0}, PANE, 3.6, {0.0, 1.0, 0.0}},
        {{1.5, 3.0, 1.4},
         {0.3, -1.0, 0.0},
         PANE,
         3.4 * 1.044030650891055,
         {0.0, 1.0, 0.0}},
        /* The upper side of the niche is at 2.2; the ray is at 2.16 at the mouth and at
         * 2.26 at the pane. */
        {{1.5, 3.0, 1.4}, {0.0, -3.0, 0.76}, SIDE, 3.257652, {0.0, 0.0, -1.0}},
        {{1.5, 3.0, 1.4}, {0.0, -3.0, 0.86}, WALL, 3.120833, {0.0, 1.0, 0.0}},
        /* The left side of the niche is at 0.3, where the ray arrives at y = -0.2. */
        {{1.5, 3.0, 1.4}, {-1.2, -3.2, 0.0}, SIDE, 3.417601, {1.0, 0.0, 0.0}},
        {{1.5, 3.0, 1.4}, {1.1, -3.2, -0.1}, SIDE, 3.385262, {-1.0, 0.0, 0.0}},
        {{1.5, 3.0, 1.4}, {0.0, -3.2, -0.6}, SIDE, 3.255764, {0.0, 0.0, 1.0}},
        {{1.5, 3.5, 1.4}, {-1.0, 0.0, 0.0}, KERNELS, 0.0, {0.0, 0.0, 0.0}},
        {{1.5, -0.2, 1.4}, {0.0, -1.0, 0.0}, KERNELS, 0.0, {0.0, 0.0, 0.0}},
        {{1.5, -0.2, 1.4}, {0.0, 1.0, 0.0}, KERNELS, 0.0, {0.0, 0.0, 0.0}}};
    for (size_t i = 0; i < sizeof at / sizeof *at; i++) {
        struct pp_light_ray ray = {.from = pp_vec_sub(at[i].from, scene->centre),
                                   .to = pp_vec_unit(at[i].to),
                                   .space = PP_INDOORS};
        struct pp_vec3 point;
        double distance;
        int part =
            pp_convex_room_meet(scene->convex, scene, &ray, NULL, &distance, &point);
        assert_true((part < 0) == (at[i].meets == KERNELS));
        if (part < 0)
            continue;
        const struct pp_light_part *met = &scene->parts[part];
        assert_int_equal(met->window >= 0  ? PANE
                         : met->niche >= 0 ? SIDE
                                           : WALL,
                         at[i].meets);
        assert_true(at[i].meets == WALL || met->window == 0 || met->niche == 0);
        assert_near(distance, at[i].distance_m, 1e-6);
        assert_near(pp_vec_length(pp_vec_sub(met->normal, at[i].normal)), 0.0, 1e-12);
        assert_near(pp_vec_dot(met->normal, point), met->offset_m, 1e-12);
    }
    pp_light_scene_destroy(scene);
    pp_world_destroy(world);
}

/* A point inside a niche is not in the convex room; a point on its mouth, on a wall or
 * in a corner is. */
static void a_niche_is_not_enclosed_by_the_room(void **state)
{
    (void)state;
    struct pp_world *world = pp_test_world(NICHES "</room>");
    struct pp_light_scene *scene = pp_test_matt_scene(world);
    const struct {
        struct pp_vec3 at;
        bool enclosed;
    } points[] = {{{1.5, 3.0, 1.4}, true},    {{1.5, 0.0, 1.4}, true},
                  {{0.0, 0.0, 2.7}, true},    {{1.5, -0.2, 1.4}, false},
                  {{1.5, -1e-6, 1.4}, false}, {{1.5, 4.9, 2.9}, false}};
    for (size_t i = 0; i < sizeof points / sizeof *points; i++)
        assert_true(pp_convex_room_encloses(scene->convex,
                                            pp_vec_sub(points[i].at, scene->centre))
                    == points[i].enclosed);
    pp_light_scene_destroy(scene);
    pp_world_destroy(world);
}

/* Rays from the air, from a wall, from corners and from outside, also parallel to the
 * axes. */
static void rays_of_a_run_meet_what_each_meets_alone(void **state)
{
    (void)state;
    static const char *const rooms[] = {BOX "</room>", TENT "</room>",
                                        NICHES "</room>"};
    static const struct pp_vec3 from[] = {{1.5, 2.1, 1.1},  {0.0, 3.5, 1.2},
                                          {1.3, 0.0, 1.2},  {0.0, 0.0, 0.0},
                                          {1.5, -0.2, 1.4}, {2.2, 2.0, 2.7}};
    uint64_t series = 17;
    int known = 0, met = 0;
    for (int r = 0; r < 3; r++) {
        struct pp_world *world = pp_test_world(rooms[r]);
        struct pp_light_scene *scene = pp_test_matt_scene(world);
        for (int trial = 0; trial < 600; trial++) {
            int count = 1 + trial % PP_RUN_MOST;
            struct pp_lanes_directions to;
            struct pp_convex_nearest nearest[PP_RUN_MOST];
            for (int i = 0; i < PP_RUN_MOST; i++) {
                struct pp_vec3 u = pp_vec_unit(pp_vec(draw(&series, -1.0, 1.0),
                                                      draw(&series, -1.0, 1.0),
                                                      draw(&series, -1.0, 1.0)));
                if (trial % 5 == 0)
                    u = pp_vec(i % 3 == 0, i % 3 == 1, i % 3 == 2 ? -1.0 : 0.0);
                to.x[i] = u.x;
                to.y[i] = u.y;
                to.z[i] = u.z;
            }
            struct pp_light_ray ray = {.from =
                                           pp_vec_sub(from[trial % 6], scene->centre),
                                       .space = PP_INDOORS};
            bool inside = pp_light_scene_nearest(scene, ray.from, &to, count, nearest);
            known += inside;
            for (int i = 0; i < count; i++) {
                struct pp_vec3 alone, by;
                double alone_m, by_m;
                ray.to = pp_vec(to.x[i], to.y[i], to.z[i]);
                int part = pp_convex_room_meet(scene->convex, scene, &ray, NULL,
                                               &alone_m, &alone);
                assert_true(inside || part < 0);
                if (!inside)
                    continue;
                assert_int_equal(pp_convex_room_meet(scene->convex, scene, &ray,
                                                     &nearest[i], &by_m, &by),
                                 part);
                met += part >= 0;
                if (part >= 0)
                    assert_true(by_m == alone_m && by.x == alone.x && by.y == alone.y
                                && by.z == alone.z);
            }
        }
        pp_light_scene_destroy(scene);
        pp_world_destroy(world);
    }
    assert_true(known > 900 && known < 1800 && met > 5000);
}

static void assert_not_convex(const char *xml)
{
    struct pp_world *world = pp_test_world(xml);
    struct pp_light_scene *scene = pp_test_matt_scene(world);
    assert_null(scene->convex);
    pp_light_scene_destroy(scene);
    pp_world_destroy(world);
}

static void a_room_with_a_corner_or_a_table_is_left_to_the_kernels(void **state)
{
    (void)state;
    assert_not_convex("<room version='1'><plan height='2.6'><vertex x='0' y='0'/>"
                      "<vertex x='5' y='0'/><vertex x='5' y='2'/><vertex x='2' y='2'/>"
                      "<vertex x='2' y='6'/><vertex x='0' y='6'/></plan></room>");
    assert_not_convex(BOX "<surface reflectance='0.4'><vertex x='1' y='1' z='0.7'/>"
                          "<vertex x='2' y='1' z='0.7'/><vertex x='2' y='2' z='0.7'/>"
                          "</surface></room>");
}

/* Outside, other objects may exist. */
static void a_ray_from_outside_is_left_to_the_kernels(void **state)
{
    (void)state;
    struct pp_world *world = pp_test_world(BOX "</room>");
    struct pp_light_scene *scene = pp_test_matt_scene(world);
    struct pp_light_ray ray = {.from =
                                   pp_vec_sub(pp_vec(1.5, -0.3, 1.2), scene->centre),
                               .to = pp_vec(0.0, 1.0, 0.0),
                               .space = PP_INDOORS};
    struct pp_vec3 point;
    double distance;
    assert_int_equal(
        pp_convex_room_meet(scene->convex, scene, &ray, NULL, &distance, &point), -1);
    pp_light_scene_destroy(scene);
    pp_world_destroy(world);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rays_meet_what_the_kernels_say),
        cmocka_unit_test(straight_up_lie_ceiling_and_rooflight),
        cmocka_unit_test(behind_the_mouth_of_a_niche_are_its_pane_and_its_sides),
        cmocka_unit_test(a_niche_is_not_enclosed_by_the_room),
        cmocka_unit_test(rays_of_a_run_meet_what_each_meets_alone),
        cmocka_unit_test(a_room_with_a_corner_or_a_table_is_left_to_the_kernels),
        cmocka_unit_test(a_ray_from_outside_is_left_to_the_kernels),
    };
    add_tests(tests, NULL, NULL);
}
