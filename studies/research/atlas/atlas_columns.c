/* atlas_columns.c - lists the columns of an atlas, and writes their names and the rows
 * as CSV. */
#include "studies/research/atlas/atlas_columns.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "studies/research/atlas/room_features.h"

static const char *const component_names[PP_COMPONENT_COUNT] = {
    [PP_SC] = "sc", [PP_ERC] = "erc", [PP_IRC] = "irc", [PP_DF] = "df"};

enum pp_status pp_atlas_columns_of(struct pp_atlas_columns *columns,
                                   const struct pp_report *report, struct pp_error *err)
{
    *columns = (struct pp_atlas_columns){0};
    columns->methods =
        calloc((size_t)report->column_count + 1, sizeof *columns->methods);
    if (!columns->methods)
        return pp_fail_memory(err);
    for (int i = 0; i < report->column_count; i++) {
        const struct pp_column *column = &report->columns[i];
        /* Leaves out an average over all surfaces, since the simulated average is over
         * the working plane. */
        if (column->of_all_surfaces || strcmp(column->name, "traced") == 0)
            continue;
        struct pp_atlas_method *method = &columns->methods[columns->count++];
        method->component = column->component;
        memcpy(method->name, column->name, sizeof method->name);
    }
    return PP_OK;
}

void pp_atlas_columns_clear(struct pp_atlas_columns *columns)
{
    free(columns->methods);
    *columns = (struct pp_atlas_columns){0};
}

void pp_atlas_columns_print_names(const struct pp_atlas_columns *columns, FILE *out)
{
    fputs("room,point,x,y", out);
    for (int i = 0; i < PP_ROOM_FEATURES; i++)
        fprintf(out, ",%s", pp_room_feature_names[i]);
    for (int c = 0; c < PP_COMPONENT_COUNT; c++)
        fprintf(out, ",true.%s,se.%s", component_names[c], component_names[c]);
    for (int i = 0; i < columns->count; i++)
        fprintf(out, ",%s.%s", component_names[columns->methods[i].component],
                columns->methods[i].name);
    for (int i = 0; i < columns->count; i++)
        if (columns->methods[i].component == PP_DF)
            fprintf(out, ",own.df.%s", columns->methods[i].name);
    putc('\n', out);
}

static void put_atlas_value(FILE *out, double value)
{
    if (isfinite(value))
        fprintf(out, ",%.5g", value);
    else
        putc(',', out);
}

static void put_per_cent(FILE *out, double fraction)
{
    put_atlas_value(out, 100.0 * fraction);
}

/* Value of a column at a point; point -1: the average. */
static double atlas_column_value(const struct pp_report *report,
                                 const struct pp_atlas_method *method, int point)
{
    const struct pp_column *column =
        pp_report_find(report, method->component, method->name);
    if (!column || (point >= 0 && !column->points))
        return NAN;
    return point < 0 ? column->average.value : column->points[point].value;
}

static void print_row(const struct pp_atlas_columns *columns, int room, int point,
                      const struct pp_report *report, const double *features,
                      const struct pp_atlas_truth *truth, FILE *out)
{
    struct pp_vec3 place =
        point < 0 ? pp_vec(NAN, NAN, NAN) : report->receivers[point].position;
    fprintf(out, "%d,%d", room, point);
    put_atlas_value(out, place.x);
    put_atlas_value(out, place.y);
    for (int i = 0; i < PP_ROOM_FEATURES; i++)
        put_atlas_value(out, features[i]);
    for (int c = 0; c < PP_COMPONENT_COUNT; c++) {
        put_per_cent(out, truth->value[c]);
        put_per_cent(out, truth->std_error[c]);
    }
    for (int i = 0; i < columns->count; i++)
        put_per_cent(out, atlas_column_value(report, &columns->methods[i], point));
    for (int i = 0; i < columns->count; i++) {
        const struct pp_atlas_method *method = &columns->methods[i];
        if (method->component == PP_DF)
            put_per_cent(out, isfinite(atlas_column_value(report, method, point))
                                  ? truth->own[i]
                                  : NAN);
    }
    putc('\n', out);
}

static void print_rows(const struct pp_atlas_columns *columns, int room,
                       const struct pp_report *report, const double *features,
                       pp_atlas_truth_of *truth_of, const void *data,
                       struct pp_atlas_truth *truth, FILE *out)
{
    for (int i = 0; i < report->receiver_count; i++) {
        double here[PP_ROOM_FEATURES];
        memcpy(here, features, sizeof here);
        pp_room_features_at(here, report->world, report->receivers[i].position);
        truth_of(data, i, truth);
        print_row(columns, room, i, report, here, truth, out);
    }
    truth_of(data, -1, truth);
    print_row(columns, room, -1, report, features, truth, out);
}

enum pp_status pp_atlas_columns_print_room(const struct pp_atlas_columns *columns,
                                           int room, const struct pp_report *report,
                                           pp_atlas_truth_of *truth_of,
                                           const void *data, FILE *out,
                                           struct pp_error *err)
{
    double features[PP_ROOM_FEATURES];
    struct pp_atlas_truth truth = {
        .own = calloc((size_t)columns->count + 1, sizeof *truth.own)};
    enum pp_status status =
        truth.own ? pp_room_features(features, report->world, &report->light, err)
                  : pp_fail_memory(err);
    if (status == PP_OK)
        print_rows(columns, room, report, features, truth_of, data, &truth, out);
    free(truth.own);
    return status;
}
