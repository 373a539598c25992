/* sweep_bands.h - what an atlas says of methods: the table of bands that is compiled in, how
 * its bands do on rooms held out, and the manual's pages on them. */
#ifndef PP_CLI_ATLAS_SWEEP_BANDS_H
#define PP_CLI_ATLAS_SWEEP_BANDS_H

#include "cli/exit_status.h"

/* Writes the bands of the atlas in the file as tables/atlas_bands.csv has them; output NULL
 * is standard output. */
enum pp_exit pp_sweep_bands(const char *path, const char *output);

/* Prints how bands from half of its rooms do on the others; PP_EXIT_INPUT where a regime is
 * farther off than chance has it. */
enum pp_exit pp_sweep_bands_try(const char *path, const char *output);

/* Prints the bands compiled in as docs/accuracy.md has them. */
enum pp_exit pp_sweep_bands_accuracy(const char *output);

#endif
