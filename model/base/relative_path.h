/* relative_path.h - the prefix from one folder to another, to rewrite relative file
 * names when they move. */
#ifndef PP_MODEL_BASE_RELATIVE_PATH_H
#define PP_MODEL_BASE_RELATIVE_PATH_H

#include "model/base/error.h"

/* The prefix that makes a path relative to the folder of `file` valid in the folder of
 * `moved`: "../plans/", or nothing if both folders are the same or one does not exist. Only
 * the folders have to exist. *prefix is the caller's; fails only if memory is out. */
enum pp_status pp_relative_path_prefix(char **prefix, const char *file,
                                       const char *moved, struct pp_error *err);

#endif
