/* size_block.h - size --obstruction, size --envelope: how high a block may be, and what may
 * stand on its plot. */
#ifndef PP_CLI_SIZE_SIZE_BLOCK_H
#define PP_CLI_SIZE_SIZE_BLOCK_H

#include "cli/exit_status.h"
#include "cli/size/size_options.h"

enum pp_exit pp_size_block(const struct pp_size_options *options, const char *file);

#endif
