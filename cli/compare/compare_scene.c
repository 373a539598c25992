/* compare_scene.c - see compare_scene.h. */
#include "cli/compare/compare_scene.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cli/radiance/import_building.h"
#include "formats/radiance/read/rad_read.h"
#include "model/base/read_file.h"

bool pp_compare_scene_is(const char *file)
{
    FILE *in = strcmp(file, "-") == 0 ? NULL : fopen(file, "rb");
    if (!in)
        return false;
    fclose(in);
    return !pp_import_building_is(file);
}

static char *title_of(const char *const *files, int count)
{
    size_t length = 1;
    for (int i = 0; i < count; i++)
        length += strlen(files[i]) + 1;
    char *title = calloc(length, 1);
    for (int i = 0; title && i < count; i++) {
        if (i > 0)
            strcat(title, " ");
        strcat(title, files[i]);
    }
    return title;
}

enum pp_status pp_compare_scene_read(struct pp_compare_scene *scene,
                                     const char *const *files, int count,
                                     struct pp_error *err)
{
    struct pp_rad_summary summary;
    *scene = (struct pp_compare_scene){.title = title_of(files, count)};
    if (!scene->title)
        return pp_fail_memory(err);
    enum pp_status status =
        pp_rad_read(&scene->description, &summary, files, count, err);
    if (status != PP_OK) {
        free(scene->title);
        *scene = (struct pp_compare_scene){0};
    }
    return status;
}

void pp_compare_scene_clear(struct pp_compare_scene *scene)
{
    pp_scene_description_clear(&scene->description);
    free(scene->title);
    free(scene->points);
    *scene = (struct pp_compare_scene){0};
}

enum pp_status pp_compare_scene_place(int **chosen, struct pp_compare_scene *scene,
                                      const struct pp_other_values *values,
                                      const char *path, int most, struct pp_error *err)
{
    int count = values->count, kept = count < most ? count : most;
    for (int i = 0; i < count; i++)
        if (!values->has_places || isnan(values->list[i].place.z))
            return pp_fail(err, PP_BAD_INPUT,
                           "%.200s:%d: x, y and z are missing; a scene has no points "
                           "or working plane of its own",
                           pp_read_file_title(path), values->list[i].line);
    scene->points = calloc((size_t)kept + 1, sizeof *scene->points);
    *chosen = calloc((size_t)kept + 1, sizeof **chosen);
    if (!scene->points || !*chosen) {
        free(*chosen);
        *chosen = NULL;
        return pp_fail_memory(err);
    }
    scene->count = kept;
    for (int i = 0; i < kept; i++) {
        (*chosen)[i] = pp_other_values_spread(i, count, kept);
        const struct pp_other_value *value = &values->list[(*chosen)[i]];
        scene->points[i] =
            (struct pp_receiver){value->place, value->normal, value->line, 0.0};
    }
    return PP_OK;
}
