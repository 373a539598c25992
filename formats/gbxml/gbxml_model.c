/* gbxml_model.c - see gbxml_model.h. */
#include "formats/gbxml/gbxml_model.h"

#include <stdlib.h>
#include <string.h>

void pp_gbxml_model_clear(struct pp_gbxml_model *model)
{
    for (int i = 0; i < model->space_count; i++) {
        for (int k = 0; k < model->spaces[i].shell_count; k++)
            free(model->spaces[i].shell[k].corners);
        free(model->spaces[i].shell);
        free(model->spaces[i].floor.corners);
    }
    for (int i = 0; i < model->surface_count; i++) {
        struct pp_gbxml_surface *surface = &model->surfaces[i];
        for (int k = 0; k < surface->opening_count; k++)
            free(surface->openings[k].outline.corners);
        free(surface->openings);
        free(surface->outline.corners);
    }
    free(model->spaces);
    free(model->surfaces);
    *model = (struct pp_gbxml_model){0};
}

bool pp_gbxml_model_bounds(const struct pp_gbxml_surface *surface,
                           const struct pp_gbxml_space *space)
{
    if (strcmp(surface->type, "Shade") == 0 || strstr(surface->type, "Column"))
        return false;
    for (int i = 0; i < PP_GBXML_NEIGHBOURS; i++)
        if (surface->spaces[i] && strcmp(surface->spaces[i], space->id) == 0)
            return true;
    return false;
}

bool pp_gbxml_model_is_outer(const struct pp_gbxml_surface *surface)
{
    bool one =
        !surface->spaces[1]
        || (surface->spaces[0] && strcmp(surface->spaces[0], surface->spaces[1]) == 0);
    return one && !strstr(surface->type, "Interior");
}
