/* building.h - a parsed room file: a room, or a building of several rooms on one site.
 * world.h makes worlds of its rooms. */
#ifndef PP_MODEL_ROOM_BUILDING_H
#define PP_MODEL_ROOM_BUILDING_H

#include <stdbool.h>
#include <stddef.h>

#include "model/base/error.h"
#include "model/base/mistakes.h"
#include "model/room/project.h"
#include "model/room/text/room_change.h"
#include "model/room/world.h"

/* One room as described in the file: names, lengths and lines, unresolved. */
struct pp_room;

/* A line in plan. */
struct pp_mirror_line {
    double from[2], to[2];
};

/* Contents of one file: one room, or a building of several. */
struct pp_building;

/* Reads a room file; path "-" is standard input. Mistakes in the file's form or values
 * go to mistakes (PP_BAD_INPUT); an unreadable file is PP_SYSTEM (or PP_BAD_INPUT if it
 * does not exist). *building is made even if there are mistakes, as far as the file
 * could be understood, so that pp_world_create can find the rest of them; NULL if
 * nothing could. */
enum pp_status pp_building_read(struct pp_building **building, const char *path,
                                struct pp_mistakes *mistakes, struct pp_error *err);

/* The same with changes in its text (room_change.h), which pp_building_text then has. */
enum pp_status pp_building_read_changed(struct pp_building **building, const char *path,
                                        const struct pp_room_changes *changes,
                                        struct pp_mistakes *mistakes,
                                        struct pp_error *err);

/* The same from memory. */
enum pp_status pp_building_parse(struct pp_building **building, const char *bytes,
                                 size_t length, struct pp_mistakes *mistakes,
                                 struct pp_error *err);

/* The same of the text that another was read from, in its folder. */
enum pp_status pp_building_read_again(struct pp_building **building,
                                      const struct pp_building *other,
                                      struct pp_mistakes *mistakes,
                                      struct pp_error *err);
void pp_building_destroy(struct pp_building *building); /* NULL is allowed */

const char *pp_building_name(
    const struct pp_building *building); /* NULL: a lone room */
int pp_building_room_count(const struct pp_building *building);
struct pp_room *pp_building_room(struct pp_building *building, int index);

/* Index of that room among all rooms of the file, of any state, from 0. */
int pp_building_place(const struct pp_building *building, int index);

/* Number of windows, rooflights and openings before those of that room in the file,
 * over rooms of any state. */
int pp_building_openings_before(const struct pp_building *building, int index);

/* True if the file has anything that exists in one state only. */
bool pp_building_has_states(const struct pp_building *building);

/* Replaces the rooms, whose pointers become invalid, by the rooms in that state,
 * PP_STATE_EXISTING or PP_STATE_PROPOSED. A building just read is in the proposed
 * state. Fails only if out of memory. */
enum pp_status pp_building_set_state(struct pp_building *building,
                                     enum pp_site_state state, struct pp_error *err);

/* Replaces all rooms by those that exist in both states, with their common
 * surroundings, and by the mirror image of those with a place; otherwise like
 * pp_building_set_state. The line is in the building's axes (m), its ends apart.
 * PP_BAD_INPUT if rooms stand on both sides of it, or none has a place. */
enum pp_status pp_building_mirror(struct pp_building *building,
                                  const struct pp_mirror_line *line,
                                  struct pp_error *err);

/* For whom and by whom the file was made; not owned. */
const struct pp_project *pp_building_project(const struct pp_building *building);

/* The file's own text, as it was read; not owned. */
const char *pp_building_text(const struct pp_building *building, size_t *length);

/* Height (m) of the block of that name, of the building or of a lone room: of its walls,
 * where it has a roof. NAN where there is none, or more than one. */
double pp_building_block_height(const struct pp_building *building, const char *name);

/* Gives that block another height (m, greater than 0), roof and all; base and footprint
 * stay. For the rooms of the building it counts from the next pp_building_set_state
 * on. */
void pp_building_set_block_height(struct pp_building *building, const char *name,
                                  double height_m);

/* The outline that the block of that name stands on: its corners, counter-clockwise seen
 * from above, at its base; to be freed. PP_BAD_INPUT where there is not one so called. */
enum pp_status pp_building_block_footprint(struct pp_vec3 **corners, int *count,
                                           const struct pp_building *building,
                                           const char *name, struct pp_error *err);

/* A box that stands on a part of a block's plot: turned about its corner. */
struct pp_building_cell {
    struct pp_vec3 corner;
    double width_m, depth_m, height_m;
    double rotate_rad;
};

/* Puts boxes (1 or more) of that name in place of all that the block is, or of the boxes
 * before; they are like it otherwise. It counts as a new height does, above. */
enum pp_status pp_building_divide_block(struct pp_building *building, const char *name,
                                        const struct pp_building_cell *cells, int count,
                                        struct pp_error *err);

/* Gives up to `most` names of blocks, the building's or a lone room's; not owned.
 * Returns their number. */
int pp_building_block_names(const struct pp_building *building, const char **names,
                            int most);

#endif
