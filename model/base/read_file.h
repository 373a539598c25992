/* read_file.h - all of a file in memory, up to a limit. */
#ifndef PP_MODEL_BASE_READ_FILE_H
#define PP_MODEL_BASE_READ_FILE_H

#include <stddef.h>

#include "model/base/error.h"

/* Most bytes read from a pipe, a terminal, or any other stream that need not end. */
#define PP_READ_FILE_STREAM_MOST ((size_t)512 << 20)

/* Reads the file; path "-" is standard input. On success *bytes is the caller's to
 * free; *length is their number, at most `most` + 1, which means that the file is
 * larger than `most`. PP_BAD_INPUT where there is no such file, or a directory, a
 * device, or a stream of more than PP_READ_FILE_STREAM_MOST; PP_INTERRUPTED by a
 * signal; PP_SYSTEM for other failures. */
enum pp_status pp_read_file(char **bytes, size_t *length, const char *path, size_t most,
                            struct pp_error *err);

/* Name of a path in messages: itself, or "standard input" for "-". */
const char *pp_read_file_title(const char *path);

#endif
