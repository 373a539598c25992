/* equilibrium.h - rooms in thermal equilibrium, whose light is known for any shape.
 *
 * Under a uniform sky over perfectly white ground, and with every surface emitting the
 * 1 - rho that it does not reflect, all light is isotropic. For any geometry, number of
 * bounces or path through lossless glass every receiver has the value 1, unless light
 * is lost, counted twice or leaks, inside or outside.
 */
#ifndef PP_TESTS_LIB_EQUILIBRIUM_H
#define PP_TESTS_LIB_EQUILIBRIUM_H

#include "tests/lib/room_of.h"

/* World of a room file in that state, and its light; the caller destroys the world. */
static inline struct pp_world *pp_test_equilibrium(struct pp_outside_light *light,
                                                   const char *xml, bool lossless_glass)
{
    struct pp_world *world = pp_test_lit_world(light, xml);
    light->sky = pp_sky_uniform();
    light->ground_reflectance = 1.0;
    for (int i = 0; i < world->surface_count; i++) {
        world->surfaces[i].front = world->surfaces[i].back = 0.3;
        world->surfaces[i].exitance = 0.7;
    }
    for (int i = 0; lossless_glass && i < world->opening_count; i++)
        world->openings[i].glass = pp_glass_panes(1, 1.52, 0.0);
    return world;
}

/* A box, and points in it that face up, sideways and down. */
#define PP_TEST_BOX "<plan width='3.1' depth='4.3' height='2.6'/>"
#define PP_TEST_BOX_POINTS                                                             \
    "<point x='0.9' y='0.7'/><point x='1.7' y='3.9'/>"                                 \
    "<point x='2.3' y='1.9' z='1.4' nx='0.3' ny='-1' nz='0.1'/>"                       \
    "<point x='1.3' y='2.1' z='2.2' nx='0.1' ny='0.2' nz='-1'/>"

/* Room files for lossless_glass = true. Glass on two sides and above. */
#define PP_TEST_GLAZED_ROOM                                                            \
    "<room version='1'>" PP_TEST_BOX                                                   \
    "<window wall='south' left='0.3' sill='0.7' width='2.2' height='1.5'/>"            \
    "<window wall='west' left='0.4' sill='0.2' width='1.2' height='2.1'/>"             \
    "<rooflight x='0.6' y='1.9' width='1.1' depth='1.3'/>" PP_TEST_BOX_POINTS          \
    "</room>"

/* Deep reveals. */
#define PP_TEST_REVEALED_ROOM                                                          \
    "<room version='1'>" PP_TEST_BOX                                                   \
    "<window wall='south' left='0.3' sill='0.7' width='2.2' height='1.5' "             \
    "reveal='0.35'/><rooflight x='0.6' y='1.9' width='1.1' depth='1.3' "               \
    "reveal='0.5'/>" PP_TEST_BOX_POINTS "</room>"

/* An L-shape with a block outside and a surface inside, and its points. The wall of
 * each of its two windows is visible from the other window. */
#define PP_TEST_L_SHAPED_ROOM                                                          \
    "<room version='1'><plan height='2.6'><vertex x='0' y='0'/>"                       \
    "<vertex x='5' y='0'/><vertex x='5' y='2'/><vertex x='2' y='2'/>"                  \
    "<vertex x='2' y='6'/><vertex x='0' y='6'/></plan>"                                \
    "<window wall='3' left='0.3' sill='0.4' width='2.2' height='1.9'/>"                \
    "<window wall='4' left='0.5' sill='0.4' width='3.1' height='1.9'/>"                \
    "<block x='3' y='3.1' width='1.2' depth='1.7' height='2.2' rotate='20'/>"          \
    "<surface reflectance='0.3'><vertex x='0.3' y='2.2' z='1.1'/>"                     \
    "<vertex x='1.4' y='2.3' z='1.1'/><vertex x='1.3' y='3.1' z='1.4'/></surface>"     \
    "<point x='0.7' y='1.1'/><point x='4.1' y='0.9'/><point x='1.2' y='5.1'/>"         \
    "</room>"

/* A diffusing pane with transmittance 0.9 and reflectance 0.1. */
#define PP_TEST_DIFFUSING_ROOM                                                         \
    "<room version='1'>" PP_TEST_BOX                                                   \
    "<window wall='south' left='0.3' sill='0.7' width='2.2' height='1.5' "             \
    "transmittance='0.9' diffusing='yes'/>" PP_TEST_BOX_POINTS "</room>"

#endif
