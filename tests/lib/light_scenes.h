/* light_scenes.h - scenes of a few rectangles, domes and boxes, for tests. */
#ifndef PP_TESTS_LIB_LIGHT_SCENES_H
#define PP_TESTS_LIB_LIGHT_SCENES_H

#include "simulate/scene/light_scene_of_description.h"
#include "tests/lib/near.h"

/* Adds the material to the scene and returns its index. */
static inline int pp_test_material(struct pp_scene_description *scene,
                                   struct pp_material material)
{
    int index;
    struct pp_error err = {0};
    if (pp_scene_description_add_material(scene, &material, &index, &err) != PP_OK)
        fail_msg("%s", err.message);
    return index;
}

/* Adds a cone of directions at infinite distance. */
static inline void pp_test_dome(struct pp_scene_description *scene, int material,
                                struct pp_vec3 direction, double half_angle_rad)
{
    struct pp_shape dome = {.kind = PP_SHAPE_DISTANT,
                            .material = material,
                            .back_material = -1,
                            .is.distant = {direction, half_angle_rad}};
    assert_int_equal(pp_scene_description_add_shape(scene, &dome, NULL, NULL), PP_OK);
}

/* Adds a rectangle; its front faces in the direction of the vector product of along and
 * across. */
static inline void pp_test_rectangle(struct pp_scene_description *scene, int material,
                                     struct pp_vec3 corner, struct pp_vec3 along,
                                     struct pp_vec3 across)
{
    struct pp_vec3 v[4] = {corner, pp_vec_add(corner, along),
                           pp_vec_add(pp_vec_add(corner, along), across),
                           pp_vec_add(corner, across)};
    assert_int_equal(
        pp_scene_description_add_polygon(scene, v, 4, material, NULL, NULL), PP_OK);
}

/* Adds the faces of a box of size x, y, z with a corner at the origin; they face
 * inwards. */
static inline void pp_test_box(struct pp_scene_description *scene, int material,
                               double x, double y, double z)
{
    struct pp_vec3 o = {0.0, 0.0, 0.0}, far = {x, y, z};
    struct pp_vec3 ex = {x, 0.0, 0.0}, ey = {0.0, y, 0.0}, ez = {0.0, 0.0, z};
    pp_test_rectangle(scene, material, o, ex, ey);
    pp_test_rectangle(scene, material, o, ey, ez);
    pp_test_rectangle(scene, material, o, ez, ex);
    struct pp_vec3 mx = pp_vec_scale(ex, -1.0), my = pp_vec_scale(ey, -1.0);
    struct pp_vec3 mz = pp_vec_scale(ez, -1.0);
    pp_test_rectangle(scene, material, far, my, mx);
    pp_test_rectangle(scene, material, far, mz, my);
    pp_test_rectangle(scene, material, far, mx, mz);
}

/* Builds the scene for rays; the description is cleared. */
static inline struct pp_light_scene *pp_test_built(struct pp_scene_description *from)
{
    struct pp_light_scene *scene = NULL;
    struct pp_error err = {0};
    if (pp_light_scene_of_description(&scene, from, &err) != PP_OK)
        fail_msg("%s", err.message);
    pp_scene_description_clear(from);
    return scene;
}

/* Configuration factor of a square of half side a at distance h, parallel to the
 * receiver and centred over the point. */
static inline double pp_test_square_factor(double a, double h)
{
    double s = sqrt(a * a + h * h);
    return 4.0 * 2.0 / (2.0 * PP_PI) * (a / s) * atan(a / s);
}

/* Scene of a square of half side a at height h over the origin, facing down. */
static inline struct pp_light_scene *pp_test_under_square(struct pp_material material,
                                                          double a, double h)
{
    struct pp_scene_description scene;
    pp_scene_description_init(&scene);
    pp_test_rectangle(&scene, pp_test_material(&scene, material), pp_vec(-a, -a, h),
                      pp_vec(0.0, 2.0 * a, 0.0), pp_vec(2.0 * a, 0.0, 0.0));
    return pp_test_built(&scene);
}

#endif
