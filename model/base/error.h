/* error.h - reporting of errors.
 *
 * Functions that can fail return a status and take a struct pp_error last, which may be
 * NULL; the message is one sentence for people and names the file, line or value. */
#ifndef PP_MODEL_BASE_ERROR_H
#define PP_MODEL_BASE_ERROR_H

#include "pepperpot.h"

/* Fills err (may be NULL) and returns status. */
enum pp_status pp_fail(struct pp_error *err, enum pp_status status, const char *format,
                       ...) __attribute__((format(printf, 3, 4)));

/* pp_fail for an allocation that was refused. */
enum pp_status pp_fail_memory(struct pp_error *err);

#endif
