/* sky_mask.c - see sky_mask.h. */
#include "model/results/sheets/sky_mask.h"

#include <stdlib.h>

void pp_sky_mask_clear(struct pp_sky_mask *mask)
{
    for (int i = 0; i < mask->count; i++)
        free(mask->pieces[i].edges);
    free(mask->pieces);
    *mask = (struct pp_sky_mask){0};
}
