/* room_values.c - see room_values.h. */
#include "model/room/read/room_values.h"

#include <math.h>

#include "model/geometry/vec.h"
#include "model/room/corrections.h"
#include "model/room/read/plan_roof.h"
#include "model/room/room_use.h"
#include "model/room/sky_words.h"

const struct pp_value_kind pp_room_values_text = {
    .reading = PP_VALUE_TEXT, .expected = "text without control characters"};
const struct pp_value_kind pp_room_values_wall_name = {
    .reading = PP_VALUE_NAME, .expected = "the name of a wall"};
const struct pp_value_kind pp_room_values_face_name = {.reading = PP_VALUE_NAME,
                                                       .expected = "a name"};
const struct pp_value_kind pp_room_values_file_name = {
    .reading = PP_VALUE_NAME, .expected = "the name of a file"};
const struct pp_value_kind pp_room_values_coordinate = {
    PP_VALUE_NUMBER,
    "a number of metres from -100000 to 100000",

    -PP_ROOM_LENGTH_MOST_M,
    PP_ROOM_LENGTH_MOST_M,
    .unit = 1.0,
    .expected_mm = "a number of millimetres from -100000000 to 100000000"};
const struct pp_value_kind pp_room_values_size = {
    PP_VALUE_NUMBER,
    "a number of metres from 0.001 to 100000",
    PP_ROOM_LENGTH_LEAST_M,
    PP_ROOM_LENGTH_MOST_M,
    .unit = 1.0,
    .expected_mm = "a number of millimetres from 1 to 100000000"};
const struct pp_value_kind pp_room_values_depth = {
    PP_VALUE_NUMBER,
    "a number of metres from 0 to 100000",
    0.0,
    PP_ROOM_LENGTH_MOST_M,
    .unit = 1.0,
    .expected_mm = "a number of millimetres from 0 to 100000000"};
const struct pp_value_kind pp_room_values_component = {
    PP_VALUE_NUMBER, "a number from -100000 to 100000", -1e5, 1e5, .unit = 1.0};
const struct pp_value_kind pp_room_values_fraction = {
    PP_VALUE_NUMBER, "a fraction from 0 to 1", 0.0, 1.0, .unit = 1.0};
const struct pp_value_kind pp_room_values_transmittance = {
    PP_VALUE_NUMBER,
    "a fraction greater than 0, up to 1",
    0.0,
    1.0,
    .above_least = true,
    .unit = 1.0};
const struct pp_value_kind pp_room_values_bearing = {
    PP_VALUE_NUMBER, "a number of degrees from -360 to 360", -360.0, 360.0,
    .unit = PP_RAD};
const struct pp_value_kind pp_room_values_latitude = {
    PP_VALUE_NUMBER, "a number of degrees from -90 to 90", -90.0, 90.0, .unit = PP_RAD};
const struct pp_value_kind pp_room_values_longitude = {
    PP_VALUE_NUMBER, "a number of degrees from -180 to 180", -180.0, 180.0,
    .unit = PP_RAD};
const struct pp_value_kind pp_room_values_altitude = {
    PP_VALUE_NUMBER, "a number of degrees from 0 to 90", 0.0, 90.0, .unit = PP_RAD};
const struct pp_value_kind pp_room_values_skyline_angle = {
    PP_VALUE_NUMBER,
    "a number of degrees from 0 to less than 90",
    0.0,
    90.0,
    .below_most = true,
    .unit = PP_RAD};
const struct pp_value_kind pp_room_values_number_of_points = {
    PP_VALUE_COUNT, "a whole number from 2 to 100000", 2.0, PP_ROOM_POINTS_MOST,
    .unit = 1.0};
const struct pp_value_kind pp_room_values_position = {
    PP_VALUE_PAIR,
    "two numbers of metres \"X Y\", each from -100000 to 100000",

    -PP_ROOM_LENGTH_MOST_M,
    PP_ROOM_LENGTH_MOST_M,
    .unit = 1.0,
    .expected_mm =
        "two numbers of millimetres \"X Y\", each from -100000000 to 100000000"};
#define EXPECTED_REFLECTANCE                                                           \
    "a fraction from 0 to 1, a named finish, "                                         \
    "or # and the name of a <material> of the file"
const struct pp_value_kind pp_room_values_reflectance = {
    PP_VALUE_REFLECTANCE, EXPECTED_REFLECTANCE, 0.0, 1.0, .unit = 1.0};
const struct pp_value_kind pp_room_values_even_reflectance = {
    PP_VALUE_REFLECTANCE, EXPECTED_REFLECTANCE,   0.0, 1.0,
    .unit = 1.0,          .without_pattern = true};
const struct pp_value_kind pp_room_values_or_auto = {
    PP_VALUE_AUTO, "a fraction from 0 to 1 or \"auto\"", 0.0, 1.0, .unit = 1.0};
const struct pp_value_kind pp_room_values_frame = {
    PP_VALUE_FACTOR,
    "a fraction from 0 to 1 or a named frame",
    0.0,
    1.0,
    .unit = 1.0,
    .factors = &pp_frames};
const struct pp_value_kind pp_room_values_curtains = {
    PP_VALUE_FACTOR,
    "a fraction from 0 to 1 or named curtains",
    0.0,
    1.0,
    .unit = 1.0,
    .factors = &pp_curtains};
const struct pp_value_kind pp_room_values_glazing = {
    .reading = PP_VALUE_GLAZING, .expected = "a named glazing or \"none\""};

static const char *const versions[] = {"1", NULL};
const struct pp_value_kind pp_room_values_version = {
    .reading = PP_VALUE_CHOICE, .expected = "\"1\"", .words = versions};
static const char *const units[] = {"m", "mm", NULL};
const struct pp_value_kind pp_room_values_unit_of_lengths = {
    .reading = PP_VALUE_CHOICE, .expected = "\"m\" or \"mm\"", .words = units};
static const char *const no_yes[] = {"no", "yes", NULL};
const struct pp_value_kind pp_room_values_yes_no = {
    .reading = PP_VALUE_CHOICE, .expected = "\"yes\" or \"no\"", .words = no_yes};
/* Names in the order of enum pp_role, enum pp_surroundings and enum pp_work. */
static const char *const roles[] = {"floor", "wall", "ceiling", NULL};
const struct pp_value_kind pp_room_values_role = {
    .reading = PP_VALUE_CHOICE,
    .expected = "\"floor\", \"wall\" or \"ceiling\"",
    .words = roles};
static const char *const places[] = {"rural", "urban", "industrial", NULL};
const struct pp_value_kind pp_room_values_surroundings = {
    .reading = PP_VALUE_CHOICE,
    .expected = "\"rural\", \"urban\" or \"industrial\"",
    .words = places};
const struct pp_value_kind pp_room_values_country = {
    .reading = PP_VALUE_NAME, .expected = "two capital letters, such as \"GB\""};
static const char *const works[] = {"clean", "dirty", NULL};
const struct pp_value_kind pp_room_values_work = {
    .reading = PP_VALUE_CHOICE, .expected = "\"clean\" or \"dirty\"", .words = works};
static const char *const dirt_editions[] = {"bre-309", "bs-8206", NULL};
const struct pp_value_kind pp_room_values_dirt_edition = {
    .reading = PP_VALUE_CHOICE,
    .expected = "\"bre-309\" or \"bs-8206\"",
    .words = dirt_editions};
static const char *const grounds[] = {"shaded", "open", NULL};
const struct pp_value_kind pp_room_values_ground_kind = {
    .reading = PP_VALUE_CHOICE, .expected = "\"shaded\" or \"open\"", .words = grounds};
static const char *const states[] = {"both", "existing", "proposed", "cumulative",
                                     NULL};
const struct pp_value_kind pp_room_values_state = {
    .reading = PP_VALUE_CHOICE,
    .expected = "\"existing\", \"proposed\", \"cumulative\" or \"both\"",
    .words = states};
const struct pp_value_kind pp_room_values_use = {
    .reading = PP_VALUE_CHOICE,
    .expected = "\"bedroom\", \"living-room\", \"dining-room\", \"kitchen\", "
                "\"living-kitchen\", \"studio\", \"study\", \"office\", "
                "\"meeting-room\", \"classroom\", \"ward\", \"shop\", \"workshop\", "
                "\"bathroom\", \"circulation\", \"store\", \"other\" or \"unknown\"",
    .words = pp_room_use_words};
static const char *const sides[] = {"both", "left", "right", NULL};
const struct pp_value_kind pp_room_values_side = {.reading = PP_VALUE_CHOICE,
                                                  .expected =
                                                      "\"both\", \"left\" or \"right\"",
                                                  .words = sides};
const struct pp_value_kind pp_room_values_slat_angle = {
    PP_VALUE_NUMBER, "a number of degrees from -90 to 90", -90.0, 90.0, .unit = PP_RAD};
static const char *const slat_directions[] = {"horizontal", "vertical", NULL};
const struct pp_value_kind pp_room_values_slat_direction = {
    .reading = PP_VALUE_CHOICE,
    .expected = "\"horizontal\" or \"vertical\"",
    .words = slat_directions};
/* Names in the order of enum pp_device_position. */
static const char *const device_positions[] = {"inside", "between", "outside", NULL};
const struct pp_value_kind pp_room_values_device_position = {
    .reading = PP_VALUE_CHOICE,
    .expected = "\"inside\", \"between\" or \"outside\"",
    .words = device_positions};
static const char *const peaks[] = {"ray", "patch", NULL};
const struct pp_value_kind pp_room_values_peak = {
    .reading = PP_VALUE_CHOICE, .expected = "\"ray\" or \"patch\"", .words = peaks};
static const char *const wall_kinds[] = {"outer", "inner", "party", NULL};
const struct pp_value_kind pp_room_values_wall_kind = {
    .reading = PP_VALUE_CHOICE,
    .expected = "\"outer\", \"inner\" or \"party\"",
    .words = wall_kinds};
static const char *const roofs[] = {"flat", "mono", "gable", "hip", NULL};
const struct pp_value_kind pp_room_values_roof = {
    .reading = PP_VALUE_CHOICE,
    .expected = "\"flat\", \"mono\", \"gable\" or \"hip\"",
    .words = roofs};
static const char *const plan_roofs[] = {"flat", "mono",      "gable",
                                         "hip",  "saw-tooth", NULL};
const struct pp_value_kind pp_room_values_plan_roof = {
    .reading = PP_VALUE_CHOICE,
    .expected = "\"flat\", \"mono\", \"gable\", \"hip\" or \"saw-tooth\"",
    .words = plan_roofs};
const struct pp_value_kind pp_room_values_teeth = {
    PP_VALUE_COUNT, "a whole number from 1 to 50", 1.0, PP_PLAN_ROOF_TEETH_MOST,
    .unit = 1.0};
const struct pp_value_kind pp_room_values_month = {
    PP_VALUE_COUNT, "the number of a month, from 1 to 12", 1.0, 12.0, .unit = 1.0};
static const char *const ridges[] = {"longer", "width", "depth", NULL};
const struct pp_value_kind pp_room_values_ridge = {
    .reading = PP_VALUE_CHOICE,
    .expected = "\"longer\", \"width\" or \"depth\"",
    .words = ridges};
const struct pp_value_kind pp_room_values_pitch = {
    .reading = PP_VALUE_NUMBER,
    .expected = "a number of degrees above 0, up to 85",
    .least = 0.0,
    .most = 85.0,
    .above_least = true,
    .unit = PP_RAD};
const struct pp_value_kind pp_room_values_sky_type = {
    .reading = PP_VALUE_CHOICE,
    .expected = "\"overcast\", \"uniform\", \"iso-1\" to \"iso-15\" or \"picture\"",
    .words = pp_sky_words};

const struct pp_value_kind pp_room_values_scale = {
    PP_VALUE_NUMBER, "a number of metres per unit, from 1e-9 to 1e9", 1e-9, 1e9,
    .unit = 1.0};
static const char *const up_words[] = {"z", "y", NULL};
const struct pp_value_kind pp_room_values_up = {
    .reading = PP_VALUE_CHOICE, .expected = "\"z\" or \"y\"", .words = up_words};

/* Optical constants and lengths of physically rough materials. */
const struct pp_value_kind pp_room_values_refractive_index = {
    PP_VALUE_TRIPLE, "one number from 0.01 to 20, or three for red, green and blue",
    0.01, 20.0, .unit = 1.0};
const struct pp_value_kind pp_room_values_extinction = {
    PP_VALUE_TRIPLE, "one number from 0 to 100, or three for red, green and blue", 0.0,
    100.0, .unit = 1.0};
const struct pp_value_kind pp_room_values_wavelength = {
    PP_VALUE_TRIPLE,
    "one number of micrometres from 0.38 to 0.78, or three for red, green and blue",
    0.38, 0.78, .unit = 1.0};
const struct pp_value_kind pp_room_values_roughness = {
    PP_VALUE_NUMBER, "a number of micrometres from 0.0001 to 20", 1e-4, 20.0,
    .unit = 1.0};
const struct pp_value_kind pp_room_values_correlation = {
    PP_VALUE_NUMBER, "a number of micrometres from 0.1 to 200", 0.1, 200.0,
    .unit = 1.0};
const struct pp_value_kind pp_room_values_diffuse = {
    PP_VALUE_TRIPLE, "one fraction from 0 to 0.95, or three for red, green and blue",
    0.0, 0.95, .unit = 1.0};
const struct pp_value_kind pp_room_values_pattern = {
    .reading = PP_VALUE_NAME,
    .expected = "a formula of x, y and z, of at most 200 characters"};
