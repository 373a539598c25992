/* room_schema.c - the tables of elements and attributes, according to which
 * element_form.c reads elements. */
#include "model/room/read/room_schema.h"

#include <math.h>

#include "model/room/read/room_values.h"
#include "model/geometry/vec.h"
#include "model/room/room_use.h"
#include "model/room/sky_words.h"

/* Kinds of values. */

static const struct pp_value_kind text = {
    .reading = PP_VALUE_TEXT, .expected = "text without control characters"};
static const struct pp_value_kind wall = {.reading = PP_VALUE_NAME,
                                          .expected = "the name of a wall"};
static const struct pp_value_kind face_name = {.reading = PP_VALUE_NAME,
                                               .expected = "a name"};
static const struct pp_value_kind file_name = {.reading = PP_VALUE_NAME,
                                               .expected = "the name of a file"};
/* ---- elements ---- */

#define REQUIRED true, NAN
#define OR(fallback) false, fallback
#define IN(form, member) offsetof(struct pp_##form##_form, member)
#define RULE(id, element, attributes, children)                                        \
    const struct pp_element_rule pp_rule_##id = {                                      \
        element, attributes, sizeof attributes / sizeof *attributes, children,         \
        sizeof children / sizeof *children}
#define LEAF(id, element, attributes)                                                  \
    const struct pp_element_rule pp_rule_##id = {                                      \
        element, attributes, sizeof attributes / sizeof *attributes, NULL, 0}

static const struct pp_attribute_rule project_rows[PP_PROJECT_FACTS] = {
    {"name", &text, OR(NAN), IN(project, facts[0])},
    {"client", &text, OR(NAN), IN(project, facts[1])},
    {"number", &text, OR(NAN), IN(project, facts[2])},
    {"author", &text, OR(NAN), IN(project, facts[3])},
    {"checked", &text, OR(NAN), IN(project, facts[4])},
    {"date", &text, OR(NAN), IN(project, facts[5])},
    {"revision", &text, OR(NAN), IN(project, facts[6])},
};
LEAF(project, "project", project_rows);

static const struct pp_attribute_rule site_rows[] = {
    {"latitude", &pp_room_values_latitude, OR(NAN), IN(site, latitude_rad)},
    {"longitude", &pp_room_values_longitude, OR(NAN), IN(site, longitude_rad)},
    {"country", &pp_room_values_country, OR(NAN), IN(site, country)},
    {"surroundings", &pp_room_values_surroundings, OR(0), IN(site, surroundings)},
    {"work", &pp_room_values_work, OR(-1), IN(site, work)},
    {"ground-reflectance", &pp_room_values_reflectance, OR(0.2), IN(site, ground)},
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
    {"file", &file_name, OR(NAN), IN(sky, file)},
    {"second", &file_name, OR(NAN), IN(sky, second)},
    {"projection", &text, OR(NAN), IN(sky, picture[0])},
    {"view-angle", &text, OR(NAN), IN(sky, picture[1])},
    {"top-bearing", &text, OR(NAN), IN(sky, picture[2])},
    {"view-bearing", &text, OR(NAN), IN(sky, picture[3])},
    {"view-altitude", &text, OR(NAN), IN(sky, picture[4])},
    {"mirrored", &text, OR(NAN), IN(sky, picture[5])},
    {"circle", &text, OR(NAN), IN(sky, picture[6])},
    {"horizon", &text, OR(NAN), IN(sky, picture[7])},
    {"fill", &text, OR(NAN), IN(sky, picture[8])},
    {"illuminance", &text, OR(NAN), IN(sky, picture[9])},
    {"exposure", &text, OR(NAN), IN(sky, picture[10])},
    {"primaries", &text, OR(NAN), IN(sky, picture[11])},
    {"sampling", &text, OR(NAN), IN(sky, picture[12])},
    {"lamps", &text, OR(NAN), IN(sky, picture[13])},
    {"sun-illuminance", &text, OR(NAN), IN(sky, picture[14])},
};
const char *const pp_sky_form_keys[PP_SKY_FORM_OPTIONS] = {
    "projection", "view-angle", "top-bearing", "view-bearing", "view-altitude",
    "mirrored",   "circle",     "horizon",     "fill",         "illuminance",
    "exposure",   "primaries",  "sampling",    "lamps",        "sun-illuminance",
};
LEAF(sky, "sky", sky_rows);

static const struct pp_attribute_rule vertex_rows[] = {
    {"x", &pp_room_values_coordinate, REQUIRED, IN(vertex, x)},
    {"y", &pp_room_values_coordinate, REQUIRED, IN(vertex, y)},
    {"z", &pp_room_values_coordinate, REQUIRED, IN(vertex, z)},
};
LEAF(vertex, "vertex", vertex_rows);
const struct pp_element_rule pp_rule_plan_vertex = {"vertex", vertex_rows, 2, NULL, 0};

static const struct pp_child_rule polygon[] = {
    {&pp_rule_vertex, 3, PP_ROOM_VERTICES_MOST}};

static const struct pp_attribute_rule plan_rows[] = {
    {"width", &pp_room_values_size, OR(NAN), IN(plan, width_m)},
    {"depth", &pp_room_values_size, OR(NAN), IN(plan, depth_m)},
    {"height", &pp_room_values_size, REQUIRED, IN(plan, height_m)},
    {"roof", &pp_room_values_plan_roof, OR(0), IN(plan, roof)},
    {"pitch", &pp_room_values_pitch, OR(NAN), IN(plan, pitch_rad)},
    {"ridge", &pp_room_values_ridge, OR(0), IN(plan, ridge)},
    {"teeth", &pp_room_values_teeth, OR(0), IN(plan, teeth)},
};
static const struct pp_child_rule plan_children[] = {
    {&pp_rule_plan_vertex, 0, PP_ROOM_VERTICES_MOST}};
RULE(plan, "plan", plan_rows, plan_children);

static const struct pp_attribute_rule face_rows[] = {
    {"role", &pp_room_values_role, REQUIRED, IN(face, role)},
    {"name", &face_name, REQUIRED, IN(face, name)},
    {"reflectance", &pp_room_values_reflectance, OR(NAN), IN(face, finish)},
};
RULE(face, "face", face_rows, polygon);
static const struct pp_child_rule envelope_children[] = {
    {&pp_rule_face, 4, PP_ROOM_VERTICES_MOST}};
const struct pp_element_rule pp_rule_envelope = {"envelope", NULL, 0, envelope_children,
                                                 1};

static const struct pp_attribute_rule finishes_rows[] = {
    {"floor", &pp_room_values_reflectance, OR(0.2), IN(finishes, floor)},
    {"walls", &pp_room_values_reflectance, OR(0.5), IN(finishes, walls)},
    {"ceiling", &pp_room_values_reflectance, OR(0.7), IN(finishes, ceiling)},
    {"decorations", &pp_room_values_or_auto, OR(1), IN(finishes, decorations)},
};
LEAF(finishes, "finishes", finishes_rows);

static const struct pp_attribute_rule finish_rows[] = {
    {"wall", &wall, REQUIRED, IN(finish, wall)},
    {"reflectance", &pp_room_values_reflectance, REQUIRED, IN(finish, finish)},
};
LEAF(finish, "finish", finish_rows);

static const struct pp_attribute_rule material_rows[] = {
    {"name", &face_name, REQUIRED, IN(material, name)},
    {"n", &pp_room_values_refractive_index, REQUIRED, IN(material, n)},
    {"k", &pp_room_values_extinction, OR(0), IN(material, k)},
    {"roughness", &pp_room_values_roughness, REQUIRED, IN(material, roughness_um)},
    {"correlation-length", &pp_room_values_correlation, REQUIRED,
     IN(material, correlation_um)},
    {"diffuse", &pp_room_values_diffuse, OR(0), IN(material, diffuse)},
    {"wavelength", &pp_room_values_wavelength, OR(0), IN(material, wavelength_um)},
};
LEAF(material, "material", material_rows);

static const struct pp_attribute_rule wall_rows[] = {
    {"name", &wall, REQUIRED, IN(wall, name)},
    {"kind", &pp_room_values_wall_kind, REQUIRED, IN(wall, kind)},
};
LEAF(wall, "wall", wall_rows);

#define GLAZING_ROWS                                                                   \
    {"glazing", &pp_room_values_glazing, OR(NAN), IN(opening, glazing)},               \
        {"transmittance", &pp_room_values_transmittance, OR(NAN),                      \
         IN(opening, transmittance)},                                                  \
        {"glazing-file", &file_name, OR(NAN), IN(opening, glazing_file)},              \
        {"glazing-peak", &pp_room_values_peak, OR(0), IN(opening, peak)},              \
        {"diffusing", &pp_room_values_yes_no, OR(-1), IN(opening, diffusing)},         \
        {"absorbing", &pp_room_values_yes_no, OR(-1), IN(opening, absorbing)},         \
        {"frame-factor", &pp_room_values_frame, OR(1), IN(opening, frame_factor)},     \
        {"maintenance", &pp_room_values_or_auto, OR(1), IN(opening, maintenance)},     \
        {"curtains", &pp_room_values_curtains, OR(1), IN(opening, curtains)},          \
        {"reveal", &pp_room_values_depth, OR(0), IN(opening, reveal_m)},               \
    {                                                                                  \
        "name", &text, OR(NAN), IN(opening, name)                                      \
    }
static const struct pp_attribute_rule window_rows[] = {
    {"wall", &wall, REQUIRED, IN(opening, wall)},
    {"left", &pp_room_values_coordinate, REQUIRED, IN(opening, left_m)},
    {"sill", &pp_room_values_coordinate, REQUIRED, IN(opening, sill_m)},
    {"width", &pp_room_values_size, REQUIRED, IN(opening, width_m)},
    {"height", &pp_room_values_size, REQUIRED, IN(opening, height_m)},
    GLAZING_ROWS,
};
static const struct pp_attribute_rule overhang_rows[] = {
    {"depth", &pp_room_values_size, REQUIRED, IN(shade, depth_m)},
    {"above", &pp_room_values_depth, OR(0), IN(shade, above_m)},
    {"left", &pp_room_values_depth, OR(0), IN(shade, left_m)},
    {"right", &pp_room_values_depth, OR(0), IN(shade, right_m)},
    {"reflectance", &pp_room_values_reflectance, OR(0.2), IN(shade, finish)},
};
LEAF(overhang, "overhang", overhang_rows);
static const struct pp_attribute_rule fin_rows[] = {
    {"depth", &pp_room_values_size, REQUIRED, IN(shade, depth_m)},
    {"side", &pp_room_values_side, OR(0), IN(shade, side)},
    {"gap", &pp_room_values_depth, OR(0), IN(shade, left_m)},
    {"above", &pp_room_values_depth, OR(0), IN(shade, above_m)},
    {"below", &pp_room_values_depth, OR(0), IN(shade, below_m)},
    {"reflectance", &pp_room_values_reflectance, OR(0.2), IN(shade, finish)},
};
LEAF(fin, "fin", fin_rows);
static const struct pp_attribute_rule balcony_rows[] = {
    {"depth", &pp_room_values_size, REQUIRED, IN(shade, depth_m)},
    {"left", &pp_room_values_depth, OR(0), IN(shade, left_m)},
    {"right", &pp_room_values_depth, OR(0), IN(shade, right_m)},
    {"level", &pp_room_values_coordinate, OR(0), IN(shade, height_m)},
    {"parapet", &pp_room_values_depth, OR(1.1), IN(shade, parapet_m)},
    {"reflectance", &pp_room_values_reflectance, OR(0.2), IN(shade, finish)},
};
LEAF(balcony, "balcony", balcony_rows);
static const struct pp_attribute_rule shelf_rows[] = {
    {"height", &pp_room_values_size, REQUIRED, IN(shade, height_m)},
    {"depth", &pp_room_values_depth, OR(0.5), IN(shade, depth_m)},
    {"inside", &pp_room_values_depth, OR(0), IN(shade, inside_m)},
    {"left", &pp_room_values_depth, OR(0), IN(shade, left_m)},
    {"right", &pp_room_values_depth, OR(0), IN(shade, right_m)},
    {"reflectance", &pp_room_values_reflectance, OR(0.7), IN(shade, finish)},
};
LEAF(shelf, "shelf", shelf_rows);
static const struct pp_attribute_rule blind_rows[] = {
    {"slat-width", &pp_room_values_size, OR(0.025), IN(blind, width_m)},
    {"spacing", &pp_room_values_size, OR(NAN), IN(blind, spacing_m)},
    {"angle", &pp_room_values_slat_angle, OR(NAN), IN(blind, angle_rad)},
    {"cut-off", &pp_room_values_yes_no, OR(0), IN(blind, cut_off)},
    {"curvature", &pp_room_values_coordinate, OR(0), IN(blind, curvature_m)},
    {"reflectance", &pp_room_values_reflectance, OR(0.5), IN(blind, upper)},
    {"reflectance-below", &pp_room_values_reflectance, OR(NAN), IN(blind, lower)},
    {"direction", &pp_room_values_slat_direction, OR(0), IN(blind, direction)},
    {"position", &pp_room_values_device_position, OR(0), IN(blind, position)},
};
LEAF(blind, "blind", blind_rows);
static const struct pp_attribute_rule screen_rows[] = {
    {"openness", &pp_room_values_fraction, REQUIRED, IN(screen, openness)},
    {"reflectance", &pp_room_values_reflectance, OR(0.5), IN(screen, finish)},
};
LEAF(screen, "screen", screen_rows);
static const struct pp_attribute_rule curtain_rows[] = {
    {"transmittance", &pp_room_values_transmittance, REQUIRED,
     IN(curtain, transmittance)},
};
LEAF(curtain, "curtain", curtain_rows);
#define DEVICES                                                                        \
    {&pp_rule_blind, 0, 0}, {&pp_rule_screen, 0, 0},                                   \
    {                                                                                  \
        &pp_rule_curtain, 0, 0                                                         \
    }
static const struct pp_child_rule window_children[] = {{&pp_rule_overhang, 0, 0},
                                                       {&pp_rule_fin, 0, 0},
                                                       {&pp_rule_balcony, 0, 0},
                                                       {&pp_rule_shelf, 0, 0},
                                                       DEVICES};
RULE(window, "window", window_rows, window_children);
static const struct pp_attribute_rule rooflight_rows[] = {
    {"x", &pp_room_values_coordinate, REQUIRED, IN(opening, x)},
    {"y", &pp_room_values_coordinate, REQUIRED, IN(opening, y)},
    {"width", &pp_room_values_size, REQUIRED, IN(opening, width_m)},
    {"depth", &pp_room_values_size, REQUIRED, IN(opening, depth_m)},
    GLAZING_ROWS,
};
static const struct pp_child_rule rooflight_children[] = {DEVICES};
RULE(rooflight, "rooflight", rooflight_rows, rooflight_children);
static const struct pp_attribute_rule opening_rows[] = {GLAZING_ROWS};
static const struct pp_child_rule opening_children[] = {
    {&pp_rule_vertex, 3, PP_ROOM_VERTICES_MOST}, DEVICES};
RULE(opening, "opening", opening_rows, opening_children);

static const struct pp_attribute_rule skyline_rows[] = {
    {"wall", &wall, REQUIRED, IN(skyline, wall)},
    {"angle", &pp_room_values_skyline_angle, REQUIRED, IN(skyline, angle_rad)},
    {"distance", &pp_room_values_size, OR(INFINITY), IN(skyline, distance_m)},
    {"reflectance", &pp_room_values_reflectance, OR(0.2), IN(skyline, finish)},
    {"state", &pp_room_values_state, OR(0), IN(skyline, state)},
};
LEAF(skyline, "skyline", skyline_rows);

static const struct pp_attribute_rule facade_rows[] = {
    {"wall", &wall, REQUIRED, IN(facade, wall)},
    {"left", &pp_room_values_depth, OR(0), IN(facade, left_m)},
    {"right", &pp_room_values_depth, OR(0), IN(facade, right_m)},
    {"up", &pp_room_values_depth, OR(0), IN(facade, up_m)},
    {"down", &pp_room_values_depth, OR(0), IN(facade, down_m)},
    {"depth", &pp_room_values_depth, OR(NAN),
     IN(facade, depth_m)}, /* default: largest reveal */
    {"reflectance", &pp_room_values_reflectance, OR(0.2), IN(facade, finish)},
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
    {"reflectance", &pp_room_values_reflectance, OR(0.2), IN(block, finish)},
    {"name", &text, OR(NAN), IN(block, name)},
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
    {"reflectance", &pp_room_values_reflectance, OR(0.2), IN(block, finish)},
    {"name", &text, OR(NAN), IN(block, name)},
    {"state", &pp_room_values_state, OR(0), IN(block, state)},
};
static const struct pp_child_rule footprint[] = {
    {&pp_rule_plan_vertex, 3, PP_ROOM_VERTICES_MOST}};
RULE(footprint, "block", footprint_rows, footprint);

static const struct pp_attribute_rule surface_rows[] = {
    {"reflectance", &pp_room_values_reflectance, OR(0.2), IN(surface, finish)},
    {"exitance", &pp_room_values_fraction, OR(0), IN(surface, exitance)},
    {"name", &text, OR(NAN), IN(surface, name)},
    {"state", &pp_room_values_state, OR(0), IN(surface, state)},
};
RULE(surface, "surface", surface_rows, polygon);

static const struct pp_attribute_rule mesh_rows[] = {
    {"file", &file_name, REQUIRED, IN(mesh, file)},
    {"scale", &pp_room_values_scale, OR(NAN),
     IN(mesh, scale)}, /* default: unit of the file */
    {"x", &pp_room_values_coordinate, OR(0), IN(mesh, x)},
    {"y", &pp_room_values_coordinate, OR(0), IN(mesh, y)},
    {"z", &pp_room_values_coordinate, OR(0), IN(mesh, z)},
    {"rotate", &pp_room_values_bearing, OR(0), IN(mesh, rotate_rad)},
    {"up", &pp_room_values_up, OR(0), IN(mesh, up)},
    {"reflectance", &pp_room_values_reflectance, OR(0.2), IN(mesh, finish)},
    {"name", &text, OR(NAN), IN(mesh, name)},
    {"state", &pp_room_values_state, OR(0), IN(mesh, state)},
};
LEAF(mesh, "mesh", mesh_rows);

static const struct pp_attribute_rule garden_rows[] = {
    {"name", &text, OR(NAN), IN(garden, name)},
    {"state", &pp_room_values_state, OR(0), IN(garden, state)},
};
static const struct pp_child_rule garden_children[] = {
    {&pp_rule_plan_vertex, 3, PP_ROOM_VERTICES_MOST}};
RULE(garden, "garden", garden_rows, garden_children);

static const struct pp_attribute_rule plane_rows[] = {
    {"height", &pp_room_values_coordinate, OR(0.85), IN(plane, height_m)},
};
LEAF(working_plane, "working-plane", plane_rows);

static const struct pp_attribute_rule furniture_rows[] = {
    {"x", &pp_room_values_coordinate, REQUIRED, IN(fitting, x)},
    {"y", &pp_room_values_coordinate, REQUIRED, IN(fitting, y)},
    {"z", &pp_room_values_coordinate, OR(0), IN(fitting, z)},
    {"width", &pp_room_values_size, REQUIRED, IN(fitting, width_m)},
    {"depth", &pp_room_values_size, REQUIRED, IN(fitting, depth_m)},
    {"height", &pp_room_values_size, REQUIRED, IN(fitting, height_m)},
    {"rotate", &pp_room_values_bearing, OR(0), IN(fitting, rotate_rad)},
    {"reflectance", &pp_room_values_reflectance, OR(0.3), IN(fitting, finish)},
    {"name", &text, OR(NAN), IN(fitting, name)},
};
LEAF(furniture, "furniture", furniture_rows);
static const struct pp_attribute_rule column_rows[] = {
    {"x", &pp_room_values_coordinate, REQUIRED, IN(fitting, x)},
    {"y", &pp_room_values_coordinate, REQUIRED, IN(fitting, y)},
    {"width", &pp_room_values_size, OR(NAN), IN(fitting, width_m)},
    {"depth", &pp_room_values_size, OR(NAN), IN(fitting, depth_m)},
    {"diameter", &pp_room_values_size, OR(NAN), IN(fitting, diameter_m)},
    {"height", &pp_room_values_size, OR(NAN), IN(fitting, height_m)},
    {"rotate", &pp_room_values_bearing, OR(0), IN(fitting, rotate_rad)},
    {"reflectance", &pp_room_values_reflectance, OR(NAN), IN(fitting, finish)},
    {"name", &text, OR(NAN), IN(fitting, name)},
};
LEAF(column, "column", column_rows);
static const struct pp_attribute_rule partition_rows[] = {
    {"from", &pp_room_values_position, REQUIRED, IN(fitting, from)},
    {"to", &pp_room_values_position, REQUIRED, IN(fitting, to)},
    {"thickness", &pp_room_values_size, OR(0.1), IN(fitting, thickness_m)},
    {"height", &pp_room_values_size, OR(NAN), IN(fitting, height_m)},
    {"reflectance", &pp_room_values_reflectance, OR(NAN), IN(fitting, finish)},
    {"name", &text, OR(NAN), IN(fitting, name)},
};
LEAF(partition, "partition", partition_rows);

static const struct pp_attribute_rule door_rows[] = {
    {"wall", &wall, REQUIRED, IN(cover, wall)},
    {"left", &pp_room_values_coordinate, REQUIRED, IN(cover, left_m)},
    {"width", &pp_room_values_size, OR(0.9), IN(cover, width_m)},
    {"height", &pp_room_values_size, OR(2.1), IN(cover, height_m)},
    {"reflectance", &pp_room_values_reflectance, OR(0.3), IN(cover, finish)},
    {"name", &text, OR(NAN), IN(cover, name)},
};
LEAF(door, "door", door_rows);
static const struct pp_attribute_rule dado_rows[] = {
    {"wall", &wall, OR(NAN), IN(cover, wall)},
    {"height", &pp_room_values_size, OR(1), IN(cover, height_m)},
    {"reflectance", &pp_room_values_reflectance, REQUIRED, IN(cover, finish)},
    {"name", &text, OR(NAN), IN(cover, name)},
};
LEAF(dado, "dado", dado_rows);

static const struct pp_attribute_rule point_rows[] = {
    {"x", &pp_room_values_coordinate, REQUIRED, IN(receiver, x)},
    {"y", &pp_room_values_coordinate, REQUIRED, IN(receiver, y)},
    {"z", &pp_room_values_coordinate, OR(NAN), IN(receiver, z)},
    {"nx", &pp_room_values_component, OR(NAN), IN(receiver, nx)},
    {"ny", &pp_room_values_component, OR(NAN), IN(receiver, ny)},
    {"nz", &pp_room_values_component, OR(NAN), IN(receiver, nz)},
};
LEAF(point, "point", point_rows);
static const struct pp_attribute_rule line_rows[] = {
    {"from", &pp_room_values_position, REQUIRED, IN(receiver, from)},
    {"to", &pp_room_values_position, REQUIRED, IN(receiver, to)},
    {"points", &pp_room_values_number_of_points, REQUIRED, IN(receiver, points)},
};
LEAF(line, "line", line_rows);
static const struct pp_attribute_rule grid_rows[] = {
    {"spacing", &pp_room_values_size, OR(0.5), IN(receiver, spacing_m)},
    {"margin", &pp_room_values_depth, OR(0.5), IN(receiver, margin_m)},
};
LEAF(grid, "grid", grid_rows);
static const struct pp_attribute_rule view_rows[] = {
    {"name", &text, OR(NAN), IN(view, name)},
    {"x", &pp_room_values_coordinate, REQUIRED, IN(view, x)},
    {"y", &pp_room_values_coordinate, REQUIRED, IN(view, y)},
    {"z", &pp_room_values_coordinate, OR(1.2), IN(view, z)},
    {"bearing", &pp_room_values_bearing, REQUIRED, IN(view, bearing_rad)},
};
LEAF(view, "view", view_rows);

static const struct pp_attribute_rule room_rows[] = {
    {"units", &pp_room_values_unit_of_lengths, OR(0),
     IN(room, units)}, /* root element only */
    {"version", &pp_room_values_version, OR(-1), IN(room, version)},
    {"name", &text, OR(NAN), IN(room, name)},
    {"north", &pp_room_values_bearing, OR(NAN), IN(room, north_rad)},
    {"ref", &text, OR(NAN), IN(room, ref)},
    {"address", &text, OR(NAN), IN(room, address)},
    {"use", &pp_room_values_use, OR(0), IN(room, use)},
    {"within", &file_name, OR(NAN), IN(room, within)},
    {"window", &face_name, OR(NAN), IN(room, window)},
    /* For rooms in a building only. */
    {"x", &pp_room_values_coordinate, OR(NAN), IN(room, x)},
    {"y", &pp_room_values_coordinate, OR(NAN), IN(room, y)},
    {"z", &pp_room_values_coordinate, OR(NAN), IN(room, z)},
    {"rotate", &pp_room_values_bearing, OR(NAN), IN(room, rotate_rad)},
    {"state", &pp_room_values_state, OR(0), IN(room, state)},
};
enum { BUILDING_ROWS = 5 };
static const struct pp_child_rule room_children[] = {
    {&pp_rule_site, 0, 1},      {&pp_rule_sky, 0, 1},
    {&pp_rule_plan, 0, 1},      {&pp_rule_envelope, 0, 1},
    {&pp_rule_finishes, 0, 1},  {&pp_rule_finish, 0, 0},
    {&pp_rule_wall, 0, 0},      {&pp_rule_window, 0, 0},
    {&pp_rule_rooflight, 0, 0}, {&pp_rule_opening, 0, 0},
    {&pp_rule_skyline, 0, 0},   {&pp_rule_facade, 0, 0},
    {&pp_rule_block, 0, 0},     {&pp_rule_surface, 0, 0},
    {&pp_rule_mesh, 0, 0},      {&pp_rule_garden, 0, 0},
    {&pp_rule_furniture, 0, 0}, {&pp_rule_column, 0, 0},
    {&pp_rule_partition, 0, 0}, {&pp_rule_door, 0, 0},
    {&pp_rule_dado, 0, 0},      {&pp_rule_working_plane, 0, 1},
    {&pp_rule_point, 0, 0},     {&pp_rule_line, 0, 0},
    {&pp_rule_grid, 0, 0},      {&pp_rule_view, 0, 0},
    {&pp_rule_grid, 0, 0},      {&pp_rule_material, 0, 0},
    {&pp_rule_project, 0, 1}, /* root element only */
};
enum { ROOM_ROWS = sizeof room_rows / sizeof *room_rows };
const struct pp_element_rule pp_rule_building_room = {
    "room", room_rows + 1, ROOM_ROWS - 1, room_children,
    sizeof room_children / sizeof *room_children - 1};
const struct pp_element_rule pp_rule_room = {
    "room", room_rows, ROOM_ROWS - BUILDING_ROWS, room_children,
    sizeof room_children / sizeof *room_children};

static const struct pp_attribute_rule building_rows[] = {
    {"units", &pp_room_values_unit_of_lengths, OR(0), IN(building, units)},
    {"version", &pp_room_values_version, REQUIRED, IN(building, version)},
    {"name", &text, OR(NAN), IN(building, name)},
    {"north", &pp_room_values_bearing, OR(NAN), IN(building, north_rad)},
    {"glass-reflectance", &pp_room_values_fraction, OR(NAN),
     IN(building, glass_reflectance)},
};
static const struct pp_child_rule building_children[] = {
    {&pp_rule_site, 0, 1},   {&pp_rule_sky, 0, 1},           {&pp_rule_skyline, 0, 0},
    {&pp_rule_block, 0, 0},  {&pp_rule_surface, 0, 0},       {&pp_rule_mesh, 0, 0},
    {&pp_rule_garden, 0, 0}, {&pp_rule_building_room, 1, 0}, {&pp_rule_material, 0, 0},
    {&pp_rule_project, 0, 1}};
RULE(building, "building", building_rows, building_children);
