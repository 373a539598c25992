/* json_room.c - makes the JSON object of a room's envelope, openings and
 * surroundings. */
#include "model/room/corrections.h"
#include "reports/parts/json_room.h"

#include <math.h>

#include "model/light/slats/blind.h"
#include "reports/parts/json.h"

static const char *const roles[] = {
    [PP_FLOOR] = "floor",   [PP_WALL] = "wall",     [PP_CEILING] = "ceiling",
    [PP_REVEAL] = "reveal", [PP_COVER] = "cover",   [PP_FREE_SURFACE] = "surface",
    [PP_BLOCK] = "block",   [PP_FACADE] = "facade", [PP_SKYLINE] = "skyline"};

/* Total area of the openings in a face. */
static double openings_m2(const struct pp_world *world, int face)
{
    double area = 0.0;
    for (int i = 0; i < world->opening_count; i++)
        if (world->openings[i].face == face)
            area += world->openings[i].inner.area_m2;
    return area;
}

/* Makes the object of a face of the envelope, with its area less openings. */
static struct json_object *face_of(const struct pp_world *world, int index)
{
    const struct pp_surface *face = &world->surfaces[index];
    struct json_object *object = json_object_new_object();
    bool good = object && (!face->name || pp_json_text(object, "name", face->name))
                && pp_json_text(object, "role", roles[face->role])
                && pp_json_number(object, "area",
                                  face->outline.area_m2 - openings_m2(world, index))
                && pp_json_number(object, "reflectance", face->front);
    if (good)
        pp_json_on_one_line(object);
    return pp_json_whole(object, good);
}

/* Adds label, name and wall of an opening. */
static bool add_names(struct json_object *object, const struct pp_world *world,
                      const struct pp_opening *opening)
{
    const struct pp_surface *face = &world->surfaces[opening->face];
    return pp_json_text(object, "label", opening->label)
           && (!opening->name || pp_json_text(object, "name", opening->name))
           && (!face->name || pp_json_text(object, "wall", face->name));
}

bool pp_json_room_add_opening_names(struct json_object *object,
                                    const struct pp_world *world, int line)
{
    for (int i = 0; i < world->opening_count; i++)
        if (world->openings[i].line == line)
            return add_names(object, world, &world->openings[i]);
    return true;
}

/* Adds the blind, screen or curtain, if there is one. */
static bool add_device(struct json_object *object, const struct pp_opening *opening)
{
    const struct pp_window_device *device = &opening->device;
    if (device->kind == PP_DEVICE_NONE)
        return true;
    if (!pp_json_text(object, "device", pp_window_device_word(device->kind)))
        return false;
    return !opening->blind
           || pp_json_number(object, "blind-transmittance", opening->blind->mean);
}

/* Adds the data of a measured pane; adds nothing for NULL. */
static bool add_measured(struct json_object *object,
                         const struct pp_measured_pane *pane)
{
    static const char *const kinds[] = {[PP_MEASURED_CLEAR] = "clear",
                                        [PP_MEASURED_DIFFUSING] = "diffusing",
                                        [PP_MEASURED_SCATTERING] = "scattering"};
    return !pane
           || ((!pane->file || pp_json_text(object, "glazing-file", pane->file))
               && pp_json_text(object, "measured-as", kinds[pane->kind])
               && pp_json_number(object, "unscattered-transmittance",
                                 pane->straight_diffuse));
}

static struct json_object *opening_of(const struct pp_world *world, int index)
{
    const struct pp_opening *opening = &world->openings[index];
    const struct pp_surface *face = &world->surfaces[opening->face];
    const struct pp_glass *glass = &opening->glass;
    double sill = INFINITY, area = opening->inner.area_m2;
    for (int i = 0; i < opening->inner.count; i++)
        sill = fmin(sill, opening->inner.vertices[i].z);
    struct json_object *object = json_object_new_object();
    bool good =
        object && pp_json_add(object, "line", json_object_new_int(opening->line))
        && add_names(object, world, opening)
        && (!world->name || pp_json_text(object, "room", world->name))
        && (!face->name || pp_json_text(object, "face", face->name))
        && pp_json_number(object, "width", opening->width_m)
        && pp_json_number(object, "height", opening->height_m)
        && pp_json_number(object, "sill", sill) && pp_json_number(object, "area", area)
        && pp_json_number(object, "glass-area", area * opening->frame_factor)
        && pp_json_number(object, "slope", opening->slope_rad / PP_RAD)
        && pp_json_number(object, "reveal", opening->reveal_m)
        && pp_json_add(object, "panes", json_object_new_int(glass->panes))
        && pp_json_add(object, "diffusing", json_object_new_boolean(glass->diffusing))
        && pp_json_number(object, "transmittance", glass->normal)
        && pp_json_number(object, "diffuse-transmittance", glass->diffuse)
        && pp_json_number(object, "frame-factor", opening->frame_factor)
        && pp_json_number(object, "maintenance", opening->maintenance)
        && (!opening->maintenance_is_auto
            || pp_json_text(object, "maintenance-by",
                            pp_corrections_editions[world->dirt]))
        && pp_json_number(object, "curtains", opening->curtains)
        && add_device(object, opening) && add_measured(object, opening->measured);
    if (good)
        pp_json_on_one_line(object);
    return pp_json_whole(object, good);
}

static struct json_object *skyline_of(const struct pp_world *world, int index)
{
    const struct pp_skyline *skyline = &world->skylines[index];
    const char *name = world->surfaces[skyline->face].name;
    struct json_object *object = json_object_new_object();
    bool good = object && (!name || pp_json_text(object, "wall", name))
                && pp_json_number(object, "angle", skyline->angle_rad / PP_RAD)
                && pp_json_number(object, "distance", skyline->distance_m)
                && pp_json_number(object, "reflectance", skyline->reflectance);
    if (good)
        pp_json_on_one_line(object);
    return pp_json_whole(object, good);
}

/* Makes the object of a facade. left, right, up and down: how far it extends beyond its
 * wall, seen from outside. */
static struct json_object *facade_of(const struct pp_world *world, int index)
{
    const struct pp_facade *facade = &world->facades[index];
    const struct pp_surface *wall = &world->surfaces[facade->face];
    struct json_object *object = json_object_new_object();
    bool good = object && (!wall->name || pp_json_text(object, "wall", wall->name))
                && pp_json_number(object, "left", facade->left_m)
                && pp_json_number(object, "right", facade->right_m)
                && pp_json_number(object, "up", facade->up_m)
                && pp_json_number(object, "down", facade->down_m)
                && pp_json_number(object, "depth", facade->depth_m)
                && pp_json_number(object, "reflectance", facade->reflectance);
    if (good)
        pp_json_on_one_line(object);
    return pp_json_whole(object, good);
}

/* Adds an array of `count` objects made by the function `make`. */
static bool add_list(struct json_object *object, const char *key, int count,
                     struct json_object *(*make)(const struct pp_world *, int),
                     const struct pp_world *world)
{
    struct json_object *list = json_object_new_array();
    bool good = pp_json_add(object, key, list);
    for (int i = 0; i < count && good; i++)
        good = pp_json_append(list, make(world, i));
    return good;
}

/* Adds the areas of the floor, of all internal surfaces, of the openings and of their
 * glass. Also adds the mean reflectance of the surfaces, weighted by their areas less
 * openings, and the height of the room. */
static bool add_sums(struct json_object *object, const struct pp_world *world)
{
    double all_m2 = 0.0, reflecting_m2 = 0.0, opaque_m2 = 0.0;
    double openings = 0.0, glass = 0.0;
    for (int i = 0; i < world->face_count; i++) {
        const struct pp_surface *face = &world->surfaces[i];
        double opaque = face->outline.area_m2 - openings_m2(world, i);
        all_m2 += face->outline.area_m2;
        opaque_m2 += opaque;
        reflecting_m2 += opaque * face->front;
    }
    for (int i = 0; i < world->opening_count; i++) {
        double area = world->openings[i].inner.area_m2;
        openings += area;
        glass += area * world->openings[i].frame_factor;
    }
    return pp_json_number(object, "floor-area", pp_world_floor_m2(world))
           && pp_json_number(object, "surface-area", all_m2)
           && pp_json_number(object, "opening-area", openings)
           && pp_json_number(object, "glass-area", glass)
           && pp_json_number(object, "mean-reflectance",
                             opaque_m2 > 0.0 ? reflecting_m2 / opaque_m2 : NAN)
           && pp_json_number(object, "height", world->height_m);
}

/* Adds the outlines of the working plane as lists of corners, { "x", "y" }. The outer
 * outline is counter-clockwise. */
static bool add_plane(struct json_object *object, const struct pp_region *plane)
{
    struct json_object *list = json_object_new_array();
    bool good = pp_json_add(object, "plane", list);
    for (int r = 0; r < plane->count && good; r++) {
        struct json_object *ring = json_object_new_array();
        good = pp_json_append(list, ring);
        for (int i = 0; i < plane->rings[r].count && good; i++) {
            struct json_object *corner = json_object_new_object();
            good = pp_json_append(ring, corner)
                   && pp_json_number(corner, "x", plane->rings[r].xy[i][0])
                   && pp_json_number(corner, "y", plane->rings[r].xy[i][1]);
        }
        if (good)
            pp_json_on_one_line(ring);
    }
    return good;
}

/* Adds the coarse model in which the room is nested, if there is one. */
static bool add_within(struct json_object *model, const struct pp_world *world)
{
    struct json_object *within = json_object_new_object();
    if (!world->within) {
        json_object_put(within);
        return true;
    }
    return pp_json_add(model, "within", within)
           && pp_json_text(within, "name", world->within->name)
           && pp_json_add(within, "in-front",
                          json_object_new_boolean(world->within_is_before))
           && pp_json_add(within, "surfaces",
                          json_object_new_int(world->coarse_surface_count))
           && pp_json_add(within, "panes",
                          json_object_new_int(pp_world_coarse_panes(world)));
}

bool pp_json_room_add(struct json_object *object, const struct pp_world *world,
                      const struct pp_outside_light *light)
{
    struct json_object *model = json_object_new_object();
    int outside = 0;
    for (int i = 0; i < world->surface_count; i++)
        outside +=
            world->surfaces[i].role == PP_FREE_SURFACE && !world->surfaces[i].inside;
    int triangles = world->surface_count - pp_world_before_meshes(world);
    return pp_json_add(object, "model", model) && add_sums(model, world)
           && pp_json_number(model, "working-plane", world->working_plane_m)
           && pp_json_number(model, "plane-area", pp_region_area(&world->plane))
           && add_plane(model, &world->plane)
           && pp_json_number(model, "decorations", world->decorations)
           && pp_json_number(model, "ground-reflectance", light->ground_reflectance)
           && add_list(model, "faces", world->face_count, face_of, world)
           && add_list(model, "openings", world->opening_count, opening_of, world)
           && add_list(model, "skylines", world->skyline_count, skyline_of, world)
           && add_list(model, "facades", world->facade_count, facade_of, world)
           && pp_json_add(model, "blocks", json_object_new_int(world->block_count))
           && pp_json_add(model, "surfaces-outside", json_object_new_int(outside))
           && pp_json_add(model, "meshes", json_object_new_int(world->mesh_count))
           && pp_json_add(model, "mesh-triangles", json_object_new_int(triangles))
           && (world->tree_count == 0
               || pp_json_add(model, "trees", json_object_new_int(world->tree_count)))
           && add_within(model, world);
}
