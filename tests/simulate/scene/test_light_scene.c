/* test_light_scene.c - intersections of rays with scenes of any shapes. */
#include "simulate/scene/light_scene.h"

#include "simulate/scene/light_scene_of_description.h"
#include "simulate/scene/light_scene_of_world.h"
#include "simulate/sampling/scatter.h"
#include "tests/lib/light_scenes.h"
#include "tests/lib/room_of.h"

static const double huge_far = 1e4;

static int add(struct pp_scene_description *scene, const char *name)
{
    struct pp_material material = pp_material_diffuse(pp_rgb_grey(0.5));
    int index;
    strcpy(material.name, name);
    assert_int_equal(pp_scene_description_add_material(scene, &material, &index, NULL),
                     PP_OK);
    return index;
}

static void add_shape(struct pp_scene_description *scene, struct pp_shape shape,
                      int tag)
{
    struct pp_error err = {0};
    shape.tag = tag;
    shape.back_material = -1;
    if (pp_scene_description_add_shape(scene, &shape, NULL, &err) != PP_OK)
        fail_msg("%s", err.message);
}

static struct pp_light_scene *built(struct pp_scene_description *from)
{
    struct pp_light_scene *scene = NULL;
    assert_int_equal(pp_light_scene_of_description(&scene, from, NULL), PP_OK);
    pp_scene_description_clear(from);
    return scene;
}

static bool look(const struct pp_light_scene *scene, struct pp_vec3 from,
                 struct pp_vec3 to, struct pp_light_hit *hit)
{
    struct pp_light_ray ray = {.from = from, .to = pp_vec_unit(to)};
    return pp_light_scene_first(scene, &ray, hit);
}

static void assert_at(struct pp_vec3 p, double x, double y, double z, double near)
{
    assert_near(p.x, x, near);
    assert_near(p.y, y, near);
    assert_near(p.z, z, near);
}

/* The shape is found in single precision; the point on it is calculated in double
 * precision: 1e-12 of the size. */
static void a_sphere_is_met_where_it_is_from_outside_and_from_inside(void **state)
{
    (void)state;
    struct pp_scene_description scene;
    pp_scene_description_init(&scene);
    add(&scene, "ball");
    add_shape(&scene,
              (struct pp_shape){.kind = PP_SHAPE_SPHERE,
                                .is.sphere = {pp_vec(1.0, 2.0, 3.0), 0.7}},
              42);
    struct pp_light_scene *made = built(&scene);
    struct pp_light_hit hit;
    assert_true(look(made, pp_vec(1.0, -4.0, 3.0), pp_vec(0.0, 1.0, 0.0), &hit));
    assert_at(hit.point, 1.0, 1.3, 3.0, 1e-9);
    assert_at(hit.normal, 0.0, -1.0, 0.0, 1e-9);
    assert_int_equal(hit.tag, 42);
    assert_false(hit.back);
    assert_true(look(made, pp_vec(1.0, 2.0, 3.0), pp_vec(0.6, 0.0, 0.8), &hit));
    assert_at(hit.point, 1.42, 2.0, 3.56, 1e-9);
    assert_at(hit.normal, -0.6, 0.0, -0.8, 1e-9);
    assert_true(hit.back);
    assert_false(look(made, pp_vec(1.0, -4.0, 3.71), pp_vec(0.0, 1.0, 0.0), &hit));
    /* A ray that leaves the sphere does not meet it again. */
    struct pp_light_ray away = {.from = pp_vec(1.0, 1.3, 3.0),
                                .off = pp_vec(0.0, -1.0, 0.0),
                                .to = pp_vec_unit(pp_vec(1.0, -1e-3, 0.3))};
    assert_false(pp_light_scene_first(made, &away, &hit));
    pp_light_scene_destroy(made);
}

static void cones_are_open_and_rings_have_holes(void **state)
{
    (void)state;
    struct pp_scene_description scene;
    pp_scene_description_init(&scene);
    add(&scene, "tin");
    /* A cone from radius 1 at z = 0 to 0.5 at z = 2, and a ring above it. */
    add_shape(
        &scene,
        (struct pp_shape){
            .kind = PP_SHAPE_CONE,
            .is.cone = {{pp_vec(0.0, 0.0, 0.0), pp_vec(0.0, 0.0, 2.0)}, {1.0, 0.5}}},
        1);
    add_shape(
        &scene,
        (struct pp_shape){
            .kind = PP_SHAPE_RING,
            .is.ring = {pp_vec(0.0, 0.0, 3.0), pp_vec(0.0, 0.0, 2.0), {0.2, 0.9}}},
        2);
    struct pp_light_scene *made = built(&scene);
    struct pp_light_hit hit;
    assert_true(look(made, pp_vec(5.0, 0.0, 1.0), pp_vec(-1.0, 0.0, 0.0), &hit));
    assert_at(hit.point, 0.75, 0.0, 1.0, 1e-9);
    /* The surface is inclined by 1 in 4. */
    assert_at(hit.normal, 4.0 / sqrt(17.0), 0.0, 1.0 / sqrt(17.0), 1e-9);
    assert_false(hit.back);
    /* From inside: its back, and out through the open end and the hole of the ring. */
    assert_true(look(made, pp_vec(0.0, 0.0, 1.0), pp_vec(0.0, 1.0, 0.0), &hit));
    assert_at(hit.point, 0.0, 0.75, 1.0, 1e-9);
    assert_true(hit.back);
    assert_false(look(made, pp_vec(0.1, 0.0, 1.0), pp_vec(0.0, 0.0, 1.0), &hit));
    assert_true(look(made, pp_vec(0.3, 0.0, 1.0), pp_vec(0.0, 0.0, 1.0), &hit));
    assert_int_equal(hit.tag, 2);
    assert_true(hit.back);
    assert_false(look(made, pp_vec(0.0, 1.05, 5.0), pp_vec(0.0, 0.0, -1.0), &hit));
    pp_light_scene_destroy(made);
}

/* Shoots rays down at every tenth of a metre of a polygon in the plane z = 0, and
 * compares the hits with the number of crossings of a ray in the plane. Returns the
 * number of hits. */
static int met_as_crossed(const struct pp_vec3 *v, int count)
{
    struct pp_scene_description scene;
    pp_scene_description_init(&scene);
    int material = add(&scene, "sheet");
    struct pp_error err = {0};
    if (pp_scene_description_add_polygon(&scene, v, count, material, NULL, &err)
        != PP_OK)
        fail_msg("%s", err.message);
    struct pp_light_scene *made = built(&scene);
    int met = 0;
    for (int i = 0; i < 40; i++)
        for (int k = 0; k < 40; k++) {
            struct pp_light_hit hit;
            double x = 0.05 + 0.1 * i, y = 0.053 + 0.1 * k;
            bool crossed = false;
            for (int a = count - 1, b = 0; b < count; a = b++)
                if ((v[a].y > y) != (v[b].y > y)
                    && x < v[a].x
                               + (y - v[a].y) / (v[b].y - v[a].y) * (v[b].x - v[a].x))
                    crossed = !crossed;
            bool is_met = look(made, pp_vec(x, y, 2.0), pp_vec(0.0, 0.0, -1.0), &hit);
            assert_int_equal(is_met, crossed);
            met += is_met;
        }
    pp_light_scene_destroy(made);
    return met;
}

/* A square with a square hole, joined by a seam, as in Radiance files. */
static void a_hole_joined_by_a_seam_lets_rays_through(void **state)
{
    (void)state;
    const struct pp_vec3 v[] = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {0, 0, 0},
                                {1, 1, 0}, {1, 3, 0}, {3, 3, 0}, {3, 1, 0}, {1, 1, 0}};
    assert_int_equal(met_as_crossed(v, 10), 1600 - 400);
}

/* Radiance counts crossings: the orientation of the hole does not matter. */
static void a_hole_may_run_round_as_its_rim_does(void **state)
{
    (void)state;
    const struct pp_vec3 v[] = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {0, 0, 0},
                                {1, 1, 0}, {3, 1, 0}, {3, 3, 0}, {1, 3, 0}, {1, 1, 0}};
    assert_int_equal(met_as_crossed(v, 10), 1600 - 400);
    /* Starting from another corner, with the ends of the loop in the middle of the
     * seam. */
    const struct pp_vec3 w[] = {{3, 1, 0}, {3, 3, 0}, {1, 3, 0}, {1, 1, 0}, {3, 1, 0},
                                {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {0, 0, 0}, {4, 0, 0}};
    assert_int_equal(met_as_crossed(w, 10), 1600 - 400);
}

/* A five-pointed star turns left at each corner and winds twice around its centre,
 * which is crossed twice. A crossed strip is met on both sides of the crossing; a
 * triangle traced twice is not met. */
static void outlines_that_cross_themselves_are_what_crossings_make_them(void **state)
{
    (void)state;
    const struct pp_vec3 star[] = {
        {2.0, 3.9, 0}, {0.9, 0.4, 0}, {3.8, 2.6, 0}, {0.2, 2.6, 0}, {3.1, 0.4, 0}};
    const struct pp_vec3 strip[] = {
        {0.2, 0.3, 0}, {3.7, 2.1, 0}, {3.7, 0.4, 0}, {0.2, 3.6, 0}};
    const struct pp_vec3 twice[] = {{0.2, 0.3, 0}, {3.7, 0.4, 0}, {1.7, 3.1, 0},
                                    {0.2, 0.3, 0}, {3.7, 0.4, 0}, {1.7, 3.1, 0}};
    assert_true(met_as_crossed(star, 5) > 200);
    assert_true(met_as_crossed(strip, 4) > 200);
    assert_int_equal(met_as_crossed(twice, 6), 0);
}

static void what_makes_no_sense_is_refused(void **state)
{
    (void)state;
    struct pp_scene_description scene;
    pp_scene_description_init(&scene);
    int material = add(&scene, "any");
    const struct pp_vec3 line[] = {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}};
    const struct pp_vec3 bent[] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0.2}, {0, 1, 0}};
    const struct pp_vec3 none[] = {{0, 0, 0}, {1, 0, NAN}, {1, 1, 0}};
    struct pp_error err;
    assert_int_equal(
        pp_scene_description_add_polygon(&scene, line, 3, material, NULL, &err),
        PP_BAD_INPUT);
    assert_int_equal(
        pp_scene_description_add_polygon(&scene, bent, 4, material, NULL, &err),
        PP_BAD_INPUT);
    assert_int_equal(
        pp_scene_description_add_polygon(&scene, none, 3, material, NULL, &err),
        PP_BAD_INPUT);
    assert_int_equal(
        pp_scene_description_add_polygon(&scene, bent, 3, material + 1, NULL, &err),
        PP_BAD_INPUT);
    struct pp_shape shape = {.kind = PP_SHAPE_SPHERE, .is.sphere = {{0, 0, 0}, -1.0}};
    assert_int_equal(pp_scene_description_add_shape(&scene, &shape, NULL, &err),
                     PP_BAD_INPUT);
    shape = (struct pp_shape){.kind = PP_SHAPE_CONE,
                              .is.cone = {{{1, 1, 1}, {1, 1, 1}}, {1.0, 1.0}}};
    assert_int_equal(pp_scene_description_add_shape(&scene, &shape, NULL, &err),
                     PP_BAD_INPUT);
    shape = (struct pp_shape){.kind = PP_SHAPE_RING,
                              .is.ring = {{0, 0, 0}, {0, 0, 1}, {2.0, 1.0}}};
    assert_int_equal(pp_scene_description_add_shape(&scene, &shape, NULL, &err),
                     PP_BAD_INPUT);
    shape = (struct pp_shape){.kind = PP_SHAPE_DISTANT, .is.distant = {{0, 0, 0}, 0.1}};
    assert_int_equal(pp_scene_description_add_shape(&scene, &shape, NULL, &err),
                     PP_BAD_INPUT);
    assert_int_equal(scene.shape_count, 0);

    struct pp_material bright = pp_material_plastic(pp_rgb_grey(1.0), 0.05, 0.1, 0.1);
    strcpy(bright.name, "too bright");
    bright.gloss.g = 0.1;
    assert_int_equal(pp_scene_description_add_material(&scene, &bright, NULL, &err),
                     PP_BAD_INPUT);
    assert_non_null(strstr(err.message, "\"too bright\""));
    bright = pp_material_diffuse(pp_rgb(0.1, NAN, 0.1));
    assert_int_equal(pp_scene_description_add_material(&scene, &bright, NULL, &err),
                     PP_BAD_INPUT);
    bright = pp_material_pane(pp_rgb(0.9, 1.2, 0.9), 1.52);
    assert_int_equal(pp_scene_description_add_material(&scene, &bright, NULL, &err),
                     PP_BAD_INPUT);
    pp_scene_description_clear(&scene);
}

static void an_empty_scene_is_met_nowhere(void **state)
{
    (void)state;
    struct pp_scene_description scene;
    pp_scene_description_init(&scene);
    struct pp_light_scene *made = built(&scene);
    struct pp_light_hit hit;
    assert_false(look(made, pp_vec(1.0, 2.0, 3.0), pp_vec(0.1, 0.2, 1.0), &hit));
    assert_true(isinf(hit.distance_m));
    pp_light_scene_destroy(made);
    pp_light_scene_destroy(NULL);
}

#define ROOM                                                                           \
    "<room version='1'><plan width='3.1' depth='4.3' height='2.6'/>"                   \
    "<finishes floor='oak-floor' walls='0.6' ceiling='0.8'/>"                          \
    "<finish wall='north' reflectance='brushed-aluminium'/>"                           \
    "<window wall='south' left='0.5' sill='0.9' width='1.7' height='1.2' "             \
    "reveal='0.2'/>"

static void a_room_is_met_by_its_surfaces_names(void **state)
{
    (void)state;
    struct pp_world *world = pp_test_world(ROOM "</room>");
    struct pp_light_scene *scene;
    assert_int_equal(pp_light_scene_of_world(&scene, world, NULL), PP_OK);
    struct pp_vec3 in = {1.4, 2.2, 1.3};
    assert_int_equal(pp_light_scene_space(scene, in), PP_INDOORS);
    assert_int_equal(pp_light_scene_space(scene, pp_vec(1.4, -3.0, 1.3)), PP_ANYWHERE);
    const struct {
        struct pp_vec3 to;
        const char *name;
    } looks[] = {{{0.1, 0.2, -1.0}, "floor"},
                 {{0.0, 0.0, 1.0}, "ceiling"},
                 {{0.0, 1.0, 0.0}, "north"},
                 {{-1.0, 0.0, 0.1}, "west"},
                 {{0.0, -1.0, 0.05}, "glazing"}};
    for (size_t i = 0; i < sizeof looks / sizeof *looks; i++) {
        struct pp_light_hit hit;
        assert_true(look(scene, in, looks[i].to, &hit));
        assert_string_equal(pp_light_scene_material(scene, hit.material)->name,
                            looks[i].name);
        assert_false(hit.back);
    }
    struct pp_light_hit hit;
    assert_true(look(scene, pp_vec(1.4, -3.0, 0.2), pp_vec(0.0, 1.0, 0.0), &hit));
    assert_string_equal(pp_light_scene_material(scene, hit.material)->name,
                        "south (outside)");
    struct pp_bounds3 room = pp_light_scene_bounds(scene, true);
    assert_at(room.low, 0.0, 0.0, 0.0, 0.0);
    assert_at(room.high, 3.1, 4.3, 2.6, 0.0);
    pp_light_scene_destroy(scene);
    pp_world_destroy(world);
}

/* Named finishes have a gloss; hand methods use their total reflectance. */
static void a_named_finish_has_its_gloss(void **state)
{
    (void)state;
    struct pp_world *world = pp_test_world(ROOM "</room>");
    struct pp_light_scene *scene;
    assert_int_equal(pp_light_scene_of_world(&scene, world, NULL), PP_OK);
    struct pp_light_hit hit;
    struct pp_vec3 in = {1.4, 2.2, 1.3};
    assert_true(look(scene, in, pp_vec(0.0, 1.0, 0.0), &hit));
    const struct pp_material *metal = pp_light_scene_material(scene, hit.material);
    assert_near(metal->gloss.g, 0.5, 1e-12);
    assert_near(metal->roughness[1], 0.2, 0.0);
    assert_near(pp_material_reflectance(metal), 0.6, 1e-12);
    assert_true(look(scene, in, pp_vec(0.0, 0.0, -1.0), &hit));
    const struct pp_material *oak = pp_light_scene_material(scene, hit.material);
    assert_true(oak->diffuse.r > oak->diffuse.b);
    assert_near(pp_material_reflectance(oak), 0.25, 1e-12);
    pp_light_scene_destroy(scene);
    pp_world_destroy(world);
}

static uint64_t hash_of(const char *xml)
{
    struct pp_world *world = pp_test_world(xml);
    struct pp_light_scene *scene;
    assert_int_equal(pp_light_scene_of_world(&scene, world, NULL), PP_OK);
    uint64_t hash = pp_light_scene_hash(scene);
    pp_light_scene_destroy(scene);
    pp_world_destroy(world);
    return hash;
}

static void the_hash_hangs_on_all_that_light_meets(void **state)
{
    (void)state;
    uint64_t plain = hash_of(ROOM "</room>");
    assert_true(plain == hash_of(ROOM "<point x='1' y='1'/></room>"));
    assert_false(plain == hash_of(ROOM "<skyline wall='south' angle='20'/></room>"));
    assert_false(
        plain
        == hash_of(ROOM
                   "<block x='-4' y='-14' width='10' depth='6' height='8'/></room>"));
    assert_false(plain
                 == hash_of(ROOM "<finish wall='east' reflectance='0.61'/></room>"));
}

/* A ball of 0.5 m radius 10 km away is met, and a ray that passes 1 m from its centre
 * misses it. */
static void a_small_ball_far_away_is_met(void **state)
{
    (void)state;
    struct pp_scene_description scene;
    pp_scene_description_init(&scene);
    add(&scene, "ball");
    add_shape(&scene,
              (struct pp_shape){.kind = PP_SHAPE_SPHERE,
                                .is.sphere = {pp_vec(huge_far, 0.0, 0.0), 0.5}},
              7);
    struct pp_light_scene *made = built(&scene);
    struct pp_light_hit hit;
    assert_true(look(made, pp_vec(0.0, 0.0, 0.0), pp_vec(1.0, 0.0, 0.0), &hit));
    assert_near(hit.distance_m, huge_far - 0.5, 2e-3);
    assert_false(look(made, pp_vec(0.0, 0.0, 0.0), pp_vec(1.0, 1e-4, 0.0), &hit));
    pp_light_scene_destroy(made);
}

/* A scene of 80 kinds of glass, each used twice, and a coloured one: the first kinds
 * have a tabulated curve, which both panes share. The others are evaluated by their
 * formula, which gives the same value. */
static void glass_is_its_law_with_and_without_a_curve(void **state)
{
    (void)state;
    struct pp_scene_description from = {0};
    for (int i = 0; i < 161; i++) {
        double t = 0.2 + 0.009 * (i % 80);
        struct pp_material pane =
            pp_material_pane(pp_rgb(t, t, i < 160 ? t : 0.5), 1.52);
        snprintf(pane.name, sizeof pane.name, "pane %d", i);
        int index;
        assert_int_equal(pp_scene_description_add_material(&from, &pane, &index, NULL),
                         PP_OK);
        pp_test_rectangle(&from, index, pp_vec(i, 0.0, 0.0), pp_vec(0.9, 0.0, 0.0),
                          pp_vec(0.0, 0.0, 1.0));
    }
    struct pp_light_scene *scene = built(&from);
    for (int i = 0; i < 161; i++) {
        const struct pp_material *pane = pp_light_scene_material(scene, i);
        assert_int_equal(pane->curve != NULL, i < 160 && i % 80 < 64);
        assert_ptr_equal(pane->curve,
                         i < 160 ? pp_light_scene_material(scene, i % 80)->curve
                                 : NULL);
        for (int k = 1; k <= 10; k++)
            assert_near(pp_scatter_regular_transmittance(pane, 0.1 * k).b,
                        pp_glass_transmittance(&pane->glass[2], 0.1 * k), 1e-8);
    }
    pp_light_scene_destroy(scene);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_sphere_is_met_where_it_is_from_outside_and_from_inside),
        cmocka_unit_test(cones_are_open_and_rings_have_holes),
        cmocka_unit_test(a_hole_joined_by_a_seam_lets_rays_through),
        cmocka_unit_test(a_hole_may_run_round_as_its_rim_does),
        cmocka_unit_test(outlines_that_cross_themselves_are_what_crossings_make_them),
        cmocka_unit_test(a_small_ball_far_away_is_met),
        cmocka_unit_test(what_makes_no_sense_is_refused),
        cmocka_unit_test(an_empty_scene_is_met_nowhere),
        cmocka_unit_test(a_room_is_met_by_its_surfaces_names),
        cmocka_unit_test(a_named_finish_has_its_gloss),
        cmocka_unit_test(the_hash_hangs_on_all_that_light_meets),
        cmocka_unit_test(glass_is_its_law_with_and_without_a_curve),
    };
    add_tests(tests, NULL, NULL);
}
