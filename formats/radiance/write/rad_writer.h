/* rad_writer.h - state of the Radiance writer, shared by rad_write.c (names and shapes)
 * and rad_write_materials.c. Inside formats/radiance/ only. */
#ifndef PP_FORMATS_RADIANCE_WRITE_RAD_WRITER_H
#define PP_FORMATS_RADIANCE_WRITE_RAD_WRITER_H

#include "formats/radiance/rad_names.h"
#include "formats/radiance/write/rad_write.h"

enum { PP_RAD_NAME_MOST = 63 };

struct pp_rad_name_text {
    char text[PP_RAD_NAME_MOST + 1 + 32];
};

/* Materials of front and back, and the index of the pair's name. A mirror, black from
 * behind in Radiance, has the name of its front. */
struct pp_rad_pair {
    int front, back, name;
};

struct pp_rad_writer {
    const struct pp_scene_description *scene; /* not owned */
    struct pp_rad_name_text *names;           /* order: materials, patterns, pairs */
    int name_count;
    struct pp_rad_names
        taken; /* names in use, each with the number last appended to make another
                * name unique */
    struct pp_rad_pair *pairs;
    int pair_count;
    int *pair_of;     /* by shape; -1: one material */
    bool *in_pairs;   /* by material: a side of a glazing or pane that is written with
                       * its pair, or the back of a mirror, which is not written */
    bool *on_its_own; /* by material: written by itself, for shapes or for a mixfunc */
    bool *behind;     /* by material: used as the back of a shape */
};

#endif
