/* run_suite.h - runs a suite, prints what came out and writes its page. */
#ifndef PP_CLI_VALIDATE_RUN_SUITE_H
#define PP_CLI_VALIDATE_RUN_SUITE_H

#include "cli/exit_status.h"
#include "cli/room_options.h"
#include "reports/parts/format.h"
#include "studies/research/validation/suite.h"

/* Where a suite's cases come from. */
struct pp_suite_source {
    const struct pp_suite *suite;
    enum pp_status (*find)(void *data, struct pp_known_cases *cases,
                           struct pp_error *err);
    bool (*is_finished)(const void *data); /* as in job.h; NULL: nothing stops it */
    void *data;
};

/* page: a file for the page, or NULL. PP_EXIT_INPUT where more answers are outside their
 * limits than may be; of the quick suite PP_EXIT_MACHINE: such a build is not to be
 * trusted. */
enum pp_exit pp_run_suite(const struct pp_suite_source *source,
                          const struct pp_room_options *options, enum pp_format format,
                          const char *page);

/* The same of a suite that has its own rooms. */
enum pp_exit pp_run_suite_known(const struct pp_suite *suite,
                                const struct pp_room_options *options,
                                enum pp_format format, const char *page);

#endif
