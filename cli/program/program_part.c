/* program_part.c - asks the system which file runs. */
#include "cli/program/program_part.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

void pp_program_part(char path[PP_PROGRAM_PART_PATH], const char *built,
                     const char *installed, const char *name)
{
    ssize_t length = readlink("/proc/self/exe", path, PP_PROGRAM_PART_PATH / 2);
    if (length > 0) {
        path[length] = '\0';
        char *slash = strrchr(path, '/') + 1;
        snprintf(slash, PP_PROGRAM_PART_PATH - (size_t)(slash - path), "%s%s", built,
                 name);
        if (access(path, R_OK) == 0)
            return;
    }
    snprintf(path, PP_PROGRAM_PART_PATH, "%s/%s", installed, name);
}
