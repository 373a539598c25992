/* mpirun_module.h - the module that brings messages by MPI: loaded by mpirun.c where
 * there are ranks, so that a plain run does not load MPI's libraries.
 */
#ifndef PP_CLI_RANKS_MPIRUN_MODULE_H
#define PP_CLI_RANKS_MPIRUN_MODULE_H

#include "model/base/ranks.h"

/* The module's one function: begins, *ranks is good until `end`, a count of 1 where this
 * process is alone. What `end` (NULL where beginning failed) does has to be done before
 * the process ends. 0, or what MPI says is wrong. */
typedef int pp_mpirun_module_begin(struct pp_ranks *ranks, void (**end)(void *data));
extern pp_mpirun_module_begin pp_mpirun_module;

#endif
