/* atlas_renewal.c - combines the simulated values of an existing table with newly
 * calculated results of the methods. */
#include "studies/research/atlas/atlas_renewal.h"

#include <math.h>
#include <stdlib.h>

#include "studies/research/validation/own_world.h"

enum { ROWS = PP_ATLAS_POINTS + 1 }; /* rows of a room */

enum pp_status pp_atlas_renewal_rooms(int *rooms, const struct pp_atlas_table *table,
                                      struct pp_error *err)
{
    *rooms = table->row_count / ROWS;
    for (int i = 0; i < table->row_count; i++) {
        int point = i % ROWS < PP_ATLAS_POINTS ? i % ROWS : -1;
        if (pp_atlas_table_value(table, i, table->room) != i / ROWS
            || pp_atlas_table_value(table, i, table->point) != point)
            return pp_fail(err, PP_BAD_INPUT,
                           "the rows are not those of an atlas: expected point %d of "
                           "room %d in row %d",
                           point, i / ROWS, i + 1);
    }
    return PP_OK;
}

/* A room whose simulated values are kept. */
struct kept {
    const struct pp_atlas_columns *columns;
    const struct pp_report *report;
    const struct pp_own_worlds *worlds; /* not traced */
    const struct pp_atlas_table *table;
    int row;     /* first row of the room */
    int *own_at; /* for each method: column of the table with the simulated value in its
                  * own world; -1: none */
};

static double value_at(const struct kept *kept, int point, const char *name)
{
    int row = kept->row + (point < 0 ? PP_ATLAS_POINTS : point);
    return 0.01
           * pp_atlas_table_value(kept->table, row,
                                  pp_atlas_table_find(kept->table, name));
}

/* a pp_atlas_truth_of */
static void truth_of(const void *data, int point, struct pp_atlas_truth *truth)
{
    static const char *const names[PP_COMPONENT_COUNT][2] = {
        [PP_SC] = {"true.sc", "se.sc"},
        [PP_ERC] = {"true.erc", "se.erc"},
        [PP_IRC] = {"true.irc", "se.irc"},
        [PP_DF] = {"true.df", "se.df"}};
    const struct kept *kept = data;
    int row = kept->row + (point < 0 ? PP_ATLAS_POINTS : point);
    for (int c = 0; c < PP_COMPONENT_COUNT; c++) {
        truth->value[c] = value_at(kept, point, names[c][0]);
        truth->std_error[c] = value_at(kept, point, names[c][1]);
    }
    for (int i = 0; i < kept->columns->count; i++)
        truth->own[i] = 0.01 * pp_atlas_table_value(kept->table, row, kept->own_at[i]);
}

/* True if both methods give a daylight factor and assume the same worlds. */
static bool are_alike(const struct kept *kept, int one, int other)
{
    const struct pp_column *a =
        pp_report_find(kept->report, PP_DF, kept->columns->methods[one].name);
    const struct pp_column *b =
        pp_report_find(kept->report, PP_DF, kept->columns->methods[other].name);
    bool alike = a && b;
    for (int c = PP_SC; alike && c <= PP_IRC; c++)
        alike = pp_own_world_of(kept->worlds, a, (enum pp_component)c)
                == pp_own_world_of(kept->worlds, b, (enum pp_component)c);
    return alike;
}

/* Column of the table with a value of this room in the method's own world; -1: none. */
static int own_column(const struct kept *kept, int method)
{
    char name[PP_ATLAS_NAME];
    snprintf(name, sizeof name, "own.df.%s", kept->columns->methods[method].name);
    int column = pp_atlas_table_find(kept->table, name);
    bool any = false;
    for (int i = 0; i < ROWS && column >= 0; i++)
        any |= isfinite(pp_atlas_table_value(kept->table, kept->row + i, column));
    return any ? column : -1;
}

static void find_own(struct kept *kept)
{
    const struct pp_atlas_method *methods = kept->columns->methods;
    for (int i = 0; i < kept->columns->count; i++) {
        kept->own_at[i] = methods[i].component == PP_DF ? own_column(kept, i) : -1;
        for (int k = 0; k < kept->columns->count && kept->own_at[i] < 0; k++)
            if (methods[i].component == PP_DF && methods[k].component == PP_DF
                && are_alike(kept, i, k))
                kept->own_at[i] = own_column(kept, k);
    }
}

/* Checks that the points in the table are the points of the room, to the printed
 * digits. */
static enum pp_status check_points(const struct kept *kept, int index,
                                   struct pp_error *err)
{
    for (int i = 0; i < PP_ATLAS_POINTS; i++) {
        struct pp_vec3 place = kept->report->receivers[i].position;
        double x = 100.0 * value_at(kept, i, "x"), y = 100.0 * value_at(kept, i, "y");
        if (!(fabs(x - place.x) < 1e-3 && fabs(y - place.y) < 1e-3))
            return pp_fail(err, PP_BAD_INPUT,
                           "point %d of room %d does not belong to this sweep: "
                           "expected %.3f, %.3f",
                           i, index, place.x, place.y);
    }
    return PP_OK;
}

static enum pp_status print_renewed_rows(struct kept *kept, int index, char **rows,
                                         size_t *length, struct pp_error *err)
{
    kept->own_at = calloc((size_t)kept->columns->count + 1, sizeof *kept->own_at);
    FILE *out = kept->own_at ? open_memstream(rows, length) : NULL;
    if (!out) {
        free(kept->own_at);
        return pp_fail_memory(err);
    }
    find_own(kept);
    enum pp_status status = check_points(kept, index, err);
    if (status == PP_OK)
        status = pp_atlas_columns_print_room(kept->columns, index, kept->report,
                                             truth_of, kept, out, err);
    if (fclose(out) != 0 && status == PP_OK)
        status = pp_fail_memory(err);
    free(kept->own_at);
    return status;
}

enum pp_status pp_atlas_renewal_rows(char **rows, size_t *length,
                                     const struct pp_atlas_columns *columns,
                                     const struct pp_atlas_design *design,
                                     const struct pp_atlas_table *table, int index,
                                     struct pp_error *err)
{
    struct pp_atlas_drawn drawn;
    struct pp_own_worlds *worlds = NULL;
    const struct pp_atlas_trace none = {0};
    *rows = NULL;
    enum pp_status status = pp_atlas_drawn_room(&drawn, design, index, &none, err);
    if (status == PP_OK)
        status = pp_own_world_list(&worlds, drawn.room.room, &drawn.report, err);
    if (status == PP_OK) {
        struct kept kept = {.columns = columns,
                            .report = &drawn.report,
                            .worlds = worlds,
                            .table = table,
                            .row = ROWS * index};
        status = print_renewed_rows(&kept, index, rows, length, err);
    }
    if (status != PP_OK) {
        free(*rows);
        *rows = NULL;
    }
    pp_own_world_destroy(worlds);
    pp_atlas_drawn_clear(&drawn);
    return status;
}
