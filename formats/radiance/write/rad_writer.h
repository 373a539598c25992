/* rad_writer.h - the state of the Radiance writer, which rad_write.c (names and shapes)
 * and rad_write_materials.c share. Inside formats/radiance/ only. */
#ifndef PP_FORMATS_RADIANCE_WRITE_RAD_WRITER_H
#define PP_FORMATS_RADIANCE_WRITE_RAD_WRITER_H

#include "formats/radiance/rad_names.h"
#include "formats/radiance/write/rad_write.h"

enum { PP_RAD_NAME_MOST = 63 };

struct pp_rad_name_text {
    char text[PP_RAD_NAME_MOST + 1 + 32];
};

/* Materials of front and back, and the name of both together; of a mirror, which is
 * black from behind anyway, that of the front. */
struct pp_rad_pair {
    int front, back, name;
};

struct pp_rad_writer {
    const struct pp_scene_description *scene; /* not owned */
    struct pp_rad_name_text *names; /* of materials, then patterns, then pairs */
    int name_count;
    struct pp_rad_names
        taken; /* the names in use; each with the last number that was put
                                * behind it to make others */
    struct pp_rad_pair *pairs;
    int pair_count;
    int *pair_of;     /* of each shape; -1: it has one material */
    bool *in_pairs;   /* of each material: is it written within a pair? */
    bool *on_its_own; /* and by itself? */
    bool *behind;     /* true for the back of a shape */
};

#endif
