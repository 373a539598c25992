/* lumen_option.h - --lumen-table: a user's own coefficients for the lumen method.
 */
#ifndef PP_CLI_LUMEN_OPTION_H
#define PP_CLI_LUMEN_OPTION_H

#include "cli/exit_status.h"
#include "cli/options.h"
#include "methods/lumen/lumen_table.h"

enum { PP_LUMEN_FILES_MOST = 2 }; /* one for side windows, one for rooflights */

struct pp_lumen_files {
    const char *list[PP_LUMEN_FILES_MOST]; /* as typed; borrowed from argv */
    int count;
};

/* Option for struct pp_option_group; the values are stored in a struct
 * pp_lumen_files. */
extern const struct pp_option pp_lumen_option[];

/* Loads the program's tables, with those in the files in place of the program's own.
 * The caller destroys *table, which is NULL if there are no files. All errors in all
 * files are reported on standard error; *table is then NULL. */
enum pp_exit pp_lumen_option_load(struct pp_lumen_table **table,
                                  const struct pp_lumen_files *files);

#endif
