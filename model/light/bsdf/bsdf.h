/* bsdf.h - the scattering data of a glazing system, as matrices over patches of
 * directions.
 *
 * A block gives f(out, in), 1/sr: the radiance that leaves in a patch `out`, divided by
 * the irradiance of the light that arrives in a patch `in`. With W the projected solid
 * angle of a patch,
 *
 *     direct-hemispherical    T(in) = sum over out of f(out, in) W(out)
 *     hemispherical           T     = sum over in of W(in) T(in) / pi
 *
 * Directions are directions of travel, for arriving and leaving light, in the axes of
 * the pane: z is its normal into the room, y is up, x = y cross z (to the right for a
 * person who looks out). Unscattered light has the same patch in and out. Light from a
 * high sun travels downwards, at an azimuth of about 270 degrees. Front is the outside.
 *
 * A passive pane is reciprocal: light that travels the opposite way is scattered alike,
 *
 *     f_back(opposite(in), opposite(out)) = f_front(out, in)
 */
#ifndef PP_MODEL_LIGHT_BSDF_BSDF_H
#define PP_MODEL_LIGHT_BSDF_BSDF_H

#include <stdbool.h>

#include "model/base/error.h"
#include "model/light/bsdf/angle_basis.h"

enum pp_bsdf_part {
    PP_BSDF_THROUGH_FRONT, /* light from outside into the room */
    PP_BSDF_THROUGH_BACK,  /* light from the room to the outside */
    PP_BSDF_REFLECT_FRONT, /* light from outside, reflected */
    PP_BSDF_REFLECT_BACK,  /* light from the room, reflected */
    PP_BSDF_PARTS
};

struct pp_bsdf_block {
    struct pp_angle_basis in, out;
    double *values; /* f(out, in) at [out * in.count + in]; NULL: not known */
};

enum { PP_BSDF_NAME = 128, PP_BSDF_WARNINGS_MOST = 8, PP_BSDF_WARNING = 256 };

struct pp_bsdf {
    char name[PP_BSDF_NAME]; /* name of the system; may be empty */
    struct pp_bsdf_block blocks[PP_BSDF_PARTS];

    /* Doubts about the data, each without a full stop. */
    char warnings[PP_BSDF_WARNINGS_MOST][PP_BSDF_WARNING];
    int warning_count;
};

void pp_bsdf_clear(struct pp_bsdf *bsdf);

/* Allocates the values of a block whose bases are set. */
enum pp_status pp_bsdf_block_init(struct pp_bsdf_block *block, struct pp_error *err);

/* T(in) of the patch `in`, and T; both are 0 for a block without values. */
double pp_bsdf_block_direct(const struct pp_bsdf_block *block, int in);
double pp_bsdf_block_hemispherical(const struct pp_bsdf_block *block);

/* Adds a warning; warnings beyond PP_BSDF_WARNINGS_MOST are dropped. */
void pp_bsdf_warn(struct pp_bsdf *bsdf, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* Completes data that have at least one block of transmission: calculates the missing
 * direction by reciprocity. Adds warnings if more light is transmitted and reflected
 * than arrives, or if the two directions contradict reciprocity. */
enum pp_status pp_bsdf_complete(struct pp_bsdf *bsdf, struct pp_error *err);

#endif
