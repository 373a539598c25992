/* lumen_option.h - the option --lumen-table: the user's own coefficients for the lumen
 * method.
 */
#ifndef PP_CLI_LUMEN_OPTION_H
#define PP_CLI_LUMEN_OPTION_H

#include "cli/exit_status.h"
#include "cli/options.h"
#include "methods/lumen/lumen_table.h"

enum { PP_LUMEN_FILES_MOST = 2 }; /* one for side windows, one for rooflights */

struct pp_lumen_files {
    const char *list[PP_LUMEN_FILES_MOST]; /* file names as typed; strings of argv, not
                                            * owned */
    int count;
};

/* Option list for struct pp_option_group; the values are stored in a struct
 * pp_lumen_files. */
extern const struct pp_option pp_lumen_option[];

/* Loads the program's own tables, and replaces those that the files contain. The caller
 * destroys *table. *table is NULL if there are no files, or after errors. All errors in
 * all files are reported on standard error. */
enum pp_exit pp_lumen_option_load(struct pp_lumen_table **table,
                                  const struct pp_lumen_files *files);

#endif
