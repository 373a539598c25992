/* world.h - a room and its surroundings, resolved once, for all calculations.
 *
 * Nothing here has to be looked up by name or worked out a second time: polygons in
 * metres, fractions, radians, the room's own x, y, z (floor at z = 0, z up). The hand
 * methods, the tracer, the charts and the exports read only this, and the light from
 * outside that they are given beside it (room_light.h); a world is never changed once
 * made. Everything in it is owned by it.
 */
#ifndef PP_MODEL_ROOM_WORLD_H
#define PP_MODEL_ROOM_WORLD_H

#include <stdbool.h>

#include "model/base/error.h"
#include "model/base/mistakes.h"
#include "model/geometry/bounds.h"
#include "model/geometry/polygon.h"
#include "model/geometry/region.h"
#include "model/geometry/vec.h"
#include "model/light/glass.h"
#include "model/room/placement.h"
#include "model/room/room_use.h"

enum pp_role {
    PP_FLOOR,        /* of the room's own envelope */
    PP_WALL,         /* of the room's own envelope */
    PP_CEILING,      /* of the room's own envelope */
    PP_REVEAL,       /* a side of an opening's depth */
    PP_COVER,        /* a door or a piece of a dado, right before a wall, inside */
    PP_FREE_SURFACE, /* a <surface>, inside or outside */
    PP_BLOCK,        /* a side of a <block> */
    PP_FACADE,       /* a piece of a <facade>: of its sheet, or a rim */
    PP_SKYLINE,      /* the wall of a <skyline> with a distance */
    PP_ROLE_COUNT
};

/* Opaque, diffuse, seen from both sides. A face of the envelope stands whole here; the
 * openings name it. */
struct pp_surface {
    struct pp_polygon outline; /* envelope and reveals: normal into the room;
                                * blocks: outwards; facades:
                                * to the open air; skylines: towards the room;
                                * free-standing: as in the file */
    int (*triangles)
        [3]; /* that cover the outline, by its vertices; NULL: it is convex */
    int triangle_count;
    enum pp_role role;
    bool inside;      /* does it stand in the room (envelope, reveal, free-standing)? */
    const char *name; /* the wall's, or NULL */
    double front,
        back;        /* reflectance of the side the normal points to, and the other */
    double exitance; /* emitted by each side by itself, over Eh */
    const struct pp_finish *finish; /* named in the file: for the front, and for both
                                     * sides of blocks and free-standing surfaces; NULL:
                                     * grey and without gloss. The reflectance is always
                                     * that of `front` */
    int owner;     /* reveal: its opening; cover: its wall's surface; block: its block;
                    * facade: its facade; skyline: its skyline; shade of a window of the room: its
                    * opening; else -1 */
    bool is_door;  /* of a cover: a door, and no dado */
    bool is_shade; /* an overhang, fin, balcony or shelf of a window's own, or of
                    * another room's in the same front of the building */
    bool is_inner; /* of a wall: behind it is another room, or another's house */
    int line;      /* in the room file; 0 where none */
};

/* When a thing stands there: always, before something is built, or with it. */
enum pp_site_state { PP_STATE_BOTH, PP_STATE_EXISTING, PP_STATE_PROPOSED };

/* Bytes of an opening's label, its end included. */
enum { PP_WORLD_LABEL = 32 };

/* An opening in a face, with its glass. Its own axes lie in the face's plane: along is
 * horizontal and runs to the right seen from inside, up completes it; their cross
 * product is the normal, into the room. */
struct pp_opening {
    int face;                /* the surface it is cut from */
    struct pp_polygon inner; /* outline in the face, normal into the room */
    struct pp_polygon outer; /* where the glass stands: inner moved out by the reveal */
    struct pp_vec3 along, up; /* unit */
    double slope_rad;         /* of the glass: 0 horizontal, pi/2 vertical */
    double width_m, height_m; /* extent along `along` and `up` */
    bool rectangle;           /* and with edges along its axes? */
    double middle_z_m; /* middle of its height: where upper and lower parts meet */
    struct pp_glass glass;
    double frame_factor;      /* glass area / opening area */
    double maintenance;       /* share of the light that dirt leaves */
    bool maintenance_is_auto; /* by the world's edition of dirt */
    double curtains; /* share of the light that curtains leave, 1: there are none */
    double reveal_m; /* depth, 0 where the glass stands in the face */
    int facade;      /* that it looks out of, -1: there is none */
    double recess_m; /* how far the glass stands back from that facade's plane */
    char *name;      /* NULL where it has none */
    char
        label[PP_WORLD_LABEL]; /* for people: its name, shortened to fit, or by its kind
                                 * and place in the file W1, W2 or RL1 (a rooflight) */
    int part; /* which of its room's openings it is, as the file has them */
    int line;

    /* Lies it before the planes of all faces, or in them? A point that does so too sees it
     * past all faces. */
    bool faces_open_in;
    bool faces_open_out; /* has no face a part beyond its glass? */
};

/* One endless obstruction parallel to a wall, from the ground up. If it has a distance
 * it is also a wall among the surfaces, long enough to appear endless from the room
 * (skylines.c). Otherwise it hides directions. */
struct pp_skyline {
    int face;          /* its wall; outline.normal points away from the skyline */
    double angle_rad;  /* above the horizontal from the middle of the wall's openings */
    double middle_z_m; /* that middle's height */
    double distance_m; /* from the wall's plane; INFINITY: the angle is the same from
                        * every point */
    double head_z_m; /* of its upper edge: middle_z + distance tan angle, or INFINITY */
    double reflectance;
    int line;
};

/* Has the skyline no distance, and is it before the face? It then hides directions. */
bool pp_world_skyline_is_far(const struct pp_skyline *skyline, int face);

/* Altitude of its upper edge (rad), in the section square to its wall, from a point at
 * height z_m that lies `behind_m` behind the wall's plane (negative: before it). */
double pp_world_skyline_angle(const struct pp_skyline *skyline, double z_m,
                              double behind_m);

/* A box outside; its sides stand among the surfaces too. */
struct pp_block {
    struct pp_vec3 corner; /* lower corner */
    double width_m, depth_m, height_m;
    double rotate_rad; /* about the corner, counter-clockwise seen from above */
    double reflectance;
    const struct pp_finish *finish; /* as a surface's */
    char *name;                     /* NULL where it has none */
    bool is_of_site;                /* given by a building, for all of its rooms */
    enum pp_site_state state;
    int line;

    /* Block of a world: the edges from the corner, width_m and depth_m long, and where
     * its sides stand among the surfaces. */
    struct pp_vec3 along, across;
    int first_side, side_count;
};

/* Furniture, a column or a partition: an upright prism; its sides stand among the
 * surfaces too. */
enum { PP_FITTING_CORNERS = 12 };
struct pp_fitting {
    double xy[PP_FITTING_CORNERS][2]; /* convex, counter-clockwise seen from above */
    int corner_count;
    double low_m, high_m; /* z of its underside and its top */
};

/* Triangles of a file, outside; they stand together among the surfaces too, behind all
 * others. */
struct pp_world_mesh {
    char *name; /* NULL where it has none */
    struct pp_bounds3 bounds;
    int first_side, side_count; /* where among the surfaces */
    int line;
};

/* Outside of a wall and its continuation beyond the room; its pieces are among the
 * surfaces. */
struct pp_facade {
    int face;                  /* its wall */
    struct pp_vec3 corners[4]; /* the rectangle that it fills but for its openings:
                                * lower left, lower right, upper right, upper left, seen
                                * from outside */
    double left_m, right_m, up_m, down_m; /* by how much it is longer than the rectangle
                                           * round its wall, as drawn from outside */
    double depth_m;                       /* of its plane outside the wall's */
    double reflectance;
    int line;
};

/* A piece of ground that the sun is to reach. */
struct pp_garden {
    struct pp_polygon outline; /* at the ground's level, normal up */
    char *name;                /* NULL where it has none */
    int line;
};

/* Point at which light is calculated. */
struct pp_receiver {
    struct pp_vec3 position;
    struct pp_vec3 normal; /* unit */
    int line;
};

enum pp_surroundings { PP_RURAL, PP_URBAN, PP_INDUSTRIAL };
enum pp_work { PP_CLEAN, PP_DIRTY }; /* that is done in the room */
/* Edition of the figures for dirt on glass: of smoky towns, or of cleaner air. */
enum pp_dirt { PP_DIRT_BRE309, PP_DIRT_BS8206 };

struct pp_world {
    char *name, *ref; /* NULL where it has none */
    enum pp_room_use use;
    struct pp_placement placement;      /* in its building */
    double north_rad;                   /* bearing of +y, clockwise from true north */
    double latitude_rad, longitude_rad; /* NAN where the file has none */
    char country[3];                    /* two letters; empty where the file has none */
    enum pp_surroundings surroundings;
    enum pp_work work;
    enum pp_dirt dirt;
    double decorations; /* share of the internally reflected component that the
                         * deterioration of decorations leaves; 1: they are as new */

    double ground_level_m; /* z of the ground outside */
    bool ground_is_open; /* lit by the whole sky everywhere; else shadowed by objects on
                          * it */

    struct pp_surface *surfaces; /* the envelope's faces first */
    int surface_count, face_count;
    struct pp_opening *openings;
    int opening_count;
    struct pp_skyline *skylines;
    int skyline_count;
    struct pp_facade *facades;
    int facade_count;
    struct pp_block *blocks; /* their sides stand together among the surfaces */
    int block_count;
    struct pp_fitting *fittings;
    int fitting_count;
    struct pp_world_mesh *meshes;
    int mesh_count;
    struct pp_garden *gardens;
    int garden_count;

    bool is_empty; /* stands no surface in the room but those that cover others? */

    double height_m;               /* of the highest point of the envelope */
    double working_plane_m;        /* z of the working plane */
    struct pp_region plane;        /* the room's section at that height */
    struct pp_receiver *receivers; /* the file's, or the default grid */
    int receiver_count;
};

/* Label of the first opening on that line of the room file; "" if there is none. */
const char *pp_world_label(const struct pp_world *world, int line);

/* "window" if that opening is in a wall, else "rooflight"; for texts, before its label. */
const char *pp_world_kind(const struct pp_world *world, int line);

/* Area of the floor, m2. */
double pp_world_floor_m2(const struct pp_world *world);

/* Number of surfaces before those of meshes, which come last. */
int pp_world_before_meshes(const struct pp_world *world);

/* The surface behind surface i; behind a side of a block, the first that is none. */
int pp_world_next_but_blocks(const struct pp_world *world, int i);

/* A room as its file describes it (building.h). */
struct pp_room;

/* Resolves a room. Mistakes in its description go to mistakes (PP_BAD_INPUT, and no
 * world). */
enum pp_status pp_world_create(struct pp_world **world, const struct pp_room *room,
                               struct pp_mistakes *mistakes, struct pp_error *err);
void pp_world_destroy(struct pp_world *world); /* NULL is allowed */

#endif
