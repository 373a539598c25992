/* error.h - reporting of errors.
 *
 * Functions that can fail return a status. Their last argument is a struct pp_error,
 * which may be NULL. The message of an error is one sentence for users and names the
 * file, line or value.
 */
#ifndef PP_MODEL_BASE_ERROR_H
#define PP_MODEL_BASE_ERROR_H

#include "pepperpot.h"

/* Sets err (may be NULL) and returns status. */
enum pp_status pp_fail(struct pp_error *err, enum pp_status status, const char *format,
                       ...) __attribute__((format(printf, 3, 4)));

/* Sets err for a failed allocation and returns PP_SYSTEM. */
enum pp_status pp_fail_memory(struct pp_error *err);

#endif
