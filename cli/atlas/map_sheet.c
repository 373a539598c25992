/* map_sheet.c - reads an atlas and draws a map of it. */
#include "cli/atlas/map_sheet.h"

#include "charts/atlas_chart.h"
#include "cli/message.h"
#include "cli/output.h"

static enum pp_status draw_atlas_map(const struct pp_atlas_map *map,
                                     enum pp_paper paper, enum pp_chart_format format,
                                     FILE *out, struct pp_error *err)
{
    char title[96];
    snprintf(title, sizeof title, "Error of %.80s", map->column);
    const struct pp_sheet sheet = {
        .format = format,
        .paper = paper,
        .landscape = true,
        .title = title,
        .description =
            "what the method says over what is true, over rooms of an atlas"};
    struct pp_canvas *canvas;
    enum pp_status status = pp_canvas_create(&canvas, &sheet, err);
    if (status != PP_OK)
        return status;
    status = pp_atlas_chart_draw(canvas, map, err);
    if (status == PP_OK)
        status = pp_canvas_write(canvas, pp_output_put, out, err);
    pp_canvas_destroy(canvas);
    return status;
}

enum pp_exit pp_map_sheet_write(const struct pp_map_sheet *sheet, const char *path,
                                const char *output)
{
    enum pp_chart_format format;
    struct pp_atlas_table table;
    struct pp_atlas_map map;
    struct pp_output file;
    struct pp_error err = {0};
    if (pp_canvas_format_of(&format, output, &err) != PP_OK)
        return pp_message_usage("atlas", &err);
    enum pp_status status = pp_atlas_table_read(&table, path, &err);
    if (status == PP_OK)
        status = pp_atlas_mapping_of(&map, &table, sheet->kind, sheet->method, &err);
    if (status == PP_OK) {
        status = pp_output_open(&file, output, &err);
        if (status == PP_OK)
            status = draw_atlas_map(&map, sheet->paper, format, file.stream, &err);
        status = pp_output_close(&file, status, &err);
    }
    pp_atlas_table_clear(&table);
    return status == PP_OK ? PP_EXIT_DONE : pp_message_error(&err);
}
