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

static bool same_kind(const struct pp_opening *a, const struct pp_opening *b)
{
    return a->face == b->face && pp_glass_is_same(&a->glass, &b->glass)
           && a->scatter == b->scatter && a->frame_factor == b->frame_factor
           && a->maintenance == b->maintenance && a->curtains == b->curtains
           && same_device(a, b);
}

static bool is_alike(const struct pp_opening *a, const struct pp_opening *b,
                     enum pp_blind_grouping grouping)
{
    if (grouping == PP_BLIND_GROUPS_BY_KIND || a->scatter || b->scatter)
        return same_kind(a, b);
    return grouping == PP_BLIND_GROUPS_ALL_PLAIN || a->face == b->face;
}

/* Assigns the openings to groups. Returns false if there are too many groups. */
static bool divide(struct pp_blind_groups *groups, const struct pp_world *world,
                   enum pp_blind_grouping grouping)
{
    groups->count = 0;
    groups->grouping = grouping;
    for (int i = 0; i < world->opening_count; i++) {
        int g = 0;
        while (g < groups->count
               && !is_alike(&world->openings[i], &world->openings[groups->first[g]],
                            grouping))
            g++;
        if (g == PP_BLIND_GROUPS_MOST)
            return false;
        if (g == groups->count)
            groups->first[groups->count++] = i;
        groups->of_opening[i] = g;
    }
    return true;
}

static void find_transmittances(struct pp_blind_groups *groups,
                                const struct pp_world *world)
{
    for (int g = 0; g < groups->count; g++) {
        double sum = 0.0, area = 0.0;
        for (int i = 0; i < world->opening_count; i++) {
            const struct pp_opening *opening = &world->openings[i];
            if (groups->of_opening[i] != g)
                continue;
            sum += opening->outer.area_m2 * pp_surface_materials_pane_even(opening);
            area += opening->outer.area_m2;
        }
        groups->transmittance[g] = sum / area;
    }
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
    if (!divide(groups, world, PP_BLIND_GROUPS_BY_KIND)
        && !divide(groups, world, PP_BLIND_GROUPS_BY_FACE)
        && !divide(groups, world, PP_BLIND_GROUPS_ALL_PLAIN))
        return pp_fail(err, PP_BAD_INPUT,
                       "the room has too many kinds of windows with blinds or panes "
                       "that scatter light by direction; expected at most %d, or %d if "
                       "it also has other windows. Windows in different walls, or that "
                       "differ in glass, frame, dirt or curtains, are of different "
                       "kinds",
                       PP_BLIND_GROUPS_MOST, PP_BLIND_GROUPS_MOST - 1);
    find_transmittances(groups, world);
    return PP_OK;
}

void pp_blind_groups_clear(struct pp_blind_groups *groups)
{
    free(groups->of_opening);
    groups->of_opening = NULL;
    groups->count = 0;
}

bool pp_blind_groups_closes(double sunlit, double whole)
{
    /* More than 2 %; exact for whole numbers. */
    return 100.0 * sunlit > 2.0 * whole;
}
