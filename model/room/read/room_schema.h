/* room_schema.h - the elements of a room file, their attributes and valid values.
 *
 * Inside model/room/ only. Each attribute has one row: its name, the kind of its value,
 * whether it is required, its default, and the offset of the value in the element's
 * form. A form holds the values of an element's attributes before they become a part of
 * a room.
 */
#ifndef PP_MODEL_ROOM_READ_ROOM_SCHEMA_H
#define PP_MODEL_ROOM_READ_ROOM_SCHEMA_H

#include <stdbool.h>
#include <stddef.h>

#include "model/room/corrections.h"
#include "model/room/project.h"
#include "model/base/mistakes.h"
#include "model/base/xml.h"

/* Interpretation of the text of a value, and the C type of the result. */
enum pp_reading_of_value {
    PP_VALUE_TEXT,        /* const char *, owned by the XML tree */
    PP_VALUE_NAME,        /* as PP_VALUE_TEXT, but not empty */
    PP_VALUE_NUMBER,      /* double */
    PP_VALUE_COUNT,       /* int */
    PP_VALUE_PAIR,        /* double[2]; two numbers separated by white space */
    PP_VALUE_TRIPLE,      /* double[3]; three numbers, or one for all three */
    PP_VALUE_CHOICE,      /* int; index in `words` */
    PP_VALUE_REFLECTANCE, /* struct pp_finish_value; a number, a named finish, or # and
                           * the name of a material of the file */
    PP_VALUE_AUTO,        /* double; a number, or "auto" for NAN */
    PP_VALUE_FACTOR,      /* double; a number, or a name in `factors` */
    PP_VALUE_GLAZING,     /* const char *; a named glazing or "none" */
};

struct pp_value_kind {
    enum pp_reading_of_value reading;
    const char *expected;     /* text after "expected" in a message */
    double least, most;       /* limits of numbers, included unless: */
    bool above_least;         /* least is excluded */
    bool below_most;          /* most is excluded */
    double unit;              /* PP_VALUE_NUMBER: factor to the stored unit */
    const char *const *words; /* words of a choice; NULL-terminated */
    const struct pp_named_factors *factors;
    const char *expected_mm; /* lengths: `expected` for a file in millimetres */
    bool without_pattern;    /* PP_VALUE_REFLECTANCE: materials have no pattern */
};

struct pp_attribute_rule {
    const char *name;
    const struct pp_value_kind *kind;
    bool required;
    double fallback; /* default, in the stored unit; texts default to NULL */
    size_t offset;   /* offset of the value in the form */
};

struct pp_element_rule;

struct pp_child_rule {
    const struct pp_element_rule *rule;
    int least, most; /* allowed number of children; most 0: no limit */
};

struct pp_element_rule {
    const char *name;
    const struct pp_attribute_rule *attributes;
    int attribute_count;
    const struct pp_child_rule *children;
    int child_count;
};

/* Limits of values and polygons. */
#define PP_ROOM_LENGTH_MOST_M 1e5   /* any coordinate or length, absolute value */
#define PP_ROOM_LENGTH_LEAST_M 1e-3 /* lengths that must be greater than 0 */
enum {
    PP_ROOM_POINTS_MOST = 100000,
    PP_ROOM_VERTICES_MOST = 1000,
    PP_ROOM_MATERIALS_MOST = 32, /* each takes 0.1 s to prepare */
    PP_ROOM_PLACED_MOST = 200    /* each obstructs all others */
};

/* A reflectance, and its finish if it was given by name. */
struct pp_finish_value {
    double reflectance;
    const struct pp_finish *finish; /* NULL: given as a number */
};

struct pp_building_form {
    int version;
    int units; /* 1: millimetres */
    const char *name;
    double north_rad;         /* NAN: not given */
    double glass_reflectance; /* NAN: not given */
};

struct pp_room_form {
    int version; /* -1: not given */
    int units;   /* 1: millimetres; root only */
    const char *name, *ref, *address;
    double north_rad;            /* NAN: not given */
    double x, y, z, rotate_rad;  /* NAN: not given */
    int use;                     /* enum pp_room_use, 0: not given */
    int state;                   /* enum pp_site_state */
    const char *within, *window; /* NULL: not given */
};

struct pp_project_form {
    const char *facts[PP_PROJECT_FACTS]; /* NULL: not given */
};

struct pp_site_form {
    double latitude_rad, longitude_rad, ground_level_m;
    struct pp_finish_value ground;
    const char *country;    /* NULL: not given */
    int surroundings;       /* enum pp_surroundings */
    int work;               /* enum pp_work, -1: not given */
    int ground_is_open;     /* 0 shaded, 1 open */
    int dirt;               /* enum pp_dirt */
    int bare_from, bare_to; /* months; 0: not given */
};

struct pp_tree_form {
    double x, y, height_m, crown_base_m, crown_width_m;
    double transmittance, winter_transmittance; /* winter NAN: not given */
    int state;                                  /* enum pp_site_state */
};

/* Attributes read by sky_picture_file.h. */
enum { PP_SKY_FORM_OPTIONS = 15 };
extern const char *const pp_sky_form_keys[PP_SKY_FORM_OPTIONS];

struct pp_sky_form {
    int type; /* index in pp_sky_words */
    double sun_altitude_rad, sun_bearing_rad;
    const char *file, *second; /* photographs; second: the opposite half, or NULL */
    const char
        *picture[PP_SKY_FORM_OPTIONS]; /* texts, by pp_sky_form_keys; NULL: not given */
};

/* Attributes of an outline that are read by sky_picture_file.h: the first ones of
 * pp_sky_form_keys. */
enum { PP_OUTLINE_FORM_OPTIONS = 7 };

struct pp_outline_form {
    const char *file, *name;
    const char *picture[PP_OUTLINE_FORM_OPTIONS];
    double x, y, z, distance_m;
    struct pp_finish_value finish;
    int state; /* enum pp_site_state */
};

struct pp_plan_form {
    double width_m, depth_m, height_m;
    int roof, ridge;  /* enum pp_roof, enum pp_ridge */
    double pitch_rad; /* NAN: not given */
    int teeth;        /* 0: not given */
};

struct pp_face_form {
    int role; /* enum pp_role */
    const char *name;
    struct pp_finish_value finish;
};

struct pp_vertex_form {
    double x, y, z;
};

struct pp_finishes_form {
    struct pp_finish_value floor, walls, ceiling;
    double decorations;
};

struct pp_wall_form {
    const char *name;
    int kind; /* 0 outer, 1 inner, 2 party */
};

struct pp_finish_form {
    const char *wall;
    struct pp_finish_value finish;
};

/* A material; index of a channel: red, green, blue. Matt: n, roughness and correlation
 * are 0. */
struct pp_material_form {
    const char *name;
    double n[3], k[3], wavelength_um[3], diffuse[3];
    double roughness_um, correlation_um;
    const char *pattern, *bump; /* formulae; NULL: none */
};

/* A window, a rooflight or an opening. */
struct pp_opening_form {
    const char *name, *wall;
    double left_m, sill_m, width_m, height_m, x, y, depth_m;
    const char *glazing;
    double transmittance, frame_factor, maintenance, curtains, reveal_m;
    int diffusing;            /* 0 no, 1 yes, -1 not given */
    int absorbing;            /* 0 no, 1 yes, -1 not given */
    const char *glazing_file; /* NULL: not given */
    int peak;                 /* 0 ray, 1 patch */
};

/* An overhang, a fin, a balcony or a shelf. */
struct pp_shade_form {
    double depth_m, inside_m, above_m, below_m, left_m, right_m, height_m, parapet_m;
    int side; /* 0 both, 1 left, 2 right */
    struct pp_finish_value finish;
};

struct pp_blind_form {
    double width_m, spacing_m, angle_rad,
        curvature_m;                     /* spacing and angle NAN: not given */
    int cut_off;                         /* 0 no, 1 yes */
    struct pp_finish_value upper, lower; /* lower NAN: as upper */
    int direction;                       /* 0 horizontal, 1 vertical */
    int position;                        /* enum pp_device_position */
};

struct pp_screen_form {
    double openness;
    struct pp_finish_value finish;
};

struct pp_curtain_form {
    double transmittance;
};

struct pp_garden_form {
    const char *name;
    int state;
};

struct pp_skyline_form {
    const char *wall;
    double angle_rad, distance_m;
    struct pp_finish_value finish;
    int state; /* enum pp_site_state */
};

struct pp_facade_form {
    const char *wall;
    double left_m, right_m, up_m, down_m, depth_m;
    struct pp_finish_value finish;
};

struct pp_block_form {
    const char *name;
    double x, y, base, width_m, depth_m, height_m, rotate_rad; /* NAN: not given */
    double pitch_rad;                                          /* NAN: not given */
    int roof, ridge; /* enum pp_roof, enum pp_ridge */
    struct pp_finish_value finish;
    int state; /* enum pp_site_state */
};

struct pp_surface_form {
    const char *name;
    struct pp_finish_value finish;
    double exitance;
    int state; /* enum pp_site_state */
};

struct pp_mesh_form {
    const char *file, *name;
    double scale; /* NAN: not given */
    double x, y, z, rotate_rad;
    int up; /* 0 z, 1 y */
    struct pp_finish_value finish;
    int state; /* enum pp_site_state */
};

struct pp_plane_form {
    double height_m;
};

/* A piece of furniture, a column or a partition. */
struct pp_fitting_form {
    const char *name;
    double x, y, z, width_m, depth_m, height_m, rotate_rad; /* NAN: not given */
    double diameter_m, thickness_m;
    double from[2], to[2];
    struct pp_finish_value finish;
};

/* A door or a dado. */
struct pp_cover_form {
    const char *name, *wall;
    double left_m, width_m, height_m;
    struct pp_finish_value finish;
};

/* A point, a line or a grid. */
struct pp_receiver_form {
    double x, y, z, nx, ny, nz;
    double from[2], to[2];
    int points;
    double spacing_m, margin_m;
};

struct pp_view_form {
    const char *name;
    double x, y, z, bearing_rad;
};

extern const struct pp_element_rule pp_rule_building, pp_rule_building_room,
    pp_rule_project, pp_rule_room, pp_rule_site, pp_rule_sky, pp_rule_plan,
    pp_rule_plan_vertex, pp_rule_envelope, pp_rule_face, pp_rule_vertex,
    pp_rule_finishes, pp_rule_finish, pp_rule_material, pp_rule_window,
    pp_rule_rooflight, pp_rule_opening, pp_rule_skyline, pp_rule_furniture,
    pp_rule_column, pp_rule_partition, pp_rule_door, pp_rule_dado, pp_rule_facade,
    pp_rule_garden, pp_rule_block, pp_rule_footprint, pp_rule_surface, pp_rule_mesh,
    pp_rule_outline, pp_rule_working_plane, pp_rule_wall, pp_rule_overhang, pp_rule_fin,
    pp_rule_balcony, pp_rule_shelf, pp_rule_blind, pp_rule_screen, pp_rule_curtain,
    pp_rule_point, pp_rule_line, pp_rule_grid, pp_rule_view, pp_rule_tree;

#endif
