/* rad_names.h - what the names in a Radiance scene stand for. A later definition of a
 * name takes the place of an earlier one from there on. A name may be any bytes; to
 * define or to find one takes the same time however many there are. */
#ifndef PP_FORMATS_RADIANCE_RAD_NAMES_H
#define PP_FORMATS_RADIANCE_RAD_NAMES_H

#include <stdbool.h>
#include <stddef.h>

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

/* The name as it is from now on; false: memory is out. */
bool pp_rad_names_define(struct pp_rad_names *names, const char *text, size_t length,
                         struct pp_rad_meaning meaning);

/* False: there is no such name. "void" is always there. */
bool pp_rad_names_find(const struct pp_rad_names *names, const char *text,
                       size_t length, struct pp_rad_meaning *meaning);

void pp_rad_names_clear(struct pp_rad_names *names);

#endif
