/* rad_reader.h - the state of the Radiance reader, which its parts share. Inside
 * formats/radiance/ only.
 *
 * rad_read.c goes over files, primitives and commands; rad_primitive.c reads one
 * primitive, which becomes a part of the scene in rad_shapes.c, rad_materials.c,
 * rad_sky.c and rad_functions.c; rad_pipe.c, rad_xform.c and rad_genbox.c are about
 * commands.
 */
#ifndef PP_FORMATS_RADIANCE_READ_RAD_READER_H
#define PP_FORMATS_RADIANCE_READ_RAD_READER_H

#include "formats/radiance/rad_names.h"
#include "formats/radiance/read/rad_read.h"
#include "formats/radiance/read/rad_transform.h"
#include "formats/radiance/read/rad_words.h"

/* Limits. On the bytes of one file, and of all files that xforms read; on the depth of
 * files that xforms read within files; and, for all files together, on the copies by
 * xforms, on shapes, and on materials and patterns. A line of a hundred characters can
 * request any number. The contents of copies, of which an array makes several,
 * therefore have their own limits: on shapes, their corners, and bytes read again for
 * each copy. A million polygons take 700 MiB when traced. The fuzzer's limits are
 * smaller, for speed. */
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

/* "modifier type identifier" with its strings and numbers (whole numbers are passed
 * over). */
struct pp_rad_primitive {
    struct pp_rad_words *words; /* where it stands, for messages */
    int line;
    struct pp_rad_word type, name;
    struct pp_rad_meaning modifier;
    struct pp_rad_word *strings;
    int string_count;
    double *numbers;
    int number_count;
};

/* Transforms applied to shapes by xform. */
struct pp_rad_context {
    struct pp_rad_transform transform;
    bool inverted;                  /* front for back */
    bool replaced;                  /* all modifiers of shapes, */
    struct pp_rad_meaning modifier; /* by this one */
    int depth;                      /* how many files are being read within files */
    bool copied;                    /* by an array, with others */
};

struct pp_rad_reader {
    struct pp_scene_description *scene;
    struct pp_rad_summary *summary;
    struct pp_rad_names names;
    long copies;                     /* that xforms have made so far, */
    unsigned long long bytes;        /* and of the files read, */
    unsigned long long copied_bytes; /* bytes of the files read in copies */
    int copied_shapes;               /* in copies, */
    long copied_corners;             /* and of the polygons among them */
    bool too_deep;                   /* files within files were too many */
    /* Strings of the current primitive; kept from one to the next. */
    struct pp_rad_word *strings;
    int string_space;
    double *numbers;
    int number_space;
    struct pp_vec3 *corners;
    int corner_space;
};

#endif
