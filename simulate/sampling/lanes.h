/* lanes.h - arithmetic on several numbers at once.
 *
 * Uses the compiler's vector types. An operator works on each number separately, so the
 * results are bit-identical to the same operations on single numbers. A function is
 * compiled twice: its body is written once as PP_LANES_BODY. It is called from a plain
 * function, and from a function marked PP_LANES_WIDE for processors with registers of
 * 256 bits. pp_lanes_are_wide tests the processor.
 */
#ifndef PP_SIMULATE_SAMPLING_LANES_H
#define PP_SIMULATE_SAMPLING_LANES_H

#include <stdbool.h>
#include <stdint.h>

enum {
    PP_LANES = 4,     /* numbers of double precision */
    PP_INT_LANES = 8, /* integers of 32 bits */
    PP_RUN_MOST = 16  /* numbers calculated in one call; a multiple of both */
};

typedef double pp_lanes __attribute__((vector_size(32)));
typedef int64_t pp_lanes_mask __attribute__((vector_size(32)));
typedef uint32_t pp_int_lanes __attribute__((vector_size(32)));

#define PP_LANES_BODY static inline __attribute__((always_inline))

/* -DPP_LANES_NARROW: compile as for processors without wide registers (see
 * tests/house/same_bytes.sh). */
#if defined(__x86_64__) && !defined(PP_LANES_NARROW)
#define PP_LANES_WIDE __attribute__((target("avx2")))
static inline bool pp_lanes_are_wide(void)
{
    return __builtin_cpu_supports("avx2");
}
#else
#define PP_LANES_WIDE
static inline bool pp_lanes_are_wide(void)
{
    return false;
}
#endif

#define PP_LANES_ALL(a) ((pp_lanes){(a), (a), (a), (a)})

/* a where the mask is set, b elsewhere. A macro, since the calling convention for
 * vectors depends on the processor. */
#define PP_LANES_CHOOSE(mask, a, b)                                                    \
    ((pp_lanes)(((mask) & (pp_lanes_mask)(a)) | (~(mask) & (pp_lanes_mask)(b))))

/* Directions of a run, of which the first `count` are used. */
struct pp_lanes_directions {
    double x[PP_RUN_MOST], y[PP_RUN_MOST], z[PP_RUN_MOST];
};

#endif
