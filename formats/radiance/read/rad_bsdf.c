/* rad_bsdf.c - see rad_bsdf.h. */
#include "formats/radiance/read/rad_bsdf.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "model/light/bsdf/bsdf_file.h"

/* Finds the path of a file that a scene names: the given path if that file can be read,
 * else the path in the folder of the scene file. False if the path is too long. */
static bool locate_file(char *path, size_t size, const char *scene,
                        struct pp_rad_word file)
{
    const char *slash = strrchr(scene, '/');
    int folder = slash && file.text[0] != '/' ? (int)(slash + 1 - scene) : 0;
    int length = snprintf(path, size, "%.*s", (int)file.length, file.text);
    if (length > 0 && (size_t)length < size && access(path, R_OK) != 0)
        length = snprintf(path, size, "%.*s%.*s", folder, scene, (int)file.length,
                          file.text);
    return length > 0 && (size_t)length < size;
}

/* Returns the pane described by a file; each file is read once per scene and value of
 * `split`. */
static enum pp_status pane_of_file(struct pp_rad_reader *reader, const char *path,
                                   bool split, struct pp_measured_pane **pane,
                                   struct pp_error *err)
{
    struct pp_scene_description *scene = reader->scene;
    struct pp_bsdf bsdf;
    for (int i = 0; i < scene->pane_count; i++)
        if (scene->panes[i]->is_split == split
            && strcmp(scene->panes[i]->file, path) == 0) {
            *pane = scene->panes[i];
            return PP_OK;
        }
    enum pp_status status = pp_bsdf_file_read(&bsdf, path, err);
    if (status != PP_OK)
        return status;
    status = pp_measured_pane_create(pane, &bsdf, split, err);
    pp_bsdf_clear(&bsdf);
    if (status != PP_OK)
        return status;
    (*pane)->file = strdup(path);
    if (!(*pane)->file) {
        pp_measured_pane_release(*pane);
        return pp_fail_memory(err);
    }
    return pp_scene_description_add_pane(scene, *pane, err);
}

static enum pp_status add_sides(struct pp_rad_reader *reader,
                                const struct pp_rad_primitive *primitive,
                                const struct pp_measured_pane *pane, struct pp_vec3 up,
                                struct pp_error *err)
{
    struct pp_rad_meaning meaning = {PP_RAD_MATERIAL, 0, -1};
    int *indices[2] = {&meaning.index, &meaning.back};
    enum pp_status status = PP_OK;
    for (int side = 0; side < 2 && status == PP_OK; side++) {
        struct pp_material material =
            pp_material_scattering(&pane->scatter, side == 1, up, 1.0, 1.0, 0.0);
        if (primitive->number_count >= 3 * (side + 1)) {
            const double *n = primitive->numbers + 3 * side;
            material.diffuse = pp_rgb_add(material.diffuse, pp_rgb(n[0], n[1], n[2]));
        }
        int most = (int)sizeof material.name - 1;
        int length = (int)primitive->name.length;
        snprintf(material.name, sizeof material.name, "%.*s",
                 length < most ? length : most, primitive->name.text);
        status = pp_scene_description_add_material(reader->scene, &material,
                                                   indices[side], err);
    }
    return status == PP_OK ? pp_rad_names_define(&reader->names, primitive->name.text,
                                                 primitive->name.length, meaning, err)
                           : status;
}

enum pp_status pp_rad_bsdf_read(struct pp_rad_reader *reader,
                                const struct pp_rad_primitive *primitive,
                                const struct pp_rad_context *context, bool *taken,
                                struct pp_error *err)
{
    const struct pp_rad_words *words = primitive->words;
    bool split = pp_rad_words_is(primitive->type, "aBSDF");
    *taken = split || pp_rad_words_is(primitive->type, "BSDF");
    if (!*taken)
        return PP_OK;
    int first = split ? 0 : 1;
    double up[3] = {0.0};
    bool good = primitive->string_count == first + 5
                && pp_rad_words_is(primitive->strings[first + 4], ".");
    for (int i = 0; i < 3 && good; i++)
        good = pp_rad_words_number(primitive->strings[first + 1 + i], &up[i]);
    if (!good)
        return pp_rad_words_fail(words, primitive->line, err,
                                 "%s has arguments that are not supported; expected "
                                 "%s, three numbers for the direction up, and a dot",
                                 split ? "aBSDF" : "BSDF",
                                 split ? "5 strings: a WINDOW XML file"
                                       : "6 strings: a thickness, a WINDOW XML file");
    bool counted = primitive->number_count % 3 == 0 && primitive->number_count <= 9;
    for (int i = 0; i < primitive->number_count && counted; i++)
        counted = i < 6 ? primitive->numbers[i] >= 0.0 : primitive->numbers[i] == 0.0;
    if (!counted)
        return pp_rad_words_fail(
            words, primitive->line, err,
            "%s has numbers that are not supported; expected none, or the diffuse "
            "reflectances of front and back in three channels each, and no diffuse "
            "transmittance",
            split ? "aBSDF" : "BSDF");
    if (primitive->modifier.kind != PP_RAD_VOID)
        return pp_rad_words_fail(words, primitive->line, err,
                                 "another material or a pattern modifies %s; expected "
                                 "void",
                                 split ? "aBSDF" : "BSDF");
    char path[4096];
    struct pp_error said = {PP_OK, ""};
    struct pp_measured_pane *pane = NULL;
    enum pp_status status = PP_BAD_INPUT;
    if (locate_file(path, sizeof path, words->file, primitive->strings[first]))
        status = pane_of_file(reader, path, split, &pane, &said);
    else
        pp_fail(&said, PP_BAD_INPUT, "the name of the BSDF file is too long");
    if (status == PP_OK)
        status = add_sides(reader, primitive, pane,
                           pp_rad_transform_direction(&context->transform,
                                                      pp_vec(up[0], up[1], up[2])),
                           &said);
    return pp_rad_words_locate(words, primitive->line, status, &said, err);
}
