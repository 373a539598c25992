/* atlas_file.c - finds the end of the last complete room, truncates the file there, and
 * appends rooms. */
#include "cli/atlas/atlas_file.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "cli/atlas/locked_file.h"

static enum pp_status fail(const struct pp_atlas_file *file, struct pp_error *err,
                           const char *what)
{
    return pp_fail(err, PP_SYSTEM, "%s cannot be %s: %s", file->path, what,
                   strerror(errno));
}

/* Number of the first line of the file that differs from `head`; 0 if there is none.
 * *empty is set to true if the file is empty or ends within the head, which must then
 * be written again. */
static int compare_head(FILE *stream, const char *head, bool *empty)
{
    char *line = NULL;
    size_t room = 0;
    int number = 1;
    *empty = false;
    while (*head) {
        size_t length = strcspn(head, "\n") + 1;
        ssize_t got = getline(&line, &room, stream);
        if (got != (ssize_t)length || memcmp(line, head, length) != 0) {
            *empty = got < (ssize_t)length && feof(stream)
                     && (got <= 0 || memcmp(line, head, (size_t)got) == 0);
            break;
        }
        head += length;
        number++;
    }
    free(line);
    return *head ? number : 0;
}

/* Reads the rest of the file after the head and counts the complete rooms. Returns the
 * position after the last complete room. */
static long find_end(struct pp_atlas_file *file)
{
    char *line = NULL;
    size_t room = 0;
    long end = ftell(file->stream), at = end;
    for (ssize_t got; (got = getline(&line, &room, file->stream)) > 0;) {
        char *rest = line;
        long index = strtol(line, &rest, 10);
        if (line[got - 1] != '\n' || index != file->rooms || *rest != ',')
            break;
        at += got;
        if (strncmp(rest, ",-1,", 4) != 0)
            continue;
        end = at;
        file->rooms++;
    }
    free(line);
    return end;
}

static enum pp_status take_up(struct pp_atlas_file *file, const char *head,
                              struct pp_error *err)
{
    bool empty;
    int line = compare_head(file->stream, head, &empty);
    if (line > 0 && !empty)
        return pp_fail(err, PP_BAD_INPUT,
                       "%s:%d: the file belongs to another atlas; expected the same "
                       "version, sky, error and seed, or a new file",
                       file->path, line);
    long end = empty ? 0 : find_end(file);
    if (ftruncate(fileno(file->stream), end) != 0
        || fseek(file->stream, end, SEEK_SET) != 0)
        return fail(file, err, "written");
    return empty ? pp_atlas_file_add(file, head, strlen(head), err) : PP_OK;
}

enum pp_status pp_atlas_file_open(struct pp_atlas_file *file, const char *path,
                                  const char *head, struct pp_error *err)
{
    *file = (struct pp_atlas_file){.path = path};
    file->is_new = access(path, F_OK) != 0;
    enum pp_status status = pp_locked_file_open(&file->stream, path, err);
    if (status != PP_OK)
        return status;
    status = take_up(file, head, err);
    return status == PP_OK ? PP_OK : pp_atlas_file_close(file, status, err);
}

enum pp_status pp_atlas_file_add(struct pp_atlas_file *file, const char *rows,
                                 size_t length, struct pp_error *err)
{
    if (fwrite(rows, 1, length, file->stream) != length || fflush(file->stream) != 0)
        return fail(file, err, "written");
    return PP_OK;
}

enum pp_status pp_atlas_file_close(struct pp_atlas_file *file, enum pp_status status,
                                   struct pp_error *err)
{
    struct stat there;
    if (fclose(file->stream) != 0 && status == PP_OK)
        status = fail(file, err, "written");
    if (status != PP_OK && file->is_new && stat(file->path, &there) == 0
        && there.st_size == 0)
        unlink(file->path);
    return status;
}
