/* waldram_site.h - the view from a wall's outside, drawn for a vertical receiver: on
 * its Waldram diagram, and on the plan at unit height used with the skylight indicator.
 *
 * Obstructions are those of the vertical sky component (methods/exact/exterior.h): the
 * skylines of the wall, blocks, surfaces outside and the building's own outer faces. */
#ifndef PP_METHODS_WALDRAM_WALDRAM_SITE_H
#define PP_METHODS_WALDRAM_WALDRAM_SITE_H

#include "methods/waldram/waldram_scale.h"
#include "model/room/world.h"

struct pp_waldram_site {
    double sky_component; /* area of the visible sky on the diagram: the vertical sky
                           * component, relative error 1e-9 */
    struct pp_region sky, hidden; /* outlines; divided at azimuth 0 until
                                   * pp_waldram_site_join */
};

/* Projects the site on a diagram for vertical planes, in X and Y. The position is on
 * the outside of the surface `face`, which hides nothing. The caller clears the site;
 * empty on failure. */
enum pp_status pp_waldram_site_init(struct pp_waldram_site *site,
                                    const struct pp_waldram *waldram,
                                    const struct pp_world *world,
                                    struct pp_vec3 position, int face,
                                    struct pp_error *err);

/* Projects the site on the plan one unit above the position. Direction (x, y, z), x to
 * the right and y ahead, is drawn at (x/z, y/z): the edge of a building is at its
 * distance divided by its height. |x/z| and y/z are at most `reach`. sky_component is
 * not set. */
enum pp_status pp_waldram_site_init_plan(struct pp_waldram_site *site,
                                         const struct pp_world *world,
                                         struct pp_vec3 position, struct pp_vec3 facing,
                                         int face, double reach, struct pp_error *err);

/* Joins the two halves of a diagram, which meet at azimuth 0, for drawing as
 * outlines. */
enum pp_status pp_waldram_site_join(struct pp_waldram_site *site, struct pp_error *err);
void pp_waldram_site_clear(struct pp_waldram_site *site);

#endif
