/* measured_pane.h - a measured glazing system as a pane of a room.
 *
 * The data are a struct pp_bsdf (bsdf.h). They spread unscattered light over a whole
 * patch, 10 to 18 degrees wide. The following rule separates that light, which is then
 * traced as a ray. For light that arrives in a patch, let f be the BSDF of the leaving
 * patch with the same directions, W the projected solid angle of that patch, and g the
 * largest BSDF of the adjacent leaving patches. If f > 2 g,
 *
 *     straight(in) = W (f - g)
 *
 * and f is replaced by g. A smaller excess is assumed to be a broad lobe of scattered
 * light. Data with different bases for arriving and leaving light are not separated.
 *
 * Reflected light is diffuse, with the hemispherical reflectance of the data; 0 if the
 * data have none.
 */
#ifndef PP_MODEL_LIGHT_BSDF_MEASURED_PANE_H
#define PP_MODEL_LIGHT_BSDF_MEASURED_PANE_H

#include "model/light/bsdf/bsdf.h"
#include "model/light/pane_scatter.h"

/* Kind of glass by which hand methods represent the pane. */
enum pp_measured_kind {
    PP_MEASURED_CLEAR,      /* over 98 % of transmitted light is unscattered */
    PP_MEASURED_DIFFUSING,  /* Lambertian within 5 % of transmitted light */
    PP_MEASURED_SCATTERING, /* any other */
};

/* Data for light that travels one way, into the room or out of it. */
struct pp_measured_way {
    struct pp_angle_basis in, out;
    double *scattered;  /* f without unscattered light, [out][in] */
    double *cumulative; /* sums of f W(in) up to and including each `in`, [out][in] */
    double *straight;   /* [in]: unscattered transmittance */
    double *through;    /* [in]: transmittance of scattered light */
};

struct pp_measured_pane {
    struct pp_pane_scatter scatter; /* data: this pane, which must not move */
    struct pp_measured_way into_room, out_of_room;
    enum pp_measured_kind kind;
    bool is_split;  /* true if unscattered light is a ray */
    double normal;  /* direct-hemispherical transmittance at normal incidence, front */
    double diffuse; /* hemispherical transmittance, front */
    double straight_diffuse; /* unscattered part of `diffuse` */
    char name[PP_BSDF_NAME]; /* name of the system; may be empty */
    char *file;              /* as in the room file; NULL: none */
    char warnings[PP_BSDF_WARNINGS_MOST][PP_BSDF_WARNING];
    int warning_count;
    int holders; /* number of parts and openings that share it; changed by several
                  * threads */
};

/* Makes a pane, with one holder. bsdf: complete data. split: unscattered light is
 * traced as a ray. PP_BAD_INPUT if the pane transmits no light; the caller writes the
 * name of the file before the message. */
enum pp_status pp_measured_pane_create(struct pp_measured_pane **pane,
                                       const struct pp_bsdf *bsdf, bool split,
                                       struct pp_error *err);

/* Add and remove a holder; removing the last one frees the pane. NULL is allowed. */
struct pp_measured_pane *pp_measured_pane_hold(struct pp_measured_pane *pane);
void pp_measured_pane_release(struct pp_measured_pane *pane);

#endif
