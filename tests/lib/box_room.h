/* box_room.h - a rectangular room with windows and rooflights, built by hand: a world
 * and its light without a room file, for tests of functions that read worlds. */
#ifndef PP_TESTS_LIB_BOX_ROOM_H
#define PP_TESTS_LIB_BOX_ROOM_H

#include "model/light/outside_light.h"
#include "model/room/world.h"

enum { BOX_SOUTH, BOX_EAST, BOX_NORTH, BOX_WEST, BOX_FLOOR, BOX_CEILING, BOX_FACES };
enum { BOX_MOST_OPENINGS = 4 };

/* Owns everything its world points to; must not be copied once built. */
struct box_room {
    struct pp_world world;
    struct pp_outside_light light;
    struct pp_surface surfaces[BOX_FACES];
    struct pp_vec3 corners[BOX_FACES][4];
    struct pp_opening openings[BOX_MOST_OPENINGS];
    struct pp_vec3 inner[BOX_MOST_OPENINGS][4], outer[BOX_MOST_OPENINGS][4];
    struct pp_skyline skyline;
    struct pp_ring ring;
    double ring_xy[4][2];
};

static inline struct pp_polygon box_polygon(struct pp_vec3 *corners)
{
    struct pp_vec3 twice = pp_vec_cross(pp_vec_sub(corners[2], corners[0]),
                                        pp_vec_sub(corners[3], corners[1]));
    return (struct pp_polygon){4, corners, pp_vec_unit(twice),
                               pp_vec_length(twice) / 2.0};
}

/* Builds the room, x to width_m, y to depth_m, without openings, under an overcast
 * sky. */
static inline void box_room_build(struct box_room *box, double width_m, double depth_m,
                                  double height_m, double floor, double walls,
                                  double ceiling)
{
    double w = width_m, d = depth_m, h = height_m;
    const struct pp_vec3 corners[BOX_FACES][4] = {
        [BOX_SOUTH] = {{w, 0, 0}, {0, 0, 0}, {0, 0, h}, {w, 0, h}},
        [BOX_EAST] = {{w, d, 0}, {w, 0, 0}, {w, 0, h}, {w, d, h}},
        [BOX_NORTH] = {{0, d, 0}, {w, d, 0}, {w, d, h}, {0, d, h}},
        [BOX_WEST] = {{0, 0, 0}, {0, d, 0}, {0, d, h}, {0, 0, h}},
        [BOX_FLOOR] = {{0, 0, 0}, {w, 0, 0}, {w, d, 0}, {0, d, 0}},
        [BOX_CEILING] = {{0, 0, h}, {0, d, h}, {w, d, h}, {w, 0, h}},
    };
    *box = (struct box_room){0};
    memcpy(box->corners, corners, sizeof corners);
    for (int i = 0; i < BOX_FACES; i++) {
        double rho = i == BOX_FLOOR ? floor : i == BOX_CEILING ? ceiling : walls;
        enum pp_role role = i == BOX_FLOOR     ? PP_FLOOR
                            : i == BOX_CEILING ? PP_CEILING
                                               : PP_WALL;
        box->surfaces[i] = (struct pp_surface){.outline = box_polygon(box->corners[i]),
                                               .role = role,
                                               .inside = true,
                                               .front = rho,
                                               .back = 0.2,
                                               .owner = -1};
    }
    const double plane[4][2] = {{0, 0}, {w, 0}, {w, d}, {0, d}};
    memcpy(box->ring_xy, plane, sizeof plane);
    box->ring = (struct pp_ring){4, box->ring_xy};
    box->light =
        (struct pp_outside_light){.sky = pp_sky_overcast(), .ground_reflectance = 0.2};
    box->world = (struct pp_world){
        .decorations = 1.0,
        .surfaces = box->surfaces,
        .surface_count = BOX_FACES,
        .face_count = BOX_FACES,
        .openings = box->openings,
        .is_empty = true,
        .height_m = h,
        .working_plane_m = 0.85,
        .plane = {1, &box->ring},
    };
}

/* Adds an opening of clear glass to a face; `start`: its lower left corner seen from
 * inside. In floor and ceiling the width is along +x. */
static inline struct pp_opening *box_room_open(struct box_room *box, int face,
                                               struct pp_vec3 start, double width_m,
                                               double height_m)
{
    int index = box->world.opening_count++;
    struct pp_opening *opening = box->openings + index;
    struct pp_vec3 normal = box->surfaces[face].outline.normal;
    bool level = fabs(normal.z) > 0.5;
    struct pp_vec3 along =
        level ? pp_vec(1, 0, 0) : pp_vec_cross(pp_vec(0, 0, 1), normal);
    struct pp_vec3 up = pp_vec_cross(normal, along);
    struct pp_vec3 *c = box->inner[index];
    c[0] = start;
    c[1] = pp_vec_along(c[0], width_m, along);
    c[2] = pp_vec_along(c[1], height_m, up);
    c[3] = pp_vec_along(c[0], height_m, up);
    memcpy(box->outer[index], c, sizeof box->outer[index]);
    *opening = (struct pp_opening){
        .face = face,
        .inner = box_polygon(c),
        .outer = box_polygon(box->outer[index]),
        .along = along,
        .up = up,
        .slope_rad = acos(-normal.z),
        .width_m = width_m,
        .height_m = height_m,
        .rectangle = true,
        .middle_z_m = (c[0].z + c[2].z) / 2.0,
        .glass = pp_glass_clear_single(),
        .frame_factor = 1.0,
        .maintenance = 1.0,
        .curtains = 1.0,
        .line = 7 + index,
    };
    return opening;
}

/* Adds a window to the south wall, from the plan's x = left_m. */
static inline struct pp_opening *box_room_south(struct box_room *box, double left_m,
                                                double sill_m, double width_m,
                                                double height_m)
{
    /* Seen from inside, x decreases to the right. */
    return box_room_open(box, BOX_SOUTH, pp_vec(left_m + width_m, 0, sill_m), width_m,
                         height_m);
}

/* Moves the glass outwards by a reveal. */
static inline void box_room_reveal(struct box_room *box, int index, double reveal_m)
{
    struct pp_opening *opening = box->openings + index;
    opening->reveal_m = reveal_m;
    for (int i = 0; i < 4; i++)
        box->outer[index][i] =
            pp_vec_along(box->inner[index][i], -reveal_m, opening->inner.normal);
}

/* Adds a skyline to the south wall; its angle is measured at middle_z_m. */
static inline void box_room_skyline(struct box_room *box, double angle_rad,
                                    double middle_z_m, double distance_m)
{
    box->skyline = (struct pp_skyline){
        .face = BOX_SOUTH,
        .angle_rad = angle_rad,
        .middle_z_m = middle_z_m,
        .distance_m = distance_m,
        .head_z_m =
            isinf(distance_m) ? INFINITY : middle_z_m + distance_m * tan(angle_rad),
        .reflectance = 0.2};
    box->world.skylines = &box->skyline;
    box->world.skyline_count = 1;
}

#endif
