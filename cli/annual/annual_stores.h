/* annual_stores.h - the options of annual for stored coefficients: --coefficients,
 * --coefficients-from, --checkpoint. */
#ifndef PP_CLI_ANNUAL_ANNUAL_STORES_H
#define PP_CLI_ANNUAL_ANNUAL_STORES_H

#include "cli/options.h"
#include "cli/output.h"
#include "studies/year/annual.h"

struct pp_annual_stores {
    const char *matrix; /* for Radiance; its randomisations are written beside it */
    const char *from, *checkpoint;

    char *from_path, *into_path;
    FILE *from_file, *checkpoint_file;
    struct pp_output into;
    bool into_is_open;
    struct pp_year_store *list[PP_ANNUAL_STORES_MOST];
    int count;
};

/* Options stored in a struct pp_annual_stores. */
extern const struct pp_option pp_annual_stores_options[];

/* PP_BAD_INPUT if the options cannot be combined with a target error or with
 * --exact-sky. */
enum pp_status pp_annual_stores_check(const struct pp_annual_stores *stores,
                                      bool has_error, bool exact_sky,
                                      struct pp_error *err);

/* Opens the files, and sets the stores of the options. */
enum pp_status pp_annual_stores_open(struct pp_annual_stores *stores,
                                     struct pp_annual_options *options,
                                     struct pp_error *err);

/* Closes the files; keep: the file of randomisations is complete, and replaces an old
 * one. */
enum pp_status pp_annual_stores_close(struct pp_annual_stores *stores, bool keep,
                                      struct pp_error *err);

#endif
