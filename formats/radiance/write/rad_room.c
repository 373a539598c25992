/* rad_room.c - see rad_room.h. */
#include "formats/radiance/write/rad_room.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "formats/radiance/write/rad_blind.h"
#include "model/geometry/bounds.h"
#include "model/geometry/clipper.h"
#include "model/geometry/tolerance.h"
#include "model/room/ground.h"
#include "model/room/keyhole.h"
#include "model/room/position.h"
#include "model/room/section.h"
#include "model/room/surface_materials.h"

struct rad_room_builder {
    struct pp_scene_description *scene;
    const struct pp_world *world;
    const struct pp_outside_light *light;
    double horizontal;
    struct pp_surface_materials materials;
    int *described; /* scene index by material; -1: not yet added */
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

/* Materials of both sides of a surface or pane; *back is -1 if the two are equal apart
 * from their names. */
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

/* Scene index of a glowing material; adds it unless the scene has an equal one. */
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
                       "line %d: a surface both emits and reflects light, but no "
                       "Radiance material does both",
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

/* Adds the glass of an opening with a blind, and the slats. */
static enum pp_status add_blind(struct rad_room_builder *b,
                                const struct pp_opening *opening)
{
    int sides[2] = {-1, -1};
    enum pp_status status = PP_OK;
    for (int i = 0; i < 2 && status == PP_OK; i++) {
        struct pp_material pane = pp_surface_materials_glass(b->world, opening, i == 0);
        status = pp_scene_description_add_material(b->scene, &pane, &sides[i], b->err);
    }
    bool bare = opening->glass.panes == 0 && opening->frame_factor == 1.0
                && opening->maintenance * opening->curtains == 1.0;
    if (status == PP_OK && !bare)
        status = add_polygon(b, opening->outer.vertices, opening->outer.count, sides[0],
                             sides[1]);
    return status == PP_OK ? pp_rad_blind_add(b->scene, opening, b->err) : status;
}

static enum pp_status add_panes(struct rad_room_builder *b)
{
    enum pp_status status = PP_OK;
    for (int i = 0; i < b->world->opening_count && status == PP_OK; i++) {
        const struct pp_opening *opening = &b->world->openings[i];
        int front, back, pane = b->world->surface_count + i;
        if (opening->blind) {
            status = add_blind(b, opening);
            continue;
        }
        const struct pp_material *in = &b->materials.list[b->materials.sides[pane][0]];
        if (in->kind == PP_MATERIAL_GLASS && in->glass[0].panes == 0
            && in->clear_share == 1.0 && in->dirt == 1.0)
            continue; /* an air opening without any loss */
        status = sides_of(b, pane, &front, &back);
        if (status == PP_OK)
            status = add_polygon(b, opening->outer.vertices, opening->outer.count,
                                 front, back);
    }
    return status;
}

/* Adds the panes of the coarse model that the room is nested in, and crowns of
 * trees. */
static enum pp_status add_outer_panes(struct rad_room_builder *b)
{
    enum pp_status status = PP_OK;
    for (int i = 0; i < b->world->outer_pane_count && status == PP_OK; i++) {
        const struct pp_outer_pane *pane = &b->world->outer_panes[i];
        const struct pp_opening *opening =
            pane->tree < 0 ? &b->world->within->openings[pane->opening] : NULL;
        int front, back;
        if (opening && opening->blind)
            return pp_fail(b->err, PP_BAD_INPUT,
                           "%s %s of the coarse model has a blind, which the export "
                           "cannot write; expected a coarse model without blinds",
                           pp_world_kind(b->world->within, opening->line),
                           opening->label);
        status = sides_of(b, b->world->surface_count + b->world->opening_count + i,
                          &front, &back);
        if (status == PP_OK)
            status = add_polygon(b, pane->outline.vertices, pane->outline.count, front,
                                 back);
    }
    return status;
}

/* ---- skylines at infinite distance ---- */

static struct pp_vec3 outward_of(const struct pp_world *world,
                                 const struct pp_skyline *skyline)
{
    struct pp_vec3 n = world->surfaces[skyline->face].outline.normal;
    return pp_vec_unit(pp_vec(-n.x, -n.y, 0.0));
}

/* Radiance of the side of a skyline with the given normal. The side is lit by the open
 * sky, the sun and the ground. */
static double radiance_of(const struct rad_room_builder *b,
                          const struct pp_skyline *skyline, struct pp_vec3 normal)
{
    return b->horizontal / PP_PI * skyline->reflectance
           * (pp_sky_on_plane(&b->light->sky, normal)
              + pp_outside_light_sun_on_plane(b->light, normal)
              + pp_outside_light_sunlit_ground(b->light) / 2.0);
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
            return pp_fail(
                b->err, PP_BAD_INPUT,
                "line %d: there are more than %d skylines without a distance",
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

/* Adds the sun as a disc 0.533 degrees in diameter, as gendaylit does (gensky uses
 * 0.5). The radiance is set by the sun's irradiance, so the diameter changes only the
 * shadows' edges. */
static enum pp_status add_solar(struct rad_room_builder *b)
{
    static const double HALF_RAD = 0.2665 * PP_RAD;
    double half = sin(HALF_RAD / 2.0), solid = 4.0 * PP_PI * half * half;
    struct pp_material solar =
        pp_material_light(pp_rgb_grey(b->light->sun.per_sky * b->horizontal / solid));
    struct pp_shape disc = {.kind = PP_SHAPE_DISTANT,
                            .back_material = -1,
                            .is.distant = {b->light->sun.to, HALF_RAD}};
    snprintf(solar.name, sizeof solar.name, "solar");
    enum pp_status status =
        pp_scene_description_add_material(b->scene, &solar, &disc.material, b->err);
    return status == PP_OK
               ? pp_scene_description_add_shape(b->scene, &disc, NULL, b->err)
               : status;
}

static enum pp_status add_sky(struct rad_room_builder *b)
{
    struct pp_pattern pattern;
    struct pp_material sky = pp_material_glow(pp_rgb_grey(1.0));
    struct pp_material ground = pp_material_glow(
        pp_rgb_grey(pp_outside_light_sunlit_ground(b->light) * b->horizontal / PP_PI));
    enum pp_status status = pattern_of(b, &pattern);
    if (status == PP_OK)
        status =
            pp_scene_description_add_pattern(b->scene, &pattern, &sky.pattern, b->err);
    if (status == PP_OK)
        status = add_half(b, "sky", sky, 1.0);
    const char *name = b->world->ground_is_open ? "ground" : "far ground";
    if (status == PP_OK)
        status = add_half(b, name, ground, -1.0);
    return status == PP_OK && b->light->sun.per_sky > 0.0 ? add_solar(b) : status;
}

/* ---- the ground outside as a disc ----
 *
 * The disc is diffuse. Its centre is below the centre of the room. It lies a fifth of a
 * millimetre below the level of ground.h, so that floors and surfaces on the ground
 * stay visible. Its radius is 100 times the distance of the farthest surface. Ground
 * beyond the disc is seen only within 0.6 degrees below the horizon, and the objects
 * hide less than a thousandth of the sky from that ground. If the room extends below
 * ground level, the disc has a hole with the outline of the room.
 */

/* Radius of the disc divided by the distance of the farthest object. */
static const double WIDE = 100.0;
/* Least distance between the hole and the inner edge of the disc. */
static const double MARGIN_M = 1.0;

struct rad_ground_builder {
    struct pp_scene_description *scene;
    int material;
    struct pp_vec3 middle; /* on the ground below the centre of the room */
    double reach_m;        /* distance from `middle` to the farthest object */
    struct pp_error *err;
};

static void measure_ground(struct rad_ground_builder *b, const struct pp_world *world)
{
    struct pp_bounds3 room = pp_position_bounds(world);
    double level = pp_ground_level(world) - 2.0 * PP_SET_OFF_M;
    b->middle = pp_bounds3_middle(&room);
    b->middle.z = level;
    for (int i = 0; i < world->surface_count; i++) {
        const struct pp_surface *surface = &world->surfaces[i];
        /* The wall of a skyline is very long, so its distance counts instead of its
         * corners. */
        if (surface->role == PP_SKYLINE)
            b->reach_m = fmax(b->reach_m, world->skylines[surface->owner].distance_m);
        else
            for (int k = 0; k < surface->outline.count; k++)
                b->reach_m = fmax(
                    b->reach_m,
                    pp_vec_length(pp_vec_sub(surface->outline.vertices[k], b->middle)));
    }
}

static enum pp_status add_disc(struct rad_ground_builder *b, double hole_m)
{
    const struct pp_shape disc = {
        .kind = PP_SHAPE_RING,
        .material = b->material,
        .back_material = -1,
        .is.ring = {b->middle, pp_vec(0.0, 0.0, 1.0), {hole_m, WIDE * b->reach_m}}};
    return pp_scene_description_add_shape(b->scene, &disc, NULL, b->err);
}

/* Adds a triangle of the ground around a room that extends below ground level. */
static enum pp_status add_ground_triangle(struct rad_ground_builder *b, double xy[3][2])
{
    struct pp_vec3 corners[3];
    if (!(pp_region_turn(xy[0], xy[1], xy[2]) > PP_SAME_M * PP_SAME_M))
        return PP_OK;
    for (int i = 0; i < 3; i++)
        corners[i] = pp_vec(xy[i][0], xy[i][1], b->middle.z);
    return pp_scene_description_add_polygon(b->scene, corners, 3, b->material, NULL,
                                            b->err);
}

/* Adds a square of ground around the room, as triangles, with a hole for the room. */
static enum pp_status add_square(struct rad_ground_builder *b, double half_m,
                                 const struct pp_region *room)
{
    double x = b->middle.x, y = b->middle.y;
    const double corners[4][2] = {{x - half_m, y - half_m},
                                  {x + half_m, y - half_m},
                                  {x + half_m, y + half_m},
                                  {x - half_m, y + half_m}};
    struct pp_region square = {0}, left = {0};
    struct pp_clipper *clipper = NULL;
    double(*triangles)[3][2] = NULL;
    int count = 0;
    enum pp_status status = pp_clipper_create(&clipper, b->err);
    if (status == PP_OK)
        status = pp_clipper_of_ring(clipper, &square, corners, 4, b->err);
    if (status == PP_OK)
        status = pp_clipper_difference(clipper, &left, &square, room, b->err);
    if (status == PP_OK)
        status = pp_clipper_triangulate(clipper, &triangles, &count, &left, b->err);
    for (int i = 0; i < count && status == PP_OK; i++)
        status = add_ground_triangle(b, triangles[i]);
    free(triangles);
    pp_region_clear(&left);
    pp_region_clear(&square);
    pp_clipper_destroy(clipper);
    return status;
}

/* Adds the square, and the disc with a round hole inside the square. Square and disc
 * overlap in one plane. */
static enum pp_status add_round(struct rad_ground_builder *b,
                                const struct pp_region *room)
{
    double half_m = 0.0;
    for (int i = 0; i < room->count; i++)
        for (int k = 0; k < room->rings[i].count; k++)
            half_m = fmax(half_m, hypot(room->rings[i].xy[k][0] - b->middle.x,
                                        room->rings[i].xy[k][1] - b->middle.y));
    half_m += MARGIN_M;
    enum pp_status status = add_square(b, half_m, room);
    return status == PP_OK ? add_disc(b, half_m) : status;
}

static enum pp_status add_rad_ground(struct rad_room_builder *room)
{
    struct rad_ground_builder b = {.scene = room->scene, .err = room->err};
    struct pp_material ground =
        pp_material_diffuse(pp_rgb_grey(room->light->ground_reflectance));
    snprintf(ground.name, sizeof ground.name, "ground");
    struct pp_region section = {0};
    measure_ground(&b, room->world);
    enum pp_status status =
        pp_scene_description_add_material(b.scene, &ground, &b.material, b.err);
    if (status == PP_OK)
        status = pp_section_at(&section, room->world, b.middle.z, b.err);
    if (status == PP_OK)
        status = section.count > 0 ? add_round(&b, &section) : add_disc(&b, 0.0);
    pp_region_clear(&section);
    return status;
}

/* ---- the room ---- */

static enum pp_status add_inside(struct rad_room_builder *b)
{
    return add_surfaces(b, true);
}

static enum pp_status add_outside(struct rad_room_builder *b)
{
    enum pp_status status = add_surfaces(b, false);
    if (status == PP_OK)
        status = add_outer_panes(b);
    return status != PP_OK || b->world->ground_is_open ? status : add_rad_ground(b);
}

/* Adds all shapes, one group after the other. */
static enum pp_status add_groups(struct rad_room_builder *b, int first[])
{
    static enum pp_status (*const add[PP_RAD_GROUPS])(struct rad_room_builder *) = {
        [PP_RAD_ROOM] = add_inside,
        [PP_RAD_GLAZING] = add_panes,
        [PP_RAD_OUTSIDE] = add_outside,
        [PP_RAD_SKY] = add_sky};
    enum pp_status status = PP_OK;
    for (int i = 0; i < PP_RAD_GROUPS && status == PP_OK; i++) {
        first[i] = b->scene->shape_count;
        status = add[i](b);
    }
    first[PP_RAD_GROUPS] = b->scene->shape_count;
    return status;
}

enum pp_status pp_rad_room_init(struct pp_rad_room *room, const struct pp_world *world,
                                const struct pp_outside_light *light, double horizontal,
                                bool gloss, struct pp_error *err)
{
    *room = (struct pp_rad_room){0};
    pp_scene_description_init(&room->scene);
    if (light->sky.kind == PP_SKY_PICTURE)
        return pp_fail(err, PP_BAD_INPUT,
                       "a photographed sky cannot be written as a formula; expected "
                       "another sky (--sky)");
    struct rad_room_builder b = {.scene = &room->scene,
                                 .world = world,
                                 .light = light,
                                 .horizontal = horizontal,
                                 .err = err};
    enum pp_status status = pp_surface_materials_init(
        &b.materials, world, gloss ? PP_LOOK_COLOURED : PP_LOOK_MATT, err);
    if (status != PP_OK)
        goto done;
    b.described = malloc(((size_t)b.materials.count + 1) * sizeof *b.described);
    if (!b.described) {
        status = pp_fail_memory(err);
        goto done;
    }
    for (int i = 0; i < b.materials.count; i++)
        b.described[i] = -1;
    status = add_groups(&b, room->first);
done:
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
