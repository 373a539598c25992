/* test_block_shape.c - roofs of blocks. */
#include "model/room/read/block_shape.h"

#include <math.h>

#include "model/geometry/polygon.h"
#include "tests/lib/near.h"

#define WIDTH 7.3
#define DEPTH 4.1
#define EAVES 5.2
#define PITCH (37.0 * PP_RAD)

/* Volume above the eaves (m3), by the divergence theorem over the faces. They are
 * closed except for the horizontal base, which contributes nothing if z is measured
 * from it. */
static double volume(enum pp_roof roof, enum pp_ridge ridge, double width, double depth)
{
    struct pp_block_shape_face faces[PP_BLOCK_SHAPE_ROOF_MOST];
    int count = pp_block_shape_roof(faces, width, depth, EAVES, roof, PITCH, ridge);
    double sum = 0.0;
    struct pp_vec3 area = {0};
    for (int i = 0; i < count; i++)
        for (int k = 1; k + 1 < faces[i].count; k++) {
            struct pp_vec3 t[3] = {faces[i].corners[0], faces[i].corners[k],
                                   faces[i].corners[k + 1]};
            for (int j = 0; j < 3; j++)
                t[j].z -= EAVES;
            struct pp_vec3 own = pp_polygon_area_vector(t, 3);
            area = pp_vec_add(area, own);
            sum += pp_vec_dot(t[0], own) / 3.0;
        }
    /* The faces are closed except for the base. */
    assert_near(area.x, 0.0, 1e-12);
    assert_near(area.y, 0.0, 1e-12);
    assert_near(area.z, width * depth, 1e-12);
    return sum;
}

static void a_gable_roof_is_a_prism(void **state)
{
    (void)state;
    double along_width = WIDTH * DEPTH * 0.5 * (0.5 * DEPTH * tan(PITCH));
    double along_depth = WIDTH * DEPTH * 0.5 * (0.5 * WIDTH * tan(PITCH));
    assert_near(volume(PP_ROOF_GABLE, PP_RIDGE_LONGER, WIDTH, DEPTH), along_width,
                1e-12);
    assert_near(volume(PP_ROOF_GABLE, PP_RIDGE_WIDTH, WIDTH, DEPTH), along_width,
                1e-12);
    assert_near(volume(PP_ROOF_GABLE, PP_RIDGE_DEPTH, WIDTH, DEPTH), along_depth,
                1e-12);
    assert_near(volume(PP_ROOF_GABLE, PP_RIDGE_LONGER, DEPTH, WIDTH), along_width,
                1e-12);
}

static void a_mono_pitch_roof_is_a_wedge(void **state)
{
    (void)state;
    assert_near(volume(PP_ROOF_MONO, PP_RIDGE_WIDTH, WIDTH, DEPTH),
                0.5 * WIDTH * DEPTH * DEPTH * tan(PITCH), 1e-12);
    assert_near(volume(PP_ROOF_MONO, PP_RIDGE_DEPTH, WIDTH, DEPTH),
                0.5 * WIDTH * DEPTH * WIDTH * tan(PITCH), 1e-12);
}

/* A prism over the ridge; the half pyramids at both ends form one pyramid. */
static void a_hip_roof_is_a_prism_and_a_pyramid(void **state)
{
    (void)state;
    double rise = 0.5 * DEPTH * tan(PITCH);
    double wanted = 0.5 * DEPTH * rise * (WIDTH - DEPTH) + DEPTH * DEPTH * rise / 3.0;
    assert_near(volume(PP_ROOF_HIP, PP_RIDGE_LONGER, WIDTH, DEPTH), wanted, 1e-12);
    assert_near(volume(PP_ROOF_HIP, PP_RIDGE_WIDTH, DEPTH, WIDTH), wanted, 1e-12);
    assert_near(volume(PP_ROOF_HIP, PP_RIDGE_LONGER, DEPTH, DEPTH),
                DEPTH * DEPTH * rise / 3.0, 1e-12);
}

static void a_flat_roof_is_nothing_more(void **state)
{
    (void)state;
    struct pp_block_shape_face faces[PP_BLOCK_SHAPE_ROOF_MOST];
    assert_int_equal(pp_block_shape_roof(faces, WIDTH, DEPTH, EAVES, PP_ROOF_FLAT, NAN,
                                         PP_RIDGE_LONGER),
                     0);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_gable_roof_is_a_prism),
        cmocka_unit_test(a_mono_pitch_roof_is_a_wedge),
        cmocka_unit_test(a_hip_roof_is_a_prism_and_a_pyramid),
        cmocka_unit_test(a_flat_roof_is_nothing_more),
    };
    add_tests(tests, NULL, NULL);
}
