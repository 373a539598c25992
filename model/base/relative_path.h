/* relative_path.h - the prefix from one folder to another, for relative file names that
 * move. */
#ifndef PP_MODEL_BASE_RELATIVE_PATH_H
#define PP_MODEL_BASE_RELATIVE_PATH_H

#include "model/base/error.h"

/* Finds the prefix that makes a path relative to the folder of `file` valid in the
 * folder of `moved`: "../plans/". It is empty if both folders are the same or one does
 * not exist; only the folders must exist. The caller frees *prefix. Fails only if
 * memory runs out. */
enum pp_status pp_relative_path_prefix(char **prefix, const char *file,
                                       const char *moved, struct pp_error *err);

#endif
