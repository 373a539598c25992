/* assess_run.h - rooms read, traced and judged, for the commands that print it. */
#ifndef PP_CLI_ASSESS_ASSESS_RUN_H
#define PP_CLI_ASSESS_ASSESS_RUN_H

#include "cli/assess/assess_words.h"
#include "cli/exit_status.h"
#include "cli/rooms.h"
#include "reports/assess/assess_text.h"

struct pp_assess_run {
    const struct pp_assess_words *words;
    const struct pp_rooms *rooms, *before; /* before: as they were; may be empty */
    const struct pp_rooms *mirrored; /* with the mirror image outside; may be empty */
    struct pp_assessments all;
};

/* Assesses all rooms of the files and prints them by `print`, whose data is a struct
 * pp_assess_run. command: its name, for messages. */
enum pp_exit pp_assess_run(struct pp_assess_words *words, const char *command,
                           char **files, int file_count,
                           enum pp_status (*print)(const void *data, FILE *out,
                                                   struct pp_error *err));

#endif
