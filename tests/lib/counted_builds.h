/* counted_builds.h - counts the ray structures that are built. A test that includes it
 * must be linked with --wrap=pp_rays_create, which redirects all calls of that function
 * here. */
#ifndef PP_TESTS_LIB_COUNTED_BUILDS_H
#define PP_TESTS_LIB_COUNTED_BUILDS_H

#include "simulate/scene/rays.h"

/* Number of structures built so far. */
static int builds;

enum pp_status __real_pp_rays_create(struct pp_rays **rays,
                                     const float (*triangles)[3][3], int count,
                                     const struct pp_shape *rounds, int round_count,
                                     struct pp_error *err);
enum pp_status __wrap_pp_rays_create(struct pp_rays **rays,
                                     const float (*triangles)[3][3], int count,
                                     const struct pp_shape *rounds, int round_count,
                                     struct pp_error *err);
enum pp_status __wrap_pp_rays_create(struct pp_rays **rays,
                                     const float (*triangles)[3][3], int count,
                                     const struct pp_shape *rounds, int round_count,
                                     struct pp_error *err)
{
    builds++;
    return __real_pp_rays_create(rays, triangles, count, rounds, round_count, err);
}

#endif
