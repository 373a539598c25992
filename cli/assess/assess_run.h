/* assess_run.h - reads, simulates and assesses rooms, for commands that print the
 * results. */
#ifndef PP_CLI_ASSESS_ASSESS_RUN_H
#define PP_CLI_ASSESS_ASSESS_RUN_H

#include "cli/assess/assess_words.h"
#include "cli/exit_status.h"
#include "cli/rooms.h"
#include "reports/assess/assess_text.h"

struct pp_assess_run {
    const struct pp_assess_words *words;
    const struct pp_rooms *rooms, *before; /* before: rooms in their former state; may
                                            * be empty */
    const struct pp_rooms *cumulative;     /* rooms in the cumulative state; may be
                                            * empty */
    const struct pp_rooms *mirrored; /* rooms with the mirror image of the building
                                      * outside; may be empty */
    struct pp_assessments all;
};

/* Rooms in the proposed, former and cumulative states, and with the mirror image
 * outside. Initialise all members to zero. */
struct pp_assess_rooms {
    struct pp_rooms rooms, before, cumulative, mirrored;
};

/* Loads the rooms, with the changes listed in words->room.sweep. The caller unloads
 * them, also after a failure. */
enum pp_exit pp_assess_run_load(struct pp_assess_rooms *rooms,
                                struct pp_assess_words *words, const char *command,
                                char **files, int file_count);
void pp_assess_run_unload(struct pp_assess_rooms *rooms);

/* Reads the median illuminance and the probability of sunshine from the weather file,
 * if --weather is given; also its hours, if a criterion needs them. */
enum pp_exit pp_assess_run_weather(struct pp_assess_words *words);

/* Makes an empty run. The next two functions are callbacks of a struct pp_job whose
 * `data` points to the run. */
struct pp_assess_run pp_assess_run_of(const struct pp_assess_words *words,
                                      const struct pp_assess_rooms *rooms);
enum pp_status pp_assess_run_compute(void *data, struct pp_error *err);
bool pp_assess_run_is_finished(const void *data);
void pp_assess_run_clear(struct pp_assess_run *run);

/* Assesses all rooms of the files and calls `print` with the results; the `data` of
 * `print` is a struct pp_assess_run. command: name of the command, for messages. */
enum pp_exit pp_assess_run(struct pp_assess_words *words, const char *command,
                           char **files, int file_count,
                           enum pp_status (*print)(const void *data, FILE *out,
                                                   struct pp_error *err));

#endif
