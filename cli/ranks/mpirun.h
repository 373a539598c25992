/* mpirun.h - whether the program was started by mpirun, as one of several ranks. */
#ifndef PP_CLI_RANKS_MPIRUN_H
#define PP_CLI_RANKS_MPIRUN_H

#include <stdbool.h>
#include <stddef.h>

#include "cli/exit_status.h"
#include "model/base/ranks.h"

struct pp_mpirun {
    struct pp_ranks ranks;   /* good where count is 2 or more */
    void (*end)(void *data); /* of the module; NULL: none is loaded */
};

/* The path of the module for MPI. False: it is not installed; path is where it would be. */
bool pp_mpirun_module_path(char *path, size_t room);

/* To be called first. Where the process is one of several ranks, loads the module;
 * ranks but 0 print nothing from here on. Says what is wrong, if so. */
enum pp_exit pp_mpirun_begin(struct pp_mpirun *mpirun);

/* To be called last. Returns what the process says to mpirun: a rank other than 0 has
 * done what it could. */
enum pp_exit pp_mpirun_end(struct pp_mpirun *mpirun, enum pp_exit status);

/* The function of the module that sends messages by MPI; mpirun.c loads the module where
 * there are ranks, so that a plain run does not load MPI's libraries. *ranks is good until
 * `end`, its count 1 where this process is alone. What `end` (NULL where beginning failed)
 * does has to be done before the process ends. 0, or MPI's code of an error. */
typedef int pp_mpirun_module_begin(struct pp_ranks *ranks, void (**end)(void *data));
extern pp_mpirun_module_begin pp_mpirun_module;

#endif
