/* blind_groups.c - see blind_groups.h. */
#include "studies/year/blind_groups.h"

#include <stdlib.h>

#include "model/room/surface_materials.h"

static bool same_device(const struct pp_opening *a, const struct pp_opening *b)
{
    return a->device.kind == b->device.kind
           && (a->device.kind != PP_DEVICE_SCREEN
               || a->device.openness == b->device.openness);
}

static bool is_alike(const struct pp_opening *a, const struct pp_opening *b)
{
    return a->face == b->face && pp_glass_is_same(&a->glass, &b->glass)
           && a->scatter == b->scatter && a->frame_factor == b->frame_factor
           && a->maintenance == b->maintenance && a->curtains == b->curtains
           && same_device(a, b);
}

enum pp_status pp_blind_groups_of_world(struct pp_blind_groups *groups,
                                        const struct pp_world *world,
                                        struct pp_error *err)
{
    *groups = (struct pp_blind_groups){.count = 0};
    groups->of_opening =
        calloc((size_t)world->opening_count + 1, sizeof *groups->of_opening);
    if (!groups->of_opening)
        return pp_fail_memory(err);
    for (int i = 0; i < world->opening_count; i++) {
        int g = 0;
        while (g < groups->count
               && !is_alike(&world->openings[i], &world->openings[groups->first[g]]))
            g++;
        if (g == PP_BLIND_GROUPS_MOST)
            g--;
        if (g == groups->count) {
            groups->first[g] = i;
            groups->transmittance[g] =
                pp_surface_materials_pane_even(&world->openings[i]);
            groups->count++;
        }
        groups->of_opening[i] = g;
    }
    return PP_OK;
}

void pp_blind_groups_clear(struct pp_blind_groups *groups)
{
    free(groups->of_opening);
    groups->of_opening = NULL;
    groups->count = 0;
}

bool pp_blind_groups_closes(int sunlit_points, int points)
{
    /* More than 2 %, in whole numbers. */
    return 100L * sunlit_points > 2L * points;
}
