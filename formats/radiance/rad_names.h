/* rad_names.h - the names in a Radiance scene, each with its material or pattern.
 *
 * A later definition of a name replaces an earlier one for the rest of the scene. A
 * name may contain any bytes. Names are kept in a hash table, so that defining and
 * finding one takes constant time.
 */
#ifndef PP_FORMATS_RADIANCE_RAD_NAMES_H
#define PP_FORMATS_RADIANCE_RAD_NAMES_H

#include <stdbool.h>
#include <stddef.h>

#include "model/base/error.h"

enum pp_rad_kind { PP_RAD_VOID, PP_RAD_MATERIAL, PP_RAD_PATTERN };

struct pp_rad_meaning {
    enum pp_rad_kind kind;
    int index; /* index into the scene's materials or patterns */
    int back;  /* material of the back; -1: same as the front */
};

struct pp_rad_names {
    struct pp_rad_name *list; /* length is a power of two */
    size_t count, room;
};

/* Defines the name for the rest of the scene; fails only if memory runs out. */
enum pp_status pp_rad_names_define(struct pp_rad_names *names, const char *text,
                                   size_t length, struct pp_rad_meaning meaning,
                                   struct pp_error *err);

/* Finds a name; false if it is not defined. "void" is always defined. */
bool pp_rad_names_find(const struct pp_rad_names *names, const char *text,
                       size_t length, struct pp_rad_meaning *meaning);

void pp_rad_names_clear(struct pp_rad_names *names);

#endif
