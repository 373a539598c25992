/* glare_view.h - the glare sources in the view of an eye in a room, for any sky and
 * sun.
 *
 * The field of view is the hemisphere around the line of sight, divided into equal
 * cells (eye_rays.h). A cell is a source if its luminance L is at least the threshold.
 * The result is the sum of L^2 omega / P^2 over all sources (dgp.h). Cells are not
 * merged into larger sources. The sun is a separate source: a disc of 0.533 degrees
 * with the illuminance of the direct light, multiplied by the transmittance of the
 * glass.
 *
 * Luminances:
 *
 *     sky                  by the formula of the sky, times the transmittance of the
 *                          glass
 *     ground, outdoor      rho/pi times the illuminance by sun, and by sky and ground
 *     surfaces             on an unobstructed plane with the same normal; whether the
 *                          sun reaches the surface is tested at the point seen
 *     diffusing pane       like an outdoor surface in the plane of the pane, with the
 *                          transmittance of the pane in place of rho
 *     pane that scatters   light that passes straight: the luminance behind it, times
 *     by direction         the straight transmittance; plus scattered light
 *                          (glare_panes.h)
 *     indoor surfaces      rho/pi times the illuminance by sun and by all other light;
 *                          the latter is simulated at some of the points seen, and
 *                          assigned to the points near them on the same surface
 *
 * In a framed opening, the glass has its full luminance over its fraction of the cell;
 * the frame is treated as dark. The disc of the sun is seen through the glass. Between
 * slats, a fraction of the disc is visible with the luminance that the glass passes.
 */
#ifndef PP_STUDIES_GLARE_GLARE_VIEW_H
#define PP_STUDIES_GLARE_GLARE_VIEW_H

#include "model/light/perez_sky.h"
#include "model/light/sky_patches.h"
#include "model/results/sheets/glare_sheet.h"
#include "studies/glare/glare_panes.h"

/* Greatest number of points at which indoor surfaces are simulated. */
enum { PP_GLARE_SURFACES_MOST = 64 };

struct pp_glare_view {
    const struct pp_light_scene *scene;   /* not owned */
    const struct pp_world *world;         /* not owned */
    const struct pp_outside_light *light; /* for the ground; not owned */
    struct pp_receiver eye;
    struct pp_eye_rays rays;
    double *indices; /* for each ray: position index P */
    int *surface_of; /* for each ray: index in `surfaces`; -1: none */
    int *plane_of;   /* for each ray: index in `planes`; -1: not an outdoor surface */

    struct pp_receiver *surfaces; /* points of indoor surfaces, in the room's axes */
    int surface_count;
    struct pp_vec3 *planes; /* normals of outdoor surfaces */
    int plane_count;
    struct pp_sky_patches patches; /* sky patches for the skylight on these planes */
    struct pp_glare_panes panes;   /* panes that scatter light by direction */
    int work_count;                /* numbers of work space for one hour */
};

/* Finds the field of view, which has side x side cells. side: a multiple of 8; scene:
 * scene of that world with matt surfaces. The caller clears *view, even after a
 * failure. */
enum pp_status pp_glare_view_init(struct pp_glare_view *view,
                                  const struct pp_light_scene *scene,
                                  const struct pp_world *world,
                                  const struct pp_outside_light *light,
                                  const struct pp_receiver *eye, int side,
                                  struct pp_error *err);
void pp_glare_view_clear(struct pp_glare_view *view);

/* Finds the glare sources. Adds them up in *sun and in `parts`: one part for each
 * opening, then one for the surfaces of the room. sky: in the axes of the room;
 * rest_lx: illuminances at view->surfaces without direct sun; opening_count: number of
 * openings in the world; work: work space for view->work_count numbers. Returns the sum
 * over all sources. */
double pp_glare_view_sources(const struct pp_glare_view *view,
                             const struct pp_perez_sky *sky, const float *rest_lx,
                             double threshold_cd_m2, struct pp_glare_part *parts,
                             int opening_count, struct pp_glare_sun *sun, double *work);

#endif
