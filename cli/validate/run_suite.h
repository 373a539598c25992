/* run_suite.h - runs a suite of known answers, prints what came out and writes its page. */
#ifndef PP_CLI_VALIDATE_RUN_SUITE_H
#define PP_CLI_VALIDATE_RUN_SUITE_H

#include "cli/exit_status.h"
#include "cli/room_options.h"
#include "studies/validation/suite.h"

/* page: a file for the page, or NULL. PP_EXIT_INPUT where answers are outside their
 * limits; of the quick suite PP_EXIT_MACHINE: such a build is not to be trusted. */
enum pp_exit pp_run_suite(const struct pp_suite *suite,
                          const struct pp_room_options *options, enum pp_format format,
                          const char *page);

#endif
