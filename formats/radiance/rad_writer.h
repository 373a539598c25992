/* rad_writer.h - what the parts of the Radiance writer share (inside formats/radiance/ only):
 * rad_write.c has names and shapes, rad_write_materials.c materials and patterns. */
#ifndef PP_FORMATS_RADIANCE_RAD_WRITER_H
#define PP_FORMATS_RADIANCE_RAD_WRITER_H

#include "formats/radiance/rad_names.h"
#include "formats/radiance/rad_write.h"

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
    struct pp_rad_names taken; /* by text: the last number put behind it to tell others
                                * from it */
    struct pp_rad_pair *pairs;
    int pair_count;
    int *pair_of;     /* of each shape; -1: its material alone */
    bool *in_pairs;   /* of each material: it is told by pairs, */
    bool *on_its_own; /* and by itself; */
    bool *behind;     /* a back looks like it, its own or another's */
};

/* A mirror as Radiance has it: black from behind, and used in no other way? */
bool pp_rad_write_materials_is_mirror(const struct pp_rad_writer *writer,
                                      const struct pp_rad_pair *pair);

/* How many, then all of them, on a line. */
void pp_rad_write_numbers(FILE *out, const double *numbers, int count);

/* The number of 15 digits nearest to it. */
double pp_rad_write_round_15_digits(double number);

/* Fills in_pairs, on_its_own and behind by pairs and shapes. */
void pp_rad_write_materials_classify(struct pp_rad_writer *writer);

/* PP_BAD_INPUT where Radiance has no type for it. */
enum pp_status pp_rad_write_materials_check(const struct pp_material *material,
                                            struct pp_error *err);

#endif
