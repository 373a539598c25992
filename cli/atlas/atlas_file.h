/* atlas_file.h - the file of an atlas while it grows: rows are added behind those there
 * are, a room at a time.
 *
 * This file alone is not written whole or not at all. A room that a run was stopped in the
 * middle of is cut off by the next one, so that the bytes are those of a run that never
 * stopped; who reads the file (studies/research/atlas/atlas_table.h) leaves such a room out.
 */
#ifndef PP_CLI_ATLAS_ATLAS_FILE_H
#define PP_CLI_ATLAS_ATLAS_FILE_H

#include <stdio.h>

#include "model/base/error.h"

struct pp_atlas_file {
    const char *path; /* not owned */
    FILE *stream;     /* at the end of the last whole room */
    int rooms;        /* that are there */
};

/* Makes the file, or takes it up where it begins with the same head (its comments and its
 * line of names); PP_BAD_INPUT where it is another's. Two runs cannot have it at a time.
 * On success to be closed. */
enum pp_status pp_atlas_file_open(struct pp_atlas_file *file, const char *path,
                                  const char *head, struct pp_error *err);

/* Adds the rows of the next room, and has them written. */
enum pp_status pp_atlas_file_add(struct pp_atlas_file *file, const char *rows,
                                 size_t length, struct pp_error *err);

enum pp_status pp_atlas_file_close(struct pp_atlas_file *file, enum pp_status status,
                                   struct pp_error *err);

#endif
