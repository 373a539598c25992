/* read_file.h - reads a whole file into memory, up to a limit. */
#ifndef PP_MODEL_BASE_READ_FILE_H
#define PP_MODEL_BASE_READ_FILE_H

#include <stddef.h>

#include "model/base/error.h"

/* Limit for pipes, terminals and other streams that need not end. */
#define PP_READ_FILE_STREAM_MOST ((size_t)512 << 20)

/* Reads the file; path "-" is standard input. On success the caller frees *bytes, and a
 * NUL, which *length does not count, follows the last byte. *length is at most `most` +
 * 1; that value means that the file is larger than `most`. PP_BAD_INPUT if there is no
 * such file, if it is a directory or a device, if the path is empty, or if a stream is
 * longer than PP_READ_FILE_STREAM_MOST and that is less than `most`. PP_INTERRUPTED
 * after a signal; PP_SYSTEM for other failures. */
enum pp_status pp_read_file(char **bytes, size_t *length, const char *path, size_t most,
                            struct pp_error *err);

/* Reads a file that is named in another file: a regular file only, since a pipe might
 * never end, and never standard input. Else like pp_read_file. */
enum pp_status pp_read_file_regular(char **bytes, size_t *length, const char *path,
                                    size_t most, struct pp_error *err);

/* Name of a path in messages: the path, or "standard input" for "-". */
const char *pp_read_file_title(const char *path);

#endif
