/* brs_sheet_fill.c - copies the table, and records the readings for each rectangle of
 * sky or obstruction. The reading of the lower edge is subtracted from that of the
 * upper one. Readings on both sides of the normal are added; for a rectangle on one
 * side, the narrower is subtracted from the wider. */
#include "methods/brs/brs_sheet_fill.h"

#include <math.h>
#include <stdlib.h>

#include "methods/brs/brs_table.h"
#include "methods/diagram_windows.h"
#include "methods/view/elevation.h"
#include "model/base/array.h"

static const double odd_cells[][2] = {
#include "tables/brs_odd_cells.inc"
};

static bool is_odd(double h_over_d, double w_over_d)
{
    for (size_t i = 0; i < sizeof odd_cells / sizeof odd_cells[0]; i++)
        if (odd_cells[i][0] == h_over_d && odd_cells[i][1] == w_over_d)
            return true;
    return false;
}

void pp_brs_sheet_fill_blank(struct pp_brs_sheet *sheet)
{
    *sheet = (struct pp_brs_sheet){.blank = true};
    for (int i = 0; i < PP_BRS_ROWS; i++) {
        sheet->h_over_d[i] = pp_brs_table_h_over_d(i);
        for (int k = 0; k < PP_BRS_COLUMNS; k++) {
            sheet->w_over_d[k] = pp_brs_table_w_over_d(k);
            sheet->percent[i][k] = pp_brs_table_percent(i, k);
            sheet->odd[i][k] = is_odd(sheet->h_over_d[i], sheet->w_over_d[k]);
        }
    }
}

/* An edge whose height divided by its distance is less than this counts as level with
 * the point and gives no reading. */
static const double level = 1e-9;

/* Adds a reading and returns it with its sign; 0 if there is nothing to read. */
static double add_reading(struct pp_brs_sheet *sheet, struct pp_brs_reading reading,
                          struct pp_error *err, enum pp_status *status)
{
    if (!(reading.h_over_d > level && reading.w_over_d > 0.0) || *status != PP_OK)
        return 0.0;
    *status = pp_array_append(&sheet->readings, sheet->reading_count,
                              sizeof *sheet->readings, err);
    if (*status != PP_OK)
        return 0.0;
    reading.value = pp_brs_table_read(reading.h_over_d, reading.w_over_d);
    pp_brs_table_place(reading.h_over_d, reading.w_over_d, &reading.row,
                       &reading.column);
    sheet->readings[sheet->reading_count++] = reading;
    return reading.sign * reading.value;
}

/* The sum of a rectangle's four readings. */
static double read_rectangle(struct pp_brs_sheet *sheet,
                             const struct pp_elevation_part *part, int window,
                             struct pp_error *err, enum pp_status *status)
{
    bool hidden = !isnan(part->reflectance);
    double sum = 0.0;
    for (int i = 0; i < 4; i++) {
        bool lower = i >= 2, left = i % 2 == 0;
        int side = left ? (part->left < 0.0 ? 1 : -1) : (part->right > 0.0 ? 1 : -1);
        struct pp_brs_reading reading = {.window = window,
                                         .hidden = hidden,
                                         .lower = lower,
                                         .left = left,
                                         .sign = lower ? -side : side,
                                         .h_over_d = lower ? part->low : part->high,
                                         .w_over_d =
                                             fabs(left ? part->left : part->right),
                                         .factor = hidden ? part->reflectance : 1.0};
        sum += add_reading(sheet, reading, err, status);
    }
    return sum;
}

static enum pp_status fill_window(struct pp_brs_sheet *sheet,
                                  const struct pp_world *world,
                                  const struct pp_opening *opening,
                                  struct pp_vec3 point, struct pp_error *err)
{
    int index = sheet->window_count++;
    struct pp_brs_window *window = &sheet->windows[index];
    struct pp_elevation elevation;
    *window = (struct pp_brs_window){
        .label = opening->label,
        .distance_m = pp_vec_dot(pp_vec_sub(point, opening->inner.vertices[0]),
                                 opening->inner.normal),
        .allowance = pp_allowance_of(&pp_method_brs_table, world, opening)};
    enum pp_status status = pp_elevation_init(&elevation, world, opening, point, err);
    if (status != PP_OK)
        return status;
    for (int i = 0; i < elevation.count && status == PP_OK; i++) {
        const struct pp_elevation_part *part = &elevation.parts[i];
        double sum = read_rectangle(sheet, part, index, err, &status);
        if (isnan(part->reflectance))
            window->sky += sum;
        else
            window->external += part->reflectance * sum;
    }
    pp_elevation_clear(&elevation);
    window->sky = fmax(window->sky, 0.0) * window->allowance;
    window->external = fmax(window->external, 0.0) * window->allowance;
    sheet->sky_component += window->sky;
    sheet->external += window->external;
    return status;
}

enum pp_status pp_brs_sheet_fill_room(struct pp_brs_sheet *sheet,
                                      const struct pp_world *world,
                                      const struct pp_outside_light *light,
                                      const struct pp_receiver *receiver,
                                      struct pp_error *err)
{
    pp_brs_sheet_fill_blank(sheet);
    enum pp_status status =
        pp_diagram_windows_check(&pp_method_brs_table, world, light, receiver, err);
    if (status != PP_OK)
        return status;
    sheet->blank = false;
    sheet->name = world->name;
    sheet->point = receiver->position;
    sheet->windows = calloc((size_t)world->opening_count + 1, sizeof *sheet->windows);
    if (!sheet->windows)
        return pp_fail_memory(err);
    for (int i = 0; i < world->opening_count && status == PP_OK; i++)
        status =
            fill_window(sheet, world, &world->openings[i], receiver->position, err);
    if (status != PP_OK)
        pp_brs_sheet_clear(sheet);
    return status;
}
