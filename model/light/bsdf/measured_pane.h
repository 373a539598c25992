/* measured_pane.h - a measured glazing system as a pane of a room.
 *
 * Its data are a bsdf.h. Data of patches smear light that is not scattered at all over
 * a patch, 10 to 18 degrees wide. That light is split off as a ray by this rule: for light
 * in a patch, let f be the BSDF of the leaving patch of the same directions, W its projected
 * solid angle, and g the largest value of the adjacent leaving patches. If f > 2 g,
 *
 *     straight(in) = W (f - g)
 *
 * and g is left of f. A smaller excess is taken for a broad lobe of scattered light. Data
 * whose arriving and leaving directions have different bases are not split.
 *
 * Reflected light is diffuse, with the hemispherical reflectance of the data; 0 if there
 * are none.
 */
#ifndef PP_MODEL_LIGHT_BSDF_MEASURED_PANE_H
#define PP_MODEL_LIGHT_BSDF_MEASURED_PANE_H

#include "model/light/bsdf/bsdf.h"
#include "model/light/pane_scatter.h"

/* The kind of glass that the pane is for hand methods. */
enum pp_measured_kind {
    PP_MEASURED_CLEAR,      /* 98 % of the light passes straight */
    PP_MEASURED_DIFFUSING,  /* Lambertian, within 5 % of the light */
    PP_MEASURED_SCATTERING, /* any other */
};

/* Light of one direction of travel. */
struct pp_measured_way {
    struct pp_angle_basis in, out;
    double *scattered;  /* f without unscattered light, [out][in] */
    double *cumulative; /* sums of f W(in) up to and including each `in`, [out][in] */
    double *straight;   /* [in] */
    double *through;    /* [in]: scattered transmittance */
};

struct pp_measured_pane {
    struct pp_pane_scatter scatter; /* data: this pane, which must not move */
    struct pp_measured_way into_room, out_of_room;
    enum pp_measured_kind kind;
    bool is_split;  /* unscattered light is a ray */
    double normal;  /* direct-hemispherical transmittance at normal incidence, front */
    double diffuse; /* hemispherical transmittance, front */
    double straight_diffuse; /* part of it that is not scattered */
    char name[PP_BSDF_NAME]; /* of the system; may be empty */
    char *file;              /* as in the room file; NULL: none */
    char warnings[PP_BSDF_WARNINGS_MOST][PP_BSDF_WARNING];
    int warning_count;
    int holders; /* number of parts and openings that share it; changed by several
                  * threads */
};

/* Makes a pane, with one holder. bsdf: complete. split: unscattered light is a ray.
 * PP_BAD_INPUT, with a message that follows the name of a file, if the pane transmits no
 * light. */
enum pp_status pp_measured_pane_create(struct pp_measured_pane **pane,
                                       const struct pp_bsdf *bsdf, bool split,
                                       struct pp_error *err);

/* Another holder; a holder less, and the pane is freed after the last. NULL is allowed. */
struct pp_measured_pane *pp_measured_pane_hold(struct pp_measured_pane *pane);
void pp_measured_pane_release(struct pp_measured_pane *pane);

#endif
