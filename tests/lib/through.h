/* through.h - output of other programs for files that the program has drawn. */
#ifndef PP_TESTS_LIB_THROUGH_H
#define PP_TESTS_LIB_THROUGH_H

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "tests/lib/near.h"

/* Output of a command ("pdftotext %s -") for a file, up to 1 MB, freed by the caller;
 * NULL if there is no such command. */
static inline char *through(const char *command, const char *file, size_t length)
{
    char probe[256], name[] = "test_through.XXXXXX", line[512];
    snprintf(probe, sizeof probe, "command -v %.*s >/dev/null",
             (int)strcspn(command, " "), command);
    if (system(probe) != 0)
        return 0;
    int fd = mkstemp(name);
    assert_true(fd >= 0);
    assert_int_equal(write(fd, file, length), (ssize_t)length);
    close(fd);
    snprintf(line, sizeof line, command, name);
    FILE *pipe = popen(line, "r");
    assert_non_null(pipe);
    char *text = calloc(1, 1 << 20);
    size_t got = fread(text, 1, (1 << 20) - 1, pipe);
    text[got] = 0;
    pclose(pipe);
    unlink(name);
    return text;
}

#endif
