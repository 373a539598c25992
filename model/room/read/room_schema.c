/* room_schema.c - see room_schema.h: the table. element_form.c reads elements by it. */
#include "model/room/read/room_schema.h"

#include <math.h>

#include "model/room/read/plan_roof.h"
#include "model/geometry/vec.h"
#include "model/room/room_use.h"
#include "model/room/sky_words.h"

/* Kinds of value */

static const struct pp_value_kind text = {
    .reading = PP_VALUE_TEXT, .expected = "a text without control characters"};
static const struct pp_value_kind wall = {.reading = PP_VALUE_NAME,
                                          .expected = "the name of a wall"};
static const struct pp_value_kind face_name = {.reading = PP_VALUE_NAME,
                                               .expected = "a name"};
static const struct pp_value_kind coordinate = {
    PP_VALUE_NUMBER, "a number of metres from -100000 to 100000",
    -PP_ROOM_LENGTH_MOST_M, PP_ROOM_LENGTH_MOST_M, .unit = 1.0};
static const struct pp_value_kind size = {
    PP_VALUE_NUMBER, "a number of metres from 0.001 to 100000", PP_ROOM_LENGTH_LEAST_M,
    PP_ROOM_LENGTH_MOST_M, .unit = 1.0};
static const struct pp_value_kind depth = {PP_VALUE_NUMBER,
                                           "a number of metres from 0 to 100000", 0.0,
                                           PP_ROOM_LENGTH_MOST_M, .unit = 1.0};
static const struct pp_value_kind component = {
    PP_VALUE_NUMBER, "a number from -100000 to 100000", -1e5, 1e5, .unit = 1.0};
static const struct pp_value_kind fraction = {PP_VALUE_NUMBER, "a fraction from 0 to 1",
                                              0.0, 1.0, .unit = 1.0};
static const struct pp_value_kind transmittance = {PP_VALUE_NUMBER,
                                                   "a fraction greater than 0, up to 1",
                                                   0.0,
                                                   1.0,
                                                   .above_least = true,
                                                   .unit = 1.0};
static const struct pp_value_kind bearing = {PP_VALUE_NUMBER,
                                             "a number of degrees from -360 to 360",
                                             -360.0, 360.0, .unit = PP_RAD};
static const struct pp_value_kind latitude = {
    PP_VALUE_NUMBER, "a number of degrees from -90 to 90", -90.0, 90.0, .unit = PP_RAD};
static const struct pp_value_kind longitude = {PP_VALUE_NUMBER,
                                               "a number of degrees from -180 to 180",
                                               -180.0, 180.0, .unit = PP_RAD};
static const struct pp_value_kind altitude = {
    PP_VALUE_NUMBER, "a number of degrees from 0 to 90", 0.0, 90.0, .unit = PP_RAD};
static const struct pp_value_kind skyline_angle = {
    PP_VALUE_NUMBER,
    "a number of degrees from 0 to less than 90",
    0.0,
    90.0,
    .below_most = true,
    .unit = PP_RAD};
static const struct pp_value_kind number_of_points = {
    PP_VALUE_COUNT, "a whole number from 2 to 100000", 2.0, PP_ROOM_POINTS_MOST,
    .unit = 1.0};
static const struct pp_value_kind position = {
    PP_VALUE_PAIR, "two numbers of metres \"X Y\", each from -100000 to 100000",
    -PP_ROOM_LENGTH_MOST_M, PP_ROOM_LENGTH_MOST_M, .unit = 1.0};
static const struct pp_value_kind reflectance = {
    PP_VALUE_REFLECTANCE, "a fraction from 0 to 1 or a named finish", 0.0, 1.0,
    .unit = 1.0};
static const struct pp_value_kind or_auto = {
    PP_VALUE_AUTO, "a fraction from 0 to 1 or \"auto\"", 0.0, 1.0, .unit = 1.0};
static const struct pp_value_kind frame = {PP_VALUE_FACTOR,
                                           "a fraction from 0 to 1 or a named frame",
                                           0.0,
                                           1.0,
                                           .unit = 1.0,
                                           .factors = &pp_frames};
static const struct pp_value_kind curtains = {
    PP_VALUE_FACTOR,
    "a fraction from 0 to 1 or named curtains",
    0.0,
    1.0,
    .unit = 1.0,
    .factors = &pp_curtains};
static const struct pp_value_kind glazing = {.reading = PP_VALUE_GLAZING,
                                             .expected = "a named glazing or \"none\""};

static const char *const versions[] = {"1", NULL};
static const struct pp_value_kind version = {
    .reading = PP_VALUE_CHOICE, .expected = "\"1\"", .words = versions};
static const char *const no_yes[] = {"no", "yes", NULL};
static const struct pp_value_kind yes_no = {
    .reading = PP_VALUE_CHOICE, .expected = "\"yes\" or \"no\"", .words = no_yes};
/* In the order of enum pp_role, of enum pp_surroundings, and of enum pp_work. */
static const char *const roles[] = {"floor", "wall", "ceiling", NULL};
static const struct pp_value_kind role = {.reading = PP_VALUE_CHOICE,
                                          .expected =
                                              "\"floor\", \"wall\" or \"ceiling\"",
                                          .words = roles};
static const char *const places[] = {"rural", "urban", "industrial", NULL};
static const struct pp_value_kind surroundings = {
    .reading = PP_VALUE_CHOICE,
    .expected = "\"rural\", \"urban\" or \"industrial\"",
    .words = places};
static const struct pp_value_kind country = {
    .reading = PP_VALUE_NAME, .expected = "two capital letters, such as \"GB\""};
static const char *const works[] = {"clean", "dirty", NULL};
static const struct pp_value_kind work = {
    .reading = PP_VALUE_CHOICE, .expected = "\"clean\" or \"dirty\"", .words = works};
static const char *const dirt_editions[] = {"bre-309", "bs-8206", NULL};
static const struct pp_value_kind dirt_edition = {.reading = PP_VALUE_CHOICE,
                                                  .expected =
                                                      "\"bre-309\" or \"bs-8206\"",
                                                  .words = dirt_editions};
static const char *const grounds[] = {"shaded", "open", NULL};
static const struct pp_value_kind ground_kind = {
    .reading = PP_VALUE_CHOICE, .expected = "\"shaded\" or \"open\"", .words = grounds};
static const char *const states[] = {"both", "existing", "proposed", NULL};
static const struct pp_value_kind state = {.reading = PP_VALUE_CHOICE,
                                           .expected =
                                               "\"existing\", \"proposed\" or \"both\"",
                                           .words = states};
static const struct pp_value_kind use = {
    .reading = PP_VALUE_CHOICE,
    .expected = "\"bedroom\", \"living-room\", \"dining-room\", \"kitchen\", "
                "\"living-kitchen\", \"studio\", \"study\", \"office\", "
                "\"meeting-room\", \"classroom\", \"ward\", \"shop\", \"workshop\", "
                "\"bathroom\", \"circulation\", \"store\", \"other\" or \"unknown\"",
    .words = pp_room_use_words};
static const char *const sides[] = {"both", "left", "right", NULL};
static const struct pp_value_kind side = {.reading = PP_VALUE_CHOICE,
                                          .expected = "\"both\", \"left\" or \"right\"",
                                          .words = sides};
static const char *const wall_kinds[] = {"outer", "inner", "party", NULL};
static const struct pp_value_kind wall_kind = {.reading = PP_VALUE_CHOICE,
                                               .expected =
                                                   "\"outer\", \"inner\" or \"party\"",
                                               .words = wall_kinds};
static const char *const roofs[] = {"flat", "mono", "gable", "hip", NULL};
static const struct pp_value_kind roof = {
    .reading = PP_VALUE_CHOICE,
    .expected = "\"flat\", \"mono\", \"gable\" or \"hip\"",
    .words = roofs};
static const char *const plan_roofs[] = {"flat", "mono",      "gable",
                                         "hip",  "saw-tooth", NULL};
static const struct pp_value_kind plan_roof = {
    .reading = PP_VALUE_CHOICE,
    .expected = "\"flat\", \"mono\", \"gable\", \"hip\" or \"saw-tooth\"",
    .words = plan_roofs};
static const struct pp_value_kind teeth = {PP_VALUE_COUNT,
                                           "a whole number from 1 to 50", 1.0,
                                           PP_PLAN_ROOF_TEETH_MOST, .unit = 1.0};
static const char *const ridges[] = {"longer", "width", "depth", NULL};
static const struct pp_value_kind ridge = {.reading = PP_VALUE_CHOICE,
                                           .expected =
                                               "\"longer\", \"width\" or \"depth\"",
                                           .words = ridges};
static const struct pp_value_kind pitch = {.reading = PP_VALUE_NUMBER,
                                           .expected =
                                               "a number of degrees above 0, up to 85",
                                           .least = 0.0,
                                           .most = 85.0,
                                           .above_least = true,
                                           .unit = PP_RAD};
static const struct pp_value_kind sky_type = {
    .reading = PP_VALUE_CHOICE,
    .expected = "\"overcast\", \"uniform\" or \"iso-1\" to \"iso-15\"",
    .words = pp_sky_words};

/* Elements */

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

static const struct pp_attribute_rule site_rows[] = {
    {"latitude", &latitude, OR(NAN), IN(site, latitude_rad)},
    {"longitude", &longitude, OR(NAN), IN(site, longitude_rad)},
    {"country", &country, OR(NAN), IN(site, country)},
    {"surroundings", &surroundings, OR(0), IN(site, surroundings)},
    {"work", &work, OR(-1), IN(site, work)},
    {"ground-reflectance", &reflectance, OR(0.2), IN(site, ground)},
    {"ground-level", &coordinate, OR(0), IN(site, ground_level_m)},
    {"ground", &ground_kind, OR(0), IN(site, ground_is_open)},
    {"dirt", &dirt_edition, OR(0), IN(site, dirt)},
};
LEAF(site, "site", site_rows);

static const struct pp_attribute_rule sky_rows[] = {
    {"type", &sky_type, OR(0), IN(sky, type)},
    {"sun-altitude", &altitude, OR(NAN), IN(sky, sun_altitude_rad)},
    {"sun-bearing", &bearing, OR(NAN), IN(sky, sun_bearing_rad)},
};
LEAF(sky, "sky", sky_rows);

static const struct pp_attribute_rule vertex_rows[] = {
    {"x", &coordinate, REQUIRED, IN(vertex, x)},
    {"y", &coordinate, REQUIRED, IN(vertex, y)},
    {"z", &coordinate, REQUIRED, IN(vertex, z)},
};
LEAF(vertex, "vertex", vertex_rows);
const struct pp_element_rule pp_rule_plan_vertex = {"vertex", vertex_rows, 2, NULL, 0};

static const struct pp_child_rule polygon[] = {
    {&pp_rule_vertex, 3, PP_ROOM_VERTICES_MOST}};

static const struct pp_attribute_rule plan_rows[] = {
    {"width", &size, OR(NAN), IN(plan, width_m)},
    {"depth", &size, OR(NAN), IN(plan, depth_m)},
    {"height", &size, REQUIRED, IN(plan, height_m)},
    {"roof", &plan_roof, OR(0), IN(plan, roof)},
    {"pitch", &pitch, OR(NAN), IN(plan, pitch_rad)},
    {"ridge", &ridge, OR(0), IN(plan, ridge)},
    {"teeth", &teeth, OR(0), IN(plan, teeth)},
};
static const struct pp_child_rule plan_children[] = {
    {&pp_rule_plan_vertex, 0, PP_ROOM_VERTICES_MOST}};
RULE(plan, "plan", plan_rows, plan_children);

static const struct pp_attribute_rule face_rows[] = {
    {"role", &role, REQUIRED, IN(face, role)},
    {"name", &face_name, REQUIRED, IN(face, name)},
    {"reflectance", &reflectance, OR(NAN), IN(face, finish)},
};
RULE(face, "face", face_rows, polygon);
static const struct pp_child_rule envelope_children[] = {
    {&pp_rule_face, 4, PP_ROOM_VERTICES_MOST}};
const struct pp_element_rule pp_rule_envelope = {"envelope", NULL, 0, envelope_children,
                                                 1};

static const struct pp_attribute_rule finishes_rows[] = {
    {"floor", &reflectance, OR(0.2), IN(finishes, floor)},
    {"walls", &reflectance, OR(0.5), IN(finishes, walls)},
    {"ceiling", &reflectance, OR(0.7), IN(finishes, ceiling)},
    {"decorations", &or_auto, OR(1), IN(finishes, decorations)},
};
LEAF(finishes, "finishes", finishes_rows);

static const struct pp_attribute_rule finish_rows[] = {
    {"wall", &wall, REQUIRED, IN(finish, wall)},
    {"reflectance", &reflectance, REQUIRED, IN(finish, finish)},
};
LEAF(finish, "finish", finish_rows);

static const struct pp_attribute_rule wall_rows[] = {
    {"name", &wall, REQUIRED, IN(wall, name)},
    {"kind", &wall_kind, REQUIRED, IN(wall, kind)},
};
LEAF(wall, "wall", wall_rows);

#define GLAZING_ROWS                                                                   \
    {"glazing", &glazing, OR(NAN), IN(opening, glazing)},                              \
        {"transmittance", &transmittance, OR(NAN), IN(opening, transmittance)},        \
        {"diffusing", &yes_no, OR(-1), IN(opening, diffusing)},                        \
        {"frame-factor", &frame, OR(1), IN(opening, frame_factor)},                    \
        {"maintenance", &or_auto, OR(1), IN(opening, maintenance)},                    \
        {"curtains", &curtains, OR(1), IN(opening, curtains)},                         \
        {"reveal", &depth, OR(0), IN(opening, reveal_m)},                              \
    {                                                                                  \
        "name", &text, OR(NAN), IN(opening, name)                                      \
    }
static const struct pp_attribute_rule window_rows[] = {
    {"wall", &wall, REQUIRED, IN(opening, wall)},
    {"left", &coordinate, REQUIRED, IN(opening, left_m)},
    {"sill", &coordinate, REQUIRED, IN(opening, sill_m)},
    {"width", &size, REQUIRED, IN(opening, width_m)},
    {"height", &size, REQUIRED, IN(opening, height_m)},
    GLAZING_ROWS,
};
static const struct pp_attribute_rule overhang_rows[] = {
    {"depth", &size, REQUIRED, IN(shade, depth_m)},
    {"above", &depth, OR(0), IN(shade, above_m)},
    {"left", &depth, OR(0), IN(shade, left_m)},
    {"right", &depth, OR(0), IN(shade, right_m)},
    {"reflectance", &reflectance, OR(0.2), IN(shade, finish)},
};
LEAF(overhang, "overhang", overhang_rows);
static const struct pp_attribute_rule fin_rows[] = {
    {"depth", &size, REQUIRED, IN(shade, depth_m)},
    {"side", &side, OR(0), IN(shade, side)},
    {"gap", &depth, OR(0), IN(shade, left_m)},
    {"above", &depth, OR(0), IN(shade, above_m)},
    {"below", &depth, OR(0), IN(shade, below_m)},
    {"reflectance", &reflectance, OR(0.2), IN(shade, finish)},
};
LEAF(fin, "fin", fin_rows);
static const struct pp_attribute_rule balcony_rows[] = {
    {"depth", &size, REQUIRED, IN(shade, depth_m)},
    {"left", &depth, OR(0), IN(shade, left_m)},
    {"right", &depth, OR(0), IN(shade, right_m)},
    {"level", &coordinate, OR(0), IN(shade, height_m)},
    {"parapet", &depth, OR(1.1), IN(shade, parapet_m)},
    {"reflectance", &reflectance, OR(0.2), IN(shade, finish)},
};
LEAF(balcony, "balcony", balcony_rows);
static const struct pp_attribute_rule shelf_rows[] = {
    {"height", &size, REQUIRED, IN(shade, height_m)},
    {"depth", &depth, OR(0.5), IN(shade, depth_m)},
    {"inside", &depth, OR(0), IN(shade, inside_m)},
    {"left", &depth, OR(0), IN(shade, left_m)},
    {"right", &depth, OR(0), IN(shade, right_m)},
    {"reflectance", &reflectance, OR(0.7), IN(shade, finish)},
};
LEAF(shelf, "shelf", shelf_rows);
static const struct pp_child_rule window_children[] = {{&pp_rule_overhang, 0, 0},
                                                       {&pp_rule_fin, 0, 0},
                                                       {&pp_rule_balcony, 0, 0},
                                                       {&pp_rule_shelf, 0, 0}};
RULE(window, "window", window_rows, window_children);
static const struct pp_attribute_rule rooflight_rows[] = {
    {"x", &coordinate, REQUIRED, IN(opening, x)},
    {"y", &coordinate, REQUIRED, IN(opening, y)},
    {"width", &size, REQUIRED, IN(opening, width_m)},
    {"depth", &size, REQUIRED, IN(opening, depth_m)},
    GLAZING_ROWS,
};
LEAF(rooflight, "rooflight", rooflight_rows);
static const struct pp_attribute_rule opening_rows[] = {GLAZING_ROWS};
RULE(opening, "opening", opening_rows, polygon);

static const struct pp_attribute_rule skyline_rows[] = {
    {"wall", &wall, REQUIRED, IN(skyline, wall)},
    {"angle", &skyline_angle, REQUIRED, IN(skyline, angle_rad)},
    {"distance", &size, OR(INFINITY), IN(skyline, distance_m)},
    {"reflectance", &reflectance, OR(0.2), IN(skyline, finish)},
    {"state", &state, OR(0), IN(skyline, state)},
};
LEAF(skyline, "skyline", skyline_rows);

static const struct pp_attribute_rule facade_rows[] = {
    {"wall", &wall, REQUIRED, IN(facade, wall)},
    {"left", &depth, OR(0), IN(facade, left_m)},
    {"right", &depth, OR(0), IN(facade, right_m)},
    {"up", &depth, OR(0), IN(facade, up_m)},
    {"down", &depth, OR(0), IN(facade, down_m)},
    {"depth", &depth, OR(NAN), IN(facade, depth_m)}, /* then the largest reveal */
    {"reflectance", &reflectance, OR(0.2), IN(facade, finish)},
};
LEAF(facade, "facade", facade_rows);

static const struct pp_attribute_rule block_rows[] = {
    {"x", &coordinate, REQUIRED, IN(block, x)},
    {"y", &coordinate, REQUIRED, IN(block, y)},
    {"width", &size, REQUIRED, IN(block, width_m)},
    {"depth", &size, REQUIRED, IN(block, depth_m)},
    {"base", &coordinate, OR(NAN), IN(block, base)}, /* then the ground's level */
    {"height", &size, REQUIRED, IN(block, height_m)},
    {"rotate", &bearing, OR(0), IN(block, rotate_rad)},
    {"reflectance", &reflectance, OR(0.2), IN(block, finish)},
    {"name", &text, OR(NAN), IN(block, name)},
    {"state", &state, OR(0), IN(block, state)},
    {"roof", &roof, OR(0), IN(block, roof)},
    {"pitch", &pitch, OR(NAN), IN(block, pitch_rad)},
    {"ridge", &ridge, OR(0), IN(block, ridge)},
};
LEAF(block, "block", block_rows);
static const struct pp_attribute_rule footprint_rows[] = {
    {"x", &coordinate, OR(0), IN(block, x)},
    {"y", &coordinate, OR(0), IN(block, y)},
    {"base", &coordinate, OR(NAN), IN(block, base)},
    {"height", &size, REQUIRED, IN(block, height_m)},
    {"rotate", &bearing, OR(0), IN(block, rotate_rad)},
    {"reflectance", &reflectance, OR(0.2), IN(block, finish)},
    {"name", &text, OR(NAN), IN(block, name)},
    {"state", &state, OR(0), IN(block, state)},
};
static const struct pp_child_rule footprint[] = {
    {&pp_rule_plan_vertex, 3, PP_ROOM_VERTICES_MOST}};
RULE(footprint, "block", footprint_rows, footprint);

static const struct pp_attribute_rule surface_rows[] = {
    {"reflectance", &reflectance, OR(0.2), IN(surface, finish)},
    {"exitance", &fraction, OR(0), IN(surface, exitance)},
    {"name", &text, OR(NAN), IN(surface, name)},
    {"state", &state, OR(0), IN(surface, state)},
};
RULE(surface, "surface", surface_rows, polygon);

static const struct pp_attribute_rule garden_rows[] = {
    {"name", &text, OR(NAN), IN(garden, name)},
    {"state", &state, OR(0), IN(garden, state)},
};
static const struct pp_child_rule garden_children[] = {
    {&pp_rule_plan_vertex, 3, PP_ROOM_VERTICES_MOST}};
RULE(garden, "garden", garden_rows, garden_children);

static const struct pp_attribute_rule plane_rows[] = {
    {"height", &coordinate, OR(0.85), IN(plane, height_m)},
};
LEAF(working_plane, "working-plane", plane_rows);

static const struct pp_attribute_rule furniture_rows[] = {
    {"x", &coordinate, REQUIRED, IN(fitting, x)},
    {"y", &coordinate, REQUIRED, IN(fitting, y)},
    {"z", &coordinate, OR(0), IN(fitting, z)},
    {"width", &size, REQUIRED, IN(fitting, width_m)},
    {"depth", &size, REQUIRED, IN(fitting, depth_m)},
    {"height", &size, REQUIRED, IN(fitting, height_m)},
    {"rotate", &bearing, OR(0), IN(fitting, rotate_rad)},
    {"reflectance", &reflectance, OR(0.3), IN(fitting, finish)},
    {"name", &text, OR(NAN), IN(fitting, name)},
};
LEAF(furniture, "furniture", furniture_rows);
static const struct pp_attribute_rule column_rows[] = {
    {"x", &coordinate, REQUIRED, IN(fitting, x)},
    {"y", &coordinate, REQUIRED, IN(fitting, y)},
    {"width", &size, OR(NAN), IN(fitting, width_m)},
    {"depth", &size, OR(NAN), IN(fitting, depth_m)},
    {"diameter", &size, OR(NAN), IN(fitting, diameter_m)},
    {"height", &size, OR(NAN), IN(fitting, height_m)},
    {"rotate", &bearing, OR(0), IN(fitting, rotate_rad)},
    {"reflectance", &reflectance, OR(NAN), IN(fitting, finish)},
    {"name", &text, OR(NAN), IN(fitting, name)},
};
LEAF(column, "column", column_rows);
static const struct pp_attribute_rule partition_rows[] = {
    {"from", &position, REQUIRED, IN(fitting, from)},
    {"to", &position, REQUIRED, IN(fitting, to)},
    {"thickness", &size, OR(0.1), IN(fitting, thickness_m)},
    {"height", &size, OR(NAN), IN(fitting, height_m)},
    {"reflectance", &reflectance, OR(NAN), IN(fitting, finish)},
    {"name", &text, OR(NAN), IN(fitting, name)},
};
LEAF(partition, "partition", partition_rows);

static const struct pp_attribute_rule point_rows[] = {
    {"x", &coordinate, REQUIRED, IN(receiver, x)},
    {"y", &coordinate, REQUIRED, IN(receiver, y)},
    {"z", &coordinate, OR(NAN), IN(receiver, z)},
    {"nx", &component, OR(NAN), IN(receiver, nx)},
    {"ny", &component, OR(NAN), IN(receiver, ny)},
    {"nz", &component, OR(NAN), IN(receiver, nz)},
};
LEAF(point, "point", point_rows);
static const struct pp_attribute_rule line_rows[] = {
    {"from", &position, REQUIRED, IN(receiver, from)},
    {"to", &position, REQUIRED, IN(receiver, to)},
    {"points", &number_of_points, REQUIRED, IN(receiver, points)},
};
LEAF(line, "line", line_rows);
static const struct pp_attribute_rule grid_rows[] = {
    {"spacing", &size, OR(0.5), IN(receiver, spacing_m)},
    {"margin", &depth, OR(0.5), IN(receiver, margin_m)},
};
LEAF(grid, "grid", grid_rows);

static const struct pp_attribute_rule room_rows[] = {
    {"version", &version, OR(-1), IN(room, version)},
    {"name", &text, OR(NAN), IN(room, name)},
    {"north", &bearing, OR(NAN), IN(room, north_rad)},
    {"ref", &text, OR(NAN), IN(room, ref)},
    {"use", &use, OR(0), IN(room, use)},
    /* Those that follow are of rooms in a building. */
    {"x", &coordinate, OR(NAN), IN(room, x)},
    {"y", &coordinate, OR(NAN), IN(room, y)},
    {"z", &coordinate, OR(NAN), IN(room, z)},
    {"rotate", &bearing, OR(NAN), IN(room, rotate_rad)},
    {"state", &state, OR(0), IN(room, state)},
};
enum { BUILDING_ROWS = 5 };
static const struct pp_child_rule room_children[] = {
    {&pp_rule_site, 0, 1},          {&pp_rule_sky, 0, 1},
    {&pp_rule_plan, 0, 1},          {&pp_rule_envelope, 0, 1},
    {&pp_rule_finishes, 0, 1},      {&pp_rule_finish, 0, 0},
    {&pp_rule_wall, 0, 0},          {&pp_rule_window, 0, 0},
    {&pp_rule_rooflight, 0, 0},     {&pp_rule_opening, 0, 0},
    {&pp_rule_skyline, 0, 0},       {&pp_rule_facade, 0, 0},
    {&pp_rule_block, 0, 0},         {&pp_rule_surface, 0, 0},
    {&pp_rule_garden, 0, 0},        {&pp_rule_furniture, 0, 0},
    {&pp_rule_column, 0, 0},        {&pp_rule_partition, 0, 0},
    {&pp_rule_working_plane, 0, 1}, {&pp_rule_point, 0, 0},
    {&pp_rule_line, 0, 0},          {&pp_rule_grid, 0, 0},
};
RULE(building_room, "room", room_rows, room_children);
const struct pp_element_rule pp_rule_room = {
    "room", room_rows, sizeof room_rows / sizeof *room_rows - BUILDING_ROWS,
    room_children, sizeof room_children / sizeof *room_children};

static const struct pp_attribute_rule building_rows[] = {
    {"version", &version, REQUIRED, IN(building, version)},
    {"name", &text, OR(NAN), IN(building, name)},
    {"north", &bearing, OR(NAN), IN(building, north_rad)},
};
static const struct pp_child_rule building_children[] = {
    {&pp_rule_site, 0, 1},         {&pp_rule_sky, 0, 1},     {&pp_rule_skyline, 0, 0},
    {&pp_rule_block, 0, 0},        {&pp_rule_surface, 0, 0}, {&pp_rule_garden, 0, 0},
    {&pp_rule_building_room, 1, 0}};
RULE(building, "building", building_rows, building_children);
