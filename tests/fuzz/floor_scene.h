/* floor_scene.h - the smallest scene in which light can be traced: a grey triangle. */
#ifndef PP_TESTS_FUZZ_FLOOR_SCENE_H
#define PP_TESTS_FUZZ_FLOOR_SCENE_H

#include "model/light/scene_description.h"
#include "simulate/scene/light_scene_of_description.h"
#include "tests/fuzz/must.h"

/* Created at the first call and kept for later calls. */
static inline const struct pp_light_scene *floor_scene(void)
{
    static struct pp_light_scene *scene;
    const struct pp_vec3 floor[3] = {{0, 0, 0}, {2, 0, 0}, {0, 3, 0}};
    struct pp_material grey = pp_material_diffuse(pp_rgb_grey(0.4));
    struct pp_scene_description from;
    if (scene)
        return scene;
    pp_scene_description_init(&from);
    must(pp_scene_description_add_material(&from, &grey, NULL, NULL) == PP_OK);
    must(pp_scene_description_add_polygon(&from, floor, 3, 0, NULL, NULL) == PP_OK);
    must(pp_light_scene_of_description(&scene, &from, NULL) == PP_OK);
    pp_scene_description_clear(&from);
    return scene;
}

#endif
