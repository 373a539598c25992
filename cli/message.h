/* message.h - what went wrong, said on standard error. */
#ifndef PP_CLI_MESSAGE_H
#define PP_CLI_MESSAGE_H

#include "cli/exit_status.h"
#include "model/base/error.h"
#include "model/base/mistakes.h"

/* "pepperpot: what the error says". Returns the exit status that goes with it. */
enum pp_exit pp_message_error(const struct pp_error *err);

/* "pepperpot df: what is wrong", and where help is. Returns PP_EXIT_USAGE. */
enum pp_exit pp_message_usage(const char *command, const struct pp_error *err);

/* "pepperpot: ..." */
void pp_message(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* Warns that a simulation was interrupted and its results are marked so. Returns
 * PP_EXIT_INTERRUPTED. */
enum pp_exit pp_message_unfinished(void);

/* Each as "FILE:LINE: what is wrong, and what was expected". Returns PP_EXIT_INPUT. */
enum pp_exit pp_message_mistakes(struct pp_mistakes *mistakes);

#endif
