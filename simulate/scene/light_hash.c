/* light_hash.c - hashes a scene value by value, since the padding of structs is
 * undefined. */
#include "simulate/scene/light_hash.h"

#include "model/light/photographs/sky_picture.h"
#include "model/room/surface_materials.h"
#include "simulate/sampling/hash.h"
#include "simulate/scene/light_scene_parts.h"

static uint64_t stir(uint64_t hash, double value)
{
    return pp_hash_double(hash, value);
}

static uint64_t stir_sky(uint64_t hash, const struct pp_sky *sky)
{
    hash = stir(stir(hash, sky->kind), sky->iso);
    hash = pp_hash_vec(hash, sky->sun);
    if (sky->kind == PP_SKY_PICTURE)
        hash = pp_hash(stir(hash, sky->north[1]), sky->picture->hash);
    hash = stir(stir(stir(hash, sky->a), sky->b), sky->c);
    return stir(stir(stir(hash, sky->d), sky->e), sky->per_horizontal);
}

static uint64_t stir_text(uint64_t hash, const char *text)
{
    for (const char *c = text; *c; c++)
        hash = pp_hash(hash, (unsigned char)*c);
    return hash;
}

static uint64_t stir_rough(uint64_t hash, const struct pp_material *material)
{
    const struct pp_rough_optics *optics = &material->rough->optics;
    for (int c = 0; c < 3; c++)
        hash =
            stir(stir(stir(hash, optics->n[c]), optics->k[c]), optics->wavelength[c]);
    hash = stir(stir(hash, optics->roughness), optics->correlation);
    return stir(hash, material->rough_is_grey);
}

static uint64_t stir_surface_pattern(uint64_t hash, const struct pp_material *material)
{
    hash = stir_text(hash, material->surface_pattern->text);
    if (material->bumps)
        hash = stir_text(pp_hash(hash, 0), material->bumps->text);
    struct pp_rgb scale = material->pattern_scale;
    hash = stir(stir(stir(hash, scale.r), scale.g), scale.b);
    return stir(hash, material->pattern_mean);
}

static uint64_t stir_material(uint64_t hash, const struct pp_material *material)
{
    struct pp_material_key key = pp_surface_materials_key(material);
    hash = stir_text(hash, key.name);
    int count = PP_MATERIAL_KEY_NUMBERS;
    if (!material->scatter)
        count -= PP_MATERIAL_KEY_OF_SCATTER;
    for (int i = 0; i < count; i++)
        hash = stir(hash, key.numbers[i]);
    if (material->surface_pattern)
        hash = stir_surface_pattern(hash, material);
    return material->rough ? stir_rough(hash, material) : hash;
}

static uint64_t stir_pattern(uint64_t hash, const struct pp_pattern *p)
{
    hash = stir(stir(hash, p->kind), p->factor);
    for (int i = 0; p->kind == PP_PATTERN_SKY && i < p->skyline_count; i++) {
        hash = pp_hash_vec(hash, p->skylines[i].outward);
        hash = stir(stir(hash, p->skylines[i].slope), p->skylines[i].radiance);
    }
    if (p->kind == PP_PATTERN_SKY)
        return stir_sky(hash, &p->sky);
    hash = stir(stir(stir(stir(hash, p->type), p->zenith), p->ground), p->norm);
    for (int i = 0; i < 5 && p->type == PP_GENSKY_PEREZ; i++)
        hash = stir(hash, p->perez[i]);
    return pp_hash_vec(hash, p->sun);
}

static uint64_t stir_part(uint64_t hash, const struct pp_light_part *part)
{
    hash = stir(pp_hash_vec(hash, part->normal), part->offset_m);
    hash = stir(stir(hash, part->material[0]), part->material[1]);
    return stir(stir(hash, part->back_emits), part->envelope);
}

static uint64_t stir_round(uint64_t hash, const struct pp_shape *shape)
{
    hash = stir(stir(hash, shape->kind), shape->inward);
    switch (shape->kind) {
    case PP_SHAPE_SPHERE:
        return stir(pp_hash_vec(hash, shape->is.sphere.centre),
                    shape->is.sphere.radius_m);
    case PP_SHAPE_RING:
        hash =
            pp_hash_vec(pp_hash_vec(hash, shape->is.ring.centre), shape->is.ring.axis);
        return stir(stir(hash, shape->is.ring.radii_m[0]), shape->is.ring.radii_m[1]);
    default:
        hash = pp_hash_vec(pp_hash_vec(hash, shape->is.cone.ends[0]),
                           shape->is.cone.ends[1]);
        return stir(stir(hash, shape->is.cone.radii_m[0]), shape->is.cone.radii_m[1]);
    }
}

static uint64_t stir_skylines(uint64_t hash, const struct pp_scene_skylines *skylines)
{
    for (int i = 0; i < skylines->far_count; i++) {
        const struct pp_far_skyline *far = &skylines->far[i];
        hash =
            stir(stir(pp_hash_vec(hash, far->outward), far->slope), far->reflectance);
    }
    return hash;
}

void pp_light_hash_scene(struct pp_light_scene *scene, const float (*triangles)[3][3])
{
    uint64_t hash = pp_hash_vec(0, scene->centre);
    for (int i = 0; i < scene->material_count; i++)
        hash = stir_material(hash, &scene->materials[i]);
    for (int i = 0; i < scene->pattern_count; i++)
        hash = stir_pattern(hash, &scene->patterns[i]);
    for (int i = 0; i < scene->part_count; i++)
        hash = stir_part(hash, &scene->parts[i]);
    for (int i = 0; i < scene->triangle_count; i++)
        for (int k = 0; k < 3; k++)
            hash = pp_hash_vec(hash, pp_vec(triangles[i][k][0], triangles[i][k][1],
                                            triangles[i][k][2]));
    for (int i = 0; i < scene->round_count; i++)
        hash = stir_round(hash, &scene->rounds[i]);
    for (int i = 0; i < scene->distant_count; i++) {
        const struct pp_distant *distant = &scene->distants[i];
        hash = stir(pp_hash_vec(hash, distant->direction), distant->cos_half);
        hash = stir(hash, distant->material);
    }
    if (scene->world)
        hash = stir(stir(stir_skylines(hash, &scene->skylines), scene->ground.level_m),
                    scene->ground.shaded);
    scene->hash = hash;
}
