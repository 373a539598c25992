/* glazing_ratio.c - ratio of window area to floor area, as required by building codes:
 *
 *   glass, net of frames, over floor area                  >= 8 %  [IBC21] section
 *                                                          1204.2
 *   openings in the wall, frames included, over floor area >= 1/8  [MBO02] section 47
 *
 * In the United States only the first applies, in Germany only the second; elsewhere
 * both are assessed. All openings are included, with any kind of glass, also
 * rooflights. The floor area is that of the whole room.
 */
#include <math.h>
#include <string.h>

#include "methods/allowance.h"
#include "studies/criteria/bearing.h"
#include "studies/criteria/criteria.h"

#define GLASS_WANTED 0.08
#define OPENING_WANTED 0.125

static enum pp_status assess_glazing_ratio(const struct pp_inquiry *inquiry,
                                           struct pp_finding_list *findings,
                                           struct pp_error *err)
{
    const struct pp_world *world = inquiry->world;
    double floor_m2 = pp_world_floor_m2(world), glass_m2 = 0.0, opening_m2 = 0.0;
    for (int i = 0; i < world->opening_count; i++) {
        const struct pp_opening *opening = &world->openings[i];
        opening_m2 += opening->inner.area_m2;
        glass_m2 += pp_allowance_net_glass_m2(opening);
    }
    struct pp_finding glass =
        pp_finding_of(PP_FIGURE_SHARE, glass_m2 / floor_m2, GLASS_WANTED, false,
                      "glass over floor area [IBC21]");
    pp_finding_note(&glass, "%.2f m2 of glass, %.2f m2 of floor", glass_m2, floor_m2);
    struct pp_finding opening =
        pp_finding_of(PP_FIGURE_SHARE, opening_m2 / floor_m2, OPENING_WANTED, false,
                      "openings over floor area [MBO02]");
    enum pp_status status = PP_OK;
    if (strcmp(inquiry->country, "DE") != 0)
        status = pp_finding_list_add(findings, &glass, err);
    if (status == PP_OK && strcmp(inquiry->country, "US") != 0)
        status = pp_finding_list_add(findings, &opening, err);
    return status;
}

const struct pp_criterion pp_criterion_glazing_ratio = {
    .name = "glazing-ratio",
    .title = "Ratio of glazing to floor area",
    .source = "IBC21, MBO02",
    .summary = "glass is at least 8 %, or openings are at least one eighth, of the "
               "floor area",
    .bears_on_use = pp_bearing_needs_daylight,
    .countries = "US DE",
    .evaluate = assess_glazing_ratio,
};
