/* atlas_mapping.c - sorts the rows of an atlas into the classes of a map, and
 * calculates the quantiles of each class. */
#include "studies/research/atlas/atlas_mapping.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Simulated values with a larger relative standard error than this are not used. */
static const double known_to = 0.1;

const char *const pp_atlas_mapping_names[PP_MAP_KINDS] = {
    [PP_MAP_DEPTH] = "depth",
    [PP_MAP_ERC] = "erc",
    [PP_MAP_GROUND] = "ground",
    [PP_MAP_REFLECTANCE] = "reflectance",
    [PP_MAP_OBSTRUCTION] = "obstruction",
};

/* Horizontal axis of each map: its column and classes. The column is "" for the
 * fraction of ERC, which is calculated. */
static const struct mapping_side {
    const char *column;
    struct pp_atlas_scale scale;
} sides[PP_MAP_KINDS] = {
    [PP_MAP_DEPTH] = {"depth",
                      {"Distance from the opening divided by its head height",
                       10,
                       {0, 0.5, 1, 1.5, 2, 2.5, 3, 4, 5, 7, INFINITY}}},
    [PP_MAP_ERC] = {"",
                    {"Externally reflected component as a share of the direct "
                     "component",
                     10,
                     {0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1}}},
    [PP_MAP_GROUND] = {"ground",
                       {"Ground reflectance",
                        8,
                        {0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.35, 0.4, 1}}},
    [PP_MAP_REFLECTANCE] = {"reflectance",
                            {"Mean interior reflectance",
                             9,
                             {0, 0.2, 0.3, 0.35, 0.4, 0.45, 0.5, 0.55, 0.6, 1}}},
    [PP_MAP_OBSTRUCTION] = {"obstruction",
                            {"Angle of obstruction (degrees)",
                             9,
                             {0, 10, 20, 30, 40, 50, 60, 70, 80, 90}}},
};

static const struct mapping_side proportion = {
    "depth-width",
    {"Room depth divided by room width",
     8,
     {0, 0.5, 0.75, 1, 1.33, 1.67, 2, 3, INFINITY}}};

/* ---- which columns ---- */

struct mapping_columns {
    int said, truth, error, own;
    int across, up; /* -1: none */
    int sky, outside;
};

/* Index of a method's column. If `method` is a full heading, the column with this
 * heading; otherwise the first of the method's components in the table. -1: none. */
static int find_method(const struct pp_atlas_table *table, const char *method)
{
    static const char *const components[] = {"df", "irc", "sc", "erc"};
    char name[128];
    for (int i = 0; i < 4; i++) {
        snprintf(name, sizeof name, "%s.", components[i]);
        if (strncmp(method, name, strlen(name)) == 0)
            return pp_atlas_table_find(table, method);
    }
    for (int i = 0; i < 4; i++) {
        snprintf(name, sizeof name, "%s.%.100s", components[i], method);
        int column = pp_atlas_table_find(table, name);
        if (column >= 0)
            return column;
    }
    return -1;
}

/* Index of the column "BEFORE.COMPONENT", with the component of another column such as
 * "df.exact+bre"; -1: none. */
static int find_of_component(const struct pp_atlas_table *table, const char *before,
                             const char *column)
{
    char name[64];
    snprintf(name, sizeof name, "%s.%.*s", before, (int)strcspn(column, "."), column);
    return pp_atlas_table_find(table, name);
}

static enum pp_status find_columns(struct mapping_columns *at,
                                   const struct pp_atlas_table *table,
                                   enum pp_atlas_mapping_kind kind, const char *method,
                                   struct pp_error *err)
{
    const struct mapping_side *side = &sides[kind];
    at->said = find_method(table, method);
    if (at->said < 0)
        return pp_fail(err, PP_BAD_INPUT,
                       "the atlas has no method \"%.60s\"; expected one of its "
                       "columns, such as exact+bre, average-df or erc.exact",
                       method);
    char name[128];
    snprintf(name, sizeof name, "own.%.100s", table->names[at->said]);
    at->own = pp_atlas_table_find(table, name);
    at->truth = find_of_component(table, "true", table->names[at->said]);
    at->error = find_of_component(table, "se", table->names[at->said]);
    at->across = side->column[0] ? pp_atlas_table_find(table, side->column) : -1;
    at->up = kind == PP_MAP_DEPTH ? pp_atlas_table_find(table, proportion.column) : -1;
    at->sky = pp_atlas_table_find(table, "sc.exact");
    at->outside = pp_atlas_table_find(table, "erc.exact");
    bool by_share = kind == PP_MAP_ERC;
    if (at->truth < 0 || at->error < 0
        || (by_share ? at->sky < 0 || at->outside < 0 : at->across < 0)
        || (kind == PP_MAP_DEPTH && at->up < 0))
        return pp_fail(
            err, PP_BAD_INPUT,
            "the atlas lacks columns that are needed for a map of %.60s by %s", method,
            pp_atlas_mapping_names[kind]);
    return PP_OK;
}

/* ---- rows into classes ---- */

/* Class of a value; -1: outside all classes. A value on an edge belongs to the class
 * above the edge; a value on the last edge, to the last class. */
static int class_of(const struct pp_atlas_scale *scale, double value)
{
    if (!(value >= scale->edges[0] && value <= scale->edges[scale->count]))
        return -1;
    int k = 0;
    while (k + 1 < scale->count && value >= scale->edges[k + 1])
        k++;
    return k;
}

/* Cell of a row, up * PP_ATLAS_CLASSES + across; -1: none. */
static int mapped_cell(const struct pp_atlas_map *map,
                       const struct pp_atlas_table *table,
                       const struct mapping_columns *at, int row)
{
    double sky = pp_atlas_table_value(table, row, at->sky);
    double outside = pp_atlas_table_value(table, row, at->outside);
    int across = class_of(&map->across,
                          at->across >= 0 ? pp_atlas_table_value(table, row, at->across)
                                          : outside / (sky + outside));
    int up =
        at->up < 0 ? 0 : class_of(&map->up, pp_atlas_table_value(table, row, at->up));
    return across < 0 || up < 0 ? -1 : up * PP_ATLAS_CLASSES + across;
}

struct mapped_ratio {
    int cell, room;
    double ratio, weight;
};

static int by_room(const void *a, const void *b)
{
    const struct mapped_ratio *p = a, *q = b;
    return p->cell != q->cell ? p->cell - q->cell
                              : (p->room > q->room) - (p->room < q->room);
}

static int by_ratio(const void *a, const void *b)
{
    const struct mapped_ratio *p = a, *q = b;
    if (p->cell != q->cell)
        return p->cell - q->cell;
    if (p->ratio != q->ratio)
        return p->ratio > q->ratio ? 1 : -1;
    return (p->room > q->room) - (p->room < q->room);
}

/* Gives each room a weight of 1 in every cell, divided equally among its points in the
 * cell, and counts the rooms of each cell. */
static void weigh_room_points(struct mapped_ratio *list, int count,
                              struct pp_atlas_quantiles *cells)
{
    qsort(list, (size_t)count, sizeof *list, by_room);
    for (int i = 0, next; i < count; i = next) {
        for (next = i; next < count && by_room(&list[i], &list[next]) == 0; next++)
            ;
        for (int k = i; k < next; k++)
            list[k].weight = 1.0 / (next - i);
        cells[list[i].cell].rooms++;
    }
}

/* Weighted quantile of ratios in ascending order: the least ratio for which the ratios
 * up to it have at least the fraction `share` of the weight. If they have exactly this
 * fraction, the quantile is the mean of this ratio and the next. The median of an even
 * number of rooms is therefore the mean of the middle two. Comparisons allow for
 * rounding errors of the sums. */
static double quantile(const struct mapped_ratio *list, int count, int rooms,
                       double share)
{
    double below = 0.0, wanted = share * rooms;
    for (int i = 0; i + 1 < count; i++) {
        below += list[i].weight;
        if (below > wanted + 1e-9)
            return list[i].ratio;
        if (below > wanted - 1e-9)
            return 0.5 * (list[i].ratio + list[i + 1].ratio);
    }
    return list[count - 1].ratio;
}

static void take_quantiles(struct mapped_ratio *list, int count,
                           struct pp_atlas_quantiles *cells)
{
    qsort(list, (size_t)count, sizeof *list, by_ratio);
    for (int i = 0, next; i < count; i = next) {
        for (next = i; next < count && list[next].cell == list[i].cell; next++)
            ;
        struct pp_atlas_quantiles *cell = &cells[list[i].cell];
        if (cell->rooms < PP_ATLAS_ENOUGH)
            continue;
        cell->low = quantile(&list[i], next - i, cell->rooms, 0.05);
        cell->median = quantile(&list[i], next - i, cell->rooms, 0.5);
        cell->high = quantile(&list[i], next - i, cell->rooms, 0.95);
    }
}

/* ---- a map ---- */

/* Lists the ratios of calculated to true value in this column, at points or of
 * averages. *blind: number of rows left out because the true value is too uncertain.
 * The true value in a method's own world is assumed to be as accurate as the room's. */
static int gather_mapped_ratios(struct mapped_ratio *list, int *blind,
                                const struct pp_atlas_map *map,
                                const struct pp_atlas_table *table,
                                const struct mapping_columns *at, int truth_column)
{
    int count = 0;
    *blind = 0;
    for (int row = 0; row < table->row_count; row++) {
        double said = pp_atlas_table_value(table, row, at->said);
        double truth = pp_atlas_table_value(table, row, truth_column);
        double error = pp_atlas_table_value(table, row, at->error);
        bool average = pp_atlas_table_value(table, row, table->point) < 0.0;
        int cell = mapped_cell(map, table, at, row);
        if (average != map->averages || isnan(said) || isnan(truth) || cell < 0)
            continue;
        if (!(error <= known_to * truth && truth > 0.0)) {
            ++*blind;
            continue;
        }
        list[count++] = (struct mapped_ratio){
            .cell = cell,
            .room = (int)pp_atlas_table_value(table, row, table->room),
            .ratio = said / truth};
    }
    return count;
}

static void fill_quantiles(struct pp_atlas_quantiles *cells, struct mapped_ratio *list,
                           int count)
{
    for (int i = 0; i < PP_ATLAS_CELLS; i++)
        cells[i] = (struct pp_atlas_quantiles){0, NAN, NAN, NAN};
    weigh_room_points(list, count, cells);
    take_quantiles(list, count, cells);
}

/* True if the column has values at points, not only averages. */
static bool says_at_points(const struct pp_atlas_table *table, int said)
{
    for (int row = 0; row < table->row_count; row++)
        if (pp_atlas_table_value(table, row, table->point) >= 0.0
            && !isnan(pp_atlas_table_value(table, row, said)))
            return true;
    return false;
}

static int count_rooms(const struct pp_atlas_table *table)
{
    int rooms = 0;
    for (int row = 0; row < table->row_count; row++)
        rooms += pp_atlas_table_value(table, row, table->point) < 0.0;
    return rooms;
}

enum pp_status pp_atlas_mapping_of(struct pp_atlas_map *map,
                                   const struct pp_atlas_table *table,
                                   enum pp_atlas_mapping_kind kind, const char *method,
                                   struct pp_error *err)
{
    struct mapping_columns at;
    int blind;
    enum pp_status status = find_columns(&at, table, kind, method, err);
    if (status != PP_OK)
        return status;
    *map = (struct pp_atlas_map){.column = table->names[at.said],
                                 .averages = !says_at_points(table, at.said),
                                 .rooms = count_rooms(table),
                                 .across = sides[kind].scale,
                                 .up = kind == PP_MAP_DEPTH
                                           ? proportion.scale
                                           : (struct pp_atlas_scale){.count = 1}};
    struct mapped_ratio *list = calloc((size_t)table->row_count + 1, sizeof *list);
    if (!list)
        return pp_fail_memory(err);
    int count = gather_mapped_ratios(list, &map->blind, map, table, &at, at.truth);
    bool none = count == 0;
    fill_quantiles(map->real, list, count);
    count =
        at.own < 0 ? 0 : gather_mapped_ratios(list, &blind, map, table, &at, at.own);
    fill_quantiles(map->own, list, count);
    free(list);
    return none ? pp_fail(
               err, PP_BAD_INPUT, "the atlas has no value of %.60s for a map by %s%s",
               method, pp_atlas_mapping_names[kind],
               map->averages ? ", because the method gives only an average" : "")
                : PP_OK;
}
