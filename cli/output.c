/* output.c - writes a new file in the same directory, and renames it to the target. */
#include "cli/output.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "cli/interrupt.h"

enum { MOST_LINKS = 40 };

/* Makes the path of `name` in the directory of `path`; the caller frees it. NULL: out
 * of memory. */
static char *beside(const char *path, const char *name)
{
    const char *slash = strrchr(path, '/');
    int length = slash ? (int)(slash - path) + 1 : 0;
    char *joined;
    return asprintf(&joined, "%.*s%s", length, path, name) < 0 ? NULL : joined;
}

static enum pp_status fail_file(struct pp_error *err, const char *path, int number)
{
    return pp_fail(err, PP_SYSTEM, "%s cannot be written: %s", path, strerror(number));
}

/* Follows symbolic links; the last one may point to a file that does not exist yet. The
 * caller frees *resolved. */
static enum pp_status follow_links(const char *path, char **resolved,
                                   struct pp_error *err)
{
    char *current = strdup(path);
    for (int i = 0; current && i < MOST_LINKS; i++) {
        char target[PATH_MAX];
        ssize_t length = readlink(current, target, sizeof target - 1);
        if (length < 0) {
            *resolved = current;
            return PP_OK;
        }
        target[length] = '\0';
        char *next = target[0] == '/' ? strdup(target) : beside(current, target);
        free(current);
        current = next;
    }
    if (!current)
        return pp_fail_memory(err);
    free(current);
    return fail_file(err, path, ELOOP);
}

/* Checks that a file can be written there later. */
static enum pp_status check_output_path(const char *path, struct pp_error *err)
{
    struct stat there;
    if (stat(path, &there) == 0) {
        if (S_ISDIR(there.st_mode))
            return pp_fail(err, PP_SYSTEM, "%s cannot be written: it is a directory",
                           path);
        if (access(path, W_OK) != 0)
            return fail_file(err, path, errno);
        if (!S_ISREG(there.st_mode))
            return PP_OK;
    } else if (errno != ENOENT) {
        return fail_file(err, path, errno);
    }
    char *directory = beside(path, ".");
    if (!directory)
        return pp_fail_memory(err);
    enum pp_status status = PP_OK;
    if (access(directory, W_OK | X_OK) != 0)
        status = fail_file(err, path, errno);
    free(directory);
    return status;
}

enum pp_status pp_output_open(struct pp_output *output, const char *path,
                              struct pp_error *err)
{
    *output = (struct pp_output){0};
    if (path && strcmp(path, "-") != 0) {
        enum pp_status status = follow_links(path, &output->path, err);
        if (status == PP_OK)
            status = check_output_path(output->path, err);
        if (status != PP_OK) {
            pp_output_clear(output);
            return status;
        }
    }
    output->stream = open_memstream(&output->bytes, &output->size);
    if (!output->stream) {
        pp_output_clear(output);
        return pp_fail_memory(err);
    }
    return PP_OK;
}

/* Writes all bytes; -1 and errno on failure. */
static int write_all(int file, const char *bytes, size_t size)
{
    while (size > 0) {
        ssize_t written = write(file, bytes, size);
        if (written < 0 && errno != EINTR)
            return -1;
        if (written > 0) {
            bytes += written;
            size -= (size_t)written;
        }
    }
    return 0;
}

/* Writes directly to an open file, which may be a pipe that nobody reads, and closes
 * it. The result of closing counts, since some file systems report errors only then. */
static int write_through(int file, const struct pp_output *output)
{
    if (file < 0)
        return -1;
    pp_interrupt_end_at_once();
    int failed = write_all(file, output->bytes, output->size) != 0 ? errno : 0;
    if (close(file) != 0 && !failed)
        failed = errno;
    errno = failed;
    return failed ? -1 : 0;
}

/* Mode of the replaced file, or the default mode of a new one. */
static mode_t mode_for(const char *path)
{
    struct stat there;
    if (stat(path, &there) == 0)
        return there.st_mode & 07777;
    mode_t mask = umask(0);
    umask(mask);
    return 0666 & ~mask;
}

/* Writes the new file to the disk, and renames it to the target. */
static int fill_and_rename(int file, const char *temporary,
                           const struct pp_output *output)
{
    int failed = 0;
    if (write_all(file, output->bytes, output->size) != 0
        || fchmod(file, mode_for(output->path)) != 0 || fsync(file) != 0)
        failed = errno;
    if (close(file) != 0 && !failed)
        failed = errno;
    if (!failed && rename(temporary, output->path) != 0)
        failed = errno;
    return failed;
}

/* Writes a new file beside the old one and replaces the old one by it. Returns 0, or -1
 * and errno. Signals are blocked, so that the temporary file is never left behind. */
static int replace(const struct pp_output *output)
{
    char *temporary = beside(output->path, ".pepperpot-XXXXXX");
    if (!temporary)
        return -1;
    sigset_t all, before;
    sigfillset(&all);
    sigprocmask(SIG_BLOCK, &all, &before);

    int failed = 0;
    int file = mkostemp(temporary, O_CLOEXEC);
    if (file < 0)
        failed = errno;
    else if ((failed = fill_and_rename(file, temporary, output)) != 0)
        unlink(temporary);

    sigprocmask(SIG_SETMASK, &before, NULL);
    free(temporary);
    errno = failed;
    return failed ? -1 : 0;
}

enum pp_status pp_output_try(const char *path, struct pp_error *err)
{
    struct pp_output output;
    enum pp_status status = pp_output_open(&output, path, err);
    if (status == PP_OK)
        pp_output_clear(&output);
    return status;
}

enum pp_status pp_output_commit(struct pp_output *output, struct pp_error *err)
{
    int broken = ferror(output->stream);
    broken |= fclose(output->stream);
    output->stream = NULL;
    if (broken) {
        pp_output_clear(output);
        return pp_fail_memory(err);
    }

    struct stat there;
    int done;
    if (!output->path)
        done = write_through(dup(STDOUT_FILENO), output);
    else if (stat(output->path, &there) == 0 && !S_ISREG(there.st_mode))
        done =
            write_through(open(output->path, O_WRONLY | O_CLOEXEC | O_NOCTTY), output);
    else
        done = replace(output);

    enum pp_status status = PP_OK;
    if (done != 0)
        status = fail_file(err, output->path ? output->path : "standard output", errno);
    pp_output_clear(output);
    return status;
}

void pp_output_clear(struct pp_output *output)
{
    if (output->stream)
        fclose(output->stream);
    free(output->bytes);
    free(output->path);
    *output = (struct pp_output){0};
}

enum pp_status pp_output_close(struct pp_output *output, enum pp_status status,
                               struct pp_error *err)
{
    if (status == PP_OK)
        return pp_output_commit(output, err);
    pp_output_clear(output);
    return status;
}

enum pp_status pp_output_put(void *stream, const unsigned char *bytes, size_t length,
                             struct pp_error *err)
{
    return fwrite(bytes, 1, length, stream) == length ? PP_OK : pp_fail_memory(err);
}
