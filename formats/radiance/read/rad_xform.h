/* rad_xform.h - the options of a command "xform", and the copies that it makes.
 *
 * An xform is a sequence of stages; each -i and -a begins a new one. A stage of "-i N"
 * is applied N times. A stage of "-a N" makes N copies, to which it is applied 0, 1,
 * ... N - 1 times. Options within a stage are those of rad_transform.h.
 */
#ifndef PP_FORMATS_RADIANCE_READ_RAD_XFORM_H
#define PP_FORMATS_RADIANCE_READ_RAD_XFORM_H

#include "formats/radiance/rad_names.h"
#include "formats/radiance/read/rad_pipe.h"
#include "formats/radiance/read/rad_transform.h"

enum { PP_RAD_XFORM_STAGES_MOST = 16 };

struct pp_rad_xform_stage {
    struct pp_rad_transform transform;
    int count;  /* number of applications, or of copies of an array */
    bool array; /* copy i (0 to count - 1) gets i applications */
};

struct pp_rad_xform {
    struct pp_rad_xform_stage stages[PP_RAD_XFORM_STAGES_MOST];
    int stage_count;
    bool inverted;                  /* -I: front and back exchanged */
    bool replaced;                  /* -m: `modifier` replaces the modifiers of all
                                     * shapes */
    struct pp_rad_meaning modifier; /* valid if replaced */
    char **files;
    int file_count;
};

/* Parses the words of an xform; `names` are those of the scene, for -m. */
enum pp_status pp_rad_xform_read(struct pp_rad_xform *xform,
                                 const struct pp_rad_names *names,
                                 const struct pp_rad_pipe *pipe,
                                 const struct pp_rad_command *command,
                                 struct pp_error *err);

/* Number of copies, 1 or more; a double, since the product may exceed any integer. */
double pp_rad_xform_copies(const struct pp_rad_xform *xform);

/* Combines the N applications of a stage "-i N" into one, once for all copies. */
void pp_rad_xform_fold(struct pp_rad_xform *xform);

/* Transform of copy `index`, from 0; the last array varies fastest. */
struct pp_rad_transform pp_rad_xform_copy(const struct pp_rad_xform *xform, long index);

#endif
