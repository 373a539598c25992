/* room.h - a room as described by its file, to be copied and changed. Nothing is
 * checked here: pp_world_create finds the mistakes of a changed room like those of a
 * file. */
#ifndef PP_MODEL_ROOM_ROOM_H
#define PP_MODEL_ROOM_ROOM_H

#include <stdbool.h>

#include "model/base/error.h"
#include "model/light/glass.h"
#include "model/room/building.h"

/* A copy, which is the caller's. */
enum pp_status pp_room_copy(struct pp_room **copy, const struct pp_room *room,
                            struct pp_error *err);
void pp_room_destroy(struct pp_room *room); /* of copies only; NULL is allowed */

/* Openings have the order of the file, which is also that of the world's openings. */
int pp_room_opening_count(const struct pp_room *room);

enum pp_opening_kind { PP_WINDOW, PP_ROOFLIGHT, PP_OPENING };

/* Place of a rectangular opening (m). */
struct pp_opening_place {
    double left_m, width_m;  /* of a window, as its file has them; of a rooflight x */
    double sill_m, height_m; /* of a window; of a rooflight y and its depth */
};

struct pp_room_opening {
    enum pp_opening_kind kind;
    const char *wall;              /* of a window, not owned; else NULL */
    struct pp_opening_place place; /* NAN of a PP_OPENING, which is any polygon */
    struct pp_glass glass;
    double frame_factor, maintenance; /* maintenance NAN: auto */
    int line;
};
struct pp_room_opening pp_room_opening_at(const struct pp_room *room, int index);

/* Moves and resizes a window or a rooflight. */
void pp_room_set_place(struct pp_room *room, int index, struct pp_opening_place place);

/* Appends a copy of the opening at index, with another place. */
enum pp_status pp_room_repeat_opening(struct pp_room *room, int index,
                                      struct pp_opening_place place,
                                      struct pp_error *err);

/* Puts a window into another wall, at the same left and sill. */
enum pp_status pp_room_set_wall(struct pp_room *room, int index, const char *wall,
                                struct pp_error *err);

/* Removes an opening; those behind it move up. */
void pp_room_remove_opening(struct pp_room *room, int index);

void pp_room_set_glass(struct pp_room *room, int index, struct pp_glass glass);
void pp_room_set_frame_factor(struct pp_room *room, int index, double frame_factor);
void pp_room_set_maintenance(struct pp_room *room, int index, double maintenance);

/* Puts another sky in place of the room's, in the words of pp_sky_words_parse
 * (sky_words.h): "iso-12,30,180". */
enum pp_status pp_room_set_sky(struct pp_room *room, const char *spec,
                               struct pp_error *err);

/* Puts the other room's sky in place of the room's. */
void pp_room_take_sky(struct pp_room *room, const struct pp_room *other);

/* Spacing of the finest grid of points that the room file gives (m); NAN: it has none. */
double pp_room_grid_spacing(const struct pp_room *room);

/* Gives all faces of that role (PP_FLOOR, PP_WALL or PP_CEILING) that are darker this
 * reflectance. */
void pp_room_lighten(struct pp_room *room, enum pp_role role, double reflectance);

/* Sets the reflectance of the ground outside; open: it is lit by the whole sky
 * everywhere, else it lies in the shadow of objects on it. */
void pp_room_set_ground(struct pp_room *room, double reflectance, bool open);

/* Puts one more skyline before a wall, so far away that its angle (rad, 0 to less than
 * pi/2) is the same from every point. */
enum pp_status pp_room_add_skyline(struct pp_room *room, const char *wall,
                                   double angle_rad, double reflectance,
                                   struct pp_error *err);

/* Removes skylines, blocks, meshes and the surfaces that stand outside in `world`, which is the
 * room's. Facades stay: they are the building's own. */
void pp_room_clear_surroundings(struct pp_room *room, const struct pp_world *world);

/* Removes the outside walls that go on beyond the room. */
void pp_room_clear_facades(struct pp_room *room);

/* Does the room make sense? Fails only where the machine does. */
enum pp_status pp_room_is_sound(bool *sound, const struct pp_room *room,
                                struct pp_error *err);

#endif
