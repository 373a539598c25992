/* mpirun.c - looks for what mpirun and srun put into the environment of each rank. */
#include "cli/ranks/mpirun.h"

#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "cli/message.h"
#include "cli/program/program_part.h"
#include "cli/ranks/mpirun_module.h"
#include "model/base/deal_ranks.h"

/* Open MPI's mpirun says how many ranks there are; others only which one this is. */
static bool is_rank(void)
{
    const char *count = getenv("OMPI_COMM_WORLD_SIZE");
    if (count)
        return atoi(count) > 1;
    return getenv("PMI_RANK") || getenv("PMIX_RANK");
}

enum pp_exit pp_mpirun_begin(struct pp_mpirun *mpirun)
{
    *mpirun = (struct pp_mpirun){.end = NULL};
    if (!is_rank())
        return PP_EXIT_DONE;
    char path[PP_PROGRAM_PART_PATH];
    pp_program_part(path, ".libs/", PP_MODULE_FOLDER, "pepperpot-mpi.so");
    void *module = dlopen(path, RTLD_NOW | RTLD_GLOBAL);
    pp_mpirun_module_begin *begin = NULL;
    if (module)
        *(void **)&begin = dlsym(module, "pp_mpirun_module");
    if (!begin) {
        pp_message("several ranks were started, and the module for MPI can't be loaded "
                   "(%s); configure --with-mpi builds it",
                   dlerror());
        return PP_EXIT_MACHINE;
    }
    if (begin(&mpirun->ranks, &mpirun->end) != 0) {
        pp_message("MPI can't be started");
        return PP_EXIT_MACHINE;
    }
    if (mpirun->ranks.rank > 0
        && (!freopen("/dev/null", "w", stdout) || !freopen("/dev/null", "w", stderr)))
        return PP_EXIT_MACHINE;
    return PP_EXIT_DONE;
}

enum pp_exit pp_mpirun_end(struct pp_mpirun *mpirun, enum pp_exit status)
{
    if (!mpirun->end)
        return status;
    bool other = mpirun->ranks.rank > 0;
    if (!other)
        pp_deal_ranks_dismiss(&mpirun->ranks);
    mpirun->end(mpirun->ranks.data);
    return other ? PP_EXIT_DONE : status;
}
