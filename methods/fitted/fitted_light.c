/* fitted_light.c - calculates V, C_b and C_g by the geometry of `exact`, with and
 * without a reflecting ground, and their effective parts. */
#include "methods/fitted/fitted_light.h"

#include <stdlib.h>

#include "methods/exact/exterior.h"
#include "methods/fitted/fitted_constants.h"
#include "methods/refusals.h"

static const struct pp_formula_quantity of_shade[] = {
    {"V", PP_UNIT_DAYLIGHT_FACTOR,
     "illuminance on the outside of the opening from the sky"},
    {"C_b", PP_UNIT_DAYLIGHT_FACTOR,
     "illuminance on the opening from obstructions if they are unshaded"},
    {"C_g", PP_UNIT_DAYLIGHT_FACTOR,
     "illuminance on the opening from the visible ground if it is unshaded"},
    {0},
};

const struct pp_formula pp_fitted_light_E_b = {
    .symbol = "E_b",
    .sum = "C_b max(V / 39.6, 0.003)^" PP_FITTED_SHADE,
    .unit = PP_UNIT_DAYLIGHT_FACTOR,
    .source = "ATLAS",
    .what = "illuminance on the outside of the opening from obstructions",
    .quantities = of_shade,
};

const struct pp_formula pp_fitted_light_E_g = {
    .symbol = "E_g",
    .sum = "C_g max(V / 39.6, 0.003)^(" PP_FITTED_SHADE " / 2)",
    .unit = PP_UNIT_DAYLIGHT_FACTOR,
    .source = "ATLAS",
    .what = "illuminance on the outside of the opening from the ground",
    .quantities = of_shade,
};

static enum pp_status light_on(struct pp_fitted_light *on, const struct pp_world *world,
                               const struct pp_outside_light *light,
                               const struct pp_opening *opening, struct pp_error *err)
{
    struct pp_vec3 out = pp_vec_scale(opening->inner.normal, -1.0);
    struct pp_vec3 middle = pp_exterior_opening_centroid(opening);
    struct pp_outside_light dark = *light;
    struct pp_exterior_light all, without;
    dark.ground_reflectance = 0.0;
    enum pp_status status =
        pp_exterior_sky_on_plane(&on->V, world, opening, out, &light->sky, err);
    if (status == PP_OK)
        status = pp_exterior_light_on_plane(&without, world, &dark, middle, out,
                                            opening->face, err);
    if (status == PP_OK)
        status = pp_exterior_light_on_plane(&all, world, light, middle, out,
                                            opening->face, err);
    if (status != PP_OK)
        return status;
    on->C_b = without.external;
    on->C_g = all.external - without.external;
    return PP_OK;
}

enum pp_status pp_fitted_light_prepare(void **tools, const struct pp_world *world,
                                       const struct pp_outside_light *light,
                                       struct pp_error *err)
{
    struct pp_fitted_light *list =
        calloc((size_t)world->opening_count + 1, sizeof *list);
    if (!list)
        return pp_fail_memory(err);
    const struct pp_interior all = pp_interior_all(world);
    for (int i = 0; i < world->opening_count; i++) {
        const struct pp_opening *opening = world->openings + i;
        list[i].all = all;
        /* Most windows of a room have the same height. */
        list[i].parts = i > 0 && opening[-1].middle_z_m == opening->middle_z_m
                            ? list[i - 1].parts
                            : pp_interior_split(world, opening->middle_z_m);
        enum pp_status status = light_on(list + i, world, light, opening, err);
        if (status != PP_OK) {
            free(list);
            return status;
        }
    }
    *tools = list;
    return PP_OK;
}

void pp_fitted_light_put(struct pp_worksheet *sheet, const void *tools,
                         const struct pp_world *world, const struct pp_opening *opening)
{
    const struct pp_fitted_light *list = tools;
    struct pp_fitted_light on = list[opening - world->openings];
    pp_worksheet_put(sheet, PP_UNIT_DAYLIGHT_FACTOR, on.V, "V",
                     "illuminance on the outside of the opening from the sky");
    pp_worksheet_put(sheet, PP_UNIT_DAYLIGHT_FACTOR, on.C_b, "C_b",
                     "illuminance on the opening from obstructions if they are "
                     "unshaded");
    pp_worksheet_put(sheet, PP_UNIT_DAYLIGHT_FACTOR, on.C_g, "C_g",
                     "illuminance on the opening from the visible ground if it is "
                     "unshaded");
    pp_worksheet_work(sheet, &pp_fitted_light_E_b,
                      "illuminance on the opening from obstructions");
    pp_worksheet_work(sheet, &pp_fitted_light_E_g,
                      "illuminance on the opening from the ground");
}

const char *pp_fitted_light_refuses(const struct pp_world *world,
                                    const struct pp_outside_light *light,
                                    const struct pp_opening *opening,
                                    const struct pp_receiver *receiver)
{
    (void)light, (void)receiver;
    const char *why = pp_refusals_unless_vertical(opening);
    if (why)
        return why;
    if (opening->glass.diffusing)
        return "has diffusing glass, but the method is for clear glass only";
    if (!(pp_interior_all(world).reflectance < 1.0))
        return "is in a room with a mean reflectance of 1";
    return NULL;
}
