/* mpirun.h - determines whether mpirun started this process as one of several ranks. */
#ifndef PP_CLI_RANKS_MPIRUN_H
#define PP_CLI_RANKS_MPIRUN_H

#include <stdbool.h>
#include <stddef.h>

#include "cli/exit_status.h"
#include "model/base/ranks.h"

struct pp_mpirun {
    struct pp_ranks ranks;   /* valid if the count is 2 or more */
    void (*end)(void *data); /* function of the module that ends MPI; NULL: no module is
                              * loaded */
};

/* Finds the MPI module. Returns false if it is not installed; `path` is then its
 * expected path. */
bool pp_mpirun_module_path(char *path, size_t room);

/* Begins the use of ranks. Must be called before a command runs. If the process is one
 * of several ranks, loads the module; all ranks except 0 then print nothing. Reports
 * errors. */
enum pp_exit pp_mpirun_begin(struct pp_mpirun *mpirun);

/* Ends the use of ranks. Must be called last. Returns the exit status for mpirun:
 * `status` on rank 0, success on other ranks. */
enum pp_exit pp_mpirun_end(struct pp_mpirun *mpirun, enum pp_exit status);

/* Function of the module that sends messages by MPI. mpirun.c loads the module only if
 * there are ranks, so that an ordinary run does not load the MPI libraries. *ranks is
 * valid until `end` is called; its count is 1 if this process is alone. `end` must be
 * called before the process ends (NULL after a failure). Returns 0 or an error code of
 * MPI. */
typedef int pp_mpirun_module_begin(struct pp_ranks *ranks, void (**end)(void *data));
extern pp_mpirun_module_begin pp_mpirun_module;

#endif
