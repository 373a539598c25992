/* output.c - writes a new file in the directory of the target, and renames it to the
 * target. */
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

/* Makes the path of `name` in the directory of `path`. The caller frees the path. NULL:
 * out of memory. */
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

/* Resolves symbolic links. The last link may point to a file that does not exist yet.
 * The caller frees *resolved. */
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

/* Checks that a file can later be written at this path. */
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

/* Writes all bytes. Returns 0, or -1 with errno set. */
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

/* True for standard output and for files that are not regular, such as pipes. */
static bool is_written_directly(const struct pp_output *output)
{
    struct stat there;
    return !output->path
           || (stat(output->path, &there) == 0 && !S_ISREG(there.st_mode));
}

/* Writes to a pipe or another special file. A pipe without a reader blocks even when it
 * is opened. Errors of close() count, since some file systems report write errors only
 * there. Returns 0 or an error number. */
static int write_directly(const struct pp_output *output)
{
    pp_interrupt_end_at_once();
    int file = output->path ? open(output->path, O_WRONLY | O_CLOEXEC | O_NOCTTY)
                            : dup(STDOUT_FILENO);
    if (file < 0)
        return errno;
    int failed = write_all(file, output->bytes, output->size) != 0 ? errno : 0;
    if (close(file) != 0 && !failed)
        failed = errno;
    return failed;
}

/* Mode of the file to be replaced, or the default mode of a new file. */
static mode_t mode_for(const char *path)
{
    struct stat there;
    if (stat(path, &there) == 0)
        return there.st_mode & 07777;
    mode_t mask = umask(0);
    umask(mask);
    return 0666 & ~mask;
}

/* Writes a new file in the directory of the target. Returns 0 or an error number. */
static int write_temporary(struct pp_output *output)
{
    output->temporary = beside(output->path, ".pepperpot-XXXXXX");
    if (!output->temporary)
        return ENOMEM;
    int file = mkostemp(output->temporary, O_CLOEXEC);
    if (file < 0) {
        int failed = errno;
        free(output->temporary);
        output->temporary = NULL;
        return failed;
    }
    int failed = 0;
    if (write_all(file, output->bytes, output->size) != 0
        || fchmod(file, mode_for(output->path)) != 0 || fsync(file) != 0)
        failed = errno;
    if (close(file) != 0 && !failed)
        failed = errno;
    return failed;
}

/* Replaces the target by the new file. Returns 0 or an error number. */
static int rename_temporary(struct pp_output *output)
{
    if (rename(output->temporary, output->path) != 0)
        return errno;
    free(output->temporary);
    output->temporary = NULL;
    return 0;
}

/* Writes all new files, then renames all of them. Signals are blocked meanwhile, so
 * that no temporary file is left behind. */
static enum pp_status replace_all(struct pp_output *outputs, int count,
                                  struct pp_error *err)
{
    static int (*const steps[])(struct pp_output *) = {write_temporary,
                                                       rename_temporary};
    sigset_t all, before;
    sigfillset(&all);
    sigprocmask(SIG_BLOCK, &all, &before);
    enum pp_status status = PP_OK;
    for (int step = 0; step < 2; step++)
        for (int i = 0; i < count && status == PP_OK; i++) {
            if (is_written_directly(&outputs[i]))
                continue;
            int failed = steps[step](&outputs[i]);
            if (failed)
                status = fail_file(err, outputs[i].path, failed);
        }
    for (int i = 0; i < count; i++)
        pp_output_clear(&outputs[i]);
    sigprocmask(SIG_SETMASK, &before, NULL);
    return status;
}

enum pp_status pp_output_try(const char *path, struct pp_error *err)
{
    struct pp_output output;
    enum pp_status status = pp_output_open(&output, path, err);
    if (status == PP_OK)
        pp_output_clear(&output);
    return status;
}

enum pp_status pp_output_commit_all(struct pp_output *outputs, int count,
                                    struct pp_error *err)
{
    enum pp_status status = PP_OK;
    for (int i = 0; i < count; i++) {
        int broken = ferror(outputs[i].stream);
        broken |= fclose(outputs[i].stream);
        outputs[i].stream = NULL;
        if (broken)
            status = pp_fail_memory(err);
    }
    for (int i = 0; i < count && status == PP_OK; i++) {
        int failed = is_written_directly(&outputs[i]) ? write_directly(&outputs[i]) : 0;
        if (failed)
            status = fail_file(
                err, outputs[i].path ? outputs[i].path : "standard output", failed);
    }
    if (status == PP_OK)
        return replace_all(outputs, count, err);
    for (int i = 0; i < count; i++)
        pp_output_clear(&outputs[i]);
    return status;
}

enum pp_status pp_output_commit(struct pp_output *output, struct pp_error *err)
{
    return pp_output_commit_all(output, 1, err);
}

void pp_output_clear(struct pp_output *output)
{
    if (output->stream)
        fclose(output->stream);
    if (output->temporary)
        unlink(output->temporary);
    free(output->temporary);
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
