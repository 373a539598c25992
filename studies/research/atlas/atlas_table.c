/* atlas_table.c - reads the lines of a CSV table one by one. */
#include "studies/research/atlas/atlas_table.h"

#include <limits.h>
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/array.h"
#include "model/base/read_file.h"

static const size_t file_most = (size_t)4 << 30;

struct table_reading {
    struct pp_atlas_table *table;
    const char *path;
    int line;
    int capacity;   /* space for values */
    int name_space; /* space for names */
};

/* Sets *end to the end of a field. Returns the start of the next one; NULL after the
 * last field of the line. */
static char *next_field(char *field, char **end)
{
    *end = field + strcspn(field, ",");
    return **end == ',' ? *end + 1 : NULL;
}

static enum pp_status read_names(struct table_reading *reading, char *line,
                                 struct pp_error *err)
{
    struct pp_atlas_table *table = reading->table;
    char *end;
    for (char *field = line, *next; field; field = next) {
        next = next_field(field, &end);
        *end = '\0';
        enum pp_status status =
            pp_array_reserve(&table->names, &reading->name_space,
                             table->column_count + 1, sizeof *table->names, err);
        if (status != PP_OK)
            return status;
        table->names[table->column_count++] = field;
    }
    table->room = pp_atlas_table_find(table, "room");
    table->point = pp_atlas_table_find(table, "point");
    return table->room >= 0 && table->point >= 0
               ? PP_OK
               : pp_fail(err, PP_BAD_INPUT,
                         "%s:%d: no columns \"room\" and \"point\"; expected the "
                         "column names of an atlas",
                         reading->path, reading->line);
}

/* Reads the number in a field that ends at `end`; an empty field is NAN. False if the
 * field is not a finite number. */
static bool read_field_number(double *value, const char *field, const char *end)
{
    char *behind;
    *value = NAN;
    if (field == end)
        return true;
    *value = strtod(field, &behind);
    return behind == end && isfinite(*value);
}

/* True if the value is a whole number of at least `least` that an int can hold. */
static bool is_number_from(double value, int least)
{
    return value >= least && value <= INT_MAX && value == floor(value);
}

/* Checks the numbers of a row's room and point: both are counted from 0, and point -1
 * is the average. */
static enum pp_status check_numbers(const struct table_reading *reading, int row,
                                    struct pp_error *err)
{
    const struct pp_atlas_table *table = reading->table;
    if (!is_number_from(pp_atlas_table_value(table, row, table->room), 0))
        return pp_fail(err, PP_BAD_INPUT,
                       "%s:%d: the room has no number; expected a whole number from 0",
                       reading->path, reading->line);
    if (!is_number_from(pp_atlas_table_value(table, row, table->point), -1))
        return pp_fail(err, PP_BAD_INPUT,
                       "%s:%d: the point has no number; expected a whole number from "
                       "0, or -1 for the average",
                       reading->path, reading->line);
    return PP_OK;
}

static enum pp_status read_atlas_row(struct table_reading *reading, char *line,
                                     struct pp_error *err)
{
    struct pp_atlas_table *table = reading->table;
    size_t first = (size_t)table->row_count * (size_t)table->column_count;
    enum pp_status status =
        pp_array_reserve(&table->values, &reading->capacity, table->row_count + 1,
                         (size_t)table->column_count * sizeof *table->values, err);
    if (status != PP_OK)
        return status;
    int count = 0;
    char *end;
    for (char *field = line, *next; field; field = next, count++) {
        next = next_field(field, &end);
        if (count < table->column_count
            && !read_field_number(&table->values[first + (size_t)count], field, end))
            return pp_fail(err, PP_BAD_INPUT,
                           "%s:%d: %s is \"%.*s\"; expected a number, or nothing",
                           reading->path, reading->line, table->names[count],
                           (int)(end - field < 40 ? end - field : 40), field);
    }
    if (count != table->column_count)
        return pp_fail(err, PP_BAD_INPUT, "%s:%d: %d fields; expected %d",
                       reading->path, reading->line, count, table->column_count);
    table->row_count++;
    return check_numbers(reading, table->row_count - 1, err);
}

/* Removes the rows after the last average, which belong to an unfinished room. */
static void keep_whole_rooms(struct pp_atlas_table *table)
{
    while (table->row_count > 0
           && !(pp_atlas_table_value(table, table->row_count - 1, table->point) < 0.0))
        table->row_count--;
}

enum pp_status pp_atlas_table_read(struct pp_atlas_table *table, const char *path,
                                   struct pp_error *err)
{
    struct table_reading reading = {.table = table, .path = pp_read_file_title(path)};
    size_t length;
    *table = (struct pp_atlas_table){.room = -1, .point = -1};
    enum pp_status status = pp_read_file(&table->text, &length, path, file_most, err);
    char *line = table->text, *end = line;
    while (status == PP_OK
           && (end = memchr(line, '\n', length - (size_t)(line - table->text)))) {
        *end = '\0';
        reading.line++;
        table->iso |= strncmp(line, "# sky iso,", strlen("# sky iso,")) == 0;
        if (line[0] != '#')
            status = table->names ? read_atlas_row(&reading, line, err)
                                  : read_names(&reading, line, err);
        line = end + 1;
    }
    if (status == PP_OK && !table->names)
        status = pp_fail(err, PP_BAD_INPUT, "%s: the file is empty; expected an atlas",
                         reading.path);
    if (status == PP_OK)
        keep_whole_rooms(table);
    return status;
}

void pp_atlas_table_clear(struct pp_atlas_table *table)
{
    free(table->names);
    free(table->values);
    free(table->text);
    *table = (struct pp_atlas_table){.room = -1, .point = -1};
}

int pp_atlas_table_find(const struct pp_atlas_table *table, const char *name)
{
    for (int i = 0; i < table->column_count; i++)
        if (strcmp(table->names[i], name) == 0)
            return i;
    return -1;
}
