/* relative_path.h - adapts relative file names to a file that moves to another
 * folder. */
#ifndef PP_MODEL_BASE_RELATIVE_PATH_H
#define PP_MODEL_BASE_RELATIVE_PATH_H

#include "model/base/error.h"

/* Finds the prefix that makes a path relative to the folder of `file` valid in the
 * folder of `moved`: "../plans/". The files need not exist. The prefix is empty if both
 * folders are the same, or if one of them does not exist. The caller frees *prefix.
 * Fails only if memory runs out. */
enum pp_status pp_relative_path_prefix(char **prefix, const char *file,
                                       const char *moved, struct pp_error *err);

#endif
