/* atlas_room.c - simulates a room, and the worlds that its methods assume. */
#include "studies/research/atlas/atlas_room.h"

#include <math.h>
#include <stdlib.h>

#include "studies/study_report.h"
#include "studies/research/validation/own_world.h"

enum pp_status pp_atlas_room_columns(struct pp_atlas_columns *columns,
                                     const struct pp_atlas_design *design,
                                     struct pp_error *err)
{
    struct pp_atlas_drawn drawn;
    const struct pp_atlas_trace none = {0};
    enum pp_status status = pp_atlas_drawn_room(&drawn, design, 0, &none, err);
    if (status == PP_OK)
        status = pp_atlas_columns_of(columns, &drawn.report, err);
    pp_atlas_drawn_clear(&drawn);
    return status;
}

/* ---- simulation ---- */

struct traced {
    const struct pp_atlas_columns *columns;
    const struct pp_report *report;
    const struct pp_own_worlds *worlds;
};

/* Simulated component at a point; point -1: the average. */
static struct pp_reading traced_reading(const struct pp_report *report,
                                        enum pp_component component, int point)
{
    const struct pp_column *column = pp_report_find(report, component, "traced");
    if (!column)
        return (struct pp_reading){.value = NAN, .std_error = NAN};
    return point < 0 ? column->average : column->points[point];
}

/* Daylight factor in the world that a column's method assumes. */
static double own_value(const struct pp_own_worlds *worlds,
                        const struct pp_column *column, int point)
{
    const struct pp_report *of[3];
    for (int c = PP_SC; c <= PP_IRC; c++)
        of[c] = pp_own_world_of(worlds, column, (enum pp_component)c);
    /* If all components are from one world, the daylight factor of this world is used,
     * which has a smaller error than the sum of the components. */
    if (of[PP_SC] == of[PP_ERC] && of[PP_ERC] == of[PP_IRC])
        return traced_reading(of[PP_SC], PP_DF, point).value;
    double sum = 0.0;
    for (int c = PP_SC; c <= PP_IRC; c++)
        sum += traced_reading(of[c], (enum pp_component)c, point).value;
    return sum;
}

/* a pp_atlas_truth_of */
static void truth_of(const void *data, int point, struct pp_atlas_truth *truth)
{
    const struct traced *traced = data;
    for (int c = 0; c < PP_COMPONENT_COUNT; c++) {
        struct pp_reading reading =
            traced_reading(traced->report, (enum pp_component)c, point);
        truth->value[c] = reading.value;
        truth->std_error[c] = reading.std_error;
    }
    for (int i = 0; i < traced->columns->count; i++) {
        const struct pp_atlas_method *method = &traced->columns->methods[i];
        const struct pp_column *column =
            pp_report_find(traced->report, method->component, method->name);
        truth->own[i] = method->component == PP_DF && column
                            ? own_value(traced->worlds, column, point)
                            : NAN;
    }
}

/* Simulates the room, and the worlds that its methods assume. */
static enum pp_status trace_all(struct pp_atlas_drawn *drawn,
                                struct pp_own_worlds *worlds, struct pp_error *err)
{
    bool finished = true, by_clock = false;
    enum pp_status status =
        pp_study_report_traced(&drawn->report, &drawn->options, &by_clock, err);
    if (status == PP_OK)
        status = pp_own_world_trace(worlds, &drawn->options, &finished, &by_clock, err);
    return status;
}

static enum pp_status print_atlas_rows(char **rows, size_t *length,
                                       const struct traced *traced, int index,
                                       struct pp_error *err)
{
    FILE *out = open_memstream(rows, length);
    if (!out)
        return pp_fail_memory(err);
    enum pp_status status = pp_atlas_columns_print_room(
        traced->columns, index, traced->report, truth_of, traced, out, err);
    if (fclose(out) != 0 && status == PP_OK)
        status = pp_fail_memory(err);
    return status;
}

enum pp_status pp_atlas_room_rows(char **rows, size_t *length,
                                  const struct pp_atlas_columns *columns,
                                  const struct pp_atlas_design *design, int index,
                                  const struct pp_atlas_trace *trace,
                                  struct pp_error *err)
{
    struct pp_atlas_drawn drawn;
    struct pp_own_worlds *worlds = NULL;
    *rows = NULL;
    enum pp_status status = pp_atlas_drawn_room(&drawn, design, index, trace, err);
    if (status == PP_OK)
        status = pp_own_world_list(&worlds, drawn.room.room, &drawn.report, err);
    if (status == PP_OK)
        status = trace_all(&drawn, worlds, err);
    if (status == PP_OK)
        status = print_atlas_rows(
            rows, length, &(struct traced){columns, &drawn.report, worlds}, index, err);
    if (status != PP_OK) {
        free(*rows);
        *rows = NULL;
    }
    pp_own_world_destroy(worlds);
    pp_atlas_drawn_clear(&drawn);
    return status;
}
