/* variant_scene.c - changes a copy of the scene's materials, and simulates the scene
 * with the copy. */
#include "studies/research/compare/variant_scene.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model/light/scene_horizontal.h"
#include "simulate/scene/light_scene_of_description.h"
#include "studies/research/compare/variant_glass.h"
#include "studies/research/compare/variant_sensors.h"

/* ---- the changed scene ---- */

static struct pp_rgb grey(struct pp_rgb colour)
{
    double luminance = pp_rgb_luminance(colour);
    return pp_rgb(luminance, luminance, luminance);
}

static void change(struct pp_material *material, const struct pp_room_variant *variant)
{
    if (material->kind == PP_MATERIAL_GLASS) {
        for (int i = 0; i < 3; i++)
            material->glass[i] = pp_variant_glass(material->glass[i], variant);
        material->clear_share = variant->no_frame ? 1.0 : material->clear_share;
        material->dirt = variant->no_dirt ? 1.0 : material->dirt;
    }
    if (variant->colour == PP_ROOM_VARIANT_COLOUR_GREY) {
        material->diffuse = grey(material->diffuse);
        material->gloss = grey(material->gloss);
        material->through_diffuse = grey(material->through_diffuse);
        material->through_gloss = grey(material->through_gloss);
    }
}

/* Name of a switch that is not possible in a scene; NULL: all are possible. */
static const char *not_of_scenes(const struct pp_room_variant *variant)
{
    return variant->sky[0]                                   ? "sky"
           : variant->open_ground || !isnan(variant->ground) ? "ground"
           : variant->nothing_outside                        ? "outside"
                                                             : NULL;
}

/* ---- its values ---- */

/* Combines the colour channels as the other program does. The same combination of the
 * standard errors is never too small. */
static double sum_up(struct pp_rgb light, enum pp_room_variant_colour colour)
{
    return colour == PP_ROOM_VARIANT_COLOUR_MEAN ? (light.r + light.g + light.b) / 3.0
           : colour == PP_ROOM_VARIANT_COLOUR_GREEN ? light.g
                                                    : pp_rgb_luminance(light);
}

static enum pp_status read_sensor_values(double *values, double *errors,
                                         const struct pp_light_scene *scene,
                                         const struct pp_receiver *points, int count,
                                         struct pp_rgb horizontal,
                                         const struct pp_room_variant *variant,
                                         const struct pp_variant_tracing *tracing,
                                         struct pp_error *err)
{
    struct pp_sensor_reading *readings = calloc((size_t)count + 1, sizeof *readings);
    if (!readings)
        return pp_fail_memory(err);
    struct pp_room_variant followed = *variant;
    if (followed.bounces >= 0)
        followed.bounces++; /* in this scene the sky is a surface, which a path reaches
                             * one bounce later */
    enum pp_status status =
        pp_variant_sensors(readings, scene, NULL, points, count,
                           pp_rgb_luminance(horizontal), &followed, tracing, err);
    double over = variant->factor / sum_up(horizontal, variant->colour);
    bool by_luminance = variant->colour != PP_ROOM_VARIANT_COLOUR_MEAN
                        && variant->colour != PP_ROOM_VARIANT_COLOUR_GREEN;
    for (int i = 0; i < count && status == PP_OK; i++) {
        values[i] = over * sum_up(readings[i].irradiance, variant->colour);
        errors[i] = over
                    * (by_luminance ? readings[i].grey_error
                                    : sum_up(readings[i].std_error, variant->colour));
    }
    free(readings);
    return status;
}

static void place_points(struct pp_receiver *moved, const struct pp_receiver *points,
                         int count, double plane_m)
{
    for (int i = 0; i < count; i++) {
        moved[i] = points[i];
        if (!isnan(plane_m))
            moved[i].position.z = plane_m;
    }
}

enum pp_status pp_variant_scene_values(double *values, double *errors,
                                       const struct pp_scene_description *scene,
                                       const struct pp_receiver *points, int count,
                                       const struct pp_room_variant *variant,
                                       const struct pp_variant_tracing *tracing,
                                       struct pp_error *err)
{
    struct pp_scene_description changed = *scene;
    struct pp_light_scene *light_scene = NULL;
    struct pp_rgb horizontal = pp_scene_horizontal(scene);
    const char *stays = not_of_scenes(variant);
    for (int i = 0; i < count; i++)
        values[i] = errors[i] = 0.0;
    if (stays)
        return pp_fail(
            err, PP_BAD_INPUT,
            "%s= cannot be changed in a scene, where it is part of the geometry",
            stays);
    if (!(sum_up(horizontal, variant->colour) > 0.0))
        return pp_fail(err, PP_BAD_INPUT,
                       "the scene has no sky, which daylight factors need");
    if (variant->dark)
        return PP_OK;
    changed.materials =
        malloc(((size_t)scene->material_count + 1) * sizeof *changed.materials);
    struct pp_receiver *moved = malloc(((size_t)count + 1) * sizeof *moved);
    enum pp_status status = changed.materials && moved ? PP_OK : pp_fail_memory(err);
    if (status == PP_OK)
        place_points(moved, points, count, variant->plane_m);
    for (int i = 0; i < scene->material_count && status == PP_OK; i++) {
        changed.materials[i] = scene->materials[i];
        change(&changed.materials[i], variant);
    }
    if (status == PP_OK)
        status = pp_light_scene_of_description(&light_scene, &changed, err);
    if (status == PP_OK)
        status = read_sensor_values(values, errors, light_scene, moved, count,
                                    horizontal, variant, tracing, err);
    pp_light_scene_destroy(light_scene);
    free(changed.materials);
    free(moved);
    return status;
}
