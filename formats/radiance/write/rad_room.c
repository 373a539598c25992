/* rad_room.c - see rad_room.h. */
#include "formats/radiance/write/rad_room.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "formats/radiance/write/rad_ground.h"
#include "model/room/keyhole.h"
#include "model/room/surface_materials.h"

struct rad_room_builder {
    struct pp_scene_description *scene;
    const struct pp_world *world;
    const struct pp_outside_light *light;
    double horizontal;
    struct pp_surface_materials materials;
    int *described; /* a material's number in the scene; -1: not there yet */
    struct pp_error *err;
};

static enum pp_status describe(struct rad_room_builder *b, int material, int *index)
{
    enum pp_status status = PP_OK;
    if (b->described[material] < 0)
        status = pp_scene_description_add_material(
            b->scene, &b->materials.list[material], &b->described[material], b->err);
    *index = b->described[material];
    return status;
}

/* Both sides of a surface or pane; *back is -1 where they are the same but for their
 * names. */
static enum pp_status sides_of(struct rad_room_builder *b, int which, int *front,
                               int *back)
{
    const int *sides = b->materials.sides[which];
    struct pp_material renamed = b->materials.list[sides[1]];
    memcpy(renamed.name, b->materials.list[sides[0]].name, sizeof renamed.name);
    *back = -1;
    enum pp_status status = describe(b, sides[0], front);
    if (status == PP_OK
        && !pp_surface_materials_same(&b->materials.list[sides[0]], &renamed))
        status = describe(b, sides[1], back);
    return status;
}

/* The number in the scene of what glows: a new one, or that of one like it. */
static enum pp_status glow_of(struct rad_room_builder *b,
                              const struct pp_material *glow, int *index)
{
    for (*index = 0; *index < b->scene->material_count; ++*index)
        if (pp_surface_materials_same(&b->scene->materials[*index], glow))
            return PP_OK;
    return pp_scene_description_add_material(b->scene, glow, index, b->err);
}

static enum pp_status add_polygon(struct rad_room_builder *b,
                                  const struct pp_vec3 *corners, int count, int front,
                                  int back)
{
    int index;
    enum pp_status status = pp_scene_description_add_polygon(b->scene, corners, count,
                                                             front, &index, b->err);
    if (status == PP_OK)
        b->scene->shapes[index].back_material = back;
    return status;
}

/* ---- surfaces ---- */

static enum pp_status add_rad_surface(struct rad_room_builder *b, int which)
{
    const struct pp_surface *surface = &b->world->surfaces[which];
    if (surface->exitance > 0.0)
        return pp_fail(b->err, PP_BAD_INPUT,
                       "line %d: a surface that gives off light by itself; Radiance "
                       "has none that reflects as well",
                       surface->line);
    int material, back;
    enum pp_status status = sides_of(b, which, &material, &back);
    if (status != PP_OK || which >= b->world->face_count)
        return status != PP_OK ? status
                               : add_polygon(b, surface->outline.vertices,
                                             surface->outline.count, material, back);
    struct pp_keyhole_outlines cut;
    status = pp_keyhole_outlines_init(&cut, b->world, which, b->err);
    if (status != PP_OK)
        return status;
    for (int i = 0; i < cut.count && status == PP_OK; i++)
        status = add_polygon(b, cut.outlines[i].corners, cut.outlines[i].count,
                             material, back);
    pp_keyhole_outlines_clear(&cut);
    return status;
}

static enum pp_status add_surfaces(struct rad_room_builder *b, bool inside)
{
    enum pp_status status = PP_OK;
    for (int i = 0; i < b->world->surface_count && status == PP_OK; i++)
        if (b->world->surfaces[i].inside == inside)
            status = add_rad_surface(b, i);
    return status;
}

static enum pp_status add_panes(struct rad_room_builder *b)
{
    enum pp_status status = PP_OK;
    for (int i = 0; i < b->world->opening_count && status == PP_OK; i++) {
        const struct pp_opening *opening = &b->world->openings[i];
        int front, back, pane = b->world->surface_count + i;
        const struct pp_material *in = &b->materials.list[b->materials.sides[pane][0]];
        if (in->kind == PP_MATERIAL_GLASS && in->glass[0].panes == 0
            && in->clear_share == 1.0 && in->dirt == 1.0)
            continue; /* nothing but air */
        status = sides_of(b, pane, &front, &back);
        if (status == PP_OK)
            status = add_polygon(b, opening->outer.vertices, opening->outer.count,
                                 front, back);
    }
    return status;
}

/* ---- skylines without a distance ---- */

static struct pp_vec3 outward_of(const struct pp_world *world,
                                 const struct pp_skyline *skyline)
{
    struct pp_vec3 n = world->surfaces[skyline->face].outline.normal;
    return pp_vec_unit(pp_vec(-n.x, -n.y, 0.0));
}

/* Radiance of the skyline's side with that normal, lit by the open sky and the
 * ground. */
static double radiance_of(const struct rad_room_builder *b,
                          const struct pp_skyline *skyline, struct pp_vec3 normal)
{
    return b->horizontal / PP_PI * skyline->reflectance
           * (pp_sky_on_plane(&b->light->sky, normal)
              + b->light->ground_reflectance / 2.0);
}

/* ---- sky and ground ---- */

static enum pp_status pattern_of(struct rad_room_builder *b, struct pp_pattern *pattern)
{
    *pattern = (struct pp_pattern){
        .kind = PP_PATTERN_SKY, .factor = b->horizontal, .sky = b->light->sky};
    for (int i = 0; i < b->world->skyline_count; i++) {
        const struct pp_skyline *skyline = &b->world->skylines[i];
        double slope = tan(skyline->angle_rad);
        if (!isinf(skyline->distance_m) || !(slope > 0.0))
            continue;
        if (pattern->skyline_count == PP_PATTERN_SKYLINES_MOST)
            return pp_fail(b->err, PP_BAD_INPUT,
                           "line %d: more than %d skylines without a distance",
                           skyline->line, PP_PATTERN_SKYLINES_MOST);
        struct pp_vec3 outward = outward_of(b->world, skyline);
        pattern->skylines[pattern->skyline_count++] = (struct pp_pattern_skyline){
            outward, slope, radiance_of(b, skyline, pp_vec_scale(outward, -1.0))};
    }
    return PP_OK;
}

static enum pp_status add_half(struct rad_room_builder *b, const char *name,
                               struct pp_material glow, double z)
{
    const struct pp_shape half = {.kind = PP_SHAPE_DISTANT,
                                  .back_material = -1,
                                  .is.distant = {pp_vec(0.0, 0.0, z), PP_PI / 2.0}};
    struct pp_shape shape = half;
    snprintf(glow.name, sizeof glow.name, "%s", name);
    enum pp_status status = glow_of(b, &glow, &shape.material);
    return status == PP_OK
               ? pp_scene_description_add_shape(b->scene, &shape, NULL, b->err)
               : status;
}

static enum pp_status add_sky(struct rad_room_builder *b)
{
    struct pp_pattern pattern;
    struct pp_material sky = pp_material_glow(pp_rgb_grey(1.0));
    struct pp_material ground = pp_material_glow(
        pp_rgb_grey(b->light->ground_reflectance * b->horizontal / PP_PI));
    enum pp_status status = pattern_of(b, &pattern);
    if (status == PP_OK)
        status =
            pp_scene_description_add_pattern(b->scene, &pattern, &sky.pattern, b->err);
    if (status == PP_OK)
        status = add_half(b, "sky", sky, 1.0);
    const char *name = b->world->ground_is_open ? "ground" : "far ground";
    return status == PP_OK ? add_half(b, name, ground, -1.0) : status;
}

enum pp_status pp_rad_room_init(struct pp_rad_room *room, const struct pp_world *world,
                                const struct pp_outside_light *light, double horizontal,
                                bool gloss, struct pp_error *err)
{
    *room = (struct pp_rad_room){0};
    pp_scene_description_init(&room->scene);
    struct rad_room_builder b = {.scene = &room->scene,
                                 .world = world,
                                 .light = light,
                                 .horizontal = horizontal,
                                 .err = err};
    enum pp_status status = pp_surface_materials_init(&b.materials, world, !gloss, err);
    b.described = malloc(((size_t)b.materials.count + 1) * sizeof *b.described);
    if (status == PP_OK && !b.described)
        status = pp_fail_memory(err);
    for (int i = 0; status == PP_OK && i < b.materials.count; i++)
        b.described[i] = -1;
    if (status == PP_OK)
        status = add_surfaces(&b, true);
    room->first[PP_RAD_GLAZING] = room->scene.shape_count;
    if (status == PP_OK)
        status = add_panes(&b);
    room->first[PP_RAD_OUTSIDE] = room->scene.shape_count;
    if (status == PP_OK)
        status = add_surfaces(&b, false);
    if (status == PP_OK && !world->ground_is_open)
        status = pp_rad_ground_add(&room->scene, world, light->ground_reflectance, err);
    room->first[PP_RAD_SKY] = room->scene.shape_count;
    if (status == PP_OK)
        status = add_sky(&b);
    room->first[PP_RAD_GROUPS] = room->scene.shape_count;
    pp_surface_materials_clear(&b.materials);
    free(b.described);
    if (status != PP_OK)
        pp_rad_room_clear(room);
    return status;
}

bool pp_rad_room_has_gloss(const struct pp_world *world)
{
    for (int i = 0; i < 2 * world->surface_count; i++) {
        struct pp_material full = pp_surface_materials_of(world, i / 2, i % 2);
        struct pp_material matt = pp_surface_materials_matt(world, i / 2, i % 2);
        if (!pp_surface_materials_same(&full, &matt))
            return true;
    }
    return false;
}

void pp_rad_room_clear(struct pp_rad_room *room)
{
    pp_scene_description_clear(&room->scene);
}
