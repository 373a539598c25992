/* room_schema.c - the tables of elements and attributes, according to which
 * element_form.c reads elements. room_schema_outside.c has those outside a room. */
#include "model/room/read/schema_rows.h"

#include "model/geometry/vec.h"
#include "model/room/room_use.h"
#include "model/room/sky_words.h"

static const struct pp_attribute_rule project_rows[PP_PROJECT_FACTS] = {
    {"name", &pp_room_values_text, OR(NAN), IN(project, facts[0])},
    {"client", &pp_room_values_text, OR(NAN), IN(project, facts[1])},
    {"number", &pp_room_values_text, OR(NAN), IN(project, facts[2])},
    {"author", &pp_room_values_text, OR(NAN), IN(project, facts[3])},
    {"checked", &pp_room_values_text, OR(NAN), IN(project, facts[4])},
    {"date", &pp_room_values_text, OR(NAN), IN(project, facts[5])},
    {"revision", &pp_room_values_text, OR(NAN), IN(project, facts[6])},
};
LEAF(project, "project", project_rows);

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
    {"name", &pp_room_values_face_name, REQUIRED, IN(face, name)},
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
    {"wall", &pp_room_values_wall_name, REQUIRED, IN(finish, wall)},
    {"reflectance", &pp_room_values_reflectance, REQUIRED, IN(finish, finish)},
};
LEAF(finish, "finish", finish_rows);

static const struct pp_attribute_rule material_rows[] = {
    {"name", &pp_room_values_face_name, REQUIRED, IN(material, name)},
    {"n", &pp_room_values_refractive_index, OR(0), IN(material, n)},
    {"k", &pp_room_values_extinction, OR(0), IN(material, k)},
    {"roughness", &pp_room_values_roughness, OR(0), IN(material, roughness_um)},
    {"correlation-length", &pp_room_values_correlation, OR(0),
     IN(material, correlation_um)},
    {"diffuse", &pp_room_values_diffuse, OR(0), IN(material, diffuse)},
    {"wavelength", &pp_room_values_wavelength, OR(0), IN(material, wavelength_um)},
    {"pattern", &pp_room_values_pattern, OR(NAN), IN(material, pattern)},
    {"bump", &pp_room_values_pattern, OR(NAN), IN(material, bump)},
};
LEAF(material, "material", material_rows);

static const struct pp_attribute_rule wall_rows[] = {
    {"name", &pp_room_values_wall_name, REQUIRED, IN(wall, name)},
    {"kind", &pp_room_values_wall_kind, REQUIRED, IN(wall, kind)},
};
LEAF(wall, "wall", wall_rows);

#define GLAZING_ROWS                                                                   \
    {"glazing", &pp_room_values_glazing, OR(NAN), IN(opening, glazing)},               \
        {"transmittance", &pp_room_values_transmittance, OR(NAN),                      \
         IN(opening, transmittance)},                                                  \
        {"glazing-file", &pp_room_values_file_name, OR(NAN),                           \
         IN(opening, glazing_file)},                                                   \
        {"glazing-peak", &pp_room_values_peak, OR(0), IN(opening, peak)},              \
        {"diffusing", &pp_room_values_yes_no, OR(-1), IN(opening, diffusing)},         \
        {"absorbing", &pp_room_values_yes_no, OR(-1), IN(opening, absorbing)},         \
        {"frame-factor", &pp_room_values_frame, OR(1), IN(opening, frame_factor)},     \
        {"maintenance", &pp_room_values_or_auto, OR(1), IN(opening, maintenance)},     \
        {"curtains", &pp_room_values_curtains, OR(1), IN(opening, curtains)},          \
        {"reveal", &pp_room_values_depth, OR(0), IN(opening, reveal_m)},               \
    {                                                                                  \
        "name", &pp_room_values_text, OR(NAN), IN(opening, name)                       \
    }
static const struct pp_attribute_rule window_rows[] = {
    {"wall", &pp_room_values_wall_name, REQUIRED, IN(opening, wall)},
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
    {"reflectance", &pp_room_values_even_reflectance, OR(0.2), IN(shade, finish)},
};
LEAF(overhang, "overhang", overhang_rows);
static const struct pp_attribute_rule fin_rows[] = {
    {"depth", &pp_room_values_size, REQUIRED, IN(shade, depth_m)},
    {"side", &pp_room_values_side, OR(0), IN(shade, side)},
    {"gap", &pp_room_values_depth, OR(0), IN(shade, left_m)},
    {"above", &pp_room_values_depth, OR(0), IN(shade, above_m)},
    {"below", &pp_room_values_depth, OR(0), IN(shade, below_m)},
    {"reflectance", &pp_room_values_even_reflectance, OR(0.2), IN(shade, finish)},
};
LEAF(fin, "fin", fin_rows);
static const struct pp_attribute_rule balcony_rows[] = {
    {"depth", &pp_room_values_size, REQUIRED, IN(shade, depth_m)},
    {"left", &pp_room_values_depth, OR(0), IN(shade, left_m)},
    {"right", &pp_room_values_depth, OR(0), IN(shade, right_m)},
    {"level", &pp_room_values_coordinate, OR(0), IN(shade, height_m)},
    {"parapet", &pp_room_values_depth, OR(1.1), IN(shade, parapet_m)},
    {"reflectance", &pp_room_values_even_reflectance, OR(0.2), IN(shade, finish)},
};
LEAF(balcony, "balcony", balcony_rows);
static const struct pp_attribute_rule shelf_rows[] = {
    {"height", &pp_room_values_size, REQUIRED, IN(shade, height_m)},
    {"depth", &pp_room_values_depth, OR(0.5), IN(shade, depth_m)},
    {"inside", &pp_room_values_depth, OR(0), IN(shade, inside_m)},
    {"left", &pp_room_values_depth, OR(0), IN(shade, left_m)},
    {"right", &pp_room_values_depth, OR(0), IN(shade, right_m)},
    {"reflectance", &pp_room_values_even_reflectance, OR(0.7), IN(shade, finish)},
};
LEAF(shelf, "shelf", shelf_rows);
static const struct pp_attribute_rule blind_rows[] = {
    {"slat-width", &pp_room_values_size, OR(0.025), IN(blind, width_m)},
    {"spacing", &pp_room_values_size, OR(NAN), IN(blind, spacing_m)},
    {"angle", &pp_room_values_slat_angle, OR(NAN), IN(blind, angle_rad)},
    {"cut-off", &pp_room_values_yes_no, OR(0), IN(blind, cut_off)},
    {"curvature", &pp_room_values_coordinate, OR(0), IN(blind, curvature_m)},
    {"reflectance", &pp_room_values_even_reflectance, OR(0.5), IN(blind, upper)},
    {"reflectance-below", &pp_room_values_even_reflectance, OR(NAN), IN(blind, lower)},
    {"direction", &pp_room_values_slat_direction, OR(0), IN(blind, direction)},
    {"position", &pp_room_values_device_position, OR(0), IN(blind, position)},
};
LEAF(blind, "blind", blind_rows);
static const struct pp_attribute_rule screen_rows[] = {
    {"openness", &pp_room_values_fraction, REQUIRED, IN(screen, openness)},
    {"reflectance", &pp_room_values_even_reflectance, OR(0.5), IN(screen, finish)},
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
    {"name", &pp_room_values_text, OR(NAN), IN(fitting, name)},
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
    {"name", &pp_room_values_text, OR(NAN), IN(fitting, name)},
};
LEAF(column, "column", column_rows);
static const struct pp_attribute_rule partition_rows[] = {
    {"from", &pp_room_values_position, REQUIRED, IN(fitting, from)},
    {"to", &pp_room_values_position, REQUIRED, IN(fitting, to)},
    {"thickness", &pp_room_values_size, OR(0.1), IN(fitting, thickness_m)},
    {"height", &pp_room_values_size, OR(NAN), IN(fitting, height_m)},
    {"reflectance", &pp_room_values_reflectance, OR(NAN), IN(fitting, finish)},
    {"name", &pp_room_values_text, OR(NAN), IN(fitting, name)},
};
LEAF(partition, "partition", partition_rows);

static const struct pp_attribute_rule door_rows[] = {
    {"wall", &pp_room_values_wall_name, REQUIRED, IN(cover, wall)},
    {"left", &pp_room_values_coordinate, REQUIRED, IN(cover, left_m)},
    {"width", &pp_room_values_size, OR(0.9), IN(cover, width_m)},
    {"height", &pp_room_values_size, OR(2.1), IN(cover, height_m)},
    {"reflectance", &pp_room_values_reflectance, OR(0.3), IN(cover, finish)},
    {"name", &pp_room_values_text, OR(NAN), IN(cover, name)},
};
LEAF(door, "door", door_rows);
static const struct pp_attribute_rule dado_rows[] = {
    {"wall", &pp_room_values_wall_name, OR(NAN), IN(cover, wall)},
    {"height", &pp_room_values_size, OR(1), IN(cover, height_m)},
    {"reflectance", &pp_room_values_reflectance, REQUIRED, IN(cover, finish)},
    {"name", &pp_room_values_text, OR(NAN), IN(cover, name)},
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
    {"name", &pp_room_values_text, OR(NAN), IN(view, name)},
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
    {"name", &pp_room_values_text, OR(NAN), IN(room, name)},
    {"north", &pp_room_values_bearing, OR(NAN), IN(room, north_rad)},
    {"ref", &pp_room_values_text, OR(NAN), IN(room, ref)},
    {"address", &pp_room_values_text, OR(NAN), IN(room, address)},
    {"use", &pp_room_values_use, OR(0), IN(room, use)},
    {"within", &pp_room_values_file_name, OR(NAN), IN(room, within)},
    {"window", &pp_room_values_face_name, OR(NAN), IN(room, window)},
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
    {&pp_rule_outline, 0, 0},   {&pp_rule_material, 0, 0},
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
    {"name", &pp_room_values_text, OR(NAN), IN(building, name)},
    {"north", &pp_room_values_bearing, OR(NAN), IN(building, north_rad)},
    {"glass-reflectance", &pp_room_values_fraction, OR(NAN),
     IN(building, glass_reflectance)},
};
static const struct pp_child_rule building_children[] = {
    {&pp_rule_site, 0, 1},    {&pp_rule_sky, 0, 1},           {&pp_rule_skyline, 0, 0},
    {&pp_rule_block, 0, 0},   {&pp_rule_surface, 0, 0},       {&pp_rule_mesh, 0, 0},
    {&pp_rule_garden, 0, 0},  {&pp_rule_building_room, 1, 0}, {&pp_rule_material, 0, 0},
    {&pp_rule_outline, 0, 0}, {&pp_rule_project, 0, 1}};
RULE(building, "building", building_rows, building_children);
