/* message.h - error messages on standard error. */
#ifndef PP_CLI_MESSAGE_H
#define PP_CLI_MESSAGE_H

#include "cli/exit_status.h"
#include "model/base/error.h"
#include "model/base/mistakes.h"

/* Prints "pepperpot: MESSAGE". Returns the matching exit status. */
enum pp_exit pp_message_error(const struct pp_error *err);

/* Prints "pepperpot df: MESSAGE" and how to get help. Returns PP_EXIT_USAGE. */
enum pp_exit pp_message_usage(const char *command, const struct pp_error *err);

/* "pepperpot: ..." */
void pp_message(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* Warns that a simulation was interrupted and its results are marked so. Returns
 * PP_EXIT_INTERRUPTED. */
enum pp_exit pp_message_unfinished(void);

/* Prints each mistake as "FILE:LINE: error, and the expected value". Returns
 * PP_EXIT_INPUT. */
enum pp_exit pp_message_mistakes(struct pp_mistakes *mistakes);

/* Prints each warning as "FILE:LINE: warning: ..."; with `strict` as an error, without
 * the word "warning". */
void pp_message_warnings(struct pp_mistakes *warnings, bool strict);

#endif
