/* blind.c - see blind.h. */
#include "model/light/slats/blind.h"

#include <stdlib.h>

#include "model/base/error.h"

static double diffuse_through(const struct pp_slat_cell *cell, double low, double high)
{
    struct pp_slat_light light;
    pp_slat_cell_diffuse(cell, low, high, &light);
    struct pp_slat_parts parts = pp_slat_cell_parts(&light);
    return parts.straight + parts.room_down + parts.room_up;
}

enum pp_status pp_blind_create(struct pp_blind **made, const struct pp_slats *slats,
                               bool horizontal_in_vertical_window, struct pp_error *err)
{
    struct pp_slat_cell *cell = NULL;
    enum pp_status status = pp_slat_cell_create(&cell, slats, err);
    if (status != PP_OK)
        return status;
    struct pp_blind *blind = malloc(sizeof *blind);
    if (blind) {
        *blind =
            (struct pp_blind){.slats = *slats,
                              .sky = diffuse_through(cell, 0.0, 0.5 * PP_PI),
                              .ground = diffuse_through(cell, -0.5 * PP_PI, 0.0),
                              .all = diffuse_through(cell, -0.5 * PP_PI, 0.5 * PP_PI),
                              .holders = 1};
        blind->mean = horizontal_in_vertical_window
                          ? 0.8 * blind->sky + 0.2 * blind->ground
                          : blind->all;
        *made = blind;
    }
    pp_slat_cell_destroy(cell);
    return blind ? PP_OK : pp_fail_memory(err);
}

void pp_blind_release(struct pp_blind *blind)
{
    if (blind && --blind->holders == 0)
        free(blind);
}
