/* rad_reader.h - what the parts of the Radiance reader share (inside formats/radiance/ only).
 *
 * rad_read.c holds the loop over primitives and files, rad_materials.c,
 * rad_functions.c and rad_shapes.c what each type becomes, rad_command.c what lines
 * that begin with "!" do, rad_genbox.c the boxes of one.
 */
#ifndef PP_FORMATS_RADIANCE_RAD_READER_H
#define PP_FORMATS_RADIANCE_RAD_READER_H

#include "formats/radiance/rad_names.h"
#include "formats/radiance/rad_read.h"
#include "formats/radiance/rad_transform.h"
#include "formats/radiance/rad_words.h"

/* Of one file, and of all that xforms read. */
#define PP_RAD_BYTES_MOST ((size_t)4 << 30)

/* Files that read files that ...; copies that all xforms make, shapes, and materials
 * with patterns, in all: a line of a hundred characters can ask for any number. The
 * fuzzer's are smaller, for speed. */
#ifdef FUZZING_BUILD_MODE_UNSAFE_FOR_PRODUCTION
enum {
    PP_RAD_DEPTH_MOST = 8,
    PP_RAD_COPIES_MOST = 1000,
    PP_RAD_SHAPES_MOST = 20000,
    PP_RAD_MATERIALS_MOST = 2000
};
#else
enum {
    PP_RAD_DEPTH_MOST = 32,
    PP_RAD_COPIES_MOST = 1000000,
    PP_RAD_SHAPES_MOST = 50000000,
    PP_RAD_MATERIALS_MOST = 200000
};
#endif

/* "modifier type identifier", and behind it so many strings, whole numbers, numbers. */
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

/* How what is read is changed on its way: by the xforms that it goes through. */
struct pp_rad_context {
    struct pp_rad_transform transform;
    bool inverted;                  /* front for back */
    bool replaced;                  /* all modifiers of shapes, */
    struct pp_rad_meaning modifier; /* by this one */
    int depth;                      /* of files in files */
};

struct pp_rad_reader {
    struct pp_scene_description *scene;
    struct pp_rad_summary *summary;
    struct pp_rad_names names;
    long copies;              /* that xforms have made so far, */
    unsigned long long bytes; /* and of the files read */
    /* Of the primitive that is being read; kept from one to the next. */
    struct pp_rad_word *strings;
    int string_space;
    double *numbers;
    int number_space;
    struct pp_vec3 *corners;
    int corner_space;
};

/* Everything of one file, or of standard input ("-"). */
enum pp_status pp_rad_read_file(struct pp_rad_reader *reader, const char *path,
                                const struct pp_rad_context *way, struct pp_error *err);

/* Makes it mean its material or pattern; *taken is false if its type is none of these.
 */
enum pp_status pp_rad_materials_read(struct pp_rad_reader *reader,
                                     const struct pp_rad_primitive *primitive,
                                     const struct pp_rad_context *way, bool *taken,
                                     struct pp_error *err);

/* The same of what pepperpot's own exports say by functions (rad_functions.h). */
enum pp_status pp_rad_functions_read(struct pp_rad_reader *reader,
                                     const struct pp_rad_primitive *primitive,
                                     const struct pp_rad_context *way, bool *taken,
                                     struct pp_error *err);

/* Adds it to the scene; *taken is false if its type is no shape's. */
enum pp_status pp_rad_shapes_read(struct pp_rad_reader *reader,
                                  const struct pp_rad_primitive *primitive,
                                  const struct pp_rad_context *way, bool *taken,
                                  struct pp_error *err);

/* PP_BAD_INPUT where there are more materials and patterns than may be. */
enum pp_status pp_rad_materials_check_count(const struct pp_rad_reader *reader,
                                            const struct pp_rad_words *words, int line,
                                            struct pp_error *err);

/* Works out what the commands of a line, piped together, would print, and reads that.
 * `words` is where the line stands. */
enum pp_status pp_rad_command_run(struct pp_rad_reader *reader,
                                  const struct pp_rad_words *words, char *command,
                                  int line, const struct pp_rad_context *way,
                                  struct pp_error *err);

/* The box of a line "genbox MATERIAL NAME X Y Z [options]", in words. */
enum pp_status pp_rad_genbox(struct pp_rad_reader *reader,
                             const struct pp_rad_words *words, int line,
                             char *const *command, int count,
                             const struct pp_rad_context *way, struct pp_error *err);

/* The shape through its transform and into the scene: polygons of count corners, all
 * else by *shape. A material of void is not seen: nothing is added. */
enum pp_status pp_rad_shapes_add_polygon(struct pp_rad_reader *reader,
                                         const struct pp_rad_words *words, int line,
                                         struct pp_rad_meaning modifier,
                                         const struct pp_vec3 *corners, int count,
                                         const struct pp_rad_context *way,
                                         struct pp_error *err);
enum pp_status pp_rad_shapes_add(struct pp_rad_reader *reader,
                                 const struct pp_rad_words *words, int line,
                                 struct pp_rad_meaning modifier, struct pp_shape shape,
                                 const struct pp_rad_context *way,
                                 struct pp_error *err);

#endif
