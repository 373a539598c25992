/* eye_rays.h - the surfaces that an eye sees, by rays that divide its field of view,
 * the hemisphere around the line of sight, into equal solid angles; and those in front
 * of a pane that scatters light.
 *
 * A square grid is mapped to a disc [SC97] and the disc to the hemisphere, both with
 * equal areas. One ray through the middle of each cell is followed through clear panes
 * to its end. Reflections by glass are neglected.
 */
#ifndef PP_SIMULATE_YEAR_EYE_RAYS_H
#define PP_SIMULATE_YEAR_EYE_RAYS_H

#include "model/geometry/frame.h"
#include "simulate/path_tracer/path_trace.h"

enum pp_eye_end {
    PP_EYE_NOTHING, /* an opaque pane, or a leak */
    PP_EYE_SKY,
    PP_EYE_GROUND,  /* open ground, lit by the whole sky */
    PP_EYE_FACE,    /* skyline without a distance: only its normal is known */
    PP_EYE_SURFACE, /* a surface, or ground that objects can shade */
    PP_EYE_PANE,    /* diffusing pane: `at` is on its outside */
};

struct pp_eye_ray {
    struct pp_vec3 u; /* unit */
    enum pp_eye_end end;
    int opening;            /* first opening that the ray passes or ends at; -1: none */
    double transmittance;   /* of the glass on the way, without frames */
    double clear_share;     /* fraction of the cell that is glass and not frame */
    struct pp_lit_point at; /* from the scene's centre; PP_EYE_FACE: normal only */
    int tag;                /* surface: index in the world; ground: -1 */
    double reflectance;     /* of the ray's end; for a diffusing pane: transmittance */
    double exitance;        /* emitted by a surface, over Eh */

    /* The first pane on the way that scatters light by direction (pane_scatter.h). The
     * ray also has the light that this pane scatters towards the eye. */
    int pane;                    /* index of its opening; -1: none */
    int pane_class;              /* class of the light towards the eye */
    double pane_share;           /* transmittance of the glass and dirt on the way,
                                  * without the pane itself and without frames */
    struct pp_lit_point pane_at; /* on the outside of the pane, from the centre */
};

struct pp_eye_rays {
    struct pp_vec3 centre;   /* of the scene, in the room's axes */
    struct pp_frame view;    /* x to the right, y up, z along the line of sight */
    int side, count;         /* count: side x side */
    double solid_angle_sr;   /* of each ray */
    struct pp_eye_ray *list; /* by row of the grid */
};

/* Follows side x side rays. eye: in the room's axes; its normal is the line of sight,
 * which must not be vertical. ground_reflectance: of the ground as a surface. On
 * success the caller must clear *rays. */
enum pp_status pp_eye_rays_init(struct pp_eye_rays *rays,
                                const struct pp_light_scene *scene,
                                const struct pp_receiver *eye, int side,
                                double ground_reflectance, struct pp_error *err);
void pp_eye_rays_clear(struct pp_eye_rays *rays);

/* Follows a ray from the outside of an opening, at the middle of its glass. u: unit,
 * leads outwards. */
struct pp_eye_ray pp_eye_rays_outwards(const struct pp_light_scene *scene, int opening,
                                       struct pp_vec3 u, double ground_reflectance);

/* Luminance of the sun seen from the eye through glass, divided by that of the sun: the
 * transmittance on the way, without frames; 0 if the sun is hidden. sun: unit vector
 * towards it. *opening: index of the opening through which it is seen; -1: none. */
double pp_eye_rays_to_sun(const struct pp_light_scene *scene, struct pp_vec3 eye,
                          struct pp_vec3 sun, int *opening);

#endif
