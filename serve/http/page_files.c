/* page_files.c - finds files of page/ in a list that page2c.awk generates. */
#include "serve/http/page_files.h"

#include <string.h>

#define PAGE_FILE(path, type, text)                                                    \
    {                                                                                  \
        path, type, text, sizeof(text) - 1                                             \
    }

static const struct pp_page_file files[] = {
#include "serve/http/page_files.inc"
};

const struct pp_page_file *pp_page_files_find(const char *path)
{
    if (strcmp(path, "/") == 0)
        path = "/index.html";
    for (size_t i = 0; i < sizeof files / sizeof *files; i++)
        if (strcmp(files[i].path, path) == 0)
            return &files[i];
    return NULL;
}
