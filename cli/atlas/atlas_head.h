/* atlas_head.h - what the file of an atlas begins with: its form, how its rooms were made
 * and traced, the names of its columns.
 */
#ifndef PP_CLI_ATLAS_ATLAS_HEAD_H
#define PP_CLI_ATLAS_ATLAS_HEAD_H

#include "studies/research/atlas/atlas_columns.h"
#include "studies/research/atlas/atlas_drawn.h"

/* Settings, beside the methods, that determine the rows of a file. */
struct pp_atlas_making {
    enum pp_atlas_sky sky;
    struct pp_atlas_trace trace;
};

/* The head; the caller's to free, NULL when memory is out. */
char *pp_atlas_head_text(const struct pp_atlas_making *making,
                         const struct pp_atlas_columns *columns);

/* Reads how a file was made from its head; PP_BAD_INPUT says what is wrong with it. */
enum pp_status pp_atlas_head_read(struct pp_atlas_making *making, const char *path,
                                  struct pp_error *err);

#endif
