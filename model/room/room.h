/* room.h - a room as described by its file, to be copied and changed. Changes are not
 * checked here; pp_world_create reports mistakes of a changed room like those of a
 * file. */
#ifndef PP_MODEL_ROOM_ROOM_H
#define PP_MODEL_ROOM_ROOM_H

#include <stdbool.h>

#include "model/base/error.h"
#include "model/light/glass.h"
#include "model/room/building.h"

/* Makes a copy, owned by the caller. */
enum pp_status pp_room_copy(struct pp_room **copy, const struct pp_room *room,
                            struct pp_error *err);
void pp_room_destroy(struct pp_room *room); /* copies only; NULL is allowed */

/* Number of openings, which are in the order of the file, as in the world. */
int pp_room_opening_count(const struct pp_room *room);

enum pp_opening_kind { PP_WINDOW, PP_ROOFLIGHT, PP_OPENING };

/* Position and size of a rectangular opening (m). */
struct pp_opening_place {
    double left_m, width_m;  /* as in the file; of a rooflight: x and width */
    double sill_m, height_m; /* as in the file; of a rooflight: y and depth */
};

struct pp_room_opening {
    enum pp_opening_kind kind;
    const char *wall;              /* windows only, not owned; else NULL */
    struct pp_opening_place place; /* NAN for a PP_OPENING, which is any polygon */
    struct pp_glass glass;
    double frame_factor, maintenance; /* NAN maintenance: "auto" */
    int line;
};
struct pp_room_opening pp_room_opening_at(const struct pp_room *room, int index);

/* Moves and resizes a window or a rooflight. */
void pp_room_set_place(struct pp_room *room, int index, struct pp_opening_place place);

/* Appends a copy of the opening at index, with another position and size. */
enum pp_status pp_room_repeat_opening(struct pp_room *room, int index,
                                      struct pp_opening_place place,
                                      struct pp_error *err);

/* Moves a window to another wall, with the same left and sill. */
enum pp_status pp_room_set_wall(struct pp_room *room, int index, const char *wall,
                                struct pp_error *err);

/* Removes an opening; the following ones move up by one index. */
void pp_room_remove_opening(struct pp_room *room, int index);

void pp_room_set_glass(struct pp_room *room, int index, struct pp_glass glass);
void pp_room_set_frame_factor(struct pp_room *room, int index, double frame_factor);
void pp_room_set_maintenance(struct pp_room *room, int index, double maintenance);

/* Replaces the room's sky, given as for pp_sky_words_parse (sky_words.h):
 * "iso-12,30,180". PP_BAD_INPUT if the text is not valid. */
enum pp_status pp_room_set_sky(struct pp_room *room, const char *spec,
                               struct pp_error *err);

/* Replaces the height of the working plane (m above the floor). */
void pp_room_set_working_plane(struct pp_room *room, double height_m);

/* Replaces the room's sky by the sky of another room. */
void pp_room_take_sky(struct pp_room *room, const struct pp_room *other);

/* Spacing (m) of the finest grid of points in the room file; NAN if there is none. */
double pp_room_grid_spacing(const struct pp_room *room);

/* Sets this reflectance for all darker faces of that role (PP_FLOOR, PP_WALL or
 * PP_CEILING). */
void pp_room_lighten(struct pp_room *room, enum pp_role role, double reflectance);

/* Sets the reflectance of the ground outside. open: lit by the whole sky everywhere;
 * else objects shade it. */
void pp_room_set_ground(struct pp_room *room, double reflectance, bool open);

/* Adds a distant skyline in front of a wall; its angle (rad, 0 to less than pi/2) is
 * the same from every point. */
enum pp_status pp_room_add_skyline(struct pp_room *room, const char *wall,
                                   double angle_rad, double reflectance,
                                   struct pp_error *err);

/* Removes skylines, blocks, meshes, and the surfaces that are outside in `world`, the
 * world of this room. Facades stay, since they are part of the building. */
void pp_room_clear_surroundings(struct pp_room *room, const struct pp_world *world);

/* Removes the facades. */
void pp_room_clear_facades(struct pp_room *room);

/* Sets *sound to true if the room has no mistakes. Fails only on a system error. */
enum pp_status pp_room_is_sound(bool *sound, const struct pp_room *room,
                                struct pp_error *err);

#endif
