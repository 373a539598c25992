/* rad_names.h - the names in a Radiance scene, each with its material or pattern.
 *
 * A later definition of a name takes the place of an earlier one from there on. A name
 * may be any bytes. It is a hash table: to define or to find a name takes the same time
 * however many there are.
 */
#ifndef PP_FORMATS_RADIANCE_RAD_NAMES_H
#define PP_FORMATS_RADIANCE_RAD_NAMES_H

#include <stdbool.h>
#include <stddef.h>

#include "model/base/error.h"

enum pp_rad_kind { PP_RAD_VOID, PP_RAD_MATERIAL, PP_RAD_PATTERN };

struct pp_rad_meaning {
    enum pp_rad_kind kind;
    int index; /* of the description's materials or patterns */
    int back;  /* the material of a surface's other side; -1: the same one */
};

struct pp_rad_names {
    struct pp_rad_name *list; /* open addressing, a power of two */
    size_t count, room;
};

/* Gives the name this meaning from now on; fails only when memory is out. */
enum pp_status pp_rad_names_define(struct pp_rad_names *names, const char *text,
                                   size_t length, struct pp_rad_meaning meaning,
                                   struct pp_error *err);

/* False: there is no such name. "void" is always there. */
bool pp_rad_names_find(const struct pp_rad_names *names, const char *text,
                       size_t length, struct pp_rad_meaning *meaning);

void pp_rad_names_clear(struct pp_rad_names *names);

#endif
