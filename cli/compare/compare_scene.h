/* compare_scene.h - Radiance scene files, used by compare instead of a room, and points
 * in the scene. */
#ifndef PP_CLI_COMPARE_COMPARE_SCENE_H
#define PP_CLI_COMPARE_COMPARE_SCENE_H

#include "cli/compare/other_values.h"
#include "model/light/scene_description.h"

/* True if the file can be read and is not XML. False for standard input. */
bool pp_compare_scene_is(const char *file);

struct pp_compare_scene {
    struct pp_scene_description description;
    char *title; /* names of the files, separated by blanks */
    struct pp_receiver *points;
    int count;
};

/* Reads the files as one scene. After a failure there is nothing to clear. */
enum pp_status pp_compare_scene_read(struct pp_compare_scene *scene,
                                     const char *const *files, int count,
                                     struct pp_error *err);
void pp_compare_scene_clear(struct pp_compare_scene *scene);

/* Replaces the scene's points by the points of the values, which must have x, y and z.
 * The arguments are as for pp_other_values_place. */
enum pp_status pp_compare_scene_place(int **chosen, struct pp_compare_scene *scene,
                                      const struct pp_other_values *values,
                                      const char *path, int most, struct pp_error *err);

#endif
