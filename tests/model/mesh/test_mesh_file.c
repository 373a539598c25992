/* test_mesh_file.c - files of triangles, as written by other programs, and with
 * errors. */
#include "model/mesh/mesh_file.h"

#include <stdlib.h>
#include <stdio.h>
#include <string.h>

#include "tests/lib/near.h"

static enum pp_status parse(struct pp_mesh_triangles *mesh, const char *text,
                            const char *name, struct pp_error *err)
{
    char *bytes = strdup(text);
    *mesh = (struct pp_mesh_triangles){0};
    enum pp_status status = pp_mesh_file_parse(mesh, bytes, strlen(text), name, err);
    free(bytes);
    return status;
}

/* Area of the triangles (in the file's unit), and the height of the highest point. */
static double area_of(const struct pp_mesh_triangles *mesh, double *top)
{
    double area = 0.0;
    *top = -INFINITY;
    for (int i = 0; i < mesh->triangle_count; i++) {
        const int *of = mesh->triangles[i];
        struct pp_vec3 a = mesh->corners[of[0]], b = mesh->corners[of[1]],
                       c = mesh->corners[of[2]];
        area += pp_vec_length(pp_vec_cross(pp_vec_sub(b, a), pp_vec_sub(c, a))) / 2.0;
        *top = fmax(*top, fmax(a.z, fmax(b.z, c.z)));
    }
    return area;
}

static void assert_surface(const char *text, const char *name, double area, double top)
{
    struct pp_mesh_triangles mesh;
    struct pp_error err = {0};
    double highest;
    if (parse(&mesh, text, name, &err) != PP_OK)
        fail_msg("%s", err.message);
    assert_near(area_of(&mesh, &highest), area, 1e-12 * area);
    assert_near(highest, top, 1e-12);
    pp_mesh_triangles_clear(&mesh);
}

/* 2.3 by 1.7, at z = 3.1, as written by Blender and by SketchUp: with normals and
 * texture, CR LF, groups, and negative indices. A notch of 0.8 by 0.7 makes it an
 * L-shape. */
static void outlines_of_obj_keep_their_area(void **state)
{
    (void)state;
    assert_surface("# Blender 4.1.1 OBJ File: 'street.blend'\nmtllib street.mtl\n"
                   "o Roof\nv 0 0 3.1\nv 2.3 0 3.1\nv 2.3 1.7 3.1\nv 0 1.7 3.1\n"
                   "vn 0 0 1\nvt 0 0\ns 0\nusemtl None\nf 1/1/1 2/1/1 3/1/1 4/1/1\n",
                   "a.obj", 2.3 * 1.7, 3.1);
    assert_surface("# File units = meters\r\ng Mesh1 Group1 Model\r\nv 0 0 3.1\r\n"
                   "vt 0 0\r\nvn 0 0 1\r\nv 2.3 0 3.1\r\nv 2.3 1.7 3.1\r\n"
                   "v 0 1.7 3.1\r\nf -4//-1 -3//-1 -2//-1\r\nf -4 \\\r\n -2 -1\r\n",
                   "B.OBJ", 2.3 * 1.7, 3.1);
    assert_surface("v 0 0 3.1\nv 2.3 0 3.1\nv 2.3 1 3.1\nv 1.5 1 3.1\nv 1.5 1.7 3.1\n"
                   "v 0 1.7 3.1\nf 1 2 3 4 5 6\n",
                   "l.obj", 2.3 * 1.7 - 0.8 * 0.7, 3.1);
}

#define SECTION(name, tags) "  0\nSECTION\n  2\n" name "\n" tags "  0\nENDSEC\n"
#define DXF(tags) SECTION("ENTITIES", tags) "  0\nEOF\n"
#define RING "10\n0\n20\n0\n10\n2.3\n20\n0\n10\n2.3\n20\n1.7\n10\n0\n20\n1.7\n"
#define RAISED "0\nLWPOLYLINE\n8\nHouses\n90\n4\n70\n1\n38\n0.4\n39\n3.1\n" RING
#define CORNER(x, y, z) "0\nVERTEX\n10\n" #x "\n20\n" #y "\n30\n" #z "\n70\n192\n"

static const double raised_m2 = 2.0 * 2.3 * 1.7 + 2.0 * (2.3 + 1.7) * 3.1;

static void outlines_of_dxf_are_raised_by_their_thickness(void **state)
{
    (void)state;
    assert_surface(DXF(RAISED), "a.dxf", raised_m2, 3.5);
    /* A line on the ground hides nothing; an open line with a thickness (R12) is a
     * wall. */
    assert_surface(DXF("0\nLINE\n10\n0\n20\n0\n11\n9\n21\n9\n"
                       "0\nPOLYLINE\n66\n1\n39\n3.1\n70\n0\n0\nVERTEX\n10\n0\n20\n0\n"
                       "0\nVERTEX\n10\n2.3\n20\n0\n0\nSEQEND\n"),
                   "r12.dxf", 2.3 * 3.1, 3.1);
    /* There the entity's own z is the file's -y, and its y the file's z. */
    assert_surface(DXF(RAISED "210\n0\n220\n-1\n230\n0\n"), "side.dxf", raised_m2, 1.7);
}

static void faces_of_dxf_keep_their_area(void **state)
{
    (void)state;
    assert_surface(
        DXF("0\nPOLYLINE\n8\n0\n66\n1\n70\n64\n71\n4\n72\n1\n" CORNER(0, 0, 1)
                CORNER(2, 0, 1) CORNER(2, 3, 1) CORNER(
                    0, 3,
                    1) "0\nVERTEX\n70\n128\n71\n1\n72\n-2\n73\n3\n74\n4\n0\nSEQEND\n"
                       "0\n3DFACE\n10\n0\n20\n0\n30\n2\n11\n1\n21\n0\n31\n2\n"
                       "12\n0\n22\n1\n32\n2\n13\n0\n23\n1\n33\n2\n"),
        "faces.dxf", 2.0 * 3.0 + 0.5, 2.0);
}

/* A block with one house, twice as wide and deep, rotated: its floor and lid have four
 * times the area, its walls twice. */
static void a_block_of_dxf_is_scaled_and_turned(void **state)
{
    (void)state;
    static const char text[] = SECTION("HEADER", "9\n$INSUNITS\n70\n4\n") SECTION(
        "BLOCKS", "0\nBLOCK\n2\nHouse\n10\n1\n20\n1\n30\n0\n" RAISED "0\nENDBLK\n")
        DXF("0\nINSERT\n2\nHouse\n10\n50\n20\n60\n30\n7\n41\n2\n42\n2\n50\n33\n");
    assert_surface(text, "block.dxf", 8.0 * 2.3 * 1.7 + 4.0 * (2.3 + 1.7) * 3.1,
                   7.0 + 3.5);
    struct pp_mesh_triangles mesh;
    assert_int_equal(parse(&mesh, text, "block.dxf", NULL), PP_OK);
    assert_near(mesh.unit_m, 1e-3, 0.0); /* millimetres */
    pp_mesh_triangles_clear(&mesh);
}

/* The byte order mark of UTF-8 is not part of the first statement. */
static void a_byte_order_mark_is_passed_over(void **state)
{
    (void)state;
    static const char face[] = "v 0 0 1\nv 2 0 1\nv 0 3 1\nf 1 2 3\n";
    char marked[100];
    assert_surface(face, "a.obj", 3.0, 1.0);
    snprintf(marked, sizeof marked, "\xef\xbb\xbf%s", face);
    assert_surface(marked, "a.obj", 3.0, 1.0);
    snprintf(marked, sizeof marked, "\xef\xbb\xbf%sf 1 2 -1\n", face);
    assert_surface(marked, "a.obj", 6.0, 1.0);
}

#define POINT(x, y, z) "10\n" #x "\n20\n" #y "\n30\n" #z "\n"

/* A square and a triangle with a common edge, by indices. */
static void a_mesh_of_dxf_has_its_faces(void **state)
{
    (void)state;
    assert_surface(
        DXF("0\nMESH\n8\n0\n71\n2\n91\n0\n92\n5\n" POINT(0, 0, 1) POINT(2, 0, 1)
                POINT(2, 2, 1) POINT(0, 2, 1)
                    POINT(4, 0, 1) "93\n9\n90\n4\n90\n0\n90\n1\n90\n2\n90\n3\n90\n3\n"
                                   "90\n1\n90\n4\n90\n2\n94\n1\n90\n0\n90\n1\n95\n0\n"),
        "mesh.dxf", 4.0 + 2.0, 1.0);
}

/* The corners of a SOLID are in zigzag order. A box of 2 x 1 x 3 m has 2 (2 + 2 x 3 + 1
 * x 3) m2. A figure on the ground without thickness hides nothing. */
static void a_solid_of_dxf_is_raised(void **state)
{
    (void)state;
    assert_surface(DXF("0\nSOLID\n10\n0\n20\n0\n11\n2\n21\n0\n12\n0\n22\n1\n"
                       "13\n2\n23\n1\n39\n3\n"
                       "0\nSOLID\n10\n0\n20\n0\n11\n9\n21\n0\n12\n0\n22\n9\n"),
                   "solid.dxf", 2.0 * (2.0 + 6.0 + 3.0), 3.0);
}

/* Two columns and three rows of a triangle of 3 m2, rotated by a right angle: the
 * columns follow y. */
static void an_insert_repeats_its_block(void **state)
{
    (void)state;
    static const char text[] = SECTION(
        "BLOCKS", "0\nBLOCK\n2\nT\n0\n3DFACE\n10\n0\n20\n0\n30\n1\n11\n2\n21\n0\n"
                  "31\n1\n12\n0\n22\n3\n32\n1\n0\nENDBLK\n")
        DXF("0\nINSERT\n2\nT\n10\n0\n20\n0\n50\n90\n70\n2\n71\n3\n44\n10\n45\n20\n");
    struct pp_mesh_triangles mesh;
    assert_surface(text, "rows.dxf", 2.0 * 3.0 * 3.0, 1.0);
    assert_int_equal(parse(&mesh, text, "rows.dxf", NULL), PP_OK);
    double x = 0.0, y = 0.0;
    for (int i = 0; i < mesh.corner_count; i++) {
        x = fmin(x, mesh.corners[i].x);
        y = fmax(y, mesh.corners[i].y);
    }
    assert_near(x, -2.0 * 20.0 - 3.0, 1e-9);
    assert_near(y, 10.0 + 2.0, 1e-9);
    pp_mesh_triangles_clear(&mesh);
}

static void wrong_files_are_refused_by_line(void **state)
{
    (void)state;
    static const struct {
        const char *name, *text, *says;
    } wrong[] = {
        {"a.obj", "", "a.obj:0: the file has no faces"},
        {"a.obj", "v 0 0\n", "a.obj:1: v: has 2 numbers"},
        {"a.obj", "v 0 nan 0\n", "a.obj:1: v: \"nan\" is not a number"},
        {"a.obj", "v 0 0 0\nv 1 0 1e308\n", "a.obj:2: a coordinate exceeds"},
        {"a.obj", "v 0 0 0\nf 1 1 2\n", "a.obj:2: f: \"2\" is not a corner"},
        {"a.obj", "v 0 0 0\nf 1 1 -2\n", "a.obj:2: f: \"-2\" is not a corner"},
        {"a.obj", "v 0 0 0\nf 1 0 1\n", "a.obj:2: f: \"0\" is not a corner"},
        {"a.obj", "v 0 0 0\nf 1 1\n", "a.obj:2: f: has 2 corners"},
        {"a.obj", "v 0 0 0\nf 99999999999999999999 1 1\n", "is not a corner"},
        {"a.obj", "#\ncurv 0 1 1 2\n", "a.obj:2: curv: this keyword is not supported"},
        {"a.ply", "ply\n", "expected .obj or .dxf"},
        {"a.dxf", "", "a.dxf:0: the file is incomplete"},
        {"a.dxf", "AutoCAD Binary DXF\r\n\x1a", "a.dxf:1: this is a binary DXF file"},
        {"a.dxf", "PK\n", "a.dxf:1: \"PK\" is not a group code"},
        {"a.dxf", "0\nEOF\n", "no ENTITIES section"},
        {"a.dxf", DXF(""), "the file has no surface"},
        {"a.dxf", "0\nSECTION\n2\nENTITIES\n" RAISED, "the file is incomplete"},
        {"a.dxf", DXF("0\n3DSOLID\n70\n1\n"),
         "a.dxf:6: 3DSOLID: this entity is not supported"},
        {"a.dxf", DXF("0\nLINE\n39\n2\n"),
         "a.dxf:6: LINE: a thickness is not supported"},
        {"a.dxf", DXF("0\nINSERT\n2\nTree\n"), "no block \"Tree\""},
        {"a.dxf", DXF(RAISED "42\n0.5\n"), "LWPOLYLINE: there is an arc"},
        {"a.dxf", DXF("0\n3DFACE\n10\nnan\n"), "a.dxf:8: \"nan\" is not a number"},
        {"a.dxf", DXF("0\nPOLYLINE\n70\n16\n71\n1e9\n72\n2\n0\nSEQEND\n"),
         "a mesh of 0"},
        {"a.dxf", DXF("0\nPOLYLINE\n70\n64\n0\nVERTEX\n70\n128\n71\n1\n72\n2\n73\n3\n"),
         "refers to corner 1 of the mesh; expected one of the 0"},
        {"a.dxf",
         SECTION("BLOCKS", "0\nBLOCK\n2\nA\n0\nINSERT\n2\nA\n0\nENDBLK\n")
             DXF("0\nINSERT\n2\nA\n"),
         "blocks are nested too deeply or inserted too often, first in \"A\""},
        {"a.dxf",
         SECTION("BLOCKS", "0\nBLOCK\n2\nA\n70\n4\n1\nother.dwg\n0\nENDBLK\n")
             DXF("0\nINSERT\n2\nA\n"),
         "\"A\" is an external reference to the drawing \"other.dwg\""},
        {"a.dxf",
         SECTION("BLOCKS", "0\nBLOCK\n2\nA\n0\nENDBLK\n")
             DXF("0\nINSERT\n2\nA\n70\n1000000\n"),
         "blocks are nested too deeply or inserted too often, first in \"A\""},
        {"a.dxf", DXF("0\nMESH\n92\n2\n" POINT(0, 0, 1)), "has 1 corners; expected 2"},
        {"a.dxf",
         DXF("0\nMESH\n92\n1\n" POINT(0, 0, 1) "93\n4\n90\n3\n90\n0\n90\n0\n"
                                               "90\n7\n"),
         "a whole number from 0 to 0 in group 90"},
        {"a.dxf", DXF("0\nMESH\n92\n1\n" POINT(0, 0, 1) "93\n4\n90\n9\n"),
         "a whole number from 0 to 3 in group 90"},
    };
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        struct pp_mesh_triangles mesh;
        struct pp_error err = {0};
        assert_int_equal(parse(&mesh, wrong[i].text, wrong[i].name, &err),
                         PP_BAD_INPUT);
        if (!strstr(err.message, wrong[i].says))
            fail_msg("\"%s\", not \"%s\"", err.message, wrong[i].says);
        pp_mesh_triangles_clear(&mesh);
    }
}

/* A file truncated at any position is read or rejected, and never read beyond its
 * end. */
static void a_file_may_break_off_anywhere(void **state)
{
    (void)state;
    static const char obj[] =
        "v 0 0 0\r\nv 1 0 0\r\nv 0 1 \\\r\n 0\r\nf 1/1/1 2// \\\n-1";
    static const char dxf[] = DXF(RAISED "0\n3DFACE\n10\n0\n");
    for (int kind = 0; kind < 2; kind++)
        for (size_t k = 0; k < (kind ? sizeof dxf : sizeof obj); k++) {
            char *bytes = malloc(k + 1);
            struct pp_mesh_triangles mesh = {0};
            memcpy(bytes, kind ? dxf : obj, k);
            bytes[k] = '\0';
            enum pp_status status =
                pp_mesh_file_parse(&mesh, bytes, k, kind ? "a.dxf" : "a.obj", NULL);
            assert_true(status == PP_OK || status == PP_BAD_INPUT);
            pp_mesh_triangles_clear(&mesh);
            free(bytes);
        }
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(outlines_of_obj_keep_their_area),
        cmocka_unit_test(outlines_of_dxf_are_raised_by_their_thickness),
        cmocka_unit_test(faces_of_dxf_keep_their_area),
        cmocka_unit_test(a_block_of_dxf_is_scaled_and_turned),
        cmocka_unit_test(a_byte_order_mark_is_passed_over),
        cmocka_unit_test(a_mesh_of_dxf_has_its_faces),
        cmocka_unit_test(a_solid_of_dxf_is_raised),
        cmocka_unit_test(an_insert_repeats_its_block),
        cmocka_unit_test(wrong_files_are_refused_by_line),
        cmocka_unit_test(a_file_may_break_off_anywhere),
    };
    add_tests(tests, NULL, NULL);
}
