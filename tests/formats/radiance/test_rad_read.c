/* test_rad_read.c - Radiance scene files: their contents, and files that are
 * rejected. */
#include "tests/lib/near.h"

#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include "formats/radiance/read/rad_read.h"

static enum pp_status parse(struct pp_scene_description *scene,
                            struct pp_rad_summary *summary, const char *text,
                            size_t length, struct pp_error *err)
{
    /* A copy of exactly this length, so that a read beyond its end is detected. */
    char *copy = malloc(length ? length : 1);
    assert_non_null(copy);
    memcpy(copy, text, length);
    enum pp_status status =
        pp_rad_read_bytes(scene, summary, copy, length, "room.rad", err);
    free(copy);
    return status;
}

static struct pp_scene_description scene_of(const char *text)
{
    struct pp_scene_description scene;
    struct pp_rad_summary summary;
    struct pp_error err = {0};
    if (parse(&scene, &summary, text, strlen(text), &err) != PP_OK)
        fail_msg("%s", err.message);
    return scene;
}

#define SKY "void brightfunc skyfunc 2 skybr skybright.cal 0 3 2 5 1\n"
#define WHITE "void plastic white 0 0 5 .7 .7 .7 0 0\n"

static void assert_corner(const struct pp_scene_description *scene, int shape,
                          int corner, double x, double y, double z)
{
    assert_int_equal(scene->shapes[shape].kind, PP_SHAPE_POLYGON);
    struct pp_vec3 at = scene->vertices[scene->shapes[shape].is.polygon.first + corner];
    assert_near(at.x, x, 1e-12);
    assert_near(at.y, y, 1e-12);
    assert_near(at.z, z, 1e-12);
}

static void every_shape_is_what_it_says(void **state)
{
    (void)state;
    struct pp_scene_description scene = scene_of(
        "# a comment\n" WHITE "white polygon p 0 0 9  0 0 0  2 0 0  0 3 0 # and more\n"
        "white sphere s\n0\n0\n4 1 2 3 -.5\n"
        "white bubble b 0 0 4 1 2 3 .5\n"
        "white cone c 0 0 8 0 0 0 0 0 2 .5 0\n"
        "white tube t 0 0 7 0 0 0 0 0 2 .5\n"
        "white ring r 0 0 8 1 1 1 0 0 -5 .7 .2\n"
        "void light sun 0 0 3 1e6 1e6 9e5 sun source s 0 0 4 0 -1 2 .5\n");
    assert_int_equal(scene.shape_count, 7);
    assert_corner(&scene, 0, 1, 2.0, 0.0, 0.0);
    assert_int_equal(scene.shapes[1].kind, PP_SHAPE_SPHERE);
    assert_true(scene.shapes[1].inward); /* of a negative radius, as in Radiance */
    assert_near(scene.shapes[1].is.sphere.radius_m, 0.5, 0.0);
    assert_true(scene.shapes[2].inward);
    assert_near(scene.shapes[3].is.cone.radii_m[1], 0.0, 0.0);
    assert_true(scene.shapes[4].inward);
    assert_near(scene.shapes[4].is.cone.radii_m[1], 0.5, 0.0);
    assert_near(scene.shapes[5].is.ring.radii_m[0], 0.2, 0.0);
    assert_near(scene.shapes[5].is.ring.axis.z, -1.0, 0.0);
    assert_near(scene.shapes[6].is.distant.half_angle_rad, 0.25 * PP_RAD, 1e-15);
    assert_near(scene.shapes[6].is.distant.direction.z, 2.0 / sqrt(5.0), 1e-15);
    const struct pp_material *sun = &scene.materials[scene.shapes[6].material];
    assert_int_equal(sun->emits, PP_EMITS_CONCENTRATED);
    assert_near(sun->radiance.b, 9e5, 0.0);
    pp_scene_description_clear(&scene);
}

static void every_material_is_what_it_says(void **state)
{
    (void)state;
    struct pp_scene_description scene = scene_of(
        "void plastic a 0 0 5 .5 .4 .3 .1 .05\nvoid metal b 0 0 5 .5 .4 .3 .8 .1\n"
        "void trans c 0 0 7 .8 .8 .8 .1 .02 .5 .25\nvoid plastic d 0 0 5 .9 .8 .7 0 0\n"
        "void metal2 e 4 0 1 0 . 0 6 .5 .5 .5 .9 .1 .3\nvoid glass f 0 0 3 .96 .96 .9\n"
        "void glow g 0 0 4 1 2 3 0\nvoid alias i a\ninherit alias j b\n");
    /* The diffuse part of plastic is what its gloss leaves, times its colour [WS98]. */
    assert_near(scene.materials[0].diffuse.r, 0.5 * 0.9, 1e-15);
    assert_near(scene.materials[0].gloss.g, 0.1, 1e-15);
    assert_near(scene.materials[1].gloss.b, 0.3 * 0.8, 1e-15);
    /* Trans: transmits 0.8 . 0.9 . 0.5, a quarter of it directly. */
    assert_near(scene.materials[2].through_diffuse.r, 0.8 * 0.9 * 0.5 * 0.75, 1e-15);
    assert_near(scene.materials[2].through_gloss.r, 0.8 * 0.9 * 0.5 * 0.25, 1e-15);
    assert_near(scene.materials[3].diffuse.b, 0.7, 0.0);
    assert_near(scene.materials[4].grain.y, 1.0, 0.0);
    assert_near(scene.materials[4].roughness[1], 0.3, 0.0);
    /* A transmissivity of 0.96 is the standard pane: 0.88 transmitted. */
    assert_near(scene.materials[5].glass[0].normal, 0.88, 2e-3);
    const struct pp_material *glow = &scene.materials[6];
    assert_string_equal(glow->name, "g");
    assert_int_equal(glow->emits, PP_EMITS_EXTENDED);
    assert_near(glow->radiance.b, 3.0, 0.0);
    assert_string_equal(scene.materials[0].name, "a");
    /* Other names for the same material are not separate materials. */
    assert_int_equal(scene.material_count, 7);
    pp_scene_description_clear(&scene);
}

#define TRIANGLE " polygon p 0 0 9 0 0 0 1 0 0 0 1 0\n"

/* An illum emits light, but appears as the material that it names; a mirror is black
 * behind; a glow with a negative radius emits no light here. */
static void lamps_and_mirrors_have_two_faces(void **state)
{
    (void)state;
    struct pp_scene_description scene = scene_of(
        "void glass pane 0 0 3 .9 .8 .7\nvoid illum a 0 0 3 5 6 7\n"
        "void illum b 1 void 0 3 5 6 7\nvoid illum c 1 pane 0 3 5 6 7\n"
        "void mirror d 0 0 3 .9 .8 .7\nvoid glow e 0 0 4 1 2 3 -1\n"
        "void glow f 0 0 4 1 2 3 2.5\n"
        "a" TRIANGLE "b" TRIANGLE "c" TRIANGLE "d" TRIANGLE "e" TRIANGLE "f" TRIANGLE);
    for (int i = 0; i < 3; i++) {
        const struct pp_material *illum = &scene.materials[scene.shapes[i].material];
        assert_int_equal(illum->emits, PP_EMITS_CONCENTRATED);
        assert_true(illum->unseen);
        assert_near(illum->radiance.g, 6.0, 0.0);
        assert_int_equal(illum->kind, i < 2 ? PP_MATERIAL_AIR : PP_MATERIAL_GLASS);
        assert_int_equal(scene.shapes[i].back_material, -1);
    }
    const struct pp_material *back = &scene.materials[scene.shapes[3].back_material];
    assert_near(scene.materials[scene.shapes[3].material].gloss.g, 0.8, 0.0);
    assert_true(pp_rgb_is_black(back->gloss) && pp_rgb_is_black(back->diffuse));
    assert_near(scene.materials[scene.shapes[4].material].radiance.g, 0.0, 0.0);
    assert_near(scene.materials[scene.shapes[5].material].radiance.g, 2.0, 0.0);
    pp_scene_description_clear(&scene);
}

/* Number of corners of shapes `first` to `end` - 1. */
static int corners_at(const struct pp_scene_description *scene, int first, int end,
                      double x, double y, double z)
{
    int count = 0;
    for (int i = first; i < end; i++)
        for (int k = 0; k < scene->shapes[i].is.polygon.count; k++) {
            const struct pp_vec3 *v =
                &scene->vertices[scene->shapes[i].is.polygon.first + k];
            count += pp_vec_length(pp_vec_sub(*v, pp_vec(x, y, z))) < 1e-9;
        }
    return count;
}

/* Volume by the divergence theorem: positive if the fronts face outwards. */
static double volume_of(const struct pp_scene_description *scene)
{
    double volume = 0.0;
    for (int i = 0; i < scene->shape_count; i++) {
        const struct pp_shape *shape = &scene->shapes[i];
        const struct pp_vec3 *v = scene->vertices + shape->is.polygon.first;
        for (int k = 2; k < shape->is.polygon.count; k++)
            volume += pp_vec_dot(v[0], pp_vec_cross(v[k - 1], v[k])) / 6.0;
    }
    return volume;
}

/* A box rotated, moved, copied and scaled; fronts of a mirrored box face outwards. */
static void transforms_move_from_left_to_right_and_arrays_copy(void **state)
{
    (void)state;
    struct pp_scene_description scene =
        scene_of(WHITE "!genbox white box 1 2 3 | xform -rz 90 -t 5 0 0 -a 2 -t 0 0 10 "
                       "-a 3 -i 1 -s 2\n");
    assert_int_equal(scene.shape_count, 6 * 2 * 3);
    /* Corner 1, 0, 0 of the box: rotated to 0, 1, 0, moved to 5, 1, 0, scaled. */
    assert_int_equal(corners_at(&scene, 0, 6, 10.0, 2.0, 0.0), 3);
    assert_int_equal(corners_at(&scene, 18, 24, 10.0, 2.0, 20.0), 3);
    pp_scene_description_clear(&scene);

    static const char *const lines[] = {
        "!genbox white b 1 2 3\n", "!genbox white b 1 2 3 | xform -mx\n",
        "!genbox white b 1 2 3 -i | xform -I -mz -my\n"};
    for (int i = 0; i < 3; i++) {
        char text[200];
        snprintf(text, sizeof text, "%s%s", WHITE, lines[i]);
        scene = scene_of(text);
        assert_near(volume_of(&scene), 6.0, 1e-12);
        pp_scene_description_clear(&scene);
    }
}

/* A million steps take little more work than one: after so many rotations by a degree
 * and moves by a millimetre, a corner is at the sum of a geometric series. */
static void an_array_of_many_steps_ends_where_it_should(void **state)
{
    (void)state;
    struct pp_scene_description scene =
        scene_of(WHITE "!genbox white b 1 2 3 | xform -i 1000000 -rz 1 -t .001 0 0\n");
    /* 1000000 degrees are 280 */
    double step = PP_RAD, all = 280.0 * PP_RAD;
    double half = 0.001 * sin(all / 2.0) / sin(step / 2.0);
    double turn = (all - step) / 2.0;
    /* 1e-16 of an angle, a million times */
    double x = half * cos(turn), y = half * sin(turn);
    assert_int_equal(corners_at(&scene, 0, 6, x, y, 0.0), 3);
    pp_scene_description_clear(&scene);
}

/* Slabs on the sides of an inner box, and pieces at its edges and corners: bevelled,
 * half squares and sixths of cubes; in segments, polygons approximating quarters;
 * round, as by genbox, whole cylinders and spheres. */
static void boxes_may_have_bevelled_and_round_edges(void **state)
{
    (void)state;
    double b = 0.1, x = 0.8, y = 1.8, z = 2.8;
    double body = x * y * z + 2.0 * b * (x * y + y * z + z * x);
    double bevelled = body + 2.0 * b * b * (x + y + z) + 8.0 / 6.0 * b * b * b;
    struct pp_scene_description scene = scene_of(WHITE "!genbox white b 1 2 3 -b .1\n");
    assert_int_equal(scene.shape_count, 6 + 12 + 8);
    assert_near(volume_of(&scene), bevelled, 1e-12);
    pp_scene_description_clear(&scene);
    scene = scene_of(WHITE "!genbox white b 1 2 3 -r .1 -n 30 -i\n");
    assert_int_equal(scene.shape_count, 6 + 12 * 32 + 8 * 32 * 32);
    double quarter = 32.0 / 2.0 * sin(PP_PI / 64.0) * b * b;
    /* The facets of the corners omit less than 1 % of a sphere. */
    double round = body + 4.0 * quarter * (x + y + z) + 4.0 / 3.0 * PP_PI * b * b * b;
    assert_near(volume_of(&scene), -round, 1e-2 * 4.0 / 3.0 * PP_PI * b * b * b);
    pp_scene_description_clear(&scene);
    scene = scene_of(WHITE "!genbox white b 1 2 3 -r .1 | xform -s 2\n");
    assert_int_equal(scene.shape_count, 6 + 12 + 8);
    int rods = 0, balls = 0;
    for (int i = 0; i < scene.shape_count; i++) {
        const struct pp_shape *shape = &scene.shapes[i];
        rods += shape->kind == PP_SHAPE_CONE && shape->is.cone.radii_m[1] == 0.2;
        balls += shape->kind == PP_SHAPE_SPHERE && shape->is.sphere.radius_m == 0.2;
    }
    assert_int_equal(rods, 12);
    assert_int_equal(balls, 8);
    pp_scene_description_clear(&scene);
}

/* A file within a file, moved and with another material. */
static void a_file_includes_a_file(void **state)
{
    (void)state;
    char inner[] = "/tmp/pp-inner-XXXXXX", text[300];
    int file = mkstemp(inner);
    assert_true(file >= 0);
    static const char contents[] = "white polygon p 0 0 9 0 0 0 1 0 0 0 1 0\n";
    assert_int_equal(write(file, contents, sizeof contents - 1), sizeof contents - 1);
    snprintf(text, sizeof text,
             WHITE
             "void plastic red 0 0 5 .5 0 0 0 0\n!xform -t 1 0 0 \\\n -m red '%s'\n"
             "white polygon q 0 0 9 0 0 0 1 0 0 0 1 0\n",
             inner);
    struct pp_scene_description scene = scene_of(text);
    assert_int_equal(scene.shape_count, 2);
    assert_corner(&scene, 0, 0, 1.0, 0.0, 0.0);
    assert_string_equal(scene.materials[scene.shapes[0].material].name, "red");
    assert_string_equal(scene.materials[scene.shapes[1].material].name, "white");
    pp_scene_description_clear(&scene);

    /* A file that includes itself is rejected. */
    assert_int_equal(lseek(file, 0, SEEK_SET), 0);
    int length = snprintf(text, sizeof text, "!xform %s\n", inner);
    assert_int_equal(write(file, text, (size_t)length), length);
    struct pp_rad_summary summary;
    struct pp_error err;
    assert_int_equal(parse(&scene, &summary, text, (size_t)length, &err), PP_BAD_INPUT);
    if (!strstr(err.message, "a file may include itself"))
        fail_msg("%s", err.message);
    close(file);
    unlink(inner);
}

/* A line requests a million copies of a comment of 1 MiB. */
static void files_that_copies_read_without_end_are_refused(void **state)
{
    (void)state;
    enum { COMMENT = 1 << 20 };
    char name[] = "/tmp/pp-large-XXXXXX", text[300];
    int file = mkstemp(name);
    assert_true(file >= 0);
    char *comment = malloc(COMMENT);
    assert_non_null(comment);
    memset(comment, '#', COMMENT);
    assert_int_equal(write(file, comment, COMMENT), COMMENT);
    free(comment);
    snprintf(text, sizeof text, WHITE "!xform -a 1000000 -t 1 0 0 %s\n", name);
    struct pp_scene_description scene;
    struct pp_rad_summary summary;
    struct pp_error err;
    assert_int_equal(parse(&scene, &summary, text, strlen(text), &err), PP_BAD_INPUT);
    assert_non_null(strstr(
        err.message, ":2: this xform and those before it read more than 256 MiB"));
    close(file);
    unlink(name);
}

/* A Perez sky written into a scene, rotated by 90 degrees. */
static void a_written_perez_sky_turns_with_its_scene(void **state)
{
    (void)state;
    struct pp_scene_description scene =
        scene_of("void brightfunc skyfunc 4 skybright perezlum.cal -rz 90\n0\n10 12 10 "
                 "-1.04 -0.6 "
                 "14.2 -3.7 0.09 0 -0.5 0.8660254\nskyfunc glow sky 0 0 4 1 1 1 0\n"
                 "sky source dome 0 0 4 0 0 1 180\n");
    const struct pp_pattern *sky = &scene.patterns[0];
    assert_int_equal(sky->type, PP_GENSKY_PEREZ);
    assert_near(sky->perez[3], -3.7, 0.0);
    assert_near(sky->sun.x, 0.5, 1e-7);
    assert_near(sky->sun.y, 0.0, 1e-7);
    pp_scene_description_clear(&scene);
}

/* Skies as printed by Radiance's gensky. */
static void skies_are_those_of_gensky(void **state)
{
    (void)state;
    static const struct {
        const char *options;
        int type;
        double zenith, ground, norm, sun[3], solar;
    } skies[] = {
        {"6 21 12 +s -a 51 -o 0 -m 0",
         1,
         16.61,
         27.08,
         0.9938,
         {0.005614, -0.462495, 0.886604},
         7.076e6},
        {"3 21 9:30 -i -a 40 -o 75 -m 75",
         4,
         16.48,
         6.407,
         1.002,
         {0.634048, -0.502440, 0.587824},
         0.0},
        {"12 1 15.25EST +s -y 2020 -a 40 -o 75",
         1,
         3.464,
         3.952,
         0.2998,
         {-0.724990, -0.658269, 0.202663},
         3.041e6},
        {"-ang 30 40 +i -t 3",
         4,
         15.13,
         5.733,
         1.039,
         {-0.556670, -0.663414, 0.5},
         9.227e5},
        {"-ang 89 0 +s", 1, 148.6, 37.99, 2.714, {0.0, -0.052336, 0.998630}, 7.210e6},
        {"10 3 8 -c", 2, 15.36, 2.389, 1.0, {0.0, 0.0, 1.0}, 0.0},
        {"-ang 20 0 -u -B 55.866", 3, 17.78, 3.557, 1.0, {0.0, 0.0, 1.0}, 0.0},
        {"7 4 +14:00 +s -g .3 -R 100",
         1,
         15.36,
         14.22,
         0.9214,
         {-0.460631, -0.181908, 0.868751},
         1.925e6},
        {"-ang -5 10 +s",
         1,
         1.199,
         0.5044,
         0.2692,
         {-0.172987, -0.981060, -0.087156},
         0.0},
    };
    for (size_t i = 0; i < sizeof skies / sizeof *skies; i++) {
        char text[200];
        snprintf(text, sizeof text,
                 "!gensky %s\nskyfunc glow sky 0 0 4 1 1 1 0\n"
                 "sky source dome 0 0 4 0 0 1 180\n",
                 skies[i].options);
        struct pp_scene_description scene = scene_of(text);
        assert_int_equal(scene.pattern_count, 1);
        const struct pp_pattern *sky = &scene.patterns[0];
        assert_int_equal(sky->type, skies[i].type);
        assert_relative(sky->zenith, skies[i].zenith, 1e-12);
        assert_relative(sky->ground, skies[i].ground, 1e-12);
        assert_relative(sky->norm, skies[i].norm, 1e-12);
        assert_near(sky->sun.x, skies[i].sun[0], 1e-6);
        assert_near(sky->sun.y, skies[i].sun[1], 1e-6);
        assert_near(sky->sun.z, skies[i].sun[2], 1e-6);
        bool sun = skies[i].solar > 0.0;
        assert_int_equal(scene.shape_count, sun ? 2 : 1);
        if (sun)
            assert_relative(scene.materials[0].radiance.g, skies[i].solar, 1e-12);
        assert_int_equal(scene.materials[sun].pattern, 0);
        pp_scene_description_clear(&scene);
    }
}

/* The clock of a zone is a number of hours ahead of Greenwich: 9:20 is the same moment
 * as with its meridian, 15 degrees east of Greenwich per hour ahead. */
static void a_zone_is_its_meridian(void **state)
{
    (void)state;
    static const struct {
        const char *name;
        double ahead_h;
    } zones[] = {{"YST", -9.0}, {"YDT", -8.0}, {"PST", -8.0}, {"PDT", -7.0},
                 {"MST", -7.0}, {"MDT", -6.0}, {"CST", -6.0}, {"CDT", -5.0},
                 {"EST", -5.0}, {"EDT", -4.0}, {"AST", -4.0}, {"ADT", -3.0},
                 {"NST", -3.5}, {"NDT", -2.5}, {"GMT", 0.0},  {"BST", 1.0},
                 {"CET", 1.0},  {"CEST", 2.0}, {"EET", 2.0},  {"EEST", 3.0}};
    for (size_t i = 0; i < sizeof zones / sizeof *zones; i++) {
        struct pp_vec3 sun[2];
        for (int by_name = 0; by_name < 2; by_name++) {
            char text[240];
            double west_deg = -15.0 * zones[i].ahead_h;
            snprintf(
                text, sizeof text,
                "!gensky 5 17 9:20%s +s -a 47 -o %g -m %g\nskyfunc glow sky 0 0 4 1 "
                "1 1 0\nsky source dome 0 0 4 0 0 1 180\n",
                by_name ? zones[i].name : "", west_deg + 3.7, west_deg);
            struct pp_scene_description scene = scene_of(text);
            sun[by_name] = scene.patterns[0].sun;
            pp_scene_description_clear(&scene);
        }
        assert_near(pp_vec_length(pp_vec_sub(sun[0], sun[1])), 0.0, 1e-12);
        assert_true(sun[0].z > 0.5 && sun[0].x > 0.5); /* in the morning */
    }
}

static void shapes_without_area_or_material_are_omitted(void **state)
{
    (void)state;
    static const char text[] = WHITE "white polygon p 0 0 9 0 0 0 1 0 0 2 0 0\n"
                                     "void polygon q 0 0 9 0 0 0 1 0 0 0 1 0\n"
                                     "void sphere s 0 0 4 0 0 0 1\n";
    struct pp_scene_description scene;
    struct pp_rad_summary summary;
    assert_int_equal(parse(&scene, &summary, text, sizeof text - 1, NULL), PP_OK);
    assert_int_equal(scene.shape_count, 0);
    assert_int_equal(summary.flat, 1);
    assert_int_equal(summary.unseen, 2);
    pp_scene_description_clear(&scene);
}

static void unsupported_input_is_rejected_with_its_line(void **state)
{
    (void)state;
    static const struct {
        const char *text, *says;
    } files[] = {
        {"\n\nred polygon p 0 0 9 0 0 0 1 0 0 0 1 0\n",
         "room.rad:3: there is no material or pattern \"red\""},
        {WHITE "white polygon p 0 0 8 0 0 0 1 0 0 0 1\n", "2: a polygon has 8 numbers"},
        {WHITE "white polygon p 0 0 9 0 0 0 1 0 0\n0 1\n",
         "the file ends inside a primitive"},
        {WHITE "white polygon p 0 0 9 0 0 0 1 0 0\n0 1 x\n",
         "3: found \"x\"; expected a number"},
        {WHITE "white polygon p 0 0 9 0 0 0 1 0 0 0 nan 0\n",
         "found \"nan\"; expected a number"},
        {WHITE "white polygon p 0 0 9 0 0 0 1 0 0 0 1e999 0\n", "expected a number"},
        {WHITE "white polygon p 0 0 9 0 0 0 1 0 0 0 1e300 0\n",
         "2: the number is 1e300; expected -1e30 to 1e30"},
        {WHITE "white polygon p 0 0 12 0 0 0 1 0 0 1 1 5 0 1 0\n", "not planar"},
        {WHITE "white polygon p 0 0 12 0 0 0 1 1 0 1 0 0 0 1 0\n",
         "2: a polygon crosses itself"},
        {WHITE "white polygon p 0 0 300003\n", "at most 300000"},
        {WHITE "white polygon p 0 0 -9\n", "expected the number of numbers"},
        {WHITE "white polygon p 9999999999 0 0\n", "expected the number of strings"},
        {WHITE "white polygon", "ends inside a primitive"},
        {WHITE "white sphere s 0 0 3 0 0 0\n", "2: a sphere has 3 numbers"},
        {WHITE "white sphere s 0 0 4 0 0 0 0\n",
         "2: a sphere has the invalid radius 0"},
        {WHITE "white instance i 1 a.oct 0 0\n", "the type \"instance\""},
        {"void texfunc t 2 a b 0 0\n", "1: the type \"texfunc\""},
        {"void brightfunc b 2 f my.cal 0 0\n", "the brightfunc is not supported"},
        {"void brightfunc b 2 skybr skybright.cal 0 3 7 1 1\n",
         "the sky has 3 numbers"},
        {"void brightfunc b 4 skybr skybright.cal -rx 30 0 3 2 1 1\n",
         "the sky is tilted"},
        {"void plastic p 0 0 5 1 1 1 .5 0\nvoid plastic q 0 0 5 1.2 1 1 0 0\n",
         "2: material \"q\""},
        {"void plastic p 0 0 4 1 1 1 0\n", "1: plastic has 4 numbers"},
        {"void glass g 0 0 3 1.1 1 1\n", "transmissivities from 0 to 1"},
        {"void light l 0 0 3 -1 0 0\n", "light has the value -1"},
        {"void metal2 m 4 x y z f.cal 0 6 .5 .5 .5 1 .1 .1\n",
         "the direction is a function"},
        {WHITE "white plastic p 0 0 5 1 1 1 0 0\n",
         "a material modifies another material"},
        {"void alias a b\n", "there is no material or pattern \"b\""},
        {WHITE SKY "skyfunc light l 0 0 3 1 1 1\n"
                   "l polygon p 0 0 9 0 0 0 1 0 0 0 1 0\n",
         "4: the material \"l\" of a shape has the pattern of a sky"},
        {WHITE SKY "skyfunc glow l 0 0 4 1 1 1 0\nl sphere s 0 0 4 0 0 0 1\n",
         "4: the material \"l\" of a shape has the pattern"},
        {WHITE SKY "skyfunc glow l 0 0 4 1 1 1 0\n"
                   "void mixfunc m 4 l white if(Rdot,1,0) . 0 0\n"
                   "m ring r 0 0 8 0 0 0 0 0 1 0 1\n",
         "5: the material \"l\" of a shape has the pattern"},
        {WHITE SKY "void light l 0 0 3 1 1 1\nskyfunc alias k l\n"
                   "!genbox k b 1 1 1\n",
         "5: the material \"l\" of a shape has the pattern"},
        {WHITE SKY "void light l 0 0 3 1 1 1\n!genbox l c 1 1 1 | xform -m l\n"
                   "!genbox l b 1 1 1 | xform -m skyfunc\n",
         "5: the modifier of a shape is a pattern"},
        {WHITE SKY "skyfunc alias grey white\n",
         "3: an alias applies the brightfunc of a sky to a material without emission"},
        {WHITE SKY "skyfunc alias sky skyfunc\n",
         "3: an alias applies the brightfunc of a sky to a material without emission"},
        {WHITE SKY "skyfunc plastic p 0 0 5 1 1 1 0 0\n",
         "3: the brightfunc of a sky modifies"},
        {"!rm -rf /\n", "1: external programs are not run"},
        {"!genbox white b 1 1 1; rm x\n", "1: expected words"},
        {"!gensky 1 1 1 > sky.rad\n", "1: expected words"},
        {"!cat `ls`\n", "1: expected words"},
        {"!\n", "expected a command"},
        {"!genbox a b 1 1 1 |\n", "expected a command"},
        {"!xform -t 1 2\n", "expected valid numbers after xform's -t"},
        {"!xform -t 1 2 3\n", "nothing to transform"},
        {"!xform -q x.rad\n", "xform has no option -q"},
        {"!xform -a 2000000 x.rad\n", "after xform's -a"},
        {"!xform /no/such/file.rad\n", "1: /no/such/file.rad: cannot be opened"},
        {WHITE "!genbox white b 1 1 -1\n",
         "2: expected sizes of the genbox above 0, up to 1e9, not -1"},
        {WHITE "!genbox white b 1 1 1 -s\n", "of genbox, not -s"},
        {WHITE "!genbox white b 1 1 1 -r\n", "a size after genbox's -r"},
        {WHITE "!genbox white b 1 1 1 -b .6\n", "edges of the genbox overlap"},
        {WHITE "!genbox white b 1 1 1 -r .1 -n 1.5\n", "after genbox's -n"},
        {WHITE "!genbox white b 1 1 1 | xform -a 1001 | xform -a 999000\n",
         "make more than 1000000 copies"},
        {WHITE "!genbox white b 1 1 1 | xform -i 2|xform -i 2|xform -i 2|xform -i 2|"
               "xform -i 2|xform -i 2|xform -a 150000\n",
         "make more than 1000000 copies"},
        {WHITE "!genbox white b 1 1 1 | xform -a 999999 -t 2 0 0\n",
         "2: there are 999999 copies of 6 shapes; expected at most 1000000 shapes"},
        {WHITE
         "!genbox white b 1 1 1 | xform -a 1000 -t 2 0 0 | xform -a 999 -t 0 2 0\n",
         "2: there are 999 copies of 6000 shapes"},
        {WHITE "!genbox white b 1 1 1 | xform -a 160000 -t 2 0 0\n"
               "!genbox white b 1 1 1 | xform -a 160000 -t 2 0 0\n",
         "3: the copies made by all xforms have more than 1000000 shapes"},
        {"!a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|"
         "a|"
         "a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|"
         "a|a|"
         "a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|a|"
         "a|a\n",
         "more than 100 commands"},
        {"!xform 'x.rad\n", "a quotation mark is not closed: x.rad"},
        {"!xform 'x'.rad\n", "separated by blanks, or in quotation marks, not .rad"},
        {"void illum i 1 glass 0 3 1 1 1\n", "there is no material \"glass\""},
        {"void light l 0 0 3 1 1 1\nvoid illum i 1 l 0 3 1 1 1\n", "emits no light"},
        {WHITE "void mirror m 1 white 0 3 1 1 1\n",
         "a mirror with the alternate material \"white\" is not supported"},
        {WHITE
         "void light l 0 0 3 1 1 1\nvoid mixfunc m 4 l white if(Rdot,1,0) . 0 0\n",
         "3: Radiance does not treat \"l\" as a light source"},
        {WHITE "void glow l 0 0 4 1 1 1 0\nvoid mixfunc m 4 white l if(Rdot,1,0) . 0 "
               "0\n",
         "3: Radiance does not treat \"l\" as a light source"},
        {WHITE "!gensky -c | genbox white b 1 1 1\n", "only xform after a pipe"},
        {"!gensky 13 1 12\n", "expected gensky with month"},
        {"!gensky 1 1 12XYZ\n", "expected gensky with month"},
        {"!gensky 1 1 12 -z 3\n", "no option -z"},
        {"!gensky 1 1 12 -B\n", "after gensky's option -B"},
        {"!gensky 1 1 12 | xform -rx 10\n", "the sky is tilted"},
    };
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        struct pp_scene_description scene;
        struct pp_rad_summary summary;
        struct pp_error err = {0};
        assert_int_equal(
            parse(&scene, &summary, files[i].text, strlen(files[i].text), &err),
            PP_BAD_INPUT);
        assert_int_equal(scene.shape_count, 0);
        if (!strstr(err.message, files[i].says))
            fail_msg("%zu: \"%s\", expected \"%s\"", i, err.message, files[i].says);
    }
}

static void a_file_that_is_cut_off_or_binary_ends_well(void **state)
{
    (void)state;
    static const char text[] = WHITE
        "white ring r 0 0 8 1 1 1 0 0 -5 .7 .2\n!genbox white b 1 1 1|xform -a 2 -t "
        "1 1 1\nvoid glow g 0 0 4 1 1 1 0 g source s 0 0 4 0 0 1 180\n";
    struct pp_scene_description scene;
    struct pp_rad_summary summary;
    for (size_t length = 0; length < sizeof text; length++) {
        struct pp_error err = {0};
        enum pp_status status = parse(&scene, &summary, text, length, &err);
        assert_true(status == PP_OK || (status == PP_BAD_INPUT && err.message[0]));
        pp_scene_description_clear(&scene);
    }
    static const char binary[] = "\x7f"
                                 "ELF\2\1\1\0\0";
    struct pp_error err = {0};
    assert_int_equal(parse(&scene, &summary, binary, sizeof binary, &err),
                     PP_BAD_INPUT);
    assert_non_null(strstr(err.message, "room.rad:1: there is a character with code"));
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_shape_is_what_it_says),
        cmocka_unit_test(every_material_is_what_it_says),
        cmocka_unit_test(lamps_and_mirrors_have_two_faces),
        cmocka_unit_test(transforms_move_from_left_to_right_and_arrays_copy),
        cmocka_unit_test(an_array_of_many_steps_ends_where_it_should),
        cmocka_unit_test(boxes_may_have_bevelled_and_round_edges),
        cmocka_unit_test(a_file_includes_a_file),
        cmocka_unit_test(files_that_copies_read_without_end_are_refused),
        cmocka_unit_test(a_written_perez_sky_turns_with_its_scene),
        cmocka_unit_test(skies_are_those_of_gensky),
        cmocka_unit_test(a_zone_is_its_meridian),
        cmocka_unit_test(shapes_without_area_or_material_are_omitted),
        cmocka_unit_test(unsupported_input_is_rejected_with_its_line),
        cmocka_unit_test(a_file_that_is_cut_off_or_binary_ends_well),
    };
    add_tests(tests, NULL, NULL);
}
