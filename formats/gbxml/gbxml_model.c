/* gbxml_model.c - see gbxml_model.h. */
#include "formats/gbxml/gbxml_model.h"

#include <stdlib.h>

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
