/* envelope_sheet.c - see envelope_sheet.h. */
#include "studies/site/envelope_sheet.h"

#include <stdlib.h>
#include <string.h>

enum pp_status pp_envelope_sheet_add(struct pp_site_sheet *sheet,
                                     const struct pp_plot_envelope *envelope,
                                     const char *block, struct pp_error *err)
{
    int kept = 0;
    for (int i = 0; i < sheet->shape_count; i++) {
        struct pp_site_shape *shape = &sheet->shapes[i];
        if (shape->name && strcmp(shape->name, block) == 0)
            pp_site_sheet_clear_shape(shape);
        else
            sheet->shapes[kept++] = *shape;
    }
    sheet->shape_count = kept;
    sheet->cells = calloc((size_t)envelope->cells.count + 1, sizeof *sheet->cells);
    if (!sheet->cells)
        return pp_fail_memory(err);
    for (int i = 0; i < envelope->cells.count; i++) {
        const struct pp_building_cell *cell = &envelope->cells.list[i];
        struct pp_site_cell *drawn = &sheet->cells[sheet->cell_count++];
        drawn->height_m = cell->height_m;
        for (int k = 0; k < 4; k++) {
            struct pp_vec3 corner = pp_plot_cells_corner(cell, k);
            drawn->corners[k][0] = corner.x;
            drawn->corners[k][1] = corner.y;
        }
    }
    sheet->cells_m3 = envelope->volume_m3;
    return PP_OK;
}
