/* scene_json.c - makes the JSON object of a room's geometry. */
#include "reports/vectors/scene_json.h"

#include <math.h>
#include <stdlib.h>

#include "reports/parts/json.h"
#include "reports/vectors/json_curves.h"

static const char *const roles[PP_ROLE_COUNT] = {
    [PP_FLOOR] = "floor",   [PP_WALL] = "wall",     [PP_CEILING] = "ceiling",
    [PP_REVEAL] = "reveal", [PP_COVER] = "cover",   [PP_FREE_SURFACE] = "surface",
    [PP_BLOCK] = "block",   [PP_FACADE] = "facade", [PP_SKYLINE] = "skyline",
};

/* Adds a new object, printed on one line, to a list. NULL: out of memory. */
static struct json_object *scene_item(struct json_object *list)
{
    struct json_object *item = json_object_new_object();
    if (!pp_json_append(list, item))
        return NULL;
    pp_json_on_one_line(item);
    return item;
}

/* Adds an empty list under a key; NULL: out of memory. */
static struct json_object *scene_list(struct json_object *object, const char *key)
{
    struct json_object *list = json_object_new_array();
    return pp_json_add(object, key, list) ? list : NULL;
}

static bool add_line(struct json_object *object, int line)
{
    return line <= 0 || pp_json_add(object, "line", json_object_new_int(line));
}

static bool add_name(struct json_object *object, const char *name)
{
    return !name || pp_json_text(object, "name", name);
}

static bool add_outline(struct json_object *object, const char *key,
                        const struct pp_polygon *polygon)
{
    size_t count = 3 * (size_t)polygon->count;
    double *xyz = malloc((count + 1) * sizeof *xyz);
    bool good = xyz != NULL;
    for (int i = 0; i < polygon->count && good; i++) {
        xyz[3 * i] = polygon->vertices[i].x;
        xyz[3 * i + 1] = polygon->vertices[i].y;
        xyz[3 * i + 2] = polygon->vertices[i].z;
    }
    good = good && pp_json_curves_lengths(object, key, xyz, (int)count);
    free(xyz);
    return good;
}

static bool add_surfaces(struct json_object *object, const struct pp_world *world)
{
    struct json_object *list = scene_list(object, "surfaces");
    bool good = list != NULL;
    for (int i = 0; i < world->surface_count && good; i++) {
        const struct pp_surface *surface = &world->surfaces[i];
        struct json_object *item = scene_item(list);
        good = item && pp_json_text(item, "role", roles[surface->role])
               && add_name(item, surface->name) && add_line(item, surface->line)
               && pp_json_add(item, "inside", json_object_new_boolean(surface->inside))
               && pp_json_number(item, "reflectance", surface->front)
               && (surface->owner < 0
                   || pp_json_add(item, "owner", json_object_new_int(surface->owner)))
               && add_outline(item, "xyz", &surface->outline);
    }
    return good;
}

static bool add_openings(struct json_object *object, const struct pp_world *world)
{
    struct json_object *list = scene_list(object, "openings");
    bool good = list != NULL;
    for (int i = 0; i < world->opening_count && good; i++) {
        const struct pp_opening *opening = &world->openings[i];
        struct json_object *item = scene_item(list);
        good = item && add_name(item, opening->name)
               && pp_json_text(item, "label", opening->label)
               && add_line(item, opening->line)
               && pp_json_add(item, "face", json_object_new_int(opening->face))
               && pp_json_number(item, "slope", opening->slope_rad / PP_RAD)
               && pp_json_number(item, "reveal", opening->reveal_m)
               && add_outline(item, "inner", &opening->inner)
               && add_outline(item, "outer", &opening->outer);
    }
    return good;
}

static bool add_outside(struct json_object *object, const struct pp_world *world)
{
    struct json_object *list = scene_list(object, "blocks");
    bool good = list != NULL;
    for (int i = 0; i < world->block_count && good; i++) {
        const struct pp_block *block = &world->blocks[i];
        struct json_object *item = scene_item(list);
        good = item && add_name(item, block->name) && add_line(item, block->line)
               && pp_json_number(item, "x", block->corner.x)
               && pp_json_number(item, "y", block->corner.y)
               && pp_json_number(item, "base", block->corner.z)
               && pp_json_number(item, "height", block->height_m);
    }
    list = good ? scene_list(object, "skylines") : NULL;
    good = list != NULL;
    for (int i = 0; i < world->skyline_count && good; i++) {
        const struct pp_skyline *skyline = &world->skylines[i];
        struct json_object *item = scene_item(list);
        good = item && add_line(item, skyline->line)
               && pp_json_add(item, "face", json_object_new_int(skyline->face))
               && pp_json_number(item, "angle", skyline->angle_rad / PP_RAD)
               && pp_json_number(item, "distance", skyline->distance_m)
               && pp_json_number(item, "from", skyline->middle_z_m);
    }
    list = good ? scene_list(object, "gardens") : NULL;
    good = list != NULL;
    for (int i = 0; i < world->garden_count && good; i++) {
        struct json_object *item = scene_item(list);
        good = item && add_name(item, world->gardens[i].name)
               && add_line(item, world->gardens[i].line)
               && add_outline(item, "xyz", &world->gardens[i].outline);
    }
    return good;
}

static bool add_points(struct json_object *object, const struct pp_receiver *points,
                       int count)
{
    struct json_object *list = scene_list(object, "points");
    bool good = list != NULL;
    for (int i = 0; i < count && good; i++) {
        struct json_object *item = scene_item(list);
        good = item && add_line(item, points[i].line)
               && pp_json_number(item, "x", points[i].position.x)
               && pp_json_number(item, "y", points[i].position.y)
               && pp_json_number(item, "z", points[i].position.z);
    }
    return good;
}

enum pp_status pp_scene_json(const struct pp_world *world,
                             const struct pp_receiver *points, int point_count,
                             FILE *out, struct pp_error *err)
{
    struct json_object *object = json_object_new_object();
    bool good = object && pp_json_text(object, "format", "pepperpot-scene-1")
                && pp_json_text(object, "room", world->name)
                && pp_json_number(object, "north", world->north_rad / PP_RAD)
                && pp_json_number(object, "latitude", world->latitude_rad / PP_RAD)
                && pp_json_number(object, "longitude", world->longitude_rad / PP_RAD)
                && pp_json_number(object, "ground", world->ground_level_m)
                && pp_json_number(object, "height", world->height_m)
                && pp_json_number(object, "working-plane", world->working_plane_m)
                && pp_json_add(object, "faces", json_object_new_int(world->face_count))
                && pp_json_curves_region(object, "plane", &world->plane)
                && add_surfaces(object, world) && add_openings(object, world)
                && add_outside(object, world)
                && add_points(object, points, point_count);
    return pp_json_print(out, pp_json_whole(object, good), err);
}
