/* building.h - a parsed room file: one room, or a building of several rooms on one
 * site. world.h makes worlds of its rooms. */
#ifndef PP_MODEL_ROOM_BUILDING_H
#define PP_MODEL_ROOM_BUILDING_H

#include <stdbool.h>
#include <stddef.h>

#include "model/base/error.h"
#include "model/base/mistakes.h"
#include "model/room/project.h"
#include "model/room/text/room_change.h"
#include "model/room/world.h"

/* One room as described in the file: names, lengths and lines, not yet resolved. */
struct pp_room;

/* The line at which a building is mirrored, in plan (m). */
struct pp_mirror_line {
    double from[2], to[2];
};

/* Contents of one file: one room, or a building of several. */
struct pp_building;

/* Reads a room file; path "-" is standard input. Mistakes in the file's form or values
 * are added to mistakes (PP_BAD_INPUT). An unreadable file is PP_SYSTEM, or
 * PP_BAD_INPUT if it does not exist or is a folder. If there are mistakes, *building
 * contains the valid parts, so that pp_world_create can find further mistakes.
 * *building is NULL if the file cannot be read, is not well-formed XML, or contains no
 * room. */
enum pp_status pp_building_read(struct pp_building **building, const char *path,
                                struct pp_mistakes *mistakes, struct pp_error *err);

/* Reads a room file and changes its text first (room_change.h). pp_building_text
 * returns the changed text. */
enum pp_status pp_building_read_changed(struct pp_building **building, const char *path,
                                        const struct pp_room_changes *changes,
                                        struct pp_mistakes *mistakes,
                                        struct pp_error *err);

/* Reads from memory. A file that the text names (mesh, picture, glazing, coarse model)
 * is a mistake, since it cannot be located. */
enum pp_status pp_building_parse(struct pp_building **building, const char *bytes,
                                 size_t length, struct pp_mistakes *mistakes,
                                 struct pp_error *err);

/* Reads the text of another building again, including the changes made when it was
 * read, in the same folder. */
enum pp_status pp_building_read_again(struct pp_building **building,
                                      const struct pp_building *other,
                                      struct pp_mistakes *mistakes,
                                      struct pp_error *err);
void pp_building_destroy(struct pp_building *building); /* NULL is allowed */

const char *pp_building_name(
    const struct pp_building *building); /* NULL: a single room */
int pp_building_room_count(const struct pp_building *building);
struct pp_room *pp_building_room(struct pp_building *building, int index);

/* Index of the room among all rooms of the file, of any state, from 0. */
int pp_building_place(const struct pp_building *building, int index);

/* Number of windows, rooflights and openings in the file before those of that room,
 * including rooms of any state. */
int pp_building_openings_before(const struct pp_building *building, int index);

/* True if any part of the file exists in some states only. */
bool pp_building_has_states(const struct pp_building *building);

/* True if any part of the file exists in the cumulative state only. */
bool pp_building_has_cumulative(const struct pp_building *building);

/* Replaces the rooms by those of a state other than PP_STATE_BOTH; pointers to rooms
 * become invalid. A building just read is in the proposed state.
 * Fails only if memory runs out. */
enum pp_status pp_building_set_state(struct pp_building *building,
                                     enum pp_site_state state, struct pp_error *err);

/* Replaces all rooms by those that exist in both states, with their common surroundings
 * and the mirror image of the placed rooms; pointers to rooms become invalid. The line
 * is in the building's axes (m); its ends must differ. PP_BAD_INPUT if rooms stand on
 * both sides of the line, or if no room has a placement. */
enum pp_status pp_building_mirror(struct pp_building *building,
                                  const struct pp_mirror_line *line,
                                  struct pp_error *err);

/* Client, author and other facts for title blocks; not owned. */
const struct pp_project *pp_building_project(const struct pp_building *building);

/* Text of the file as it was read; not owned. */
const char *pp_building_text(const struct pp_building *building, size_t *length);

/* Height (m) of the block with that name, of the building or of a single room; the
 * height of its walls if it has a roof. NAN if there is no such block, or several. */
double pp_building_block_height(const struct pp_building *building, const char *name);

/* Changes the height (m, greater than 0) of the block with that name. Its roof moves up
 * or down; base and footprint stay. For the rooms of a building the change takes effect
 * at the next pp_building_set_state. */
void pp_building_set_block_height(struct pp_building *building, const char *name,
                                  double height_m);

/* Footprint of the block with that name: its corners at the base, counter-clockwise
 * seen from above; freed by the caller. PP_BAD_INPUT if there is no single block of
 * that name. */
enum pp_status pp_building_block_footprint(struct pp_vec3 **corners, int *count,
                                           const struct pp_building *building,
                                           const char *name, struct pp_error *err);

/* A box on a part of a block's plot, rotated about its corner. */
struct pp_building_cell {
    struct pp_vec3 corner;
    double width_m, depth_m, height_m;
    double rotate_rad;
};

/* Replaces the block with that name, or the boxes of an earlier call, by these boxes (1
 * or more), which keep all other properties of the block. The change takes effect as
 * for pp_building_set_block_height. */
enum pp_status pp_building_divide_block(struct pp_building *building, const char *name,
                                        const struct pp_building_cell *cells, int count,
                                        struct pp_error *err);

/* Gets up to `most` names of blocks, of the building or of a single room; not owned.
 * Returns their number. */
int pp_building_block_names(const struct pp_building *building, const char **names,
                            int most);

#endif
