/* test_measured_pane.c - measured data as a pane: unscattered light, sampling, kinds of
 * panes. */
#include "model/light/bsdf/bsdf_write.h"
#include "model/light/bsdf/measured_pane.h"

#include "tests/lib/made_bsdf.h"
#include "tests/lib/near.h"

#define QUARTER "LBNL/Klems Quarter"

static struct pp_measured_pane *made_pane(made_bsdf_law *law, bool split)
{
    struct made_bsdf file = made_bsdf_front(QUARTER, law);
    struct pp_bsdf bsdf;
    struct pp_measured_pane *pane = NULL;
    struct pp_error err = {PP_OK, ""};
    if (pp_bsdf_file_parse(&bsdf, file.text, file.length, "made.xml", &err) != PP_OK
        || pp_measured_pane_create(&pane, &bsdf, split, &err) != PP_OK)
        fail_msg("%s", err.message);
    pp_bsdf_clear(&bsdf);
    free(file.text);
    return pane;
}

static double clear(const struct pp_angle_basis *basis, int in, int out)
{
    return in == out ? 0.8 / pp_angle_basis_projected(basis, out) : 0.0;
}

/* In a patch about azimuth 300, towards which the prism scatters 0.15/pi. */
static const struct pp_vec3 DOWN = {0.35, -0.6, 0.719374728496908};

static void unscattered_light_is_split_off(void **state)
{
    (void)state;
    struct pp_measured_pane *pane = made_pane(made_bsdf_prism, true);
    const struct pp_pane_scatter *scatter = &pane->scatter;
    struct pp_vec3 up = pp_vec(DOWN.x, -DOWN.y, DOWN.z);
    assert_near(scatter->straight(pane, DOWN), 0.25, 1e-8);
    assert_near(scatter->straight(pane, up), 0.25, 1e-8);
    assert_near(scatter->scattered(pane, DOWN), 0.55, 1e-8);
    assert_near(scatter->scattered(pane, up), 0.25, 1e-8);
    assert_near(scatter->btdf(pane, DOWN, DOWN), 0.15 / PP_PI, 1e-8);
    pp_measured_pane_release(pane);

    pane = made_pane(made_bsdf_prism, false);
    assert_near(pane->scatter.straight(pane, DOWN), 0.0, 0.0);
    assert_near(pane->scatter.scattered(pane, DOWN), 0.8, 1e-8);
    pp_measured_pane_release(pane);
}

/* Louvres that hide the view perpendicular to the pane: no light at normal incidence,
 * 0.8 from all other directions. The patch about the normal has sin^2 of 9 degrees of
 * the projected solid angle of the hemisphere. */
static double selective(const struct pp_angle_basis *basis, int in, int out)
{
    return in > 0 ? clear(basis, in, out) : 0.0;
}

static void a_pane_can_be_opaque_at_normal_incidence(void **state)
{
    (void)state;
    struct pp_measured_pane *pane = made_pane(selective, true);
    double sine = sin(9.0 * PP_RAD);
    assert_near(pane->normal, 0.0, 0.0);
    assert_near(pane->diffuse, 0.8 * (1.0 - sine * sine), 1e-6);
    assert_near(pane->scatter.straight(pane, DOWN), 0.8, 1e-6);
    assert_near(pane->scatter.straight(pane, pp_vec(0.0, 0.0, 1.0)), 0.0, 0.0);
    /* No clear glass has such a transmittance. */
    assert_int_equal(pane->kind, PP_MEASURED_SCATTERING);
    pp_measured_pane_release(pane);
}

/* Means over a fine grid of samples compared with sums over all patches. */
static void samples_have_the_density_that_they_state(void **state)
{
    (void)state;
    enum { SIDE = 64 };
    struct pp_measured_pane *pane = made_pane(made_bsdf_prism, false);
    const struct pp_pane_scatter *scatter = &pane->scatter;
    const struct pp_angle_basis *basis = &pane->into_room.in;
    for (int way = 0; way < 2; way++) {
        struct pp_vec3 out = way ? pp_vec_scale(DOWN, -1.0) : DOWN, in;
        double height = 0.0, exact = 0.0, sum = 0.0;
        for (int i = 0; i < SIDE * SIDE; i++) {
            assert_near(scatter->sample(pane, out, (i / SIDE + 0.5) / SIDE,
                                        (i % SIDE + 0.5) / SIDE, &in),
                        1.0, 0.0);
            assert_true(in.z * out.z > 0.0);
            assert_true(scatter->density(pane, in, out) > 0.0);
            height += in.y / (SIDE * SIDE);
        }
        for (int i = 0; i < basis->count * 256; i++) {
            in = pp_angle_basis_direction(basis, i / 256, (i / 16 % 16 + 0.5) / 16,
                                          (i % 16 + 0.5) / 16);
            if (way)
                in.z = -in.z;
            double share = scatter->density(pane, in, out) / fabs(in.z)
                           * pp_angle_basis_projected(basis, i / 256) / 256.0;
            exact += share * in.y;
            sum += share;
        }
        assert_near(sum, 1.0, 1e-9);
        assert_near(height, exact, 0.01);
    }
    pp_measured_pane_release(pane);
}

/* The direction DOWN receives 0.25 of the light that travels in it, 0.15 of the spread
 * light and, mirrored, 0.15 of the light that travels up; its mirror image receives
 * 0.45 of the light that travels down. */
static void radiance_under_an_even_sky_sums_over_arriving_light(void **state)
{
    (void)state;
    struct pp_measured_pane *pane = made_pane(made_bsdf_prism, false);
    struct pp_vec3 up = pp_vec(DOWN.x, -DOWN.y, DOWN.z);
    assert_near(pane->scatter.arriving(pane, DOWN), 0.25 + 0.15 + 0.15, 1e-8);
    assert_near(pane->scatter.arriving(pane, up), 0.25 + 0.45 + 0.15, 1e-8);
    pp_measured_pane_release(pane);
}

static void panes_are_distinguished_by_their_light(void **state)
{
    (void)state;
    static const struct {
        made_bsdf_law *law;
        enum pp_measured_kind kind;
        double normal, diffuse, straight;
    } of[] = {{clear, PP_MEASURED_CLEAR, 0.8, 0.8, 0.8},
              {made_bsdf_lambertian, PP_MEASURED_DIFFUSING, 0.4, 0.4, 0.0}};
    for (size_t i = 0; i < sizeof of / sizeof *of; i++) {
        struct pp_measured_pane *pane = made_pane(of[i].law, true);
        assert_int_equal(pane->kind, of[i].kind);
        assert_near(pane->normal, of[i].normal, 1e-8);
        assert_near(pane->diffuse, of[i].diffuse, 1e-8);
        assert_near(pane->straight_diffuse, of[i].straight, 1e-8);
        assert_near(pane->scatter.straight(pane, DOWN), of[i].straight, 1e-8);
        pp_measured_pane_release(pane);
    }
    struct pp_measured_pane *prism = made_pane(made_bsdf_prism, true);
    assert_int_equal(prism->kind, PP_MEASURED_SCATTERING);
    pp_measured_pane_release(prism);
}

/* Exported data are those that were read, here halved by a frame. */
static void a_written_pane_reads_back(void **state)
{
    (void)state;
    for (int split = 0; split < 2; split++) {
        struct pp_measured_pane *pane = made_pane(made_bsdf_prism, split), *back = NULL;
        char *text = NULL;
        size_t length = 0;
        FILE *out = open_memstream(&text, &length);
        pp_bsdf_write(out, &pane->scatter, 0.5, "pane");
        fclose(out);
        struct pp_bsdf bsdf;
        assert_int_equal(pp_bsdf_file_parse(&bsdf, text, length, "back.xml", NULL),
                         PP_OK);
        assert_int_equal(pp_measured_pane_create(&back, &bsdf, split, NULL), PP_OK);
        for (int way = -1; way <= 1; way += 2)
            for (int i = 0; i < 41; i++) {
                struct pp_vec3 in =
                    pp_angle_basis_direction(&pane->into_room.in, i, 0.4, 0.4);
                in.z *= way;
                assert_near(back->scatter.scattered(back, in),
                            0.5 * pane->scatter.scattered(pane, in), 1e-6);
                assert_near(back->scatter.straight(back, in),
                            0.5 * pane->scatter.straight(pane, in), 1e-6);
            }
        assert_int_equal(bsdf.warning_count, 0);
        pp_bsdf_clear(&bsdf);
        free(text);
        pp_measured_pane_release(pane);
        pp_measured_pane_release(back);
    }
}

/* Rings end at 90 degrees, except for the rounding of degrees in the file. */
static void no_ring_of_directions_goes_below_the_surface(void **state)
{
    (void)state;
    struct pp_angle_basis basis = {.count = 0};
    assert_false(pp_angle_basis_add_ring(&basis, 0.0, 90.9 * PP_RAD, 1));
    assert_true(pp_angle_basis_add_ring(&basis, 0.0, 90.00005 * PP_RAD, 1));
    assert_near(basis.rings[0].high_rad, 0.5 * PP_PI, 0.0);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(unscattered_light_is_split_off),
        cmocka_unit_test(a_pane_can_be_opaque_at_normal_incidence),
        cmocka_unit_test(samples_have_the_density_that_they_state),
        cmocka_unit_test(radiance_under_an_even_sky_sums_over_arriving_light),
        cmocka_unit_test(panes_are_distinguished_by_their_light),
        cmocka_unit_test(a_written_pane_reads_back),
        cmocka_unit_test(no_ring_of_directions_goes_below_the_surface),
    };
    add_tests(tests, NULL, NULL);
}
