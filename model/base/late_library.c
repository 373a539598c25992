/* late_library.c - asks the dynamic linker. */
#include "model/base/late_library.h"

#include <dlfcn.h>
#include <string.h>

enum pp_status pp_late_library_load(void *functions, const char *const *names,
                                    const char *file, struct pp_error *err)
{
    void *library = dlopen(file, RTLD_LAZY | RTLD_LOCAL | RTLD_NODELETE);
    if (!library)
        return pp_fail(err, PP_SYSTEM, "a library can't be loaded: %s", dlerror());
    enum pp_status status = PP_OK;
    for (size_t i = 0; names[i] && status == PP_OK; i++) {
        void *symbol = dlsym(library, names[i]);
        if (!symbol)
            status = pp_fail(err, PP_SYSTEM, "%s has no %s", file, names[i]);
        /* A pointer to a function, as dlsym gives it. */
        memcpy((char *)functions + i * sizeof symbol, &symbol, sizeof symbol);
    }
    dlclose(library);
    return status;
}
