/* rooms.h - the room files of a command line, read and resolved. */
#ifndef PP_CLI_ROOMS_H
#define PP_CLI_ROOMS_H

#include <stdbool.h>

#include "cli/exit_status.h"
#include "cli/room_options.h"
#include "studies/study_room.h"

struct pp_rooms {
    struct pp_study_room *list;
    int count;
    bool several; /* a building, or more than one file: results are a list */
    bool more_than_one_file;
    struct pp_building **buildings; /* the rooms' buildings */
    int building_count;
    struct pp_mistakes **doubts; /* warnings about each room */
    int doubt_count;
};

/* Reads all files and resolves all their rooms, with the sky and points of the options.
 * All errors in all files are reported on standard error; nothing is then loaded. */
enum pp_exit pp_rooms_load(struct pp_rooms *rooms, const char *command, char **files,
                           int file_count, const struct pp_room_options *options);

/* Loads the rooms again in another state, existing or cumulative. Buildings without
 * that state are left out. */
enum pp_exit pp_rooms_load_state(struct pp_rooms *rooms, const char *command,
                                 const struct pp_rooms *proposed,
                                 const struct pp_room_options *options,
                                 enum pp_site_state state);

/* Loads the rooms again with all proposed parts replaced by the mirror image of the
 * retained parts of each building. Every file must have states. */
enum pp_exit pp_rooms_load_mirrored(struct pp_rooms *rooms, const char *command,
                                    const struct pp_rooms *proposed,
                                    const struct pp_room_options *options,
                                    const struct pp_mirror_line *line);

void pp_rooms_clear(struct pp_rooms *rooms);

#endif
