/* site_sheet.c - see site_sheet.h. */
#include "model/results/sheets/site_sheet.h"

#include <stdlib.h>

const double pp_site_sheet_levels[PP_SITE_LEVELS] = {0.05, 0.15, 0.27};

void pp_site_sheet_clear_shape(struct pp_site_shape *shape)
{
    free(shape->corners);
    free(shape->ends);
    free(shape->unseen);
    *shape = (struct pp_site_shape){0};
}

void pp_site_sheet_clear(struct pp_site_sheet *sheet)
{
    for (int i = 0; i < sheet->shape_count; i++)
        pp_site_sheet_clear_shape(&sheet->shapes[i]);
    for (int i = 0; i < sheet->garden_count; i++) {
        free(sheet->gardens[i].corners);
        pp_curve_list_clear(&sheet->gardens[i].dark);
    }
    free(sheet->trees);
    free(sheet->cells);
    free(sheet->gardens);
    free(sheet->shapes);
    free(sheet->windows);
    *sheet = (struct pp_site_sheet){0};
}

void pp_site_sheet_clear_elevations(struct pp_elevation_sheet *sheet)
{
    for (int i = 0; i < sheet->count; i++) {
        struct pp_site_elevation *elevation = &sheet->elevations[i];
        for (int k = 0; k < elevation->wall_count; k++) {
            pp_region_clear(&elevation->walls[k].outline);
            pp_curve_list_clear(&elevation->walls[k].below);
            pp_curve_list_clear(&elevation->walls[k].lines);
            free(elevation->walls[k].doors);
        }
        free(elevation->walls);
        free(elevation->facades);
        free(elevation->shades);
        free(elevation->windows);
        free(elevation->crowns);
        free(elevation->crown_trees);
    }
    free(sheet->elevations);
    pp_site_sheet_clear(&sheet->site);
    *sheet = (struct pp_elevation_sheet){0};
}
