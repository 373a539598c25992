/* chart_kind.c - the list of charts, in the order in which it is printed. */
#include "api/chart_kind.h"

#include <string.h>

static const struct pp_chart_kind *const kinds[] = {
    &pp_draw_section,
    &pp_draw_plan,
    &pp_draw_site_plan,
    &pp_draw_elevation,
    &pp_draw_note,
    &pp_draw_waldram,
    &pp_draw_pepper_pot,
    &pp_draw_protractor,
    &pp_draw_nomogram,
    &pp_draw_position_nomogram,
    &pp_draw_brs_table,
    &pp_draw_vertical_sky,
    &pp_draw_skylight_indicator,
    &pp_draw_sun_path,
    &pp_draw_overlay,
    &pp_draw_slats,
    &pp_draw_model_net,
    &pp_draw_availability,
    &pp_draw_year,
    &pp_draw_en17037,
    NULL,
};

const struct pp_chart_kind *pp_chart_kind_at(int index)
{
    return kinds[index];
}

const struct pp_chart_kind *pp_chart_kind_find(const char *name)
{
    for (int i = 0; kinds[i]; i++)
        if (strcmp(kinds[i]->name, name) == 0)
            return kinds[i];
    return NULL;
}

bool pp_chart_kind_landscape(const struct pp_chart_kind *kind,
                             const struct pp_world *world)
{
    return kind->landscape || (kind->landscape_for && kind->landscape_for(world));
}
