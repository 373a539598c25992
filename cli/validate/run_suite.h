/* run_suite.h - runs a suite, prints its results and writes its page. */
#ifndef PP_CLI_VALIDATE_RUN_SUITE_H
#define PP_CLI_VALIDATE_RUN_SUITE_H

#include "cli/exit_status.h"
#include "cli/room_options.h"
#include "reports/parts/format.h"
#include "studies/research/validation/suite.h"

/* Source of a suite's cases. */
struct pp_suite_source {
    const struct pp_suite *suite;
    enum pp_status (*find)(void *data, struct pp_known_cases *cases,
                           struct pp_error *err);
    bool (*is_finished)(const void *data); /* as in job.h; NULL: the computation cannot
                                            * be interrupted */
    void *data;
};

/* Runs the suite. page: file for the page of results; NULL: none. PP_EXIT_INPUT if more
 * results than permitted are outside their limits. For the quick suite the status is
 * then PP_EXIT_MACHINE, since the build is unreliable. */
enum pp_exit pp_run_suite(const struct pp_suite_source *source,
                          const struct pp_room_options *options, enum pp_format format,
                          const char *page);

/* Runs a suite with its own rooms. Otherwise like pp_run_suite. */
enum pp_exit pp_run_suite_known(const struct pp_suite *suite,
                                const struct pp_room_options *options,
                                enum pp_format format, const char *page);

#endif
