/* late_geos.c - see late_geos.h. */
#include "model/geometry/late_geos.h"

#include <stddef.h>

#include "model/base/late_library.h"

#define NAME(name) #name,
static const char *const names[] = {PP_LATE_GEOS_FUNCTIONS(NAME) NULL};

enum pp_status pp_late_geos_load(struct pp_late_geos *geos, GEOSMessageHandler_r say,
                                 void *say_to, struct pp_error *err)
{
    enum pp_status status =
        pp_late_library_load(&geos->call, names, "libgeos_c.so.1", err);
    if (status != PP_OK)
        return status;
    geos->context = geos->call.GEOS_init_r();
    if (!geos->context)
        return pp_fail_memory(err);
    geos->call.GEOSContext_setErrorMessageHandler_r(geos->context, say, say_to);
    return PP_OK;
}

void pp_late_geos_finish(struct pp_late_geos *geos)
{
    if (geos->context)
        geos->call.GEOS_finish_r(geos->context);
    geos->context = NULL;
}
