/* output_directory.c - writes a new directory beside the target, and renames it to the
 * target. */
#include "cli/output_directory.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "model/base/array.h"

static enum pp_status fail_path(struct pp_error *err, const char *path, int number)
{
    return pp_fail(err, PP_SYSTEM, "%s cannot be written: %s", path, strerror(number));
}

static char *joined(const char *directory, const char *name)
{
    char *path;
    return asprintf(&path, "%s/%s", directory, name) < 0 ? NULL : path;
}

/* ---- existing files ---- */

static bool is_known(const struct pp_output_directory *directory, const char *name)
{
    for (int i = 0; directory->known[i]; i++)
        if (strcmp(directory->known[i], name) == 0)
            return true;
    return false;
}

/* Counts the directory's entries in *entries, and checks that all of them are files
 * that may be replaced. If the directory must not be replaced, stops at the first
 * entry. */
static enum pp_status check_replaceable(const struct pp_output_directory *directory,
                                        const char *path, int depth, int *entries,
                                        struct pp_error *err)
{
    DIR *list = opendir(path);
    if (!list)
        return fail_path(err, path, errno);
    enum pp_status status = PP_OK;
    for (struct dirent *entry; status == PP_OK && (entry = readdir(list)) != NULL;) {
        const char *name = entry->d_name;
        if (strcmp(name, ".") == 0 || strcmp(name, "..") == 0)
            continue;
        ++*entries;
        if (!directory->replace)
            break;
        struct stat what;
        char *inner = joined(path, name);
        if (!inner)
            status = pp_fail_memory(err);
        else if (lstat(inner, &what) != 0)
            status = fail_path(err, inner, errno);
        else if (S_ISDIR(what.st_mode) && depth == 0)
            status = check_replaceable(directory, inner, 1, entries, err);
        else if (!S_ISREG(what.st_mode) || !is_known(directory, name))
            status = pp_fail(err, PP_SYSTEM,
                             "%s cannot be replaced, because it contains %s, which is "
                             "not part of an export",
                             directory->path, inner);
        free(inner);
    }
    closedir(list);
    return status;
}

static enum pp_status check_output_directory(
    const struct pp_output_directory *directory, struct pp_error *err)
{
    const char *path = directory->path;
    struct stat there;
    if (lstat(path, &there) == 0) {
        int entries = 0;
        if (!S_ISDIR(there.st_mode))
            return pp_fail(err, PP_SYSTEM,
                           "%s cannot be written, because it is not a directory; "
                           "expected a new or an empty one",
                           path);
        enum pp_status status = check_replaceable(directory, path, 0, &entries, err);
        if (status != PP_OK)
            return status;
        if (entries > 0 && !directory->replace)
            return pp_fail(err, PP_SYSTEM,
                           "%s is not empty; expected a new or an empty directory, or "
                           "--force to replace an export",
                           path);
    } else if (errno != ENOENT) {
        return fail_path(err, path, errno);
    }
    char *beside = joined(path, "..");
    const char *slash = strrchr(path, '/');
    if (beside)
        snprintf(beside, strlen(path) + 3, "%.*s", slash ? (int)(slash - path) + 1 : 1,
                 slash ? path : ".");
    enum pp_status status = PP_OK;
    if (!beside)
        status = pp_fail_memory(err);
    else if (access(beside, W_OK | X_OK) != 0)
        status = fail_path(err, path, errno);
    free(beside);
    return status;
}

enum pp_status pp_output_directory_open(struct pp_output_directory *directory,
                                        const char *path, bool replace,
                                        const char *const *known, struct pp_error *err)
{
    *directory = (struct pp_output_directory){.replace = replace, .known = known};
    directory->path = realpath(path, NULL);
    if (!directory->path)
        directory->path = strdup(path);
    if (!directory->path)
        return pp_fail_memory(err);
    for (size_t i = strlen(directory->path); i > 1 && directory->path[i - 1] == '/';)
        directory->path[--i] = '\0';
    enum pp_status status = check_output_directory(directory, err);
    if (status != PP_OK)
        pp_output_directory_clear(directory);
    return status;
}

enum pp_status pp_output_directory_add(struct pp_output_directory *directory,
                                       const char *path, bool runs, FILE **stream,
                                       struct pp_error *err)
{
    if (pp_array_append(&directory->files, directory->count, sizeof *directory->files,
                        err)
        != PP_OK)
        return PP_SYSTEM;
    struct pp_output_directory_file *file = &directory->files[directory->count];
    *file = (struct pp_output_directory_file){.path = strdup(path), .runs = runs};
    if (!file->path)
        return pp_fail_memory(err);
    file->gathered = calloc(1, sizeof *file->gathered);
    if (file->gathered)
        file->stream = open_memstream(&file->gathered->bytes, &file->gathered->size);
    if (!file->stream) {
        free(file->gathered);
        free(file->path);
        return pp_fail_memory(err);
    }
    directory->count++;
    *stream = file->stream;
    return PP_OK;
}

/* ---- writing ---- */

static int write_all(int file, const char *bytes, size_t size)
{
    while (size > 0) {
        ssize_t written = write(file, bytes, size);
        if (written < 0 && errno != EINTR)
            return errno;
        if (written > 0) {
            bytes += written;
            size -= (size_t)written;
        }
    }
    return 0;
}

static int write_directory_file(const char *directory,
                                const struct pp_output_directory_file *file,
                                mode_t mask)
{
    char *path = joined(directory, file->path);
    if (!path)
        return ENOMEM;
    int failed = 0;
    char *slash = strchr(path + strlen(directory) + 1, '/');
    if (slash) {
        *slash = '\0';
        if (mkdir(path, 0777 & ~mask) != 0 && errno != EEXIST)
            failed = errno;
        *slash = '/';
    }
    mode_t mode = (file->runs ? 0777 : 0666) & ~mask;
    int out = failed ? -1 : open(path, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
    if (!failed && out < 0)
        failed = errno;
    if (out >= 0) {
        failed = write_all(out, file->gathered->bytes, file->gathered->size);
        if (!failed && fsync(out) != 0)
            failed = errno;
        if (close(out) != 0 && !failed)
            failed = errno;
    }
    free(path);
    return failed;
}

int pp_output_directory_remove(const char *path)
{
    DIR *list = opendir(path);
    if (!list)
        return errno;
    int failed = 0;
    for (struct dirent *entry; (entry = readdir(list)) != NULL;) {
        if (strcmp(entry->d_name, ".") == 0 || strcmp(entry->d_name, "..") == 0)
            continue;
        char *inner = joined(path, entry->d_name);
        struct stat what;
        if (!inner)
            failed = ENOMEM;
        else if (lstat(inner, &what) == 0 && S_ISDIR(what.st_mode))
            failed = pp_output_directory_remove(inner);
        else if (unlink(inner) != 0)
            failed = errno;
        free(inner);
    }
    closedir(list);
    if (rmdir(path) != 0 && !failed)
        failed = errno;
    return failed;
}

/* Replaces the directory by `temporary`, and deletes its former contents. */
static int take_place(const char *temporary, const char *path)
{
    if (rename(temporary, path) == 0)
        return 0;
    if (errno != ENOTEMPTY && errno != EEXIST)
        return errno;
    if (renameat2(AT_FDCWD, temporary, AT_FDCWD, path, RENAME_EXCHANGE) != 0)
        return errno;
    pp_output_directory_remove(temporary);
    return 0;
}

/* Replaces the directory. Signals are blocked meanwhile, so that the new directory is
 * never left behind. */
static int replace(const struct pp_output_directory *directory)
{
    char *temporary;
    if (asprintf(&temporary, "%s.pepperpot-XXXXXX", directory->path) < 0)
        return ENOMEM;
    sigset_t all, before;
    sigfillset(&all);
    sigprocmask(SIG_BLOCK, &all, &before);
    mode_t mask = umask(0);
    umask(mask);
    int failed = mkdtemp(temporary) ? 0 : errno;
    if (!failed) {
        for (int i = 0; i < directory->count && !failed; i++)
            failed = write_directory_file(temporary, &directory->files[i], mask);
        if (!failed && chmod(temporary, 0777 & ~mask) != 0)
            failed = errno;
        if (!failed)
            failed = take_place(temporary, directory->path);
        if (failed)
            pp_output_directory_remove(temporary);
    }
    sigprocmask(SIG_SETMASK, &before, NULL);
    free(temporary);
    return failed;
}

/* Closes all streams, so that the contents of the files are complete. */
static bool close_streams(struct pp_output_directory *directory)
{
    bool good = true;
    for (int i = 0; i < directory->count; i++) {
        struct pp_output_directory_file *file = &directory->files[i];
        if (!file->stream)
            continue;
        good = !ferror(file->stream) && good;
        good = fclose(file->stream) == 0 && good;
        file->stream = NULL;
    }
    return good;
}

enum pp_status pp_output_directory_commit(struct pp_output_directory *directory,
                                          struct pp_error *err)
{
    enum pp_status status = PP_OK;
    if (!close_streams(directory))
        status = pp_fail_memory(err);
    if (status == PP_OK)
        status = check_output_directory(directory, err);
    int failed = status == PP_OK ? replace(directory) : 0;
    if (failed)
        status = fail_path(err, directory->path, failed);
    pp_output_directory_clear(directory);
    return status;
}

void pp_output_directory_clear(struct pp_output_directory *directory)
{
    close_streams(directory);
    for (int i = 0; i < directory->count; i++) {
        free(directory->files[i].path);
        free(directory->files[i].gathered->bytes);
        free(directory->files[i].gathered);
    }
    free(directory->files);
    free(directory->path);
    *directory = (struct pp_output_directory){0};
}
