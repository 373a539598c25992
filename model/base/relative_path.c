/* relative_path.c - see relative_path.h. */
#include "model/base/relative_path.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Absolute folder of a file, with links resolved; NULL if it does not exist. */
static char *whole_folder_of(const char *file)
{
    const char *end = strrchr(file, '/');
    char *folder = end ? strndup(file, (size_t)(end - file) + 1) : strdup(".");
    char *whole = folder ? realpath(folder, NULL) : NULL;
    free(folder);
    return whole;
}

/* Length in bytes of the leading folders common to both paths. */
static size_t common(const char *a, const char *b)
{
    size_t shared = 0;
    for (size_t i = 0;; i++) {
        bool ends_a = a[i] == '/' || !a[i], ends_b = b[i] == '/' || !b[i];
        if (ends_a && ends_b)
            shared = i;
        if (a[i] != b[i] || !a[i])
            return shared;
    }
}

enum pp_status pp_relative_path_prefix(char **prefix, const char *file,
                                       const char *moved, struct pp_error *err)
{
    char *from = whole_folder_of(file), *to = whole_folder_of(moved);
    size_t length;
    FILE *out = open_memstream(prefix, &length);
    if (out && from && to) {
        size_t shared = common(from, to);
        for (const char *at = to + shared; *at; at++)
            if (*at == '/' && at[1])
                fputs("../", out);
        const char *down = from + shared + (from[shared] == '/');
        if (*down)
            fprintf(out, "%s/", down);
    }
    free(from);
    free(to);
    if (out && fclose(out) == 0)
        return PP_OK;
    return pp_fail_memory(err);
}
