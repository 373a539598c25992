/* atlas_file.h - appends rows to the file of an atlas, one room at a time.
 *
 * Unlike other output files, an atlas is not written in one step. If a run stops in the
 * middle of a room, the next run removes the incomplete room. The finished file is then
 * the same as after an uninterrupted run. Readers
 * (studies/research/atlas/atlas_table.h) skip an incomplete room.
 */
#ifndef PP_CLI_ATLAS_ATLAS_FILE_H
#define PP_CLI_ATLAS_ATLAS_FILE_H

#include <stdbool.h>
#include <stdio.h>

#include "model/base/error.h"

struct pp_atlas_file {
    const char *path; /* not owned */
    FILE *stream;     /* positioned at the end of the last complete room */
    int rooms;        /* number of complete rooms in the file */
    bool is_new;      /* made by this run: removed if it stays empty */
};

/* Creates the file, or continues it if it begins with the same head (comments and the
 * line of column names). PP_BAD_INPUT if the head differs. Only one run can have the
 * file open. On success the caller closes it. */
enum pp_status pp_atlas_file_open(struct pp_atlas_file *file, const char *path,
                                  const char *head, struct pp_error *err);

/* Appends the rows of the next room, and flushes the file. */
enum pp_status pp_atlas_file_add(struct pp_atlas_file *file, const char *rows,
                                 size_t length, struct pp_error *err);

/* Closes the file. `status` is that of the run, and is returned unless closing fails;
 * after a failure a new file to which nothing was written is removed. */
enum pp_status pp_atlas_file_close(struct pp_atlas_file *file, enum pp_status status,
                                   struct pp_error *err);

#endif
