/* report_bytes.c - copies numbers as stored in memory, and null-terminated texts. */
#include "cli/ranks/report_bytes.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void put_bytes(FILE *out, const void *bytes, size_t length)
{
    fwrite(bytes, 1, length, out);
}

static void put_reading(FILE *out, const struct pp_reading *reading)
{
    put_bytes(out, &reading->value, sizeof reading->value);
    put_bytes(out, &reading->std_error, sizeof reading->std_error);
    put_bytes(out, reading->why ? "y" : "n", 1);
    if (reading->why)
        put_bytes(out, reading->why, strlen(reading->why) + 1);
}

static void put_column(FILE *out, const struct pp_column *column, int points)
{
    int count = column->points ? points : -1;
    put_bytes(out, &column->component, sizeof column->component);
    put_bytes(out, column->name, sizeof column->name);
    put_bytes(out, &column->common, sizeof column->common);
    put_bytes(out, &column->common_near, sizeof column->common_near);
    put_reading(out, &column->average);
    put_bytes(out, &count, sizeof count);
    for (int i = 0; i < count; i++)
        put_reading(out, &column->points[i]);
}

enum pp_status pp_report_bytes_write(const struct pp_report *report, char **bytes,
                                     size_t *length, struct pp_error *err)
{
    FILE *out = open_memstream(bytes, length);
    if (!out)
        return pp_fail_memory(err);
    put_bytes(out, &report->finished, sizeof report->finished);
    put_bytes(out, &report->column_count, sizeof report->column_count);
    for (int i = 0; i < report->column_count; i++)
        put_column(out, &report->columns[i], report->receiver_count);
    bool failed = ferror(out) != 0;
    failed |= fclose(out) != 0;
    if (!failed)
        return PP_OK;
    free(*bytes);
    *bytes = NULL;
    return pp_fail_memory(err);
}

/* Bytes that are not yet read. */
struct rest {
    const char *at;
    size_t length;
};

static bool get(struct rest *rest, void *place, size_t length)
{
    if (rest->length < length)
        return false;
    memcpy(place, rest->at, length);
    rest->at += length;
    rest->length -= length;
    return true;
}

static bool get_reading(struct rest *rest, struct pp_report *report,
                        struct pp_reading *reading)
{
    char has_why;
    *reading = pp_reading_of(NAN);
    if (!get(rest, &reading->value, sizeof reading->value)
        || !get(rest, &reading->std_error, sizeof reading->std_error)
        || !get(rest, &has_why, 1))
        return false;
    if (has_why != 'y')
        return true;
    const char *end = memchr(rest->at, '\0', rest->length);
    if (!end)
        return false;
    reading->why = pp_report_say(report, "%s", rest->at);
    rest->length -= (size_t)(end + 1 - rest->at);
    rest->at = end + 1;
    return reading->why != NULL;
}

static bool get_column(struct rest *rest, struct pp_report *report)
{
    enum pp_component component;
    char name[sizeof((struct pp_column *)0)->name];
    double common, common_near;
    struct pp_reading average;
    int count;
    if (!get(rest, &component, sizeof component) || !get(rest, name, sizeof name)
        || !get(rest, &common, sizeof common)
        || !get(rest, &common_near, sizeof common_near)
        || !get_reading(rest, report, &average) || !get(rest, &count, sizeof count)
        || (count >= 0 && count != report->receiver_count))
        return false;
    struct pp_column *column = pp_report_add(report, component, name, count >= 0);
    if (!column)
        return false;
    column->common = common;
    column->common_near = common_near;
    column->average = average;
    for (int i = 0; i < count; i++)
        if (!get_reading(rest, report, &column->points[i]))
            return false;
    return true;
}

enum pp_status pp_report_bytes_read(struct pp_report *report, const char *bytes,
                                    size_t length, struct pp_error *err)
{
    struct rest rest = {bytes, length};
    bool finished = false;
    int count = 0;
    bool good =
        get(&rest, &finished, sizeof finished) && get(&rest, &count, sizeof count);
    for (int i = 0; good && i < count; i++)
        good = get_column(&rest, report);
    report->finished &= finished;
    return good ? PP_OK
                : pp_fail(err, PP_SYSTEM,
                          "the results of another process cannot be read (%zu bytes)",
                          length);
}
