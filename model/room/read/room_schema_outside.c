/* room_schema_outside.c - tables of room_schema.h: site, sky, obstructions outside a
 * room, and vertices. */
#include "model/room/read/schema_rows.h"

static const struct pp_attribute_rule site_rows[] = {
    {"latitude", &pp_room_values_latitude, OR(NAN), IN(site, latitude_rad)},
    {"longitude", &pp_room_values_longitude, OR(NAN), IN(site, longitude_rad)},
    {"country", &pp_room_values_country, OR(NAN), IN(site, country)},
    {"surroundings", &pp_room_values_surroundings, OR(0), IN(site, surroundings)},
    {"work", &pp_room_values_work, OR(-1), IN(site, work)},
    {"ground-reflectance", &pp_room_values_even_reflectance, OR(0.2), IN(site, ground)},
    {"ground-level", &pp_room_values_coordinate, OR(0), IN(site, ground_level_m)},
    {"ground", &pp_room_values_ground_kind, OR(0), IN(site, ground_is_open)},
    {"dirt", &pp_room_values_dirt_edition, OR(0), IN(site, dirt)},
    {"bare-from", &pp_room_values_month, OR(0), IN(site, bare_from)},
    {"bare-to", &pp_room_values_month, OR(0), IN(site, bare_to)},
};
static const struct pp_attribute_rule tree_rows[] = {
    {"x", &pp_room_values_coordinate, REQUIRED, IN(tree, x)},
    {"y", &pp_room_values_coordinate, REQUIRED, IN(tree, y)},
    {"height", &pp_room_values_size, REQUIRED, IN(tree, height_m)},
    {"crown-base", &pp_room_values_depth, OR(0), IN(tree, crown_base_m)},
    {"crown-width", &pp_room_values_size, REQUIRED, IN(tree, crown_width_m)},
    {"transmittance", &pp_room_values_fraction, REQUIRED, IN(tree, transmittance)},
    {"winter-transmittance", &pp_room_values_fraction, OR(NAN),
     IN(tree, winter_transmittance)},
    {"state", &pp_room_values_state, OR(0), IN(tree, state)},
};
LEAF(tree, "tree", tree_rows);
static const struct pp_child_rule site_children[] = {{&pp_rule_tree, 0, 0}};
RULE(site, "site", site_rows, site_children);

static const struct pp_attribute_rule sky_rows[] = {
    {"type", &pp_room_values_sky_type, OR(0), IN(sky, type)},
    {"sun-altitude", &pp_room_values_altitude, OR(NAN), IN(sky, sun_altitude_rad)},
    {"sun-bearing", &pp_room_values_bearing, OR(NAN), IN(sky, sun_bearing_rad)},
    {"file", &pp_room_values_file_name, OR(NAN), IN(sky, file)},
    {"second", &pp_room_values_file_name, OR(NAN), IN(sky, second)},
    {"projection", &pp_room_values_text, OR(NAN), IN(sky, picture[0])},
    {"view-angle", &pp_room_values_text, OR(NAN), IN(sky, picture[1])},
    {"top-bearing", &pp_room_values_text, OR(NAN), IN(sky, picture[2])},
    {"view-bearing", &pp_room_values_text, OR(NAN), IN(sky, picture[3])},
    {"view-altitude", &pp_room_values_text, OR(NAN), IN(sky, picture[4])},
    {"mirrored", &pp_room_values_text, OR(NAN), IN(sky, picture[5])},
    {"circle", &pp_room_values_text, OR(NAN), IN(sky, picture[6])},
    {"horizon", &pp_room_values_text, OR(NAN), IN(sky, picture[7])},
    {"fill", &pp_room_values_text, OR(NAN), IN(sky, picture[8])},
    {"illuminance", &pp_room_values_text, OR(NAN), IN(sky, picture[9])},
    {"exposure", &pp_room_values_text, OR(NAN), IN(sky, picture[10])},
    {"primaries", &pp_room_values_text, OR(NAN), IN(sky, picture[11])},
    {"sampling", &pp_room_values_text, OR(NAN), IN(sky, picture[12])},
    {"lamps", &pp_room_values_text, OR(NAN), IN(sky, picture[13])},
    {"sun-illuminance", &pp_room_values_text, OR(NAN), IN(sky, picture[14])},
};
const char *const pp_sky_form_keys[PP_SKY_FORM_OPTIONS] = {
    "projection", "view-angle", "top-bearing", "view-bearing", "view-altitude",
    "mirrored",   "circle",     "horizon",     "fill",         "illuminance",
    "exposure",   "primaries",  "sampling",    "lamps",        "sun-illuminance",
};
LEAF(sky, "sky", sky_rows);

static const struct pp_attribute_rule skyline_rows[] = {
    {"wall", &pp_room_values_wall_name, REQUIRED, IN(skyline, wall)},
    {"angle", &pp_room_values_skyline_angle, REQUIRED, IN(skyline, angle_rad)},
    {"distance", &pp_room_values_size, OR(INFINITY), IN(skyline, distance_m)},
    {"reflectance", &pp_room_values_even_reflectance, OR(0.2), IN(skyline, finish)},
    {"state", &pp_room_values_state, OR(0), IN(skyline, state)},
};
LEAF(skyline, "skyline", skyline_rows);

static const struct pp_attribute_rule facade_rows[] = {
    {"wall", &pp_room_values_wall_name, REQUIRED, IN(facade, wall)},
    {"left", &pp_room_values_depth, OR(0), IN(facade, left_m)},
    {"right", &pp_room_values_depth, OR(0), IN(facade, right_m)},
    {"up", &pp_room_values_depth, OR(0), IN(facade, up_m)},
    {"down", &pp_room_values_depth, OR(0), IN(facade, down_m)},
    {"depth", &pp_room_values_depth, OR(NAN),
     IN(facade, depth_m)}, /* default: largest reveal */
    {"reflectance", &pp_room_values_even_reflectance, OR(0.2), IN(facade, finish)},
};
LEAF(facade, "facade", facade_rows);

static const struct pp_attribute_rule block_rows[] = {
    {"x", &pp_room_values_coordinate, REQUIRED, IN(block, x)},
    {"y", &pp_room_values_coordinate, REQUIRED, IN(block, y)},
    {"width", &pp_room_values_size, REQUIRED, IN(block, width_m)},
    {"depth", &pp_room_values_size, REQUIRED, IN(block, depth_m)},
    {"base", &pp_room_values_coordinate, OR(NAN),
     IN(block, base)}, /* default: ground level */
    {"height", &pp_room_values_size, REQUIRED, IN(block, height_m)},
    {"rotate", &pp_room_values_bearing, OR(0), IN(block, rotate_rad)},
    {"reflectance", &pp_room_values_even_reflectance, OR(0.2), IN(block, finish)},
    {"name", &pp_room_values_text, OR(NAN), IN(block, name)},
    {"state", &pp_room_values_state, OR(0), IN(block, state)},
    {"roof", &pp_room_values_roof, OR(0), IN(block, roof)},
    {"pitch", &pp_room_values_pitch, OR(NAN), IN(block, pitch_rad)},
    {"ridge", &pp_room_values_ridge, OR(0), IN(block, ridge)},
};
LEAF(block, "block", block_rows);
static const struct pp_attribute_rule footprint_rows[] = {
    {"x", &pp_room_values_coordinate, OR(0), IN(block, x)},
    {"y", &pp_room_values_coordinate, OR(0), IN(block, y)},
    {"base", &pp_room_values_coordinate, OR(NAN), IN(block, base)},
    {"height", &pp_room_values_size, REQUIRED, IN(block, height_m)},
    {"rotate", &pp_room_values_bearing, OR(0), IN(block, rotate_rad)},
    {"reflectance", &pp_room_values_even_reflectance, OR(0.2), IN(block, finish)},
    {"name", &pp_room_values_text, OR(NAN), IN(block, name)},
    {"state", &pp_room_values_state, OR(0), IN(block, state)},
};
static const struct pp_child_rule footprint[] = {
    {&pp_rule_plan_vertex, 3, PP_ROOM_VERTICES_MOST}};
RULE(footprint, "block", footprint_rows, footprint);

static const struct pp_attribute_rule vertex_rows[] = {
    {"x", &pp_room_values_coordinate, REQUIRED, IN(vertex, x)},
    {"y", &pp_room_values_coordinate, REQUIRED, IN(vertex, y)},
    {"z", &pp_room_values_coordinate, REQUIRED, IN(vertex, z)},
};
LEAF(vertex, "vertex", vertex_rows);
const struct pp_element_rule pp_rule_plan_vertex = {"vertex", vertex_rows, 2, NULL, 0};

static const struct pp_child_rule polygon[] = {
    {&pp_rule_vertex, 3, PP_ROOM_VERTICES_MOST}};
static const struct pp_attribute_rule surface_rows[] = {
    {"reflectance", &pp_room_values_reflectance, OR(0.2), IN(surface, finish)},
    {"exitance", &pp_room_values_fraction, OR(0), IN(surface, exitance)},
    {"name", &pp_room_values_text, OR(NAN), IN(surface, name)},
    {"state", &pp_room_values_state, OR(0), IN(surface, state)},
};
RULE(surface, "surface", surface_rows, polygon);

static const struct pp_attribute_rule mesh_rows[] = {
    {"file", &pp_room_values_file_name, REQUIRED, IN(mesh, file)},
    {"scale", &pp_room_values_scale, OR(NAN),
     IN(mesh, scale)}, /* default: unit of the file */
    {"x", &pp_room_values_coordinate, OR(0), IN(mesh, x)},
    {"y", &pp_room_values_coordinate, OR(0), IN(mesh, y)},
    {"z", &pp_room_values_coordinate, OR(0), IN(mesh, z)},
    {"rotate", &pp_room_values_bearing, OR(0), IN(mesh, rotate_rad)},
    {"up", &pp_room_values_up, OR(0), IN(mesh, up)},
    {"reflectance", &pp_room_values_even_reflectance, OR(0.2), IN(mesh, finish)},
    {"name", &pp_room_values_text, OR(NAN), IN(mesh, name)},
    {"state", &pp_room_values_state, OR(0), IN(mesh, state)},
};
LEAF(mesh, "mesh", mesh_rows);

static const struct pp_attribute_rule outline_rows[] = {
    {"file", &pp_room_values_file_name, REQUIRED, IN(outline, file)},
    {"projection", &pp_room_values_text, OR(NAN), IN(outline, picture[0])},
    {"view-angle", &pp_room_values_text, OR(NAN), IN(outline, picture[1])},
    {"top-bearing", &pp_room_values_text, OR(NAN), IN(outline, picture[2])},
    {"view-bearing", &pp_room_values_text, OR(NAN), IN(outline, picture[3])},
    {"view-altitude", &pp_room_values_text, OR(NAN), IN(outline, picture[4])},
    {"mirrored", &pp_room_values_text, OR(NAN), IN(outline, picture[5])},
    {"circle", &pp_room_values_text, REQUIRED, IN(outline, picture[6])},
    {"x", &pp_room_values_coordinate, REQUIRED, IN(outline, x)},
    {"y", &pp_room_values_coordinate, REQUIRED, IN(outline, y)},
    {"z", &pp_room_values_coordinate, REQUIRED, IN(outline, z)},
    {"distance", &pp_room_values_size, REQUIRED, IN(outline, distance_m)},
    {"reflectance", &pp_room_values_even_reflectance, OR(0.2), IN(outline, finish)},
    {"name", &pp_room_values_text, OR(NAN), IN(outline, name)},
    {"state", &pp_room_values_state, OR(0), IN(outline, state)},
};
LEAF(outline, "outline", outline_rows);

static const struct pp_attribute_rule garden_rows[] = {
    {"name", &pp_room_values_text, OR(NAN), IN(garden, name)},
    {"state", &pp_room_values_state, OR(0), IN(garden, state)},
};
static const struct pp_child_rule garden_children[] = {
    {&pp_rule_plan_vertex, 3, PP_ROOM_VERTICES_MOST}};
RULE(garden, "garden", garden_rows, garden_children);
