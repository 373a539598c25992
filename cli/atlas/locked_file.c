/* locked_file.c - see locked_file.h. */
#include "cli/atlas/locked_file.h"

#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <sys/file.h>
#include <unistd.h>

enum pp_status pp_locked_file_open(FILE **stream, const char *path,
                                   struct pp_error *err)
{
    int descriptor = open(path, O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (descriptor >= 0 && flock(descriptor, LOCK_EX | LOCK_NB) != 0
        && errno == EWOULDBLOCK) {
        close(descriptor);
        return pp_fail(err, PP_SYSTEM,
                       "another run is writing %s; expected one run at a time", path);
    }
    *stream = descriptor >= 0 ? fdopen(descriptor, "r+") : NULL;
    if (*stream)
        return PP_OK;
    pp_fail(err, PP_SYSTEM, "%s cannot be written: %s", path, strerror(errno));
    if (descriptor >= 0)
        close(descriptor);
    return PP_SYSTEM;
}
