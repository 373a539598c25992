/* sky_factor.c - `sky-factor`: direct light of a uniform sky through bare openings, as
 * surveyors of rights of light use it                                        [WW23]:
 *
 *   SF = (1/pi) integral of sin(gamma) over the visible sky
 *
 *   gamma  altitude of a point of the sky
 *
 * Of a level point facing up, whatever the room's own sky. An opening is a hole: it has
 * no glass, frame or dirt, and what hides the sky sends no light. By closed form, exact
 * to 1e-9 of the open sky; 1 under the whole sky.
 */
#include "methods/method.h"

#include "methods/exact/direct.h"

static const char *refuses_room(const struct pp_world *world,
                                const struct pp_receiver *receiver)
{
    (void)world;
    if (receiver && receiver->normal.z < 1.0)
        return "a sky factor is of a level point facing up";
    return NULL;
}

static const char *refuses(const struct pp_world *world,
                           const struct pp_opening *opening,
                           const struct pp_receiver *receiver)
{
    (void)world;
    (void)receiver;
    return opening->curtains < 1.0 ? "has curtains; a sky factor is of bare openings"
                                   : NULL;
}

static enum pp_status evaluate(const struct pp_world *world,
                               const struct pp_opening *opening,
                               const struct pp_receiver *receiver, const void *tools,
                               struct pp_part *part, struct pp_error *err)
{
    (void)tools;
    /* A shallow copy of the world, which owns nothing, under a uniform sky. */
    struct pp_world uniform = *world;
    uniform.sky = pp_sky_uniform();
    const struct pp_glass none = pp_glass_none();
    struct pp_direct sum = {0};
    enum pp_status status =
        pp_direct_through(&sum, &uniform, opening, receiver, &none, err);
    part->sky = sum.sky;
    part->external = 0.0;
    return status;
}

/* Its figures are meant without glass, frame and dirt, so that nothing is left to be
 * corrected for. */
const struct pp_method pp_method_sky_factor = {
    .name = "sky-factor",
    .summary = "direct light of a uniform sky through bare openings",
    .source = "WW23",
    .gives = PP_GIVES_DIRECT,
    .speaks_for = PP_FOR_POINT,
    .allowances = PP_ALLOWS_OWN_GLASS | PP_ALLOWS_FRAME | PP_ALLOWS_DIRT,
    .refuses_room = refuses_room,
    .refuses = refuses,
    .evaluate = evaluate,
};
