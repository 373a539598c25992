/* world.h - a room and its surroundings, resolved once, for all calculations.
 *
 * Polygons are in metres, angles in radians, shares are fractions. Axes are the room's
 * own x, y, z (floor at z = 0, z up). References are resolved to indices. Hand methods,
 * tracer, charts and exports read only the world, and the outdoor light given with it
 * (room_light.h). A world owns all its data and does not change. Only copies with other
 * states of their blinds or trees share data and can be changed
 * (build/device_states.h).
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
#include "model/light/bsdf/measured_pane.h"
#include "model/light/glass.h"
#include "model/light/slats/window_device.h"
#include "model/room/placement.h"
#include "model/room/room_use.h"

enum pp_role {
    PP_FLOOR,        /* face of the room's envelope */
    PP_WALL,         /* face of the room's envelope */
    PP_CEILING,      /* face of the room's envelope */
    PP_REVEAL,       /* a side of an opening's depth */
    PP_COVER,        /* door or piece of a dado, in front of a wall, inside */
    PP_FREE_SURFACE, /* a <surface>, inside or outside */
    PP_BLOCK,        /* a side of a <block> */
    PP_FACADE,       /* piece of a <facade>: of its sheet, or a rim */
    PP_SKYLINE,      /* wall of a <skyline> with a distance */
    PP_ROLE_COUNT
};

/* A surface: opaque, visible from both sides, and diffuse unless it has a finish. Faces
 * of the envelope have no holes; each opening refers to its face. */
struct pp_surface {
    struct pp_polygon outline; /* normal: envelope and reveals into the room; blocks
                                * outwards; facades to the open air; skylines towards
                                * the room; free-standing as in the file */
    int (*triangles)
        [3]; /* triangles that cover the outline, by its vertices; NULL: it is convex */
    int triangle_count;
    enum pp_role role;
    bool inside;      /* in the room: envelope, reveal, free-standing inside */
    const char *name; /* name of a wall, door, dado, <surface> or other named part;
                       * NULL: none */
    double front,
        back;        /* reflectance of the side the normal points to, and the other */
    double exitance; /* light emitted by each side, relative to Eh */
    const struct pp_finish *finish; /* named in the file: for the front; for both sides
                                     * of covers, free-standing surfaces and all
                                     * surfaces outside. NULL: grey and diffuse.
                                     * Reflectance is that of `front` */
    double pattern_mean; /* mean of the pattern of the finish over the surface; `front`,
                          * and `back` if it has the finish, are means too. 0: no
                          * pattern and no bumps */
    int owner;           /* index of: a reveal's opening; a cover's wall (surface); a
                    * block; a facade; a skyline; the opening of a shade of this
                    * room. Else -1 */
    bool is_door;        /* cover: door, not dado */
    bool is_of_fitting; /* face of a closed object in the room: nothing sees its back */
    bool is_shade; /* overhang, fin, balcony or shelf of a window, of this room or of
                    * another room in the same front */
    bool is_inner; /* wall: another room or building is behind it */
    int line;      /* line of the room file; 0: none */
};

/* States of the site in which a part exists: always; only before the new building; with
 * the new building; or only together with other buildings that are permitted nearby. A
 * part of the proposed state also exists in the cumulative state. */
enum pp_site_state {
    PP_STATE_BOTH,
    PP_STATE_EXISTING,
    PP_STATE_PROPOSED,
    PP_STATE_CUMULATIVE
};

/* Bytes of an opening's label, including its NUL. */
enum { PP_WORLD_LABEL = 32 };

/* An opening in a face, with its glass. The axes of the opening lie in the face's
 * plane: `along` is horizontal and points right as seen from inside; along x up is the
 * normal, into the room. */
struct pp_opening {
    int face;                  /* surface that contains it */
    struct pp_polygon inner;   /* outline in the face, normal into the room */
    struct pp_polygon outer;   /* outline of the glass: inner, moved outwards by the
                              * reveal */
    struct pp_vec3 along, up;  /* unit */
    double slope_rad;          /* slope of the glass: 0 horizontal, pi/2 vertical */
    double width_m, height_m;  /* extent along `along` and `up` */
    bool rectangle;            /* a rectangle with edges along its axes */
    double middle_z_m;         /* z at mid-height, between upper and lower part */
    struct pp_glass glass;     /* of a pane that scatters: the glass that hand methods
                               * use in its place */
    struct pp_glass uncovered; /* its glass without a curtain */
    const struct pp_pane_scatter *scatter; /* in simulations, instead of `glass`, in the
                                            * axes along, up and normal; not owned;
                                            * NULL: glass */
    struct pp_measured_pane *measured;     /* NULL: not measured */
    double frame_factor;                   /* glass area / opening area */
    double maintenance;                    /* share of the light that passes the dirt */
    bool maintenance_is_auto;              /* from the tables of dirt factors */
    double curtains; /* share of the light that passes the curtains; 1: none */
    struct pp_window_device device; /* PP_DEVICE_NONE: none. A curtain is in `glass` */
    struct pp_blind *blind;         /* data of the blind (slats/blind.h); NULL: none */
    double reveal_m;                /* depth; 0: glass in the plane of the face */
    int facade;                     /* facade that contains it; -1: none */
    double recess_m; /* distance of the glass behind that facade's plane */
    char *name;      /* NULL: no name */
    char
        label[PP_WORLD_LABEL]; /* for people: its name, shortened to fit, or by its kind
                                 * and place in the file W1, W2 or RL1 (a rooflight) */
    int part;                  /* index among its room's openings, in file order */
    bool is_nested;            /* its light comes from the coarse model */
    int counterpart;           /* is_nested: index of its opening in the coarse model */
    int line;

    /* True if no corner of the opening is behind the plane of a face. Then no face
     * hides the opening from a point that is not behind the plane of a face either. */
    bool faces_open_in;
    bool faces_open_out; /* no face has a part outside the plane of its glass */
};

/* A pane in the room's axes, between its windows and the sky: of the coarse model
 * (outside/nested.h), or a face of a tree's crown (outside/trees.h). */
struct pp_outer_pane {
    struct pp_polygon outline; /* normal into the coarse model; out of a crown */
    struct pp_vec3 up;         /* axis of its opening */
    int opening;               /* index in the coarse model's world; -1: a crown */
    int tree;                  /* index of the tree whose crown it bounds; -1: glass */
};

/* A tree outside (outside/trees.h). */
struct pp_tree {
    struct pp_vec3 foot; /* on the ground */
    double height_m, crown_base_m, crown_width_m;
    double transmittance,
        winter_transmittance; /* of the crown, with and without leaves */
    int line;
};

/* An infinitely long obstruction parallel to a wall, from the ground up. With a
 * distance it is also a wall among the surfaces, long enough to appear infinite from
 * the room (skylines.c). Without one it hides directions. */
struct pp_skyline {
    int face;          /* index of the wall; outline.normal points away from the
                        * skyline */
    double angle_rad;  /* altitude, from the centre of the wall's openings */
    double middle_z_m; /* z of that centre */
    double distance_m; /* from the wall's plane; INFINITY: the angle is the same from
                        * every point */
    double head_z_m;   /* z of its upper edge: middle_z + distance tan angle, or
                      * INFINITY */
    double reflectance;
    int line;
};

/* True if the skyline has no distance and is in front of the face; it then hides
 * directions. */
bool pp_world_skyline_is_far(const struct pp_skyline *skyline, int face);

/* Altitude of the skyline's upper edge (rad), in the section perpendicular to its wall,
 * from a point at height z_m that is `behind_m` behind the wall's plane (negative: in
 * front). */
double pp_world_skyline_angle(const struct pp_skyline *skyline, double z_m,
                              double behind_m);

/* A box outside; its sides are surfaces too. */
struct pp_block {
    struct pp_vec3 corner; /* lower corner */
    double width_m, depth_m, height_m;
    double rotate_rad; /* about the corner, counter-clockwise seen from above */
    double reflectance;
    const struct pp_finish *finish; /* as for a surface */
    char *name;                     /* NULL: no name */
    bool is_of_site;                /* given by the building, for all rooms */
    enum pp_site_state state;
    int line;

    /* Set in a world: edges from the corner, of length width_m and depth_m, and the
     * index range of its sides among the surfaces. */
    struct pp_vec3 along, across;
    int first_side, side_count;
};

/* Furniture, a column or a partition: a vertical prism; its sides are surfaces too. */
enum { PP_FITTING_CORNERS = 12 };
struct pp_fitting {
    double xy[PP_FITTING_CORNERS][2]; /* convex, counter-clockwise seen from above */
    int corner_count;
    double low_m, high_m; /* z of underside and top */
};

/* Mesh or outline outside the room. Its triangles are consecutive surfaces, after all others. */
struct pp_world_mesh {
    char *name; /* NULL: no name */
    struct pp_bounds3 bounds;
    int first_side, side_count; /* indices of surfaces */
    bool is_outline;            /* from an <outline> */
    int line;
};

/* Outer side of a wall and its continuation beyond the room; its pieces are
 * surfaces. */
struct pp_facade {
    int face;                  /* index of the wall */
    struct pp_vec3 corners[4]; /* rectangle including openings: lower left, lower
                                * right, upper right, upper left, seen from outside */
    double left_m, right_m, up_m, down_m; /* extension beyond the wall's bounding
                                           * rectangle, seen from outside */
    double depth_m; /* distance of its plane from the wall's, outwards */
    double reflectance;
    int line;
};

/* A garden, assessed for sunlight on the ground. */
struct pp_garden {
    struct pp_polygon outline; /* at ground level, normal up */
    char *name;                /* NULL: no name */
    int line;
};

/* A point at which light is calculated. */
struct pp_receiver {
    struct pp_vec3 position;
    struct pp_vec3 normal; /* unit */
    int line;
    double area_m2; /* part of the working plane that a point of a grid represents; 0:
                     * not a point of a grid */
};

/* An eye that looks along a horizontal line, assessed for glare. */
struct pp_world_view {
    char *name; /* NULL: no name */
    struct pp_vec3 eye;
    double bearing_rad;       /* of the line of sight, clockwise from true north */
    struct pp_vec3 direction; /* line of sight in the room's axes; unit */
    int line;                 /* 0: not from the file */
};

enum pp_surroundings { PP_RURAL, PP_URBAN, PP_INDUSTRIAL };
enum pp_work { PP_CLEAN, PP_DIRTY }; /* type of work in the room */
/* Edition of the data for dirt on glass: for smoky towns, or for cleaner air. */
enum pp_dirt { PP_DIRT_BRE309, PP_DIRT_BS8206 };

struct pp_rough_finishes;

struct pp_world {
    struct pp_rough_finishes *materials; /* materials of the file, shared; NULL: none */
    char *name, *ref;                    /* NULL: no name */
    char *address; /* the house that the room is in; NULL: not given */
    enum pp_room_use use;
    struct pp_placement placement;      /* position in the building */
    double north_rad;                   /* bearing of +y, clockwise from true north */
    double latitude_rad, longitude_rad; /* NAN: not given */
    char country[3];                    /* two letters; empty: not given */
    enum pp_surroundings surroundings;
    enum pp_work work;
    enum pp_dirt dirt;
    double decorations; /* factor on the internally reflected component for the
                         * deterioration of decorations; 1: as new */

    double ground_level_m; /* z of the ground outside */
    bool ground_is_open;   /* lit by the whole sky everywhere; else shaded by objects
                          * on it */

    struct pp_surface *surfaces; /* faces of the envelope first */
    int surface_count, face_count;
    struct pp_opening *openings;
    int opening_count;
    struct pp_skyline *skylines;
    int skyline_count;
    struct pp_facade *facades;
    int facade_count;
    struct pp_block *blocks; /* the sides of a block are consecutive surfaces */
    int block_count;
    struct pp_fitting *fittings;
    int fitting_count;
    struct pp_world_mesh *meshes;
    int mesh_count;
    struct pp_garden *gardens;
    int garden_count;
    struct pp_world_view *views;
    int view_count;

    struct pp_world *within; /* the coarse model that the room is nested in, in its own
                              * axes; held; NULL: none */
    struct pp_placement within_place;  /* converts from the axes of the coarse model */
    struct pp_outer_pane *outer_panes; /* glass of the coarse model, then crowns */
    int outer_pane_count;
    struct pp_tree *trees;
    int tree_count;
    int bare_from, bare_to;   /* months, 1 to 12: first and last without leaves */
    bool trees_are_bare;      /* true: the trees have no leaves */
    int coarse_surface_count; /* surfaces taken from the coarse model */
    bool within_is_before;    /* it is the space in front of the windows; else it is in
                               * the place of the room */
    int holders;              /* holders in addition to the first */

    bool is_empty; /* true: no free-standing surfaces or furniture in the room */

    double height_m;               /* z of the highest point of the envelope */
    double working_plane_m;        /* z of the working plane */
    struct pp_region plane;        /* section of the room at that height */
    struct pp_receiver *receivers; /* receivers of the file, or of the default grid */
    int receiver_count;
};

/* Label of the first opening on that line of the room file; "" if there is none. */
const char *pp_world_label(const struct pp_world *world, int line);

/* "rooflight" if an opening on that line of the room file is not in a wall, else
 * "window": the word before its label in texts. */
const char *pp_world_kind(const struct pp_world *world, int line);

/* Area of the floor, m2. */
double pp_world_floor_m2(const struct pp_world *world);

/* Number of panes of the coarse model between the room and the sky. */
int pp_world_coarse_panes(const struct pp_world *world);

/* Number of surfaces that do not belong to meshes; surfaces of meshes come last. */
int pp_world_before_meshes(const struct pp_world *world);

/* Index of the next surface after i. If i is a side of a block: the surface after the
 * sides of all blocks. */
int pp_world_next_but_blocks(const struct pp_world *world, int i);

/* A room as its file describes it (building.h). */
struct pp_room;

/* Resolves a room. Mistakes in its description are added to mistakes; PP_BAD_INPUT and
 * *world NULL if there are any. */
enum pp_status pp_world_create(struct pp_world **world, const struct pp_room *room,
                               struct pp_mistakes *mistakes, struct pp_error *err);

/* Holds a world for one more owner, and returns it; NULL is allowed. Each owner
 * destroys it. Not for several threads at once. */
struct pp_world *pp_world_hold(struct pp_world *world);
void pp_world_destroy(struct pp_world *world); /* NULL is allowed */

#endif
