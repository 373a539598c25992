/* test_mesh_shapes.c - outlines of meshes in plans: roofs and their edges have the
 * correct position and area, for any triangles and orientation. */
#include "studies/site/mesh_shapes.h"

#include <stdio.h>
#include <stdlib.h>

#include "tests/lib/room_of.h"

/* Triangles as surfaces of a room file; every third has the opposite orientation. */
struct mesh_text {
    char text[1 << 18];
    int triangles;
};

static void begin(struct mesh_text *mesh)
{
    mesh->triangles = 0;
    strcpy(mesh->text, "<room version='1'><plan width='4' depth='5' height='3'/>");
}

static void add_triangle(struct mesh_text *mesh, struct pp_vec3 a, struct pp_vec3 b,
                         struct pp_vec3 c)
{
    bool turned = mesh->triangles++ % 3 == 0;
    const struct pp_vec3 p[3] = {a, turned ? c : b, turned ? b : c};
    char *end = mesh->text + strlen(mesh->text);
    assert_true(end < mesh->text + sizeof mesh->text - 256);
    end += sprintf(end, "<surface>");
    for (int k = 0; k < 3; k++)
        end += sprintf(end, "<vertex x='%.9g' y='%.9g' z='%.9g'/>", p[k].x, p[k].y,
                       p[k].z);
    strcpy(end, "</surface>");
}

/* A parallelogram from o, divided into cells of two triangles. */
static void add_sheet(struct mesh_text *mesh, struct pp_vec3 o, struct pp_vec3 u,
                      struct pp_vec3 v, int cells)
{
    for (int i = 0; i < cells * cells; i++) {
        struct pp_vec3 corners[4];
        for (int k = 0; k < 4; k++)
            corners[k] = pp_vec_along(
                pp_vec_along(o, (double)(i % cells + (k == 1 || k == 2)) / cells, u),
                (double)(i / cells + k / 2) / cells, v);
        add_triangle(mesh, corners[0], corners[1], corners[2]);
        add_triangle(mesh, corners[0], corners[2], corners[3]);
    }
}

static void make(struct pp_site_sheet *sheet, struct mesh_text *mesh)
{
    strcat(mesh->text, "</room>");
    struct pp_world *world = pp_test_world(mesh->text);
    const struct pp_world_mesh part = {.first_side = world->face_count,
                                       .side_count = mesh->triangles};
    assert_int_equal(world->surface_count, world->face_count + mesh->triangles);
    *sheet = (struct pp_site_sheet){0};
    assert_int_equal(pp_mesh_shapes_add(sheet, world, &part, NULL), PP_OK);
    pp_world_destroy(world);
}

/* Sums over all shapes: their area from above, with the sign of each outline, and the
 * length of the edges drawn as lines. */
static double area_of(const struct pp_site_sheet *sheet, double *lines)
{
    double area = 0.0;
    *lines = 0.0;
    for (int s = 0; s < sheet->shape_count; s++) {
        const struct pp_site_shape *shape = &sheet->shapes[s];
        for (int ring = 0, from = 0; ring < shape->ring_count; ring++) {
            for (int i = from; i < shape->ends[ring]; i++) {
                struct pp_vec3 a = shape->corners[i];
                struct pp_vec3 b =
                    shape->corners[i + 1 < shape->ends[ring] ? i + 1 : from];
                area += 0.5 * (a.x * b.y - b.x * a.y);
                if (!shape->unseen[i])
                    *lines += hypot(b.x - a.x, b.y - a.y);
            }
            from = shape->ends[ring];
        }
    }
    return area;
}

static struct mesh_text mesh;

/* A house of 9 x 7 m without a floor, each face with 2 x 36 triangles: one roof with
 * four corners, at 6.5 m. Walls have no lines, since they are below the edges of the
 * roof. */
static void a_box_of_triangles_is_a_roof_of_four_corners(void **state)
{
    (void)state;
    struct pp_site_sheet sheet;
    struct pp_vec3 o = pp_vec(3, -20, 0), u = pp_vec(9, 0, 0), v = pp_vec(0, 7, 0),
                   up = pp_vec(0, 0, 6.5);
    double lines;
    begin(&mesh);
    add_sheet(&mesh, pp_vec_add(o, up), u, v, 6);
    add_sheet(&mesh, o, u, up, 6);
    add_sheet(&mesh, o, v, up, 6);
    add_sheet(&mesh, pp_vec_add(o, u), v, up, 6);
    add_sheet(&mesh, pp_vec_add(o, v), u, up, 6);
    make(&sheet, &mesh);
    assert_int_equal(sheet.shape_count, 1);
    assert_int_equal(sheet.shapes[0].count, 4);
    assert_int_equal(sheet.shapes[0].ring_count, 1);
    assert_true(sheet.shapes[0].is_level);
    assert_near(sheet.shapes[0].top_m, 6.5, 1e-9);
    assert_near(area_of(&sheet, &lines), 63.0, 1e-6);
    assert_near(lines, 32.0, 1e-6);
    pp_site_sheet_clear(&sheet);
}

/* Two slopes of 30 degrees meet in a ridge, which belongs to both. Slopes of 9 degrees,
 * with a bend of 18, are one roof. */
static void a_ridge_is_drawn_where_the_roof_bends_enough(void **state)
{
    (void)state;
    static const double pitches[] = {30.0 * PP_RAD, 9.0 * PP_RAD};
    for (int i = 0; i < 2; i++) {
        struct pp_site_sheet sheet;
        double rise = 8.0 * tan(pitches[i]), lines;
        begin(&mesh);
        add_sheet(&mesh, pp_vec(0, -40, 3), pp_vec(12, 0, 0), pp_vec(0, 8, rise), 4);
        add_sheet(&mesh, pp_vec(0, -24, 3), pp_vec(12, 0, 0), pp_vec(0, -8, rise), 4);
        make(&sheet, &mesh);
        assert_int_equal(sheet.shape_count, i == 0 ? 2 : 1);
        assert_near(area_of(&sheet, &lines), 12.0 * 16.0, 1e-6);
        assert_near(lines, i == 0 ? 2 * (12.0 + 16.0) + 2 * 12.0 : 2 * (12.0 + 16.0),
                    1e-6);
        pp_site_sheet_clear(&sheet);
    }
}

/* A dune that rises by 7 m in 24 cells with small bends: parts with a rise of at most
 * two metres, with lines only along the outline. */
static void a_hill_has_an_outline_and_no_lines_in_it(void **state)
{
    (void)state;
    struct pp_site_sheet sheet;
    double lines;
    begin(&mesh);
    for (int i = 0; i < 24; i++) {
        double y[2] = {-60.0 + 2.0 * i, -58.0 + 2.0 * i}, z[2];
        for (int k = 0; k < 2; k++)
            z[k] = 3.5 * (1.0 - cos((y[k] + 60.0) / 48.0 * PP_PI));
        struct pp_vec3 o = pp_vec(-10, y[0], z[0]);
        add_sheet(&mesh, o, pp_vec(20, 0, 0), pp_vec(0, y[1] - y[0], z[1] - z[0]), 1);
    }
    make(&sheet, &mesh);
    assert_in_range(sheet.shape_count, 4, 8);
    for (int i = 0; i < sheet.shape_count; i++) {
        double low = INFINITY;
        for (int k = 0; k < sheet.shapes[i].count; k++)
            low = fmin(low, sheet.shapes[i].corners[k].z);
        assert_true(sheet.shapes[i].top_m - low <= 2.0 + 1e-9);
    }
    assert_near(area_of(&sheet, &lines), 20.0 * 48.0, 1e-6);
    assert_near(lines, 2 * (20.0 + 48.0), 1e-6);
    pp_site_sheet_clear(&sheet);
}

/* A roof around a court has two outlines; a vertical screen is a line from above. */
static void a_court_is_a_ring_and_a_screen_a_line(void **state)
{
    (void)state;
    static const double outer[4][2] = {{0, 0}, {20, 0}, {20, 20}, {0, 20}};
    static const double inner[4][2] = {{5, 5}, {15, 5}, {15, 15}, {5, 15}};
    struct pp_site_sheet sheet;
    double lines;
    begin(&mesh);
    for (int k = 0, n = 1; k < 4; k++, n = (n + 1) % 4) {
        struct pp_vec3 a = pp_vec(outer[k][0], outer[k][1] - 40, 9);
        struct pp_vec3 b = pp_vec(outer[n][0], outer[n][1] - 40, 9);
        struct pp_vec3 c = pp_vec(inner[n][0], inner[n][1] - 40, 9);
        struct pp_vec3 d = pp_vec(inner[k][0], inner[k][1] - 40, 9);
        add_triangle(&mesh, a, b, c);
        add_triangle(&mesh, a, c, d);
    }
    add_sheet(&mesh, pp_vec(-9, -30, 0), pp_vec(3, 4, 0), pp_vec(0, 0, 2), 1);
    make(&sheet, &mesh);
    assert_int_equal(sheet.shape_count, 2);
    int court = sheet.shapes[0].is_level ? 0 : 1;
    assert_int_equal(sheet.shapes[court].ring_count, 2);
    assert_int_equal(sheet.shapes[court].count, 8);
    assert_int_equal(sheet.shapes[1 - court].count, 2);
    assert_false(sheet.shapes[1 - court].is_level);
    assert_near(sheet.shapes[1 - court].top_m, 2.0, 1e-9);
    assert_near(area_of(&sheet, &lines), 400.0 - 100.0, 1e-6);
    assert_near(lines, 80.0 + 40.0 + 5.0, 1e-6);
    pp_site_sheet_clear(&sheet);
}

/* Where a surface folds over itself, the fold is a line between two parts. */
static void a_fold_over_itself_is_a_line(void **state)
{
    (void)state;
    struct pp_site_sheet sheet;
    double lines;
    begin(&mesh);
    add_sheet(&mesh, pp_vec(0, -40, 3), pp_vec(10, 0, 0), pp_vec(0, 8, 0.1), 2);
    add_sheet(&mesh, pp_vec(0, -32, 3.1), pp_vec(10, 0, 0), pp_vec(0, -6, 0.1), 2);
    make(&sheet, &mesh);
    assert_int_equal(sheet.shape_count, 2);
    assert_near(area_of(&sheet, &lines), 80.0 + 60.0, 1e-6);
    assert_near(lines, 36.0 + 32.0, 1e-6);
    pp_site_sheet_clear(&sheet);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_box_of_triangles_is_a_roof_of_four_corners),
        cmocka_unit_test(a_ridge_is_drawn_where_the_roof_bends_enough),
        cmocka_unit_test(a_hill_has_an_outline_and_no_lines_in_it),
        cmocka_unit_test(a_court_is_a_ring_and_a_screen_a_line),
        cmocka_unit_test(a_fold_over_itself_is_a_line),
    };
    add_tests(tests, NULL, NULL);
}
