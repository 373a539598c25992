/* rad_xform.h - the options of a command "xform", and the copies that they make.
 *
 * An xform is a row of stages, one to begin with and one more from each -i and -a on:
 * a stage of "-i N" is applied N times, one of "-a N" makes N copies, to which it is
 * applied 0, 1, ... N - 1 times (rad_transform.h has the options within a stage).
 */
#ifndef PP_FORMATS_RADIANCE_READ_RAD_XFORM_H
#define PP_FORMATS_RADIANCE_READ_RAD_XFORM_H

#include "formats/radiance/rad_names.h"
#include "formats/radiance/read/rad_pipe.h"
#include "formats/radiance/read/rad_transform.h"

enum { PP_RAD_XFORM_STAGES_MOST = 16 };

struct pp_rad_xform_stage {
    struct pp_rad_transform transform;
    int count;  /* how often it is applied; */
    bool array; /* or 0 to count - 1 times, a copy each */
};

struct pp_rad_xform {
    struct pp_rad_xform_stage stages[PP_RAD_XFORM_STAGES_MOST];
    int stage_count;
    bool inverted;                  /* -I: front for back */
    bool replaced;                  /* -m: all modifiers of shapes, */
    struct pp_rad_meaning modifier; /* by this one */
    char **files;
    int file_count;
};

/* Reads the words of an xform; `names` are the scene's, for -m. */
enum pp_status pp_rad_xform_read(struct pp_rad_xform *xform,
                                 const struct pp_rad_names *names,
                                 const struct pp_rad_pipe *pipe,
                                 const struct pp_rad_command *command,
                                 struct pp_error *err);

/* Number of copies, 1 or more; a double, since it may be any number. */
double pp_rad_xform_copies(const struct pp_rad_xform *xform);

/* Calculates once the common parts of all copies: stages applied N times become stages
 * applied once. */
void pp_rad_xform_fold(struct pp_rad_xform *xform);

/* The transform of copy `index`, from 0, the last array running fastest. */
struct pp_rad_transform pp_rad_xform_copy(const struct pp_rad_xform *xform, long index);

#endif
