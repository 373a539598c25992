/* room_parts.h - a room as described by its file, part by part. The reader (read/)
 * fills it, world.c resolves it. Inside model/room/ only.
 *
 * Angles are in radians, everything else is as in the file. Every part has the line of
 * its element. Numbers that are missing in the file and have no default are NAN,
 * strings NULL. Lists are owned by the room.
 *
 * The reader leaves out a part with a mistake, so that nothing further is reported
 * about that part. If a plan or envelope is left out (line 0), other parts cannot be
 * checked against it. The reader has then reported the reason. The reader also reports
 * a room with neither plan nor envelope, or with both.
 */
#ifndef PP_MODEL_ROOM_ROOM_PARTS_H
#define PP_MODEL_ROOM_ROOM_PARTS_H

#include <stdbool.h>

#include "model/room/room.h"
#include "model/room/room_use.h"
#include "model/room/sky_words.h"
#include "model/geometry/vec.h"
#include "model/light/rough/rough_finishes.h"
#include "model/light/slats/window_device.h"
#include "model/mesh/mesh_triangles.h"
#include "model/room/placement.h"
#include "model/room/world.h"

struct pp_site_part {
    double latitude_rad, longitude_rad; /* NAN: not given */
    char country[3];                    /* two letters; empty: not given */
    enum pp_surroundings surroundings;  /* rural by default */
    enum pp_work
        work; /* where not given: clean, but dirty in industrial surroundings */
    enum pp_dirt dirt;
    double ground_reflectance, ground_level_m;
    bool ground_is_open;
    int bare_from, bare_to; /* months of trees without leaves */
    int line;
};

struct pp_vertices {
    struct pp_vec3 *list; /* z is 0 in a plan */
    int *lines;
    int count;
};

struct pp_face_part {
    enum pp_role role;
    char *name;
    double reflectance;             /* NAN: as in <finishes> */
    const struct pp_finish *finish; /* finish of the reflectance; NULL: given as a
                                     * number; the same for all parts below */
    struct pp_vertices vertices;
    int line;
};

struct pp_plan_part {
    bool envelope;  /* given by faces, not as a plan */
    bool rectangle; /* given by width and depth, not by vertices */
    double width_m, depth_m, height_m;
    struct pp_vertices vertices; /* vertices of a plan that is not a rectangle */
    struct pp_face_part *faces;  /* faces of an envelope */
    int face_count;
    int line; /* 0: none in the file */
};

struct pp_finish_part {
    char *wall;
    double reflectance;
    const struct pp_finish *finish;
    int line;
};

/* Properties of a wall. */
struct pp_wall_part {
    char *name;
    bool is_inner; /* another room or building is behind it; no windows */
    int line;
};

struct pp_glazing_part {
    struct pp_glass glass;
    struct pp_measured_pane *measured; /* NULL: no glazing-file */
    double frame_factor;
    double maintenance; /* NAN: from surroundings, work and slope ("auto") */
    double curtains;
    double reveal_m;
};

enum pp_shade_kind { PP_OVERHANG, PP_FIN, PP_BALCONY, PP_SHELF };

/* Shade of a window; lengths from the window's edges, left and right as seen from
 * outside (outside/shades.h). */
struct pp_shade_part {
    enum pp_shade_kind kind;
    double depth_m, inside_m; /* depth outside the wall; of a shelf, also inside */
    double above_m, below_m;  /* extension beyond head and sill */
    double left_m, right_m;   /* extension beyond the jambs */
    bool is_left, is_right;   /* true if there is a fin on that side */
    double height_m;          /* shelf: above the sill; balcony: its floor above the
                               * room's */
    double parapet_m;         /* height of a balcony's parapet; 0: none */
    double reflectance;
    const struct pp_finish *finish;
    int line;
};

struct pp_opening_part {
    char *name; /* NULL: not given */
    enum pp_opening_kind kind;
    char *wall;                               /* wall of a window */
    double left_m, sill_m, width_m, height_m; /* window */
    double x, y, depth_m;                     /* rooflight, with width_m */
    struct pp_vertices vertices;              /* opening */
    struct pp_glazing_part glazing;
    struct pp_window_device device;
    struct pp_shade_part *shades; /* windows only */
    int shade_count;
    int line;
};

struct pp_skyline_part {
    char *wall;
    double angle_rad, distance_m; /* INFINITY: not given */
    double reflectance;
    enum pp_site_state state;
    int line;
};

struct pp_facade_part {
    char *wall;
    double left_m, right_m, up_m, down_m;
    double depth_m; /* NAN: the largest reveal in the wall */
    double reflectance;
    const struct pp_finish *finish;
    int line;
};

struct pp_surface_part {
    struct pp_vertices vertices;
    double reflectance, exitance;
    const struct pp_finish *finish;
    char *name; /* NULL: not given; for parts of another room: its name */
    const char
        *what; /* the element's name in messages; NULL: surface, or block. Static */
    bool is_room_outside; /* face of another room of the building */
    bool is_front;        /* part of another room's facade, normal towards that room */
    bool is_shade;     /* shade of another room's window whose wall is in one front with
                    * a wall of this room */
    bool is_of_room;   /* side of an object in the room; must be entirely inside */
    bool is_of_site;   /* part of the building, or of another room */
    bool is_of_block;  /* part of a block's roof, or a wall over its footprint */
    bool is_on_ground; /* z is relative to the ground; used only until the reader
                        * knows the ground level */
    enum pp_site_state state;
    int line;
};

enum pp_receiver_kind { PP_POINT, PP_LINE, PP_GRID };

struct pp_receiver_part {
    enum pp_receiver_kind kind;
    double x, y, z;             /* point; z NAN: on the working plane */
    struct pp_vec3 normal;      /* point; (0, 0, 1) by default; not normalised */
    double from[2], to[2];      /* line, on the working plane */
    int points;                 /* line */
    double spacing_m, margin_m; /* grid */
    int line;
};

/* An eye that looks along a horizontal line (world.h). */
struct pp_view_part {
    char *name; /* NULL: not given */
    double x, y, z, bearing_rad;
    int line;
};

enum pp_cover_kind { PP_DOOR, PP_DADO };

/* A door or dado: part of a wall with another reflectance (build/covers.h). */
struct pp_cover_part {
    enum pp_cover_kind kind;
    char *name;             /* NULL: not given */
    char *wall;             /* NULL: a dado of all walls without their own */
    double left_m, width_m; /* position and size of a door, as for a window */
    double height_m;        /* height from the foot of the wall */
    double reflectance;
    const struct pp_finish *finish;
    int line;
};

enum pp_fitting_kind { PP_FURNITURE, PP_COLUMN, PP_PARTITION };

/* Furniture, column or partition: a box, or a round column (build/fittings.h). */
struct pp_fitting_part {
    enum pp_fitting_kind kind;
    struct pp_vec3 corner; /* furniture: its lower corner; column: its centre;
                            * partition: centre of its first end */
    double width_m, depth_m;
    double height_m;   /* NAN: up to the highest ceiling */
    double rotate_rad; /* rotation about `corner`, counter-clockwise from above */
    bool is_round;
    double reflectance; /* NAN: as for walls */
    const struct pp_finish *finish;
    char *name; /* NULL: not given */
    int line;
};

/* A mesh file, shared by several rooms; the first holder creates it. */
struct pp_shared_mesh {
    struct pp_mesh_triangles mesh;
    int holders;
};

/* Mesh outside the room: p = corner + R(rotate) scale q; q: point of the file, with z
 * up. The mesh of an outline (read_outline.h) has x east and y north; it is rotated by
 * the bearing of the room's y instead. */
struct pp_mesh_part {
    struct pp_shared_mesh *file;
    char *path; /* as in the room file */
    char *name; /* NULL: not given */
    struct pp_vec3 corner;
    double scale; /* metres per unit of the file */
    double rotate_rad;
    bool y_is_up; /* the file has y up; its -z becomes y */
    double reflectance;
    const struct pp_finish *finish;
    bool is_outline;
    bool is_of_site; /* given by the building, for all rooms */
    enum pp_site_state state;
    int line;
};

/* A tree of the site; pp_build_trees sets the z of its foot. */
struct pp_tree_part {
    struct pp_tree tree;
    enum pp_site_state state;
};

/* A garden, assessed for sunlight on the ground. */
struct pp_garden_part {
    char *name;                  /* NULL: not given */
    struct pp_vertices vertices; /* x and y only */
    enum pp_site_state state;
    int line;
};

/* The coarse model that a room is nested in. */
struct pp_within_part {
    char *path;             /* NULL: the room is not nested */
    char *window;           /* in the coarse model: the counterpart of the room's only
                             * window; NULL: windows are matched by name */
    struct pp_world *world; /* the coarse model; held; NULL: it has mistakes */
    int line;
};

/* All data it points to are its own: see pp_room_parts_clear and pp_room_copy. */
struct pp_room {
    char *name, *ref, *address; /* NULL: not given */
    enum pp_room_use use;
    double north_rad; /* bearing of +y, clockwise from true north; NAN: not given, in a
                       * room of a building as read */
    struct pp_placement placement;
    enum pp_site_state state;
    struct pp_site_part site; /* the building's site unless the room has its own */
    bool site_is_own;         /* the room has its own site */
    struct pp_sky_part sky;   /* the building's sky unless the room has its own */
    struct pp_plan_part plan;
    double floor, walls, ceiling; /* reflectances */
    const struct pp_finish *floor_finish, *walls_finish, *ceiling_finish;
    struct pp_rough_finishes *materials; /* materials of the file, shared; NULL: none */
    double decorations;                  /* NAN: from surroundings and work ("auto") */
    double working_plane_m;
    int working_plane_line; /* 0: not given */
    struct pp_finish_part *finishes;
    int finish_count;
    struct pp_wall_part *wall_kinds;
    int wall_kind_count;
    struct pp_opening_part *openings; /* in file order */
    int opening_count;
    struct pp_skyline_part *skylines;
    int skyline_count;
    struct pp_facade_part *facades;
    int facade_count;
    struct pp_block *blocks; /* as in the file */
    int block_count;
    struct pp_surface_part *surfaces;
    int surface_count;
    struct pp_mesh_part *meshes;
    int mesh_count;
    struct pp_fitting_part *fittings;
    int fitting_count;
    struct pp_cover_part *covers;
    int cover_count;
    struct pp_garden_part *gardens;
    int garden_count;
    struct pp_tree_part *trees;
    int tree_count;
    struct pp_receiver_part *receivers;
    int receiver_count;
    struct pp_view_part *views;
    int view_count;
    struct pp_within_part within;
    int line;
};

/* Frees all data that the room points to, but not the room. */
void pp_room_parts_clear(struct pp_room *room);
void pp_room_parts_clear_plan(struct pp_plan_part *plan);
void pp_room_parts_clear_surface(struct pp_surface_part *surface);

/* Copies a part with these vertices instead of its own; each vertex gets the part's
 * line. */
enum pp_status pp_room_parts_copy_surface(struct pp_surface_part *copy,
                                          const struct pp_surface_part *part,
                                          const struct pp_vec3 *vertices, int count,
                                          struct pp_error *err);
void pp_room_parts_clear_mesh(struct pp_mesh_part *mesh);
void pp_room_parts_clear_garden(struct pp_garden_part *garden);
void pp_room_parts_clear_vertices(struct pp_vertices *vertices);

#endif
