/* room_parts.h - a room as described by its file, part by part: the reader (read/)
 * fills it, and world.c resolves it. Inside model/room/ only.
 *
 * Angles are radians, everything else is as in the file. Every part has the line of its
 * element. A number that the file left out and that has no default is NAN; a string is
 * NULL. Lists are grown by the reader and owned by the room.
 *
 * A part with a mistake is left out by the reader, so that nothing further is reported
 * about it. If a plan or envelope is left out (line 0), nothing can be checked against
 * it; the reader has reported why, and also reports a room with neither or both.
 */
#ifndef PP_MODEL_ROOM_ROOM_PARTS_H
#define PP_MODEL_ROOM_ROOM_PARTS_H

#include <stdbool.h>

#include "model/room/room.h"
#include "model/room/room_use.h"
#include "model/room/sky_words.h"
#include "model/geometry/vec.h"
#include "model/mesh/mesh_triangles.h"
#include "model/room/placement.h"
#include "model/room/world.h"

struct pp_site_part {
    double latitude_rad, longitude_rad; /* NAN where not given */
    char country[3];                    /* two letters; empty where not given */
    enum pp_surroundings surroundings;  /* rural where not given */
    enum pp_work
        work; /* where not given: clean, but dirty in industrial surroundings */
    enum pp_dirt dirt;
    double ground_reflectance, ground_level_m;
    bool ground_is_open;
    int line;
};

struct pp_vertices {
    struct pp_vec3 *list; /* z is 0 for the corners of a plan */
    int *lines;
    int count;
};

struct pp_face_part {
    enum pp_role role;
    char *name;
    double reflectance;             /* NAN: the finishes' */
    const struct pp_finish *finish; /* source of the reflectance; NULL: a number; the
                                     * same below */
    struct pp_vertices vertices;
    int line;
};

struct pp_plan_part {
    bool envelope;  /* by faces instead of a plan */
    bool rectangle; /* by width and depth instead of vertices */
    double width_m, depth_m, height_m;
    struct pp_vertices vertices; /* of any other plan */
    struct pp_face_part *faces;  /* of an envelope */
    int face_count;
    int line; /* 0: the file has neither */
};

struct pp_finish_part {
    char *wall;
    double reflectance;
    const struct pp_finish *finish;
    int line;
};

/* A wall that the file says something of. */
struct pp_wall_part {
    char *name;
    bool is_inner; /* behind it is another room, or another's house: no windows there */
    int line;
};

struct pp_glazing_part {
    struct pp_glass glass;
    double frame_factor;
    double maintenance; /* NAN: by surroundings, work and slope ("auto") */
    double curtains;
    double reveal_m;
};

enum pp_shade_kind { PP_OVERHANG, PP_FIN, PP_BALCONY, PP_SHELF };

/* Shade that belongs to a window; lengths are counted from its edges, left and right as
 * drawn from outside (build/shades.h). */
struct pp_shade_part {
    enum pp_shade_kind kind;
    double depth_m, inside_m; /* outside the wall; of a shelf, inside it too */
    double above_m, below_m;  /* beyond head and sill */
    double left_m, right_m;   /* beyond the jambs */
    bool is_left, is_right;   /* which fins there are */
    double height_m;          /* of a shelf, above the sill; of a balcony's floor */
    double parapet_m;         /* height of a balcony's; 0: none */
    double reflectance;
    const struct pp_finish *finish;
    int line;
};

struct pp_opening_part {
    char *name; /* NULL where not given */
    enum pp_opening_kind kind;
    char *wall;                               /* window */
    double left_m, sill_m, width_m, height_m; /* window */
    double x, y, depth_m;                     /* rooflight, with width_m */
    struct pp_vertices vertices;              /* opening */
    struct pp_glazing_part glazing;
    struct pp_shade_part *shades; /* of a window */
    int shade_count;
    int line;
};

struct pp_skyline_part {
    char *wall;
    double angle_rad, distance_m; /* INFINITY where not given */
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
    char *name; /* NULL where not given; of a room that stands outside: that room's */
    const char
        *what; /* the element's name in messages; NULL: surface, or block. Static */
    bool is_room_outside; /* a face of another room of the building */
    bool is_front;        /* of another room's facade, normal towards that room */
    bool is_shade; /* fixed by a window of another room in a wall of one front with one
                    * of this room's */
    bool is_of_room;   /* a side of an object in the room: entirely inside */
    bool is_of_site;   /* given by the building, for all of its rooms, or by another
                        * room */
    bool is_of_block;  /* of its roof, or of its walls over a footprint */
    bool is_on_ground; /* its z is above the ground's level, which may stand behind it
                           * in the file: only while that is read */
    enum pp_site_state state;
    int line;
};

enum pp_receiver_kind { PP_POINT, PP_LINE, PP_GRID };

struct pp_receiver_part {
    enum pp_receiver_kind kind;
    double x, y, z;        /* point; z NAN: the working plane */
    struct pp_vec3 normal; /* point; (0, 0, 1) where not given; not yet unit length */
    double from[2], to[2]; /* line, on the working plane */
    int points;            /* line */
    double spacing_m, margin_m; /* grid */
    int line;
};

enum pp_cover_kind { PP_DOOR, PP_DADO };

/* Cover of a part of a wall, with another reflectance (build/covers.h). */
struct pp_cover_part {
    enum pp_cover_kind kind;
    char *name;             /* NULL where not given */
    char *wall;             /* NULL: a dado of all walls that have no other */
    double left_m, width_m; /* of a door, as a window's */
    double height_m;        /* from the foot of the wall */
    double reflectance;
    const struct pp_finish *finish;
    int line;
};

enum pp_fitting_kind { PP_FURNITURE, PP_COLUMN, PP_PARTITION };

/* Fitting in a room: a box, or a round column (build/fittings.h). */
struct pp_fitting_part {
    enum pp_fitting_kind kind;
    struct pp_vec3 corner; /* of furniture its lower corner, of columns the middle, of
                            * partitions the middle of their beginning */
    double width_m, depth_m;
    double height_m;   /* NAN: up to the highest ceiling */
    double rotate_rad; /* about the corner, counter-clockwise seen from above */
    bool is_round;
    double reflectance; /* NAN: the walls' */
    const struct pp_finish *finish;
    char *name; /* NULL where not given */
    int line;
};

/* A file of triangles, as several rooms may hold it: begins with one holder. */
struct pp_shared_mesh {
    struct pp_mesh_triangles mesh;
    int holders;
};

/* Triangles of a file that stand outside: p = corner + R(rotate) scale q, q with z up. */
struct pp_mesh_part {
    struct pp_shared_mesh *file;
    char *path; /* as in the room file */
    char *name; /* NULL where not given */
    struct pp_vec3 corner;
    double scale; /* metres of one unit */
    double rotate_rad;
    bool y_is_up; /* in the file, and its -z is y then */
    double reflectance;
    const struct pp_finish *finish;
    bool is_of_site; /* given by a building, for all of its rooms */
    enum pp_site_state state;
    int line;
};

/* A piece of ground that the sun is to reach. */
struct pp_garden_part {
    char *name;                  /* NULL where not given */
    struct pp_vertices vertices; /* x and y */
    enum pp_site_state state;
    int line;
};

/* All that it points to is its own: see pp_room_parts_clear, and pp_room_copy. */
struct pp_room {
    char *name, *ref; /* NULL where not given */
    enum pp_room_use use;
    double
        north_rad; /* of a building's room that stands as read: NAN where not given */
    struct pp_placement placement;
    enum pp_site_state state;
    struct pp_site_part site; /* the building's where the room has none */
    bool site_is_own;         /* it has */
    struct pp_sky_part sky;   /* of the same form */
    struct pp_plan_part plan;
    double floor, walls, ceiling; /* reflectances */
    const struct pp_finish *floor_finish, *walls_finish, *ceiling_finish;
    double decorations; /* NAN: by surroundings and work ("auto") */
    double working_plane_m;
    int working_plane_line; /* 0 where not given */
    struct pp_finish_part *finishes;
    int finish_count;
    struct pp_wall_part *wall_kinds;
    int wall_kind_count;
    struct pp_opening_part *openings; /* windows, rooflights, openings in file order */
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
    struct pp_receiver_part *receivers;
    int receiver_count;
    int line;
};

/* Frees all that the room points to, not the room. */
void pp_room_parts_clear(struct pp_room *room);
void pp_room_parts_clear_plan(struct pp_plan_part *plan);
void pp_room_parts_clear_surface(struct pp_surface_part *surface);

/* A copy with these vertices in place of the part's, each of the part's line. */
enum pp_status pp_room_parts_copy_surface(struct pp_surface_part *copy,
                                          const struct pp_surface_part *part,
                                          const struct pp_vec3 *vertices, int count,
                                          struct pp_error *err);
void pp_room_parts_clear_mesh(struct pp_mesh_part *mesh);
void pp_room_parts_clear_garden(struct pp_garden_part *garden);
void pp_room_parts_clear_vertices(struct pp_vertices *vertices);

#endif
