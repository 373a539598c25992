/* year_batch_bytes.c - see year_batch_bytes.h. */
#include "simulate/year/year_batch_bytes.h"

#include "simulate/sampling/little_endian.h"

enum { FLOAT = 4, POINT = 6 * 8 + 1 /* two vectors and a space */ };

/* Lists of a batch and their lengths. */
struct batch_lists {
    float *floats[7];
    size_t float_counts[7];
    struct pp_lit_point *points[3];
    size_t point_counts[3];
    bool *flags[2];
    size_t flag_counts[2];
};

static struct batch_lists lists_of(const struct pp_year_batch *batch,
                                   const struct pp_year_task *task)
{
    size_t points = (size_t)task->receiver_count, groups = (size_t)task->group_count,
           cells = (size_t)task->cells->count, columns = (size_t)task->column_count;
    return (struct batch_lists){
        .floats = {batch->light, batch->outdoor, batch->inside, batch->classes,
                   batch->by_pane, batch->on_pane, batch->on_pane_outdoor},
        .float_counts = {points * groups * columns,
                         points * groups * PP_YEAR_OUTDOOR_CELLS, points * cells,
                         points * groups * (size_t)task->class_count, points * groups,
                         groups * columns, groups * PP_YEAR_OUTDOOR_CELLS},
        .points = {batch->cell_points, (struct pp_lit_point *)batch->outdoor_points,
                   batch->pane_points},
        .point_counts = {cells, PP_YEAR_OUTDOOR_CELLS, groups * PP_YEAR_PANE_POINTS},
        .flags = {batch->cell_has_point, (bool *)batch->outdoor_is_used},
        .flag_counts = {cells, PP_YEAR_OUTDOOR_CELLS}};
}

size_t pp_year_batch_bytes_size(const struct pp_year_task *task)
{
    static const struct pp_year_batch none = {.light = NULL};
    struct batch_lists lists = lists_of(&none, task);
    size_t size = 0;
    for (int i = 0; i < 7; i++)
        size += FLOAT * lists.float_counts[i];
    for (int i = 0; i < 3; i++)
        size += POINT * lists.point_counts[i];
    return size + lists.flag_counts[0] + lists.flag_counts[1];
}

void pp_year_batch_bytes_put(unsigned char *bytes, const struct pp_year_batch *batch,
                             const struct pp_year_task *task)
{
    struct batch_lists lists = lists_of(batch, task);
    for (int i = 0; i < 7; i++)
        for (size_t k = 0; k < lists.float_counts[i]; k++)
            pp_little_endian_put_float(&bytes, lists.floats[i][k]);
    for (int i = 0; i < 3; i++)
        for (size_t k = 0; k < lists.point_counts[i]; k++) {
            pp_little_endian_put_vec(&bytes, lists.points[i][k].point);
            pp_little_endian_put_vec(&bytes, lists.points[i][k].normal);
            pp_little_endian_put(&bytes, lists.points[i][k].space, 1);
        }
    for (int i = 0; i < 2; i++)
        for (size_t k = 0; k < lists.flag_counts[i]; k++)
            pp_little_endian_put(&bytes, lists.flags[i][k], 1);
}

enum pp_status pp_year_batch_bytes_take(struct pp_year_batch *batch,
                                        const struct pp_year_task *task,
                                        const unsigned char *bytes,
                                        struct pp_error *err)
{
    enum pp_status status = pp_year_batch_make_space(batch, task, err);
    if (status != PP_OK)
        return status;
    struct batch_lists lists = lists_of(batch, task);
    for (int i = 0; i < 7; i++)
        for (size_t k = 0; k < lists.float_counts[i]; k++)
            lists.floats[i][k] = pp_little_endian_take_float(&bytes);
    for (int i = 0; i < 3; i++)
        for (size_t k = 0; k < lists.point_counts[i]; k++) {
            struct pp_lit_point *point = &lists.points[i][k];
            point->point = pp_little_endian_take_vec(&bytes);
            point->normal = pp_little_endian_take_vec(&bytes);
            uint64_t space = pp_little_endian_take(&bytes, 1);
            if (space > PP_OUTDOORS)
                return pp_fail(err, PP_BAD_INPUT, "the file is damaged");
            point->space = (enum pp_space)space;
        }
    for (int i = 0; i < 2; i++)
        for (size_t k = 0; k < lists.flag_counts[i]; k++)
            lists.flags[i][k] = pp_little_endian_take(&bytes, 1) != 0;
    return PP_OK;
}
