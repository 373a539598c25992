/* must.h - what every fuzz target begins with: its entry, and the check that ends it. */
#ifndef PP_TESTS_FUZZ_MUST_H
#define PP_TESTS_FUZZ_MUST_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

/* Called by libFuzzer with bytes that it made up; 0 where all went well. */
int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t length);

/* Ends the process, which libFuzzer reports with the bytes, unless it holds. */
static inline void must(bool holds)
{
    if (!holds)
        abort();
}

#endif
