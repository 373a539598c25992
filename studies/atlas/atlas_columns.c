/* atlas_columns.c - names and rows as CSV. */
#include "studies/atlas/atlas_columns.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "studies/atlas/room_features.h"

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
        /* One that is of all surfaces has no truth on the plane. */
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

static void put(FILE *out, double value)
{
    if (isfinite(value))
        fprintf(out, ",%.5g", value);
    else
        putc(',', out);
}

static void put_per_cent(FILE *out, double fraction)
{
    put(out, 100.0 * fraction);
}

/* A column's reading at a point, or of the average for -1. */
static struct pp_reading reading_of(const struct pp_column *column, int point)
{
    if (!column || (point >= 0 && !column->points))
        return (struct pp_reading){.value = NAN, .std_error = NAN};
    return point < 0 ? column->average : column->points[point];
}

/* The daylight factor in a column's own world. */
static double own_value(const struct pp_own_worlds *worlds,
                        const struct pp_column *column, int point)
{
    const struct pp_report *of[3];
    for (int c = PP_SC; c <= PP_IRC; c++)
        of[c] = pp_own_world_of(worlds, column, (enum pp_component)c);
    /* The daylight factor of one world is known better than the sum of its parts. */
    if (of[PP_SC] == of[PP_ERC] && of[PP_ERC] == of[PP_IRC])
        return reading_of(pp_report_find(of[PP_SC], PP_DF, "traced"), point).value;
    double sum = 0.0;
    for (int c = PP_SC; c <= PP_IRC; c++)
        sum += reading_of(pp_report_find(of[c], (enum pp_component)c, "traced"), point)
                   .value;
    return sum;
}

static void print_row(const struct pp_atlas_columns *columns, int room, int point,
                      const struct pp_report *report, const double *features,
                      const struct pp_own_worlds *worlds, FILE *out)
{
    struct pp_vec3 place =
        point < 0 ? pp_vec(NAN, NAN, NAN) : report->receivers[point].position;
    fprintf(out, "%d,%d", room, point);
    put(out, place.x);
    put(out, place.y);
    for (int i = 0; i < PP_ROOM_FEATURES; i++)
        put(out, features[i]);
    for (int c = 0; c < PP_COMPONENT_COUNT; c++) {
        struct pp_reading traced =
            reading_of(pp_report_find(report, (enum pp_component)c, "traced"), point);
        put_per_cent(out, traced.value);
        put_per_cent(out, traced.std_error);
    }
    for (int i = 0; i < columns->count; i++)
        put_per_cent(out,
                     reading_of(pp_report_find(report, columns->methods[i].component,
                                               columns->methods[i].name),
                                point)
                         .value);
    for (int i = 0; i < columns->count; i++) {
        if (columns->methods[i].component != PP_DF)
            continue;
        const struct pp_column *column =
            pp_report_find(report, PP_DF, columns->methods[i].name);
        bool there = column && isfinite(reading_of(column, point).value);
        put_per_cent(out, there ? own_value(worlds, column, point) : NAN);
    }
    putc('\n', out);
}

enum pp_status pp_atlas_columns_print_room(const struct pp_atlas_columns *columns,
                                           int room, const struct pp_report *report,
                                           const struct pp_own_worlds *worlds,
                                           FILE *out, struct pp_error *err)
{
    double features[PP_ROOM_FEATURES];
    enum pp_status status =
        pp_room_features(features, report->world, &report->light, err);
    if (status != PP_OK)
        return status;
    for (int i = 0; i < report->receiver_count; i++) {
        double here[PP_ROOM_FEATURES];
        memcpy(here, features, sizeof here);
        pp_room_features_at(here, report->world, report->receivers[i].position);
        print_row(columns, room, i, report, here, worlds, out);
    }
    print_row(columns, room, -1, report, features, worlds, out);
    return PP_OK;
}
