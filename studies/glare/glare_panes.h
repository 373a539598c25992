/* glare_panes.h - the luminance of panes that scatter light by direction, such as a
 * blind or measured glazing, in the view of an eye.
 *
 * Light of one class (pane_scatter.h) that a pane sends into the room has the luminance
 *
 *     L(class) = sum over u of f(u, class) cos(u) omega L(u)
 *                + f(sun, class) times the illuminance from the sun
 *
 *     f       BTDF of the pane
 *     u       directions on the outside of the pane: Reinhart's 577 sky patches, and
 *             their mirror images below the horizon
 *     cos     cosine of the angle between u and the normal of the pane
 *     omega   solid angle of a direction
 *     L(u)    luminance seen from the middle of the pane in direction u
 *
 * Whether the sun reaches the pane is tested at the point where a ray of the eye meets
 * it.
 */
#ifndef PP_STUDIES_GLARE_GLARE_PANES_H
#define PP_STUDIES_GLARE_GLARE_PANES_H

#include "simulate/year/eye_rays.h"

/* A pane in the view. */
struct pp_glare_pane {
    int opening;
    int ray_count;
    struct pp_eye_ray *rays; /* outwards */
    double *cos_sr;          /* for each ray: cos omega */
    int *plane_of;           /* for each ray: set by the owner; -1: none */
    int *row_of_class;       /* index of a class among the rows; -1: not in view */
};

/* All panes of a view, and the classes of light in it as rows. */
struct pp_glare_panes {
    int count;
    struct pp_glare_pane *list;
    int row_count;
    struct pp_glare_row {
        int pane, leaving;
        float *weights; /* for each ray of the pane: f cos omega */
    } * rows;
    int *row_of_ray; /* for each ray of the eye; -1: no such pane */
};

/* Finds the panes among the rays of an eye. The caller clears *panes, even after a
 * failure. */
enum pp_status pp_glare_panes_init(struct pp_glare_panes *panes,
                                   const struct pp_light_scene *scene,
                                   const struct pp_world *world,
                                   const struct pp_eye_rays *rays,
                                   double ground_reflectance, struct pp_error *err);
void pp_glare_panes_clear(struct pp_glare_panes *panes);

/* Luminance L(class) of a row without direct sun, cd/m2. luminances: L(u) of each ray
 * of the row's pane. */
double pp_glare_panes_luminance(const struct pp_glare_panes *panes, int row,
                                const double *luminances);

#endif
