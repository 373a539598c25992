/* page_files.h - the files of the web page, compiled into the program. For use inside
 * serve/ only. */
#ifndef PP_SERVE_HTTP_PAGE_FILES_H
#define PP_SERVE_HTTP_PAGE_FILES_H

#include <stddef.h>

struct pp_page_file {
    const char *path; /* such as "/main.js" */
    const char *type;
    const char *text;
    size_t length;
};

/* Finds a file by its path; "/" is the page itself. NULL if there is none. */
const struct pp_page_file *pp_page_files_find(const char *path);

#endif
