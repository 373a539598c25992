/* radiance_options.c - the options that the library's own clients begin with. */
#include "simulate/transport/radiance_options.h"

struct pp_radiance_options pp_radiance_options_defaults(void)
{
    return (struct pp_radiance_options){.sources = true,
                                        .windows = true,
                                        .stored = true,
                                        .source_size = 0.2,
                                        .source_most = 64,
                                        .bounces = -1,
                                        .least = 0.3};
}
