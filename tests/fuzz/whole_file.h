/* whole_file.h - for targets whose reader opens one file: with --wrap=pp_read_file,
 * this file consists of the fuzzer's bytes. */
#ifndef PP_TESTS_FUZZ_WHOLE_FILE_H
#define PP_TESTS_FUZZ_WHOLE_FILE_H

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/read_file.h"

enum pp_status __wrap_pp_read_file(char **bytes, size_t *length, const char *path,
                                   size_t most, struct pp_error *err);

static const uint8_t *fuzzed;
static size_t fuzzed_length;

enum pp_status __wrap_pp_read_file(char **bytes, size_t *length, const char *path,
                                   size_t most, struct pp_error *err)
{
    (void)path, (void)most;
    *length = fuzzed_length;
    *bytes = malloc(fuzzed_length + 1);
    if (!*bytes)
        return pp_fail_memory(err);
    if (fuzzed_length > 0)
        memcpy(*bytes, fuzzed, fuzzed_length);
    (*bytes)[fuzzed_length] = '\0';
    return PP_OK;
}

#endif
