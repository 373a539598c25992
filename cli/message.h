/* message.h - error messages on standard error. */
#ifndef PP_CLI_MESSAGE_H
#define PP_CLI_MESSAGE_H

#include "cli/exit_status.h"
#include "model/base/error.h"
#include "model/base/mistakes.h"

/* Prints "pepperpot: MESSAGE". Returns the matching exit status. */
enum pp_exit pp_message_error(const struct pp_error *err);

/* Prints "pepperpot df: MESSAGE" and a reference to the help. Returns PP_EXIT_USAGE. */
enum pp_exit pp_message_usage(const char *command, const struct pp_error *err);

/* Prints "pepperpot: ..." and a line feed. */
void pp_message(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* Warns that a simulation was interrupted, so that its results are marked as
 * unfinished. Returns PP_EXIT_INTERRUPTED. */
enum pp_exit pp_message_unfinished(void);

/* Prints each error as "FILE:LINE: error, and the expected value". Returns
 * PP_EXIT_INPUT. */
enum pp_exit pp_message_mistakes(struct pp_mistakes *mistakes);

/* Prints each warning as "FILE:LINE: warning: ...". If `strict` is set, the word
 * "warning" is omitted. */
void pp_message_warnings(struct pp_mistakes *warnings, bool strict);

#endif
