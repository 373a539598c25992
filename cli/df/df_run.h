/* df_run.h - the options of the command df, and the results for its rooms. */
#ifndef PP_CLI_DF_DF_RUN_H
#define PP_CLI_DF_DF_RUN_H

#include "cli/df/engine_choice.h"
#include "cli/df/formula_option.h"
#include "cli/lumen_option.h"
#include "cli/moment_choice.h"
#include "cli/rooms.h"
#include "reports/df_result.h"

struct pp_df_options {
    struct pp_room_options room;
    struct pp_lumen_files lumen_files;
    struct pp_formula_words formulae;
    bool list_formulae;
    struct pp_engine_choice engine;
    struct pp_moment_choice moment;
    enum pp_format format;
    bool array;
    bool bands, no_bands;
    bool advise; /* recommend methods (--advise) */
    bool margin; /* also average over the plane without its margin */
};

/* Results of the command for all rooms. */
struct pp_df_run {
    const struct pp_df_options *options;
    const struct pp_rooms *rooms;
    struct pp_results results;
};

/* Makes an empty run. The next three functions are callbacks of a struct pp_job whose
 * `data` points to the run. */
struct pp_df_run pp_df_run_of(const struct pp_df_options *options,
                              const struct pp_rooms *rooms);
enum pp_status pp_df_run_compute(void *data, struct pp_error *err);
enum pp_status pp_df_run_print(const void *data, FILE *out, struct pp_error *err);
bool pp_df_run_is_finished(const void *data);
void pp_df_run_clear(struct pp_df_run *run);

/* Runs the command with --sweep: once for each combination of swept values. */
enum pp_exit pp_df_run_sweep(struct pp_df_options *options, char **files,
                             int file_count);

#endif
