/* room_values.h - the kinds of values of attributes in a room file: how they are read,
 * and the words for them in messages. Inside model/room/ only. */
#ifndef PP_MODEL_ROOM_READ_ROOM_VALUES_H
#define PP_MODEL_ROOM_READ_ROOM_VALUES_H

#include "model/room/read/room_schema.h"

extern const struct pp_value_kind pp_room_values_coordinate, pp_room_values_size,
    pp_room_values_depth, pp_room_values_component, pp_room_values_fraction,
    pp_room_values_transmittance, pp_room_values_bearing, pp_room_values_latitude,
    pp_room_values_longitude, pp_room_values_altitude, pp_room_values_skyline_angle,
    pp_room_values_number_of_points, pp_room_values_position,
    pp_room_values_reflectance, pp_room_values_or_auto, pp_room_values_frame,
    pp_room_values_curtains, pp_room_values_glazing, pp_room_values_version,
    pp_room_values_unit_of_lengths, pp_room_values_yes_no, pp_room_values_role,
    pp_room_values_surroundings, pp_room_values_country, pp_room_values_work,
    pp_room_values_dirt_edition, pp_room_values_ground_kind, pp_room_values_state,
    pp_room_values_use, pp_room_values_side, pp_room_values_wall_kind,
    pp_room_values_roof, pp_room_values_plan_roof, pp_room_values_teeth,
    pp_room_values_scale, pp_room_values_up, pp_room_values_ridge, pp_room_values_pitch,
    pp_room_values_sky_type, pp_room_values_slat_angle, pp_room_values_slat_direction,
    pp_room_values_device_position, pp_room_values_refractive_index,
    pp_room_values_extinction, pp_room_values_wavelength, pp_room_values_roughness,
    pp_room_values_correlation, pp_room_values_diffuse, pp_room_values_month,
    pp_room_values_text, pp_room_values_wall_name, pp_room_values_face_name,
    pp_room_values_file_name, pp_room_values_pattern;
/* Reflectance of a surface that cannot have a pattern. */
extern const struct pp_value_kind pp_room_values_even_reflectance;
extern const struct pp_value_kind pp_room_values_peak; /* peak of a glazing-file */

#endif
