/* rad_reader.h - state of the Radiance reader, shared by its parts. Inside
 * formats/radiance/ only.
 *
 * rad_read.c iterates over files, primitives and commands. rad_primitive.c reads one
 * primitive; rad_shapes.c, rad_materials.c, rad_bsdf.c, rad_sky.c and rad_functions.c
 * add it to the scene. rad_pipe.c, rad_xform.c and rad_genbox.c handle commands.
 */
#ifndef PP_FORMATS_RADIANCE_READ_RAD_READER_H
#define PP_FORMATS_RADIANCE_READ_RAD_READER_H

#include "formats/radiance/rad_names.h"
#include "formats/radiance/read/rad_read.h"
#include "formats/radiance/read/rad_transform.h"
#include "formats/radiance/read/rad_words.h"

/* Limits. BYTES: size of one file, and of all files read by xforms. DEPTH: nesting of
 * files in xforms. COPIES: total of all xforms. SHAPES and MATERIALS (with patterns):
 * total of all files. A line of a hundred characters can request any number of copies,
 * so shapes in copies, their polygon corners, and the bytes read again for each copy
 * have their own limits. A million polygons take 700 MiB when traced. The limits of the
 * fuzzer are smaller, for speed. */
#ifdef FUZZING_BUILD_MODE_UNSAFE_FOR_PRODUCTION
#define PP_RAD_BYTES_MOST ((size_t)1 << 20)
enum {
    PP_RAD_DEPTH_MOST = 8,
    PP_RAD_COPIES_MOST = 1000,
    PP_RAD_SHAPES_MOST = 20000,
    PP_RAD_MATERIALS_MOST = 2000,
    PP_RAD_COPIED_SHAPES_MOST = 2000,
    PP_RAD_COPIED_CORNERS_MOST = 20000,
    PP_RAD_COPIED_BYTES_MOST = 1 << 20
};
#else
#define PP_RAD_BYTES_MOST ((size_t)4 << 30)
enum {
    PP_RAD_DEPTH_MOST = 32,
    PP_RAD_COPIES_MOST = 1000000,
    PP_RAD_SHAPES_MOST = 50000000,
    PP_RAD_MATERIALS_MOST = 200000,
    PP_RAD_COPIED_SHAPES_MOST = 1000000,
    PP_RAD_COPIED_CORNERS_MOST = 4000000,
    PP_RAD_COPIED_BYTES_MOST = 256 << 20
};
#endif

/* "modifier type identifier" with its strings and numbers; integer arguments are
 * skipped. */
struct pp_rad_primitive {
    struct pp_rad_words *words; /* source file, for messages */
    int line;
    struct pp_rad_word type, name;
    struct pp_rad_meaning modifier;
    struct pp_rad_word *strings;
    int string_count;
    double *numbers;
    int number_count;
};

/* Effect of the enclosing xforms on a shape. */
struct pp_rad_context {
    struct pp_rad_transform transform;
    bool inverted;                  /* front and back exchanged */
    bool replaced;                  /* `modifier` replaces the modifiers of all
                                     * shapes */
    struct pp_rad_meaning modifier; /* valid if replaced */
    int depth;                      /* nesting depth of files */
    bool copied;                    /* in an array of several copies */
};

struct pp_rad_reader {
    struct pp_scene_description *scene;
    struct pp_rad_summary *summary;
    struct pp_rad_names names;
    long copies;                     /* total of all xforms so far */
    unsigned long long bytes;        /* read from all files */
    unsigned long long copied_bytes; /* read from files in copies */
    int copied_shapes;               /* shapes in copies */
    long copied_corners;             /* corners of polygons in copies */
    bool too_deep;                   /* nesting exceeded PP_RAD_DEPTH_MOST */
    /* Strings and numbers of the current primitive, and corners of the current polygon;
     * the memory is reused for the next one. */
    struct pp_rad_word *strings;
    int string_space;
    double *numbers;
    int number_space;
    struct pp_vec3 *corners;
    int corner_space;
};

#endif
