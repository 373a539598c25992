/* test_bsdf_file.c - scattering data of WINDOW XML files. */
#include "model/light/bsdf/bsdf_file.h"

#include "tests/lib/made_bsdf.h"
#include "tests/lib/near.h"
#include "tests/model/light/towards.h"

#define FULL "LBNL/Klems Full"
#define HALF "LBNL/Klems Half"
#define QUARTER "LBNL/Klems Quarter"

/* Reads the file, which must be valid. */
static struct pp_bsdf read_made(struct made_bsdf *file)
{
    struct pp_bsdf bsdf;
    struct pp_error err = {PP_OK, ""};
    if (pp_bsdf_file_parse(&bsdf, file->text, file->length, "made.xml", &err) != PP_OK)
        fail_msg("%s", err.message);
    free(file->text);
    return bsdf;
}

static double direct(const struct pp_bsdf *bsdf, enum pp_bsdf_part part,
                     struct pp_vec3 travel)
{
    const struct pp_bsdf_block *block = &bsdf->blocks[part];
    return pp_bsdf_block_direct(block, pp_angle_basis_find(&block->in, travel));
}

/* Projected solid angles of published tables, to their digits. */
static void patches_of_klems_fill_the_hemisphere(void **state)
{
    (void)state;
    static const struct {
        const char *name;
        int count, patch;
        double projected;
    } of[] = {{FULL, 145, 0, 0.02386393},
              {FULL, 145, 1, 0.02332286},
              {FULL, 145, 9, 0.02191632},
              {HALF, 77, 0, 0.04025941},
              {QUARTER, 41, 0, 0.07688024}};
    for (size_t i = 0; i < sizeof of / sizeof *of; i++) {
        struct pp_angle_basis basis;
        double sum = 0.0;
        assert_true(pp_angle_basis_named(&basis, of[i].name));
        assert_int_equal(basis.count, of[i].count);
        assert_near(pp_angle_basis_projected(&basis, of[i].patch), of[i].projected,
                    6e-9);
        for (int k = 0; k < basis.count; k++) {
            sum += pp_angle_basis_projected(&basis, k);
            for (double u = 0.05; u < 1.0; u += 0.3)
                assert_int_equal(pp_angle_basis_find(
                                     &basis, pp_angle_basis_direction(&basis, k, u, u)),
                                 k);
        }
        assert_near(sum, PP_PI, 1e-12);
    }
}

/* Ring 1 begins with the patch centred on azimuth 0; patches are in counter-clockwise
 * order. */
static void a_ring_begins_with_a_patch_centred_on_azimuth_0(void **state)
{
    (void)state;
    struct pp_angle_basis basis;
    pp_angle_basis_named(&basis, FULL);
    assert_int_equal(pp_angle_basis_find(&basis, pp_test_towards(10, 22)), 1);
    assert_int_equal(pp_angle_basis_find(&basis, pp_test_towards(10, -22)), 1);
    assert_int_equal(pp_angle_basis_find(&basis, pp_test_towards(10, 23)), 2);
    assert_int_equal(pp_angle_basis_find(&basis, pp_test_towards(10, 270)), 7);
    assert_int_equal(pp_angle_basis_opposite(&basis, 3), 7);
    assert_int_equal(pp_angle_basis_opposite(&basis, 0), 0);
}

/* Cells of the grid have equal projected solid angles. */
static void the_grid_divides_the_hemisphere_evenly(void **state)
{
    (void)state;
    struct pp_angle_basis grid = pp_angle_basis_grid(8);
    double mean =
        0.0; /* of cos^2: 1/2 for directions uniform in projected solid angle */
    for (int k = 0; k < grid.count; k++)
        for (double u = 0.125; u < 1.0; u += 0.25)
            for (double v = 0.125; v < 1.0; v += 0.25) {
                struct pp_vec3 d = pp_angle_basis_direction(&grid, k, u, v);
                assert_int_equal(pp_angle_basis_find(&grid, d), k);
                mean += d.z * d.z / (grid.count * 16);
            }
    assert_near(mean, 0.5, 1e-3);
}

static void a_lambertian_pane_transmits_alike_from_all_directions(void **state)
{
    (void)state;
    struct made_bsdf file = made_bsdf_front(HALF, made_bsdf_lambertian);
    struct pp_bsdf bsdf = read_made(&file);
    for (double theta = 0.0; theta < 90.0; theta += 15.0)
        assert_near(direct(&bsdf, PP_BSDF_THROUGH_FRONT, pp_test_towards(theta, 200)),
                    0.4, 1e-8);
    assert_near(pp_bsdf_block_hemispherical(&bsdf.blocks[0]), 0.4, 1e-8);
    assert_int_equal(bsdf.warning_count, 0);
    assert_string_equal(bsdf.name, "made pane");
    pp_bsdf_clear(&bsdf);
}

/* The y axis of the device points up: azimuth 270 is light that travels down. */
static void a_prism_transmits_more_of_light_that_travels_down(void **state)
{
    (void)state;
    struct made_bsdf file = made_bsdf_front(QUARTER, made_bsdf_prism);
    struct pp_bsdf bsdf = read_made(&file);
    assert_near(direct(&bsdf, PP_BSDF_THROUGH_FRONT, pp_test_towards(40, 270)), 0.80,
                1e-8);
    assert_near(direct(&bsdf, PP_BSDF_THROUGH_FRONT, pp_test_towards(40, 90)), 0.50,
                1e-8);
    assert_near(direct(&bsdf, PP_BSDF_THROUGH_FRONT, pp_test_towards(0, 0)), 0.50,
                1e-8);
    /* By reciprocity in the opposite direction: light that travels down there has come
     * up here. */
    double T = 0.25 + 0.1; /* direct and scattered */
    assert_near(direct(&bsdf, PP_BSDF_THROUGH_BACK, pp_test_towards(40, 270)), T + 0.45,
                1e-8);
    assert_near(direct(&bsdf, PP_BSDF_THROUGH_BACK, pp_test_towards(40, 90)), T + 0.15,
                1e-8);
    pp_bsdf_clear(&bsdf);
}

/* The same data in rows: the leaving direction varies along each line. */
static void rows_are_columns_transposed(void **state)
{
    (void)state;
    struct made_bsdf columns = made_bsdf_front(QUARTER, made_bsdf_prism), rows;
    struct pp_bsdf a = read_made(&columns);
    const struct pp_angle_basis *basis = &a.blocks[0].in;
    made_bsdf_begin(&rows, "Rows");
    made_bsdf_block_begin(&rows, "Solar", "Transmission Front", "unknown");
    made_bsdf_block_end(&rows);
    made_bsdf_block_begin(&rows, "Visible", "Transmission Front", QUARTER);
    for (int in = 0; in < basis->count; in++)
        for (int out = 0; out < basis->count; out++)
            fprintf(rows.out, "%.9g ", made_bsdf_prism(basis, in, out));
    made_bsdf_block_end(&rows);
    made_bsdf_end(&rows);
    struct pp_bsdf b = read_made(&rows);
    assert_memory_equal(a.blocks[0].values, b.blocks[0].values,
                        41 * 41 * sizeof(double));
    pp_bsdf_clear(&a);
    pp_bsdf_clear(&b);
}

/* A tree of rank 4, and the values that Radiance reads from it, by direction of travel
 * and leaving direction (theta, phi each). */
static void a_tensor_tree_has_the_values_that_radiance_reads(void **state)
{
    (void)state;
    static const char TREE[] =
        "{ { 0.02 } { 0.03 } { 0.04 } { 0.05 } { 0.06 }\n"
        "{ { 0.2 } { 0.22 } { 0.24 } { 0.26 } { 0.28 } { 0.3 } { 0.32 } { 0.34 } { "
        "0.36 "
        "} { 0.38 } { 0.4 } { 0.42 } { 0.44 } { 0.46 } { 0.48 } { 0.5 } }\n"
        "{ 0.08 } { 0.09 } { 0.1 } { 0.11 }\n"
        "{ 0.3 0.29 0.28 0.27 0.26 0.25 0.24 0.23 0.22 0.21 0.2 0.19 0.18 0.17 0.16 "
        "0.15 "
        "} { 0.13 } { 0.14 } { 0.15 } { 0.16 } { 0.17 } }";
    static const double read[][5] = {
        {70, 190, 50, 20, 0.14},  {55, 145, 12, 110, 0.24}, {8, 235, 65, 155, 0.10},
        {55, 55, 30, 20, 0.17},   {25, 280, 50, 110, 0.11}, {55, 100, 12, 110, 0.16},
        {25, 145, 30, 155, 0.20}, {40, 325, 50, 200, 0.03}, {55, 280, 30, 65, 0.15},
        {55, 100, 65, 335, 0.08}};
    struct made_bsdf file;
    made_bsdf_begin(&file, "TensorTree4");
    made_bsdf_block_begin(&file, "Visible", "Transmission Front", "LBNL/Shirley-Chiu");
    fputs(TREE, file.out);
    made_bsdf_block_end(&file);
    made_bsdf_end(&file);
    struct pp_bsdf bsdf = read_made(&file);
    const struct pp_bsdf_block *block = &bsdf.blocks[PP_BSDF_THROUGH_FRONT];
    for (size_t i = 0; i < sizeof read / sizeof *read; i++) {
        int in =
            pp_angle_basis_find(&block->in, pp_test_towards(read[i][0], read[i][1]));
        int out =
            pp_angle_basis_find(&block->out, pp_test_towards(read[i][2], read[i][3]));
        assert_near(block->values[out * block->in.count + in], read[i][4], 1e-12);
    }
    pp_bsdf_clear(&bsdf);
}

/* A tree of rank 3 that is 0.1 for light that leaves on the side towards which it
 * travels, and 0 on the other side. */
static void an_isotropic_tree_turns_with_the_light(void **state)
{
    (void)state;
    struct made_bsdf file;
    made_bsdf_begin(&file, "TensorTree3");
    made_bsdf_block_begin(&file, "Visible", "Transmission Front", "LBNL/Shirley-Chiu");
    /* Bit 1 of a child's index selects the half in x of the leaving light. */
    fputs("{{0}{0}{{.1}{.1}{.1}{.1}{.1}{.1}{.1}{.1}}{.1}{0}{0}{.1}{.1}}", file.out);
    made_bsdf_block_end(&file);
    made_bsdf_end(&file);
    struct pp_bsdf bsdf = read_made(&file);
    const struct pp_bsdf_block *block = &bsdf.blocks[PP_BSDF_THROUGH_FRONT];
    for (double phi = 45.0; phi < 360.0; phi += 90.0) {
        int in = pp_angle_basis_find(&block->in, pp_test_towards(60, phi));
        int ahead = pp_angle_basis_find(&block->out, pp_test_towards(60, phi));
        int behind = pp_angle_basis_find(&block->out, pp_test_towards(60, phi + 180.0));
        assert_true(block->values[ahead * block->in.count + in] > 0.08);
        assert_true(block->values[behind * block->in.count + in] < 0.02);
    }
    pp_bsdf_clear(&bsdf);
}

static double too_bright(const struct pp_angle_basis *basis, int in, int out)
{
    (void)basis, (void)in, (void)out;
    return 1.2 / PP_PI;
}

static void doubtful_data_are_read_with_a_warning(void **state)
{
    (void)state;
    struct made_bsdf file = made_bsdf_front(QUARTER, too_bright);
    struct pp_bsdf bsdf = read_made(&file);
    assert_int_equal(bsdf.warning_count, 2);
    assert_non_null(strstr(bsdf.warnings[0], "1.2 times as much light"));
    pp_bsdf_clear(&bsdf);

    made_bsdf_begin(&file, "Columns");
    made_bsdf_block(&file, "Transmission Front", QUARTER, made_bsdf_prism);
    made_bsdf_block(&file, "Transmission Back", QUARTER, made_bsdf_lambertian);
    made_bsdf_end(&file);
    bsdf = read_made(&file);
    assert_int_equal(bsdf.warning_count, 1);
    assert_non_null(strstr(bsdf.warnings[0], "contradict"));
    pp_bsdf_clear(&bsdf);

    made_bsdf_begin(&file, "Columns");
    made_bsdf_block(&file, "Transmission Back", QUARTER, made_bsdf_prism);
    made_bsdf_end(&file);
    bsdf = read_made(&file);
    assert_int_equal(bsdf.warning_count, 1);
    assert_non_null(strstr(bsdf.warnings[0], "by reciprocity"));
    pp_bsdf_clear(&bsdf);
}

/* Each file is rejected with a message that contains the text. */
static void wrong_files_are_refused_with_a_line(void **state)
{
    (void)state;
    static const struct {
        const char *layout, *direction, *basis, *data, *message;
    } wrong[] = {
        {"Columns", "Transmission Front", QUARTER, "1 2 3",
         "made.xml:10: ScatteringData has 3 numbers; expected 1681"},
        {"Columns", "Transmission Front", QUARTER, "1 2 x", "before other text"},
        {"Columns", "Transmission Front", "LBNL/Klems Third", "1",
         "the ColumnAngleBasis is \"LBNL/Klems Third\""},
        {"Columns", "Absorption", QUARTER, "1", "no transmission for visible light"},
        {"TensorTree5", "Transmission Front", QUARTER, "1", "expected Columns, Rows"},
        {"TensorTree4", "Transmission Front", QUARTER, "{1 2}", "1, 16, 256"},
        {"TensorTree4", "Transmission Front", QUARTER, "{{1}{2}}", "opening brace"},
        {"TensorTree4", "Transmission Front", QUARTER, "{1} 2", "follows the tree"},
        {"TensorTree4", "Transmission Front", QUARTER, "{x}", "not a number"},
    };
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        struct made_bsdf file;
        struct pp_bsdf bsdf;
        struct pp_error err = {PP_OK, ""};
        made_bsdf_begin(&file, wrong[i].layout);
        made_bsdf_block_begin(&file, "Visible", wrong[i].direction, wrong[i].basis);
        fputs(wrong[i].data, file.out);
        made_bsdf_block_end(&file);
        made_bsdf_end(&file);
        assert_int_equal(
            pp_bsdf_file_parse(&bsdf, file.text, file.length, "made.xml", &err),
            PP_BAD_INPUT);
        if (!strstr(err.message, wrong[i].message))
            fail_msg("%s: expected %s", err.message, wrong[i].message);
        free(file.text);
    }
}

/* A rotation by half a turn of a ring with 3 patches would end between two of them. */
static void every_patch_of_a_ring_has_an_opposite_one(void **state)
{
    (void)state;
    struct pp_angle_basis basis = {.count = 0};
    assert_true(pp_angle_basis_add_ring(&basis, 0.0, 0.1, 1));
    assert_false(pp_angle_basis_add_ring(&basis, 0.1, 0.7, 3));
    assert_true(pp_angle_basis_add_ring(&basis, 0.1, 0.7, 6));
    for (int i = 1; i < 7; i++) {
        struct pp_vec3 d = pp_angle_basis_direction(&basis, i, 0.5, 0.5);
        assert_int_equal(pp_angle_basis_opposite(&basis, i),
                         pp_angle_basis_find(&basis, pp_vec(-d.x, -d.y, d.z)));
    }
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(patches_of_klems_fill_the_hemisphere),
        cmocka_unit_test(a_ring_begins_with_a_patch_centred_on_azimuth_0),
        cmocka_unit_test(every_patch_of_a_ring_has_an_opposite_one),
        cmocka_unit_test(the_grid_divides_the_hemisphere_evenly),
        cmocka_unit_test(a_lambertian_pane_transmits_alike_from_all_directions),
        cmocka_unit_test(a_prism_transmits_more_of_light_that_travels_down),
        cmocka_unit_test(rows_are_columns_transposed),
        cmocka_unit_test(a_tensor_tree_has_the_values_that_radiance_reads),
        cmocka_unit_test(an_isotropic_tree_turns_with_the_light),
        cmocka_unit_test(doubtful_data_are_read_with_a_warning),
        cmocka_unit_test(wrong_files_are_refused_with_a_line),
    };
    add_tests(tests, NULL, NULL);
}
