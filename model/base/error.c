/* error.c - see error.h. */
#include "model/base/error.h"

#include <stdarg.h>
#include <stdio.h>

enum pp_status pp_fail(struct pp_error *err, enum pp_status status, const char *format,
                       ...)
{
    if (err) {
        va_list args;
        va_start(args, format);
        vsnprintf(err->message, sizeof err->message, format, args);
        va_end(args);
        err->status = status;
    }
    return status;
}

enum pp_status pp_fail_memory(struct pp_error *err)
{
    return pp_fail(err, PP_SYSTEM, "out of memory");
}
