/* program_place.c - finds programs by means of /proc and PATH. */
#include "cli/program/program_place.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

void pp_program_place_own(char *folder, size_t room)
{
    ssize_t length = readlink("/proc/self/exe", folder, room - 1);
    folder[length > 0 ? length : 0] = '\0';
    char *slash = strrchr(folder, '/');
    folder[slash ? slash + 1 - folder : 0] = '\0';
}

bool pp_program_place_on_path(const char *program, char *path, size_t room)
{
    for (const char *at = getenv("PATH"); at && *at;) {
        size_t length = strcspn(at, ":");
        int needs = snprintf(path, room, "%.*s/%s", (int)length, at, program);
        if (length > 0 && (size_t)needs < room && access(path, X_OK) == 0)
            return true;
        at += length + (at[length] == ':');
    }
    path[0] = '\0';
    return false;
}

const char *pp_program_place_temporary(void)
{
    const char *folder = getenv("TMPDIR");
    return folder && *folder ? folder : "/tmp";
}
