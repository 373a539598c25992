/* glare_view.h - the glare sources that an eye sees from a room, for any sky and sun.
 *
 * The field of view is the hemisphere around the line of sight, in equal cells
 * (eye_rays.h). A cell whose luminance L reaches the threshold is a source; all sources
 * are added as sum of L^2 omega / P^2 (dgp.h). Cells are not merged to larger sources.
 * The sun is a source of its own, a disc of 0.533 degrees with the illuminance of the
 * direct light; the glass in front of it dims it.
 *
 * Luminances:
 *
 *     sky                  of its formula, times the transmittance of the glass
 *     ground, outdoor      rho/pi (sun + sky and ground on an unobstructed plane with
 *     surfaces             that normal); sunlight is tested at the point seen
 *     diffusing pane       as an outdoor surface in its plane, with its transmittance
 *     indoor surfaces      rho/pi (sun + rest); the rest is simulated at some of the
 *                          points seen, and is that of the nearest on the same surface
 *
 * In a framed opening the glass has its full luminance over its share of the cell, and
 * the frame counts as dark. The disc of the sun is seen through the glass.
 */
#ifndef PP_STUDIES_GLARE_GLARE_VIEW_H
#define PP_STUDIES_GLARE_GLARE_VIEW_H

#include "model/light/perez_sky.h"
#include "model/light/sky_patches.h"
#include "model/results/sheets/glare_sheet.h"
#include "simulate/year/eye_rays.h"

/* Greatest number of points at which indoor surfaces are simulated. */
enum { PP_GLARE_SURFACES_MOST = 64 };

struct pp_glare_view {
    const struct pp_light_scene *scene;   /* not owned */
    const struct pp_outside_light *light; /* for the ground; not owned */
    struct pp_receiver eye;
    struct pp_eye_rays rays;
    double *indices; /* by ray: P */
    int *surface_of; /* by ray: index in surfaces; -1: none */
    int *plane_of;   /* by ray: index in planes; -1: not an outdoor surface */

    struct pp_receiver *surfaces; /* points of indoor surfaces, in the room's axes */
    int surface_count;
    struct pp_vec3 *planes; /* normals of outdoor surfaces */
    int plane_count;
    struct pp_sky_patches patches; /* for the sky's light on these planes */
};

/* side: the field of view has side x side cells; a multiple of 8. scene: of the world,
 * matt. The caller clears *view, even after a failure. */
enum pp_status pp_glare_view_init(struct pp_glare_view *view,
                                  const struct pp_light_scene *scene,
                                  const struct pp_outside_light *light,
                                  const struct pp_receiver *eye, int side,
                                  struct pp_error *err);
void pp_glare_view_clear(struct pp_glare_view *view);

/* Fills the parts of a moment: one for each opening, one for the room's surfaces, one
 * for the sun. sky: in the room's axes. rest_lx: illuminances at view->surfaces without
 * direct sun. opening_count: of the world. Returns the sum over all parts. */
double pp_glare_view_sources(const struct pp_glare_view *view,
                             const struct pp_perez_sky *sky, const float *rest_lx,
                             double threshold_cd_m2, struct pp_glare_part *parts,
                             int opening_count, struct pp_glare_sun *sun);

#endif
