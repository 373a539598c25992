/* self_test.h - the program against answers that are known on paper. */
#ifndef PP_CLI_KNOWN_H
#define PP_CLI_KNOWN_H

#include <stdbool.h>
#include <stdint.h>

#include "model/base/error.h"

/* One question; fractions of the open sky, or plain numbers. */
struct pp_known {
    char what[80];
    const char *by; /* the method, or "traced" */
    double expected;
    double tolerance; /* how far the answer may be off: the rounding of what is
                       * expected, or four standard errors */
    double answer;
    double std_error; /* NAN: not sampled */
};

enum { PP_KNOWN_MOST = 64 };

struct pp_known_list {
    int count;
    struct pp_known list[PP_KNOWN_MOST];
};

bool pp_known_is_right(const struct pp_known *known);

/* Puts all questions to the program; takes a second or two. The seed is that of what is
 * traced. */
enum pp_status pp_known_ask(struct pp_known_list *known, uint64_t seed, int threads,
                            struct pp_error *err);

#endif
