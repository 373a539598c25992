/* epw.c - see epw.h. */
#include "formats/epw/epw.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "formats/epw/epw_records.h"
#include "model/base/read_file.h"

/* Reads header and records from a copy of the file's bytes, with a NUL behind. */
static enum pp_status read_epw_copy(struct pp_epw *epw, char *bytes, size_t length,
                                    struct pp_mistakes *mistakes, struct pp_error *err)
{
    struct pp_epw_header *header = calloc(1, sizeof *header);
    if (!header)
        return pp_fail_memory(err);
    struct pp_epw_lines lines = {.at = bytes, .end = bytes + length, .next_line = 1};
    if (strncmp(bytes, "\xEF\xBB\xBF", 3) == 0)
        lines.at += 3;
    char *record;
    struct pp_error memory = {PP_OK, ""};
    enum pp_status status = PP_OK;
    if (pp_epw_header_read(epw, header, &lines, &record, mistakes, &memory))
        status = pp_epw_records_read(epw, header, &lines, record, mistakes, err);
    else if (memory.status != PP_OK)
        status = pp_fail_memory(err);
    free(header);
    return status;
}

enum pp_status pp_epw_parse(struct pp_epw **epw, const char *bytes, size_t length,
                            struct pp_mistakes *mistakes, struct pp_error *err)
{
    int before = mistakes->count;
    enum pp_status status = PP_OK;
    *epw = NULL;
    struct pp_epw *made = calloc(1, sizeof *made);
    if (!made)
        return pp_fail_memory(err);
    if (pp_epw_lines_check_bytes(bytes, length, mistakes)) {
        char *copy = malloc(length + 1);
        if (copy) {
            memcpy(copy, bytes, length);
            copy[length] = '\0';
            status = read_epw_copy(made, copy, length, mistakes, err);
        } else {
            status = pp_fail_memory(err);
        }
        free(copy);
    }
    if (status == PP_OK && (mistakes->count > before || mistakes->truncated))
        status = pp_fail(err, PP_BAD_INPUT, "%s: it can't be read as a weather file",
                         mistakes->file ? mistakes->file : "weather file");
    if (status == PP_OK)
        *epw = made;
    else
        pp_epw_destroy(made);
    return status;
}

enum pp_status pp_epw_read(struct pp_epw **epw, const char *path,
                           struct pp_mistakes *mistakes, struct pp_error *err)
{
    char *bytes;
    size_t length;
    *epw = NULL;
    enum pp_status status = pp_read_file(&bytes, &length, path, PP_EPW_BYTES_MOST, err);
    if (status == PP_OK)
        status = pp_epw_parse(epw, bytes, length, mistakes, err);
    free(bytes);
    return status;
}

void pp_epw_destroy(struct pp_epw *epw)
{
    if (!epw)
        return;
    free(epw->place);
    free(epw->records);
    free(epw);
}
