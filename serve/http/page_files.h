/* page_files.h - the files of the page, compiled into the program. Inside serve/ only. */
#ifndef PP_SERVE_HTTP_PAGE_FILES_H
#define PP_SERVE_HTTP_PAGE_FILES_H

#include <stddef.h>

struct pp_page_file {
    const char *path; /* "/main.js" */
    const char *type;
    const char *text;
    size_t length;
};

/* File of a path; "/" is the page itself. NULL if there is none. */
const struct pp_page_file *pp_page_files_find(const char *path);

#endif
