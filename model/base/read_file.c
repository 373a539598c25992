/* read_file.c - see read_file.h. */
#include "model/base/read_file.h"

#include <errno.h>
#include <fcntl.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

const char *pp_read_file_title(const char *path)
{
    return strcmp(path, "-") == 0 ? "standard input" : path;
}

static enum pp_status read_all(char **bytes, size_t *length, size_t most, int file,
                               const char *name, struct pp_error *err)
{
    size_t room = most < 1 << 16 ? most + 1 : 1 << 16;
    *length = 0;
    *bytes = malloc(room + 1);
    while (*bytes && *length <= most) {
        if (*length == room) {
            room = room <= most / 4 ? room * 4 : most + 1;
            char *moved = realloc(*bytes, room + 1);
            if (!moved)
                break;
            *bytes = moved;
        }
        ssize_t got = read(file, *bytes + *length, room - *length);
        if (got == 0) {
            (*bytes)[*length] = '\0';
            return PP_OK;
        }
        if (got < 0)
            return errno == EINTR
                       ? pp_fail(err, PP_INTERRUPTED, "%s: interrupted", name)
                       : pp_fail(err, errno == EISDIR ? PP_BAD_INPUT : PP_SYSTEM,
                                 "%s: cannot be read: %s", name, strerror(errno));
        *length += (size_t)got;
    }
    if (*length <= most)
        return pp_fail_memory(err);
    (*bytes)[*length] = '\0';
    return PP_OK;
}

/* True for devices, which must not be opened, since that may have side effects. The
 * null device is allowed; it is an empty file. */
static bool is_device(const char *path)
{
    struct stat there;
    return strcmp(path, "/dev/null") != 0 && stat(path, &there) == 0
           && (S_ISCHR(there.st_mode) || S_ISBLK(there.st_mode));
}

static bool is_regular(int file)
{
    struct stat there;
    return fstat(file, &there) == 0 && S_ISREG(there.st_mode);
}

/* Reads a file without a size, such as a pipe, up to PP_READ_FILE_STREAM_MOST. */
static enum pp_status read_stream(char **bytes, size_t *length, size_t most, int file,
                                  const char *name, struct pp_error *err)
{
    bool less = PP_READ_FILE_STREAM_MOST < most;
    enum pp_status status = read_all(
        bytes, length, less ? PP_READ_FILE_STREAM_MOST : most, file, name, err);
    if (status == PP_OK && less && *length > PP_READ_FILE_STREAM_MOST)
        return pp_fail(
            err, PP_BAD_INPUT,
            "%s: the decompressed file is larger than %d MiB; expected a smaller file",
            name, (int)(PP_READ_FILE_STREAM_MOST >> 20));
    return status;
}

/* standard: read standard input in place of the path. */
static enum pp_status read_path(char **bytes, size_t *length, const char *path,
                                bool standard, size_t most, struct pp_error *err)
{
    const char *name = standard ? pp_read_file_title(path) : path;
    *bytes = NULL;
    if (!*path)
        return pp_fail(
            err, PP_BAD_INPUT,
            "the name of the file is empty; expected a name, or - for standard input");
    if (!standard && is_device(path))
        return pp_fail(err, PP_BAD_INPUT, "%s: this is a device; expected a file",
                       name);
    int file = standard ? STDIN_FILENO : open(path, O_RDONLY | O_CLOEXEC);
    if (file < 0) {
        bool missing = errno == ENOENT || errno == ENOTDIR || errno == ENAMETOOLONG;
        return pp_fail(err, missing ? PP_BAD_INPUT : PP_SYSTEM,
                       "%s: cannot be opened: %s", name, strerror(errno));
    }
    enum pp_status status = (is_regular(file) ? read_all : read_stream)(
        bytes, length, most, file, name, err);
    if (!standard)
        close(file);
    if (status != PP_OK) {
        free(*bytes);
        *bytes = NULL;
    }
    return status;
}

enum pp_status pp_read_file(char **bytes, size_t *length, const char *path, size_t most,
                            struct pp_error *err)
{
    return read_path(bytes, length, path, strcmp(path, "-") == 0, most, err);
}

enum pp_status pp_read_file_regular(char **bytes, size_t *length, const char *path,
                                    size_t most, struct pp_error *err)
{
    struct stat there;
    *bytes = NULL;
    if (stat(path, &there) == 0 && !S_ISREG(there.st_mode))
        return pp_fail(err, PP_BAD_INPUT, "%.200s: this is not a regular file", path);
    return read_path(bytes, length, path, false, most, err);
}
