/* rooms.h - reads and resolves the room files of a command line. */
#ifndef PP_CLI_ROOMS_H
#define PP_CLI_ROOMS_H

#include <stdbool.h>

#include "cli/exit_status.h"
#include "cli/room_options.h"
#include "studies/study_room.h"

struct pp_rooms {
    struct pp_study_room *list;
    int count;
    bool several; /* results are printed as a list, since a file describes a building,
                   * or there are several files */
    bool more_than_one_file;
    struct pp_building **buildings; /* buildings to which the rooms belong */
    int building_count;
    struct pp_mistakes **doubts; /* for each room, the warnings about its input */
    int doubt_count;
};

/* Reads all files and resolves all their rooms, with the sky and points given by the
 * options. If there are errors, all errors in all files are reported on standard error,
 * and nothing is loaded. */
enum pp_exit pp_rooms_load(struct pp_rooms *rooms, const char *command, char **files,
                           int file_count, const struct pp_room_options *options);

/* Loads the rooms again in another state, existing or cumulative. Buildings without
 * that state are omitted. */
enum pp_exit pp_rooms_load_state(struct pp_rooms *rooms, const char *command,
                                 const struct pp_rooms *proposed,
                                 const struct pp_room_options *options,
                                 enum pp_site_state state);

/* Loads the rooms again. Each building then has the parts that exist in both states,
 * and the mirror image of its placed rooms about the line. Every file must have
 * states. */
enum pp_exit pp_rooms_load_mirrored(struct pp_rooms *rooms, const char *command,
                                    const struct pp_rooms *proposed,
                                    const struct pp_room_options *options,
                                    const struct pp_mirror_line *line);

void pp_rooms_clear(struct pp_rooms *rooms);

#endif
