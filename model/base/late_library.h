/* late_library.h - a library of others that is loaded where it is first called. Linked in
 * the usual way it is loaded at every start, which takes longer than what most commands do
 * without it.
 */
#ifndef PP_MODEL_BASE_LATE_LIBRARY_H
#define PP_MODEL_BASE_LATE_LIBRARY_H

#include "model/base/error.h"

/* Finds functions of the library `file`, as the linker calls it ("libm.so.6"): `functions`
 * is a struct of pointers to functions and of nothing else, `names` are theirs, in that
 * order, and end with NULL. Loads the library unless it is here; it stays until the process
 * ends. PP_SYSTEM where it or a function of it is missing. */
enum pp_status pp_late_library_load(void *functions, const char *const *names,
                                    const char *file, struct pp_error *err);

#endif
