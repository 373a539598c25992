/* mpirun.c - reads the environment variables that mpirun and srun set for each rank,
 * and loads the MPI module. */
#include "cli/ranks/mpirun.h"

#include <dlfcn.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "cli/message.h"
#include "cli/program/program_place.h"
#include "model/base/work_ranks.h"

#define MODULE "pepperpot-mpi.so"

/* True if there are several ranks. mpirun and srun give their number; other starters
 * give only the index. A single rank is an ordinary process. *first: the process has the
 * index 0, and the number is not known. */
static bool is_rank(bool *first)
{
    static const char *const counts[] = {"PMI_SIZE", "SLURM_STEP_NUM_TASKS",
                                         "SLURM_NTASKS"};
    const char *count = getenv("OMPI_COMM_WORLD_SIZE");
    const char *index = getenv("PMI_RANK");
    if (!index)
        index = getenv("PMIX_RANK");
    bool ranked = count || index;
    for (int i = 0; i < 3 && ranked && !count; i++)
        count = getenv(counts[i]);
    *first = ranked && !count && strcmp(index, "0") == 0;
    return ranked && (!count || atoi(count) > 1);
}

/* Searches folders relative to the running program, in the build tree and in an
 * installed tree, which may be staged or moved. Then searches the folder set by
 * configure. */
bool pp_mpirun_module_path(char *path, size_t room)
{
    static const char *const relative[] = {".libs", "../lib/pepperpot"};
    char folder[PATH_MAX];
    pp_program_place_own(folder, sizeof folder);
    for (int i = 0; folder[0] && i < 2; i++) {
        snprintf(path, room, "%s%s/" MODULE, folder, relative[i]);
        if (access(path, R_OK) == 0)
            return true;
    }
    snprintf(path, room, "%s", PP_MODULE_FOLDER "/" MODULE);
    return access(path, R_OK) == 0;
}

/* Loads the module. The module is a separate file, so that the program also runs
 * without MPI. NULL: see dlerror(). */
static void *load_module(void)
{
    char path[PATH_MAX + 64];
    pp_mpirun_module_path(path, sizeof path);
    return dlopen(path, RTLD_NOW | RTLD_GLOBAL);
}

enum pp_exit pp_mpirun_begin(struct pp_mpirun *mpirun)
{
    *mpirun = (struct pp_mpirun){.end = NULL};
    bool first;
    if (!is_rank(&first))
        return PP_EXIT_DONE;
    void *module = load_module();
    pp_mpirun_module_begin *begin = NULL;
    if (module)
        *(void **)&begin = dlsym(module, "pp_mpirun_module");
    if (!begin && first)
        return PP_EXIT_DONE;
    if (!begin) {
        pp_message("several ranks were started, but the MPI module cannot be loaded "
                   "(%s); configure with --with-mpi to build it",
                   dlerror());
        return PP_EXIT_MACHINE;
    }
    if (begin(&mpirun->ranks, &mpirun->end) != 0) {
        pp_message("MPI cannot be started");
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
        pp_work_ranks_dismiss(&mpirun->ranks);
    mpirun->end(mpirun->ranks.data);
    return other ? PP_EXIT_DONE : status;
}
